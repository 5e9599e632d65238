//! The point of a polyhedron that is nearest to a target: an exact solver for a handful of planes.
//!
//! `min |t - target|²` subject to `nᵢ·t ≥ bᵢ`. The solution lies on some of the planes. In space, at most
//! three independent planes determine it: none (the target itself), one (a wall), two (a crease) or three (a
//! corner). There are few planes, so all combinations are tried, smaller ones first. The nearest candidate
//! that satisfies all planes is the solution. Without iteration, the solution does not creep towards an acute
//! corner, and the same input gives the same bits.

use crate::dim::math::{Real, Vector};

/// All points `t` with `normal · t >= at_least`. The normal has unit length.
#[derive(Copy, Clone, Debug)]
pub(super) struct HalfSpace {
    pub normal: Vector,
    pub at_least: Real,
}

/// Squared sine of the angle below which two planes are parallel.
const PARALLEL_SINE_SQUARED_MAX: Real = 1.0e-5;
/// Rounding tolerance of a candidate outside of a plane, as a fraction of the involved lengths.
const ROUNDING: Real = 64.0 * Real::EPSILON;
/// Bisections of the search for the common relaxation of contradicting planes: each halves the interval.
const BISECTIONS: usize = 12;

/// The point nearest to `target` that satisfies all half spaces; `None` if there is none.
pub(super) fn nearest(target: Vector, spaces: &[HalfSpace]) -> Option<Vector> {
    if satisfies(target, spaces, 0.0) {
        return Some(target);
    }
    let mut search = Search { target, spaces, tolerance: tolerance(target, spaces), best: None };
    for (i, first) in spaces.iter().enumerate() {
        search.offer(&[first]);
        for (j, second) in spaces[..i].iter().enumerate() {
            search.offer(&[first, second]);
            for third in &spaces[..j] {
                search.offer(&[first, second, third]);
            }
        }
    }
    search.best.map(|(_, point)| point)
}

/// The point nearest to the origin with the least violation of the half spaces. If planes contradict each
/// other, as in a corridor that is too narrow, all pushing ones are relaxed by the same length.
///
/// A relaxation by the largest demand admits the origin, so a solution always exists.
pub(super) fn least_violation(spaces: &[HalfSpace]) -> Vector {
    if let Some(point) = nearest(Vector::ZERO, spaces) {
        return point;
    }
    let largest = spaces.iter().map(|space| space.at_least).fold(0.0, Real::max);
    let (mut enough, mut too_little, mut best) = (largest, 0.0, Vector::ZERO);
    for _ in 0..BISECTIONS {
        let yielding = 0.5 * (enough + too_little);
        let softer: Vec<_> = spaces
            .iter()
            .map(|space| HalfSpace { at_least: yielded(space.at_least, yielding), ..*space })
            .collect();
        match nearest(Vector::ZERO, &softer) {
            Some(point) => (enough, best) = (yielding, point),
            None => too_little = yielding,
        }
    }
    best
}

/// The relaxed demand. A plane without a demand is not relaxed.
fn yielded(at_least: Real, yielding: Real) -> Real {
    if at_least > 0.0 { at_least - yielding } else { at_least }
}

fn satisfies(point: Vector, spaces: &[HalfSpace], tolerance: Real) -> bool {
    spaces.iter().all(|space| space.normal.dot(point) >= space.at_least - tolerance)
}

fn tolerance(target: Vector, spaces: &[HalfSpace]) -> Real {
    let demand = spaces.iter().map(|space| space.at_least.abs()).fold(0.0, Real::max);
    ROUNDING * (target.length() + demand)
}

struct Search<'a> {
    target: Vector,
    spaces: &'a [HalfSpace],
    tolerance: Real,
    best: Option<(Real, Vector)>,
}

impl Search<'_> {
    /// Tries the point nearest to the target that lies on all of these planes.
    fn offer(&mut self, planes: &[&HalfSpace]) {
        let Some(point) = on_planes(self.target, planes) else { return };
        let distance = (point - self.target).length_squared();
        let is_nearer = self.best.is_none_or(|(best, _)| distance < best);
        if is_nearer && satisfies(point, self.spaces, self.tolerance) {
            self.best = Some((distance, point));
        }
    }
}

/// The point nearest to `target` on up to three planes; `None` if they are (nearly) parallel.
///
/// It differs from the target by a combination of the normals. Instead of solving for the factors, the
/// normals are orthogonalised in sequence (Gram-Schmidt). `eₖ = nₖ - Σ (nₖ·eᵢ) eᵢ` lies in all earlier
/// planes, so a motion along it reaches the next plane and leaves none.
fn on_planes(target: Vector, planes: &[&HalfSpace]) -> Option<Vector> {
    let mut directions = [Vector::ZERO; 3];
    let mut point = target;
    for (k, plane) in planes.iter().enumerate() {
        let mut direction = plane.normal;
        for earlier in &directions[..k] {
            direction -= *earlier * earlier.dot(direction);
        }
        let squared = direction.length_squared();
        if squared < PARALLEL_SINE_SQUARED_MAX {
            return None;
        }
        point += direction * ((plane.at_least - plane.normal.dot(point)) / squared);
        directions[k] = direction / squared.sqrt();
    }
    Some(point)
}

#[cfg(test)]
mod tests {
    use super::{HalfSpace, least_violation, nearest};
    use crate::base::random::Random;
    use crate::dim::math::{DIM, Vector};

    fn random_vector(random: &mut Random) -> Vector {
        let mut vector = Vector::ZERO;
        for axis in 0..DIM {
            vector[axis] = random.within(-1.0, 1.0);
        }
        vector
    }

    /// The definition: no feasible point is nearer. Tried with many feasible points.
    #[test]
    fn nothing_feasible_is_nearer() {
        let random = &mut Random(7);
        for _ in 0..200 {
            let spaces: Vec<HalfSpace> = (0..5)
                .map(|_| HalfSpace {
                    normal: random_vector(random).normalize(),
                    at_least: random.within(-1.0, 0.0),
                })
                .collect();
            let target = random_vector(random) * 3.0;
            let found = nearest(target, &spaces).expect("the origin is feasible");
            assert!(spaces.iter().all(|s| s.normal.dot(found) >= s.at_least - 1.0e-4));
            let best = (found - target).length();
            for _ in 0..200 {
                let point = random_vector(random) * 3.0;
                let feasible = spaces.iter().all(|s| s.normal.dot(point) >= s.at_least);
                assert!(!feasible || (point - target).length() > best - 1.0e-4);
            }
        }
    }

    #[test]
    fn feasible_points_are_returned_bit_for_bit() {
        let floor = HalfSpace { normal: Vector::Y, at_least: 0.0 };
        assert_eq!(nearest(Vector::X * 0.3, &[floor]), Some(Vector::X * 0.3));
        assert_eq!(nearest(Vector::ZERO, &[floor]), Some(Vector::ZERO));
    }

    #[test]
    fn squeezed_characters_end_in_the_middle() {
        let walls = [
            HalfSpace { normal: Vector::X, at_least: 0.3 },
            HalfSpace { normal: -Vector::X, at_least: 0.1 },
            HalfSpace { normal: Vector::Y, at_least: -1.0 },
        ];
        assert!(nearest(Vector::ZERO, &walls).is_none());
        let found = least_violation(&walls);
        assert!((found - Vector::X * 0.1).length() < 1.0e-4, "{found}");
    }
}
