//! Free rotation of a rigid body, lane by lane.
//!
//! In the frame of the body's principal axes its angular momentum `m` rotates; in the world it is constant.
//! Its energy is a sum, and each term by itself is a motion that is known exactly:
//!
//! ```text
//! T = |m|² / 2 I₀ + Σ m_k² (1 / I_k - 1 / I₀) / 2
//!
//! the first:   the body turns about m by h |m| / I₀, and m stays
//! the k-th:    it turns about its own axis k by α = h m_k (1 / I_k - 1 / I₀), and m by -α about the same axis
//! ```
//!
//! The method composes these symmetrically (Strang 1968). The first commutes with all the others. The others
//! are applied for half of the time, the last of them for all of it, and back again. The result is a
//! rotation, so the world-space momentum is constant, and the method is reversible. `I₀` is the middle one of
//! the moments. Two of the terms are then exact for a body with two equal moments: a rod, a disc, a capsule.
//! For others the energy oscillates by the square of `h` times the difference of neighbouring moments.
//!
//! Sources: McLachlan, "Explicit Lie-Poisson integration and the Euler equations" (Phys. Rev. Lett. 1993);
//! Dullweber, Leimkuhler and McLachlan, "Symplectic splitting methods for rigid body molecular dynamics" (J.
//! Chem. Phys. 1997). They split off the symmetric top as well. Jacobi's elliptic functions, which are exact
//! for all bodies, take several times as long and lose their digits where two moments are nearly the same.

use super::math::ANGLE_SQUARED_MAX;
use super::rotation_vector::wide_unit_quaternion;
use super::wide::{WideRotation, WideVector};
use crate::base::turning::wide_cosine_and_sine;
use crate::base::wide::Wide;

/// Orientation of a free body after a time, relative to its start.
pub(super) struct FreeRotation<W> {
    /// Its rotation, in the frame of its principal axes.
    pub rotation: WideRotation<W>,
    /// Its angular momentum in the frame of these axes as they are then.
    pub momentum: WideVector<W>,
}

impl<W: Wide> FreeRotation<W> {
    /// A body with these inverse moments of inertia and this angular momentum, both in the frame of its
    /// principal axes, after `h` seconds.
    #[inline(always)]
    pub fn new(inv_moments: WideVector<W>, momentum: WideVector<W>, h: W) -> Self {
        let WideVector { x, y, z } = inv_moments;
        let shared = x.min(y).max(x.max(y).min(z));
        let about = momentum * (shared * h);
        let (scale, w) = wide_unit_quaternion(about);
        let about = about * scale;
        let rotation = WideRotation { x: about.x, y: about.y, z: about.z, w };
        let half = h * W::splat(0.5);
        let all = Self { rotation, momentum };
        let all = all.further::<0>((x - shared) * half).further::<1>((y - shared) * half);
        let all = all.further::<2>((z - shared) * h);
        all.further::<1>((y - shared) * half).further::<0>((x - shared) * half)
    }

    /// Turns it about one of its axes, by `rate` times the momentum about that.
    #[inline(always)]
    fn further<const AXIS: usize>(self, rate: W) -> Self {
        let WideVector { x, y, z } = self.momentum;
        let mut m = [x, y, z];
        let angle = rate * m[AXIS];
        let square = angle * angle;
        let (cos, sin) = wide_cosine_and_sine::<W, 2>(square.min(W::splat(ANGLE_SQUARED_MAX)));
        let scale = W::splat(1.0) / (cos * cos + square * (sin * sin)).sqrt();
        let (cos, sin) = (cos * scale, sin * scale * angle);
        let mut vector = [W::zero(); 3];
        vector[AXIS] = sin;
        let about = WideRotation { x: vector[0], y: vector[1], z: vector[2], w: cos };
        let (whole_cos, product) = (cos * cos - sin * sin, cos * sin);
        let whole_sin = product + product;
        let (i, j) = ((AXIS + 1) % 3, (AXIS + 2) % 3);
        (m[i], m[j]) = (m[i] * whole_cos + m[j] * whole_sin, m[j] * whole_cos - m[i] * whole_sin);
        let momentum = WideVector { x: m[0], y: m[1], z: m[2] };
        Self { rotation: self.rotation.times(about), momentum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;
    use crate::base::wide::{Kernel, Simd};
    use crate::dim3::math::{Real, Rotation, Vector, integrate_rotation};
    use crate::dim3::rotation_vector::rotation_vector;

    /// One body that rotates freely.
    struct Turn {
        inv_moments: Vector,
        momentum: Vector,
        h: Real,
    }

    impl Kernel for Turn {
        type Output = (Rotation, Vector, Vector);
        #[inline(always)]
        fn run<W: Wide>(self) -> Self::Output {
            let [moments, momentum] = [self.inv_moments, self.momentum].map(WideVector::splat);
            let free = FreeRotation::new(moments, momentum, W::splat(self.h));
            let lane = |vector: WideVector<W>| {
                let mut lanes = WideVector::ZERO;
                vector.store(&mut lanes);
                lanes.lane(0)
            };
            let WideRotation { x, y, z, w } = free.rotation;
            let (vector, real) = (lane(WideVector { x, y, z }), lane(WideVector { x: w, y, z }).x);
            let rotation = Rotation::from_xyzw(vector.x, vector.y, vector.z, real);
            (rotation, lane(free.momentum), lane(rotation_vector(free.rotation)))
        }
    }

    impl Turn {
        fn energy(&self, momentum: Vector) -> Real {
            0.5 * momentum.dot(momentum * self.inv_moments)
        }
    }

    fn turns(inv_moments: Vector, size: Real) -> impl Iterator<Item = Turn> {
        let mut random = Random(7);
        (0..200).map(move |_| {
            let mut any = || random.within(-1.0, 1.0);
            let momentum = Vector::new(any(), any(), any()) * size;
            Turn { inv_moments, momentum, h: 0.01 }
        })
    }

    /// The world-space momentum is constant, and a body with two equal moments keeps its energy. The body is
    /// a rod that rotates by up to 10 rad about its axis. Single precision has 6e-8 of each of some twenty
    /// products.
    #[test]
    fn tops_keep_momentum_and_energy_however_fast() {
        for inv_moments in [Vector::new(355.0, 1.0, 1.0), Vector::new(2.0, 2.0, 1.0)] {
            for body in turns(inv_moments, 3.0) {
                let (energy, size) = (body.energy(body.momentum), body.momentum.length());
                let start = body.momentum;
                let (rotation, momentum, _) = Simd::detect().run(Turn { ..body });
                let moved = rotation * momentum - start;
                assert!(
                    moved.length() < 2.0e-6 * size,
                    "{start} was led to {}",
                    rotation * momentum
                );
                let now = 0.5 * momentum.dot(momentum * inv_moments);
                assert!((now / energy - 1.0).abs() < 1.0e-5, "{now} of {energy}");
            }
        }
    }

    /// With three different moments the energy error is the square of the angle of the substep: half the
    /// substep, a quarter of the error.
    #[test]
    fn others_miss_their_energy_by_the_square_of_the_substep() {
        let inv_moments = Vector::new(1.0, 1.6, 2.5);
        let missed = |h: Real| {
            turns(inv_moments, 20.0)
                .map(|body| {
                    let energy = body.energy(body.momentum);
                    let (_, momentum, _) = Simd::detect().run(Turn { h, ..body });
                    (0.5 * momentum.dot(momentum * inv_moments) / energy - 1.0).abs()
                })
                .fold(0.0, Real::max)
        };
        let (whole, half) = (missed(0.02), missed(0.01));
        assert!(whole < 0.05 && half < 0.4 * whole, "{whole}, and {half} in half of the time");
    }

    /// The rotation vector and the rotation agree.
    #[test]
    fn the_vector_equals_the_rotation() {
        for body in turns(Vector::new(9.0, 2.0, 1.0), 60.0) {
            let (rotation, _, vector) = Simd::detect().run(body);
            let led = integrate_rotation(Rotation::IDENTITY, vector);
            let sign = led.dot(rotation).signum();
            let missed = (led * sign - rotation).length();
            assert!(missed < 2.0e-6, "{vector} leads to {led}, not {rotation}");
        }
    }
}
