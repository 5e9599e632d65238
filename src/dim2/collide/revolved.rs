//! The features of shapes that are neither polygons nor round: in 2D the edges that the shapes have themselves.

use super::RawManifold;
use crate::dim::math::{Pose, Vector};
use parry::shape::{PolygonalFeature, PolygonalFeatureMap, Shape};

/// Two parts without their rounding, with the direction that each shows to the other, and a point there, in the frame of the part.
pub struct FacingParts<'a> {
    /// The parts, with or without rounding.
    pub shapes: [&'a dyn Shape; 2],
    /// The parts without rounding.
    pub cores: [&'a dyn PolygonalFeatureMap; 2],
    /// Unit vectors.
    pub normals: [Vector; 2],
    /// The closest points.
    pub points: [Vector; 2],
}

/// Adds the contacts of the features that two parts show each other.
pub fn feature_contacts(pos12: &Pose, parts: &FacingParts<'_>, raw: &mut RawManifold) {
    debug_assert!(parts.shapes.iter().all(|shape| shape.as_support_map().is_some()));
    let [one, other] = [0, 1].map(|side| {
        let mut feature = PolygonalFeature::default();
        let (normal, point) = (parts.normals[side], parts.points[side]);
        parts.cores[side].local_support_feature_toward(normal, point, &mut feature);
        feature
    });
    let ([normal1, normal2], pos21) = (parts.normals, pos12.inverse());
    PolygonalFeature::contacts(pos12, &pos21, normal1, normal2, &one, &other, raw, false);
}
