//! Two convex parts of any kind: closest points, then the features of the two that meet there.

use super::cut::closest_of_parts;
use super::part::Part;
use crate::base::closest::{Closest, extents};
use crate::base::facing::FacingParts;
use crate::base::parry_version::support_feature;
use crate::dim::collide::{Polytope, RawManifold, RawPoint, feature_contacts};
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::query::details::NormalConstraintsPair;
use parry::shape::{PackedFeatureId, PolygonalFeature, PolygonalFeatureMap, Shape, SupportMap};

/// Minimum additional depth, as a fraction of the parts' thickness, of closest points that are a contact of
/// their own beside those of the features.
const DEPTH_GAIN_RATIO_MIN: Real = 0.01;
/// A normal that was limited by neighbours may show overlaps of far ends of the parts. Points that are deeper
/// than the true overlap by this factor are rejected.
const DEPTH_RATIO_MAX: Real = 5.0;

/// A part without its rounding.
#[derive(Copy, Clone)]
pub(super) struct Core<'a> {
    /// The part, with its rounding.
    part: &'a dyn Shape,
    /// The sharp shape.
    pub shape: &'a dyn PolygonalFeatureMap,
    /// Thickness of the layer around it (length units).
    pub radius: Real,
}

impl<'a> Core<'a> {
    /// The core of a part; `None` if it has no usable faces and edges.
    pub fn of(part: &Part<'a>) -> Option<Self> {
        let (shape, radius) = part.shape.as_polygonal_feature_map()?;
        Some(Self { part: part.shape, shape, radius })
    }
}

/// Computes the contacts of two parts into `raw`, whose `local_n1` is the normal of last time, or zero.
pub(super) fn support_manifold(
    pos12: &Pose,
    parts: [&Part<'_>; 2],
    cores: [Core<'_>; 2],
    prediction: Real,
    raw: &mut RawManifold,
) {
    let [core1, core2] = cores;
    let radius = core1.radius + core2.radius;
    let polytopes = cores.map(|core| Polytope::of(core.part).map(|(polytope, _)| polytope));
    let polytopes = polytopes.each_ref().map(Option::as_ref);
    let shapes = cores.map(|core| core.shape as &dyn SupportMap);
    let found = closest_of_parts(pos12, shapes, polytopes, prediction + radius, raw.local_n1);
    let (point1, point2, normal, dist) = match found {
        Closest::Apart(direction) => {
            raw.local_n1 = direction;
            return;
        }
        Closest::Near { point1, point2, normal, dist } => (point1, point2, normal, dist),
    };
    let mut local_n1 = normal;
    let mut local_n2 = pos12.rotation.inverse() * -normal;
    let constraints = (parts[0].constraints, parts[1].constraints);
    raw.local_n1 = normal;
    if !constraints.project_local_normals(pos12, &mut local_n1, &mut local_n2) {
        return;
    }
    let point2 = pos12.inverse_transform_point(point2);
    let (normals, points) = ([local_n1, local_n2], [point1, point2]);
    let is_bent = local_n1 != normal;
    if is_bent {
        add_features(pos12, cores, normals, points, raw);
        raw.points.retain(|point| point.dist >= DEPTH_RATIO_MAX * dist.min(0.0));
    } else {
        let shapes = cores.map(|core| core.part);
        let sharp = cores.map(|core| core.shape);
        feature_contacts(pos12, &FacingParts { shapes, cores: sharp, normals, points }, raw);
        add_closest(pos12, cores, [point1, point2], dist, raw);
    }
    thicken(cores, [local_n1, local_n2], raw);
}

/// Computes the contacts of two parts along a unit vector of the first frame, from the first to the second.
/// The direction need not be the best separation.
pub(super) fn contacts_along(
    pos12: &Pose,
    cores: [Core<'_>; 2],
    direction: Vector,
    raw: &mut RawManifold,
) {
    let normals = [direction, pos12.rotation.inverse() * -direction];
    let point = |side: usize| cores[side].shape.local_support_point(normals[side]);
    add_features(pos12, cores, normals, [point(0), point(1)], raw);
    thicken(cores, normals, raw);
}

/// Adds the contacts of the features at two points, each in the frame of its part. The direction need not be
/// that of the closest points.
fn add_features(
    pos12: &Pose,
    [core1, core2]: [Core<'_>; 2],
    [normal1, normal2]: [Vector; 2],
    [point1, point2]: [Vector; 2],
    raw: &mut RawManifold,
) {
    let (mut feature1, mut feature2) = (PolygonalFeature::default(), PolygonalFeature::default());
    support_feature(core1.shape, normal1, point1, &mut feature1);
    support_feature(core2.shape, normal2, point2, &mut feature2);
    let pos21 = pos12.inverse();
    PolygonalFeature::contacts(pos12, &pos21, normal1, normal2, &feature1, &feature2, raw, false);
}

/// Puts the layers of the parts around their cores.
fn thicken([core1, core2]: [Core<'_>; 2], normals: [Vector; 2], raw: &mut RawManifold) {
    [raw.local_n1, raw.local_n2] = normals;
    for point in &mut raw.points {
        point.local_p1 += normals[0] * core1.radius;
        point.local_p2 += normals[1] * core2.radius;
        point.dist -= core1.radius + core2.radius;
    }
}

/// Adds the closest points, whose features are not known, if the features have missed them.
fn add_closest(
    pos12: &Pose,
    [core1, core2]: [Core<'_>; 2],
    [point1, point2]: [Vector; 2],
    dist: Real,
    raw: &mut RawManifold,
) {
    let deepest = raw.points.iter().map(|point| point.dist).fold(Real::INFINITY, Real::min);
    let is_needed = if DIM == 2 {
        raw.points.is_empty() // Two points are the maximum.
    } else {
        let thickness = extents(pos12, core1.shape, core2.shape, raw.local_n1).thickness;
        dist < deepest - DEPTH_GAIN_RATIO_MIN * thickness
    };
    if is_needed {
        let unknown = PackedFeatureId::UNKNOWN;
        raw.points.push(RawPoint::new(point1, point2, unknown, unknown, dist));
    }
}
