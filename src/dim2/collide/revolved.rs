//! The features of shapes that are neither polygons nor round: in 2D the edges that the shapes have
//! themselves.

use super::RawManifold;
use crate::base::facing::FacingParts;
use crate::dim::math::Pose;
use parry::shape::PolygonalFeature;

/// Adds the contacts of the features that two parts show each other.
pub fn feature_contacts(pos12: &Pose, parts: &FacingParts<'_>, raw: &mut RawManifold) {
    debug_assert!(parts.shapes.iter().all(|shape| shape.as_support_map().is_some()));
    let [one, other] = [0, 1].map(|side| parts.core_feature(side));
    let ([normal1, normal2], pos21) = (parts.normals, pos12.inverse());
    PolygonalFeature::contacts(pos12, &pos21, normal1, normal2, &one, &other, raw, false);
}
