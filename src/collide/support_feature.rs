//! The feature of a convex shape that meets a plane: the corners of a face, an edge or a point.

use super::part::Part;
use super::support::Core;
use crate::base::feature;
use crate::base::parry_version::support_feature;
use crate::dim::collide::Polytope;
use crate::dim::math::{Real, Vector};
use arrayvec::ArrayVec;
use parry::shape::{PackedFeatureId, PolygonalFeature, Shape};

/// Largest number of vertices of a support feature. Supported faces have no more.
pub(super) const SUPPORT_VERTICES_MAX: usize = 32;

/// A point of the shape, in its frame.
#[derive(Copy, Clone)]
pub(super) struct SupportVertex {
    pub point: Vector,
    pub feature: PackedFeatureId,
}

/// The support feature of a shape.
pub(super) struct SupportFeature {
    pub vertices: ArrayVec<SupportVertex, SUPPORT_VERTICES_MAX>,
    /// Thickness of the shape perpendicular to the plane (length units).
    pub thickness: Real,
}

impl SupportFeature {
    /// The support feature of a shape. `down` is the unit vector from it to the plane. `None` if the feature
    /// is unknown, or if another point is lower than the vertices by more than `tolerance` (length units).
    pub fn of(shape: &dyn Shape, down: Vector, tolerance: Real) -> Option<Self> {
        debug_assert!((down.length_squared() - 1.0).abs() < 1.0e-2, "a unit vector");
        let mut vertices = ArrayVec::new();
        let mut add = |point, feature| {
            // No supported face has more vertices than the capacity.
            let _ = vertices.try_push(SupportVertex { point, feature });
        };
        if let Some(ball) = shape.as_ball() {
            add(down * ball.radius, feature::face(0));
        } else if let Some((polytope, radius)) = Polytope::of(shape) {
            polytope.for_each_corner_toward(down, |point, id| add(point + down * radius, id));
        } else {
            let Core { shape, radius, .. } = Core::of(&Part::whole(shape))?;
            let (lowest, mut feature) =
                (shape.local_support_point(down), PolygonalFeature::default());
            support_feature(shape, down, lowest, &mut feature);
            for index in 0..feature.num_vertices {
                add(feature.vertices[index] + down * radius, feature.vids[index]);
            }
        }
        let support = shape.as_support_map()?;
        let lowest = support.local_support_point(down).dot(down);
        let thickness = lowest - support.local_support_point(-down).dot(down);
        let depths = vertices.iter().map(|vertex: &SupportVertex| vertex.point.dot(down));
        let is_lowest = depths.fold(Real::NEG_INFINITY, Real::max) >= lowest - tolerance;
        is_lowest.then_some(Self { vertices, thickness })
    }
}
