//! The features of shapes of revolution: cylinders and cones.
//!
//! A cap is flat, a side is a line as seen from any direction, and rim and apex are points. A direction
//! selects the cap or the side if it is within [`FEATURE_SINE`] of their normal. Contacts farther away along
//! a feature with a larger angle are out of reach anyway. All other directions show a point of the rim or the
//! apex, where the closest points of the two shapes are the only contact.
//!
//! The alternative selects a cap or a side for every direction, up to 60° from its normal. A rim on a line
//! then has four contacts within millimetres of each other, and one in the next step with other features. A
//! pile of 250 cylinders never came to rest with it.

use super::RawManifold;
use crate::base::facing::FacingParts;
use crate::base::feature;
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::{PolygonalFeature, Shape, TypedShape};

/// Sine of the largest angle (11.5°) between a direction and the normal of a feature that it shows.
const FEATURE_SINE: Real = 0.2;
/// The same as a cosine.
const FEATURE_COSINE: Real = 0.98;
/// Tilt (sine of 0.6°) up to which a cap lies flat: the azimuth of its lowest point is rounding then.
const FLAT_CAP_SINE_MAX: Real = 0.01;
/// Least number of contacts of a flat cap, if the four points of its rim do not miss the other shape.
const FLAT_CAP_POINTS_MIN: usize = 3;
/// Largest distance of equal contacts of a line, as a fraction of its length.
const POINT_DISTANCE_FRACTION_MAX: Real = 1.0e-3;

/// Half of the outline of a shape of revolution about the second axis.
#[derive(Copy, Clone)]
struct Outline {
    radius: Real,
    half_height: Real,
    is_cone: bool,
}

impl Outline {
    /// The outline of a cylinder or cone, without its rounding.
    fn of(shape: &dyn Shape) -> Option<Self> {
        let (radius, half_height, is_cone) = match shape.as_typed_shape() {
            TypedShape::Cylinder(one) => (one.radius, one.half_height, false),
            TypedShape::RoundCylinder(one) => {
                (one.inner_shape.radius, one.inner_shape.half_height, false)
            }
            TypedShape::Cone(one) => (one.radius, one.half_height, true),
            TypedShape::RoundCone(one) => {
                (one.inner_shape.radius, one.inner_shape.half_height, true)
            }
            _ => return None,
        };
        // A cone without height is a disc.
        Some(Self { radius, half_height, is_cone: is_cone && half_height > 0.0 })
    }

    /// The feature that a unit vector shows; a single vertex for a rim or an apex. `hint` is a point of the
    /// cap that should be covered.
    fn feature(self, normal: Vector, hint: Vector) -> PolygonalFeature {
        let across = Vector::new(normal.x, 0.0, normal.z);
        let lateral = across.length();
        let has_cap = !self.is_cone || normal.y < 0.0;
        if has_cap && lateral < FEATURE_SINE {
            let azimuth = if lateral > FLAT_CAP_SINE_MAX { across } else { hint };
            return self.cap(normal.y, azimuth);
        }
        let apex = PolygonalFeature { num_vertices: 1, ..PolygonalFeature::default() };
        // The normal of the side of a flat cone is nearly its axis. Along the axis no side is the nearest.
        if lateral <= FLAT_CAP_SINE_MAX {
            return apex;
        }
        let lean = if self.is_cone { self.radius } else { 0.0 };
        let side = Vector::new(2.0 * self.half_height, lean, 0.0).normalize_or_zero();
        if lateral * side.x + normal.y * side.y > FEATURE_COSINE {
            return self.side(across / lateral);
        }
        apex
    }

    /// The line of the side along a horizontal direction.
    fn side(self, azimuth: Vector) -> PolygonalFeature {
        let rim = azimuth * self.radius;
        let top = if self.is_cone { Vector::ZERO } else { rim };
        let height = Vector::Y * self.half_height;
        PolygonalFeature {
            vertices: [rim - height, top + height, Vector::ZERO, Vector::ZERO],
            vids: [1, 11, 11, 11].map(feature::vertex),
            eids: [feature::edge(0); 4],
            fid: feature::face(0),
            num_vertices: 2,
        }
    }

    /// Four points of the rim of a cap, the first of which is in a horizontal direction.
    fn cap(self, up: Real, azimuth: Vector) -> PolygonalFeature {
        let one = Vector::new(azimuth.x, 0.0, azimuth.z).try_normalize().unwrap_or(Vector::X);
        let (one, other) = (one * self.radius, Vector::new(-one.z, 0.0, one.x) * self.radius);
        let height = Vector::Y * if up < 0.0 { -self.half_height } else { self.half_height };
        let first = if up < 0.0 { 0 } else { 10 };
        PolygonalFeature {
            vertices: [one, other, -one, -other].map(|corner| corner + height),
            vids: [1, 3, 5, 7].map(|id| feature::vertex(id + first)),
            eids: [2, 4, 6, 8].map(|id| feature::edge(id + first)),
            fid: feature::face(9 + first),
            num_vertices: 4,
        }
    }
}

/// Adds the contacts of the features that two parts show each other. There are none if one of the features is
/// a single point.
pub fn feature_contacts(pos12: &Pose, parts: &FacingParts<'_>, raw: &mut RawManifold) {
    let outlines = parts.shapes.map(Outline::of);
    // First with caps that do not turn as the closest points of two flat faces jump about.
    let features = facing_features(parts, outlines, [Vector::X; 2]);
    if features.iter().any(|feature| feature.num_vertices < 2) {
        return;
    }
    let has_cap = (0..2).any(|side| outlines[side].is_some() && features[side].num_vertices == 4);
    add_contacts(pos12, parts, features, raw);
    if has_cap && raw.points.len() < FLAT_CAP_POINTS_MIN {
        let mut hinted = RawManifold::new();
        add_contacts(pos12, parts, facing_features(parts, outlines, parts.points), &mut hinted);
        if hinted.points.len() > raw.points.len() {
            raw.points = hinted.points;
        }
    }
}

/// The features that two parts show each other. `hints` are points that caps should cover.
fn facing_features(
    parts: &FacingParts<'_>,
    outlines: [Option<Outline>; 2],
    hints: [Vector; 2],
) -> [PolygonalFeature; 2] {
    [0, 1].map(|side| match outlines[side] {
        Some(outline) => outline.feature(parts.normals[side], hints[side]),
        None => parts.core_feature(side),
    })
}

/// Adds the contacts of two features.
fn add_contacts(
    pos12: &Pose,
    parts: &FacingParts<'_>,
    [one, mut other]: [PolygonalFeature; 2],
    raw: &mut RawManifold,
) {
    let along = |line: &PolygonalFeature| line.vertices[1] - line.vertices[0];
    let lines = [&one, &other].map(|feature| feature.num_vertices == 2);
    // Lines that run against each other were not found to be parallel.
    if lines == [true; 2] && along(&one).dot(pos12.rotation * along(&other)) < 0.0 {
        other.vertices.swap(0, 1);
        other.vids.swap(0, 1);
    }
    let [normal1, normal2] = parts.normals;
    let pos21 = pos12.inverse();
    PolygonalFeature::contacts(pos12, &pos21, normal1, normal2, &one, &other, raw, false);
    match lines {
        [true, false] => remove_copies(raw, along(&one).length() * POINT_DISTANCE_FRACTION_MAX),
        [false, true] => remove_copies(raw, along(&other).length() * POINT_DISTANCE_FRACTION_MAX),
        _ => {}
    }
}

/// Removes contacts that are closer to an earlier one than a distance: a line is seen as two edges, there and
/// back.
fn remove_copies(raw: &mut RawManifold, distance: Real) {
    let points = core::mem::take(&mut raw.points);
    for point in points {
        let is_near = |other: &super::RawPoint| {
            (other.local_p1 - point.local_p1).length_squared() <= distance * distance
        };
        if !raw.points.iter().any(is_near) {
            raw.points.push(point);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::feature_contacts;
    use crate::base::facing::FacingParts;
    use crate::dim::collide::RawManifold;
    use crate::dim::math::{Pose, Real, Vector, rotation_from_angle};
    use parry::shape::{Cone, Cuboid, Cylinder, PolygonalFeatureMap, Shape};

    /// The contacts of the features that two shapes show each other along a direction of the first frame.
    fn contacts<A, B>(
        pos12: &Pose,
        one: &A,
        other: &B,
        normal: Vector,
        points: [Vector; 2],
    ) -> RawManifold
    where
        A: Shape + PolygonalFeatureMap,
        B: Shape + PolygonalFeatureMap,
    {
        let mut raw = RawManifold::new();
        let parts = FacingParts {
            shapes: [one, other],
            cores: [one, other],
            normals: [normal, pos12.rotation.inverse() * -normal],
            points,
        };
        feature_contacts(pos12, &parts, &mut raw);
        raw
    }

    /// Two cylinders that lie beside each other touch along a line, however each is turned about its axis or
    /// end for end. With one point, wherever rounding put it, they rocked on it.
    #[test]
    fn cylinders_side_by_side_touch_at_both_ends() {
        let cylinder = Cylinder::new(1.0, 0.3);
        for end_for_end in [0.0, core::f64::consts::PI as Real] {
            for spin in [0.0, 0.7, 2.0] {
                let rotation = rotation_from_angle(Vector::X * end_for_end)
                    * rotation_from_angle(Vector::Y * spin);
                let pos12 = Pose::from_parts(Vector::X * 0.59 + Vector::Y * 0.5, rotation);
                let raw = contacts(&pos12, &cylinder, &cylinder, Vector::X, [Vector::X * 0.3; 2]);
                let mut ends: Vec<_> = raw.points.iter().map(|point| point.local_p1.y).collect();
                ends.sort_by(Real::total_cmp);
                assert_eq!(ends.len(), 2, "turned by {end_for_end} and {spin}");
                assert!((ends[0] + 0.5).abs() < 1.0e-4 && (ends[1] - 1.0).abs() < 1.0e-4);
                assert!(raw.points.iter().all(|point| (point.dist + 0.01).abs() < 1.0e-4));
            }
        }
    }

    /// The side of a cylinder on a box has one contact at each end of the overlap, and not two.
    #[test]
    fn a_side_on_a_face_has_two_contacts() {
        let (cylinder, floor) = (Cylinder::new(1.0, 0.3), Cuboid::new(Vector::splat(0.6)));
        let pos12 = Pose::from_translation(Vector::X * 0.89);
        let raw = contacts(&pos12, &floor, &cylinder, Vector::X, [Vector::ZERO; 2]);
        let heights: Vec<_> = raw.points.iter().map(|point| point.local_p1.y).collect();
        assert_eq!(heights.len(), 2, "{heights:?}");
        assert!((heights[0] + heights[1]).abs() < 1.0e-5, "{heights:?}");
    }

    /// A cap that lies flat has the same contacts wherever rounding puts the closest points.
    #[test]
    fn a_flat_cap_does_not_turn() {
        let (cylinder, floor) = (Cylinder::new(0.5, 0.3), Cuboid::new(Vector::splat(2.0)));
        let pos12 = Pose::from_translation(Vector::Y * 2.49);
        let found = |angle: Real, tilt: Real| {
            let hint = Vector::new(0.3 * angle.cos(), -0.5, 0.3 * angle.sin());
            let normal = Vector::new(tilt * angle.cos(), 1.0, tilt * angle.sin()).normalize();
            let raw = contacts(&pos12, &floor, &cylinder, normal, [Vector::Y * 2.0, hint]);
            raw.points.iter().map(|point| point.local_p2).collect::<Vec<_>>()
        };
        let first = found(0.0, 0.0);
        assert_eq!(first.len(), 4);
        for step in 1..20 {
            let now = found(step as Real, 1.0e-3);
            assert_eq!(now.len(), 4);
            for (before, now) in first.iter().zip(&now) {
                assert!((before - now).length() < 2.0e-3, "moved from {before} to {now}");
            }
        }
    }

    /// A flat cone has a side whose normal is nearly the axis. Seen along the axis or nearly so it shows its
    /// apex, and no side without a direction.
    #[test]
    fn the_top_of_a_flat_cone_is_its_apex() {
        let floor = Cuboid::new(Vector::splat(2.0));
        for height in [0.001, 0.01, 0.03] {
            let cone = Cone::new(height, 0.4);
            let pos12 = Pose::from_translation(-Vector::Y * (2.0 + height));
            for tilt in [0.0, 1.0e-30, 1.0e-7, 1.0e-3, 0.03, 0.1] {
                let normal = Vector::new(tilt, -1.0, 0.0).normalize();
                let points = [-Vector::Y * 2.0, Vector::Y * height];
                let raw = contacts(&pos12, &floor, &cone, normal, points);
                let is_finite = |point: &crate::dim::collide::RawPoint| {
                    point.local_p1.is_finite() && point.local_p2.is_finite()
                };
                assert!(raw.points.iter().all(is_finite), "half height {height}, tilt {tilt}");
                let is_apex = tilt > 0.01 || raw.points.is_empty();
                assert!(is_apex, "half height {height}, tilt {tilt}: {}", raw.points.len());
            }
        }
    }

    /// Rims and apexes have no feature but themselves: the closest points are the contact.
    #[test]
    fn rims_and_apexes_are_points() {
        let (cylinder, cone) = (Cylinder::new(0.5, 0.3), Cone::new(0.5, 0.3));
        let floor = Cuboid::new(Vector::splat(2.0));
        for slope in [0.3, 0.5, 0.8, 1.0, 1.2] as [Real; 5] {
            let down = Vector::new(slope.sin(), -slope.cos(), 0.0);
            let turn = rotation_from_angle(Vector::Z * -slope);
            let pos12 = Pose::from_parts(Vector::Y * 2.5, turn);
            let seen = pos12.rotation.inverse() * -Vector::Y;
            if (seen - down).length() > 1.0e-3 {
                continue;
            }
            let points = [Vector::Y * 2.0, down];
            assert!(contacts(&pos12, &floor, &cylinder, Vector::Y, points).points.is_empty());
            assert!(contacts(&pos12, &floor, &cone, Vector::Y, points).points.is_empty());
        }
        let upside_down = Pose::from_parts(Vector::Y * 2.5, rotation_from_angle(Vector::X * 3.1));
        let points = [Vector::Y * 2.0, Vector::Y * 0.5];
        assert!(contacts(&upside_down, &floor, &cone, Vector::Y, points).points.is_empty());
    }
}
