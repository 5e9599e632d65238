//! Two convex parts that face each other.

use super::parry_version::support_feature;
use parry::math::Vector;
use parry::shape::{PolygonalFeature, PolygonalFeatureMap, Shape};

/// Two parts with the direction that each shows to the other, and a point there, in the frame of the part.
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

impl FacingParts<'_> {
    /// The feature that the core of one side has in its direction.
    pub fn core_feature(&self, side: usize) -> PolygonalFeature {
        let mut feature = PolygonalFeature::default();
        let (normal, point) = (self.normals[side], self.points[side]);
        support_feature(self.cores[side], normal, point, &mut feature);
        feature
    }
}
