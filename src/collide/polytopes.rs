//! Two polytopes: the face that separates them best, clipped against the face it meets.
//!
//! A persistent contact has hardly changed, so the face of either polytope along the last normal is tested
//! first. The search ends if the clipped faces have a point as deep as the support point of the other
//! polytope, or if that point is above the face. No similar direction then separates the two better. For
//! separated polytopes, no direction does. The same holds for the two edges that are farthest along the last
//! normal, if no corner is deeper. Else the closest points are searched, which takes several times as long.

use super::cut::closest_of_parts;
use super::normals::FACE_COSINE_MIN;
use crate::base::axis::{BestAxis, Side};
use crate::base::closest::{Closest, extents};
use crate::dim::collide::{
    Face, FaceContact, Polytope, RawManifold, RawPoint, best_axis, clip_faces, edge_normal,
};
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::shape::PackedFeatureId;

/// Tolerances on the overlap, as a fraction of the polytopes' thickness. Within it, a face is preferred to a
/// pair of edges, and the last face to another face.
const TOLERANCE: Real = 0.005;
/// Preference of the first polytope among equal faces, as a fraction of the tolerance.
const FIRST_FACE_FRACTION: Real = 0.1;
/// Least cosine of a face's normal and the last normal at which the face counts as the last one.
const AXIS_COSINE_MIN: Real = 0.98;
/// Overlaps deeper than this fraction of the thickness are searched again: a face on another side may have
/// become the better one.
pub(super) const OVERLAP_RATIO_MAX: Real = 0.25;

/// Tolerance on the depth of other corners against two edges, as a fraction of the shorter edge.
const EDGE_DEPTH_TOLERANCE: Real = 1.0e-3;

/// Two polytopes, and the largest distance of contacts.
struct Pair<'a> {
    pos12: &'a Pose,
    pos21: Pose,
    polytope1: &'a Polytope<'a>,
    polytope2: &'a Polytope<'a>,
    prediction: Real,
    /// Whether neither shape has a layer around it. With one, they touch with corners while they are apart.
    is_sharp: bool,
}

/// A face that may separate the polytopes.
#[derive(Copy, Clone)]
struct Separation {
    /// Distance of the polytopes along its normal.
    gap: Real,
    /// The normal in the first frame, from the first polytope to the second.
    normal: Vector,
    face: Face,
    is_first: bool,
    /// The lowest point of the other polytope over the face, in that polytope's frame.
    lowest: Vector,
}

/// Computes the contacts of two polytopes, each with the thickness of a layer around it, into `raw`, whose
/// `local_n1` is the last normal, or zero. Returns a lower bound of the distance, 0 if nothing is known of
/// it.
pub(super) fn polytope_polytope(
    pos12: &Pose,
    [(polytope1, radius1), (polytope2, radius2)]: [(Polytope<'_>, Real); 2],
    prediction: Real,
    raw: &mut RawManifold,
) -> Real {
    let radius = radius1 + radius2;
    let pair = Pair {
        pos12,
        pos21: pos12.inverse(),
        polytope1: &polytope1,
        polytope2: &polytope2,
        prediction: prediction + radius,
        is_sharp: radius == 0.0,
    };
    let gap = pair.add_contacts(raw);
    pair.thicken([radius1, radius2], raw);
    gap - radius
}

/// Computes the contacts of two polytopes of which the best axis is known, into `raw`. Returns a lower bound
/// of the distance, 0 if nothing is known of it.
pub(super) fn contacts_on_axis(
    [pos12, pos21]: [&Pose; 2],
    [polytope1, polytope2]: [&Polytope<'_>; 2],
    axis: &BestAxis,
    prediction: Real,
    raw: &mut RawManifold,
) -> Real {
    let pair = Pair { pos12, pos21: *pos21, polytope1, polytope2, prediction, is_sharp: true };
    pair.add_along(axis, raw)
}

/// Computes the contacts of one face of a polytope, the first or the second. Its normal is the nearest to
/// `direction` (from the first to the second, in the first frame). The direction need not be the best
/// separation. The result is empty if there is no such face.
pub(super) fn face_contacts(
    pos12: &Pose,
    [(polytope1, radius1), (polytope2, radius2)]: [(Polytope<'_>, Real); 2],
    is_first: bool,
    direction: Vector,
    prediction: Real,
    raw: &mut RawManifold,
) {
    let pair = Pair {
        pos12,
        pos21: pos12.inverse(),
        polytope1: &polytope1,
        polytope2: &polytope2,
        prediction: prediction + radius1 + radius2,
        is_sharp: radius1 + radius2 == 0.0,
    };
    let face = if is_first { pair.first_face(direction) } else { pair.second_face(direction) };
    if let Some(face) = face.filter(|face| face.normal.dot(direction) > FACE_COSINE_MIN) {
        pair.add_face(&face, raw);
        pair.thicken([radius1, radius2], raw);
    }
}

impl Pair<'_> {
    /// Computes the contacts. Returns a lower bound of the distance, 0 if nothing is known of it.
    fn add_contacts(&self, raw: &mut RawManifold) -> Real {
        let (hint, prediction) = (raw.local_n1, self.prediction);
        let axis = || best_axis(self.pos12, self.polytope1, self.polytope2, hint);
        // A box without thickness has no best axis, but sides: those of the last normal.
        let is_solid = !(self.polytope1.is_flat_box() || self.polytope2.is_flat_box());
        if let Some(axis) = (self.is_sharp && is_solid).then(axis).flatten() {
            return self.add_along(&axis, raw);
        }
        let is_known = hint != Vector::ZERO;
        let guess = if is_known { hint } else { self.pos12.translation.normalize_or(Vector::Y) };
        let best = self.best_face(guess, hint);
        if let Some(best) = &best
            && best.gap > prediction
        {
            raw.local_n1 = best.normal;
            return best.gap;
        }
        let were_faces = best.is_some_and(|best| best.normal.dot(guess) > AXIS_COSINE_MIN);
        for try_faces in [were_faces, !were_faces] {
            let gap = match &best {
                _ if !try_faces => self.add_edges(guess, raw),
                Some(best) => self.add_face(best, raw),
                None => None,
            };
            // Without a last normal, the guess is confirmed only for separated polytopes.
            match gap {
                Some(gap) if gap > prediction => return gap,
                Some(gap) if gap >= 0.0 || is_known && self.is_shallow(gap, raw.local_n1) => {
                    return 0.0;
                }
                _ => raw.points.clear(),
            }
        }
        self.search(hint, raw);
        0.0
    }

    /// Adds the contacts of the face or the edges that an axis belongs to. Polytopes that are apart and meet
    /// with corners alone have none.
    fn add_along(&self, axis: &BestAxis, raw: &mut RawManifold) -> Real {
        raw.local_n1 = axis.normal;
        if axis.gap > self.prediction {
            return axis.gap;
        }
        let face = axis.face.and_then(|side| match side {
            Side::First => self.first_face(axis.normal),
            Side::Second => self.second_face(axis.normal),
        });
        match face {
            Some(face) => drop(self.add_face(&face, raw)),
            None => drop(self.add_edges(axis.normal, raw)),
        }
        if raw.points.is_empty() { axis.gap.max(0.0) } else { 0.0 }
    }

    /// The best separation along the faces nearest to `direction`.
    fn best_face(&self, direction: Vector, hint: Vector) -> Option<Separation> {
        match (self.first_face(direction), self.second_face(direction)) {
            (Some(first), Some(second)) => {
                let is_same = |face: Separation| face.normal.dot(hint) > AXIS_COSINE_MIN;
                let bonus = |face: Separation| if is_same(face) { 1.0 } else { 0.0 };
                let scale = TOLERANCE * (first.face.offset.abs() + second.face.offset.abs());
                let advantage = (bonus(first) - bonus(second) + FIRST_FACE_FRACTION) * scale;
                Some(if first.gap + advantage >= second.gap { first } else { second })
            }
            (first, second) => first.or(second),
        }
    }

    fn first_face(&self, direction: Vector) -> Option<Separation> {
        let face = self.polytope1.face_toward(direction)?;
        let lowest = self.polytope2.support(self.pos21.rotation * -face.normal);
        let gap = face.normal.dot(*self.pos12 * lowest) - face.offset;
        Some(Separation { gap, normal: face.normal, face, is_first: true, lowest })
    }

    fn second_face(&self, direction: Vector) -> Option<Separation> {
        let face = self.polytope2.face_toward(self.pos21.rotation * -direction)?;
        let normal = self.pos12.rotation * -face.normal;
        let lowest = self.polytope1.support(normal);
        let gap = face.normal.dot(self.pos21 * lowest) - face.offset;
        Some(Separation { gap, normal, face, is_first: false, lowest })
    }

    /// Returns whether the overlap is small against the polytopes.
    fn is_shallow(&self, gap: Real, normal: Vector) -> bool {
        -gap < self.prediction || -gap < OVERLAP_RATIO_MAX * self.thickness(normal)
    }

    /// The smaller of the extents of the two along a direction.
    fn thickness(&self, direction: Vector) -> Real {
        let (shape1, shape2) = (self.polytope1.as_support(), self.polytope2.as_support());
        extents(self.pos12, shape1, shape2, direction).thickness
    }

    /// Adds the contacts of a face. Returns the distance of the polytopes, if they are closest there.
    fn add_face(&self, separation: &Separation, raw: &mut RawManifold) -> Option<Real> {
        raw.local_n1 = separation.normal;
        let (pose, polytope, other) = if separation.is_first {
            (self.pos12, self.polytope1, self.polytope2)
        } else {
            (&self.pos21, self.polytope2, self.polytope1)
        };
        let contact = FaceContact { polytope, face: separation.face, other, pose };
        let deepest = clip_faces(&contact, self.prediction, !separation.is_first, raw)?;
        let is_deepest = deepest.dist <= separation.gap + deepest.tolerance
            || self.add_lowest(separation, &contact, raw);
        is_deepest.then_some(separation.gap)
    }

    /// Adds the lowest corner of the other polytope, if it is above the face. All faces at a pointed corner
    /// may be steep, and the clipped one is another. Returns whether the corner is above the face.
    fn add_lowest(
        &self,
        separation: &Separation,
        contact: &FaceContact<'_>,
        raw: &mut RawManifold,
    ) -> bool {
        let &Separation { face, gap, is_first, lowest, .. } = separation;
        let point = *contact.pose * lowest;
        let is_above = contact.polytope.is_above(&face, point);
        if is_above && gap <= self.prediction {
            if DIM == 2 && raw.points.len() == 2 {
                // Two points are the maximum.
                let is_first_higher = raw.points[0].dist > raw.points[1].dist;
                raw.points.swap_remove(usize::from(!is_first_higher));
            }
            let (on_face, unknown) = (point - face.normal * gap, PackedFeatureId::UNKNOWN);
            raw.points.push(RawPoint::flipped(on_face, lowest, unknown, unknown, gap, !is_first));
        }
        is_above
    }

    /// Puts layers of a thickness around the polytopes.
    fn thicken(&self, [radius1, radius2]: [Real; 2], raw: &mut RawManifold) {
        if radius1 + radius2 > 0.0 {
            raw.local_n2 = self.pos21.rotation * -raw.local_n1;
            for point in &mut raw.points {
                point.local_p1 += raw.local_n1 * radius1;
                point.local_p2 += raw.local_n2 * radius2;
                point.dist -= radius1 + radius2;
            }
        }
    }

    /// Adds the contact of the two edges that are closest along `direction`. Returns the distance of the
    /// polytopes, if they are closest there.
    fn add_edges(&self, direction: Vector, raw: &mut RawManifold) -> Option<Real> {
        let edge1 = self.polytope1.edge_toward(direction)?;
        let edge2 = self.polytope2.edge_toward(self.pos21.rotation * -direction)?;
        let [start1, end1] = edge1.ends;
        let [start2, end2] = edge2.ends.map(|end| *self.pos12 * end);
        let (along1, along2) = (end1 - start1, end2 - start2);
        let normal = edge_normal(along1, along2)?;
        let normal = if normal.dot(direction) < 0.0 { -normal } else { normal };
        // The closest points of the two lines, as fractions of the edges.
        let offset = start2 - start1;
        let (a, b, c) = (along1.length_squared(), along1.dot(along2), along2.length_squared());
        let (d, e, area) = (along1.dot(offset), along2.dot(offset), a * c - b * b);
        let (fraction1, fraction2) = ((c * d - b * e) / area, (b * d - a * e) / area);
        let is_inside = |fraction: Real| (0.0..=1.0).contains(&fraction);
        if !(is_inside(fraction1) && is_inside(fraction2)) {
            return None;
        }
        let (gap, dist) = (self.gap_along(normal), offset.dot(normal));
        if dist > gap + EDGE_DEPTH_TOLERANCE * a.min(c).sqrt() {
            return None; // other corners are deeper
        }
        raw.local_n1 = normal;
        let (p1, p2) = (start1 + along1 * fraction1, self.pos21 * (start2 + along2 * fraction2));
        if dist <= self.prediction {
            raw.points.push(RawPoint::new(p1, p2, edge1.feature, edge2.feature, dist));
        }
        Some(gap)
    }

    /// Distance of the polytopes along a unit vector of the first frame.
    fn gap_along(&self, direction: Vector) -> Real {
        let highest = self.polytope1.support(direction);
        let lowest = self.polytope2.support(self.pos21.rotation * -direction);
        direction.dot(*self.pos12 * lowest - highest)
    }

    /// Searches the direction of least overlap, and adds the contacts there.
    fn search(&self, hint: Vector, raw: &mut RawManifold) {
        let polytopes = [self.polytope1, self.polytope2];
        let shapes = polytopes.map(Polytope::as_support);
        let polytopes = polytopes.map(Some);
        match closest_of_parts(self.pos12, shapes, polytopes, self.prediction, hint) {
            Closest::Apart(direction) => raw.local_n1 = direction,
            Closest::Near { point1, point2, normal, dist } => {
                // Flat shapes have no thickness, but rounding.
                let tolerance = TOLERANCE * self.thickness(normal).max(self.prediction);
                let best = self.best_face(normal, hint).filter(|best| best.gap >= dist - tolerance);
                // If the closest points are not on the face, they are better.
                if best.is_some_and(|best| self.add_face(&best, raw).is_some()) {
                    return;
                }
                raw.points.clear();
                if self.add_edges(normal, raw).is_some_and(|gap| gap >= dist - tolerance) {
                    return;
                }
                raw.points.clear();
                raw.local_n1 = normal;
                let unknown = PackedFeatureId::UNKNOWN;
                let local_p2 = self.pos21 * point2;
                raw.points.push(RawPoint::new(point1, local_p2, unknown, unknown, dist));
            }
        }
    }
}
