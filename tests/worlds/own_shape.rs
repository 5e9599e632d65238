//! A user-defined shape: the engine uses its bounding box, and cannot save it.

use crate::rapier::parry::bounding_volume::{Aabb, BoundingSphere};
use crate::rapier::parry::mass_properties::MassProperties;
use crate::rapier::parry::query::{PointProjection, PointQuery, Ray, RayCast, RayIntersection};
use crate::rapier::parry::shape::{Ball, FeatureId, ShapeType, TypedShape};
use crate::rapier::prelude::*;

/// A ball with a type that the geometry library does not define.
#[derive(Clone)]
pub struct OwnShape(pub Ball);

impl RayCast for OwnShape {
    fn cast_local_ray_and_get_normal(
        &self,
        ray: &Ray,
        time_max: Real,
        solid: bool,
    ) -> Option<RayIntersection> {
        self.0.cast_local_ray_and_get_normal(ray, time_max, solid)
    }
}

impl PointQuery for OwnShape {
    fn project_local_point(&self, point: Vector, solid: bool) -> PointProjection {
        self.0.project_local_point(point, solid)
    }

    fn project_local_point_and_get_feature(&self, point: Vector) -> (PointProjection, FeatureId) {
        self.0.project_local_point_and_get_feature(point)
    }
}

impl Shape for OwnShape {
    fn compute_local_aabb(&self) -> Aabb {
        self.0.compute_local_aabb()
    }

    fn compute_local_bounding_sphere(&self) -> BoundingSphere {
        self.0.compute_local_bounding_sphere()
    }

    fn clone_dyn(&self) -> Box<dyn Shape> {
        Box::new(self.clone())
    }

    fn scale_dyn(&self, _: Vector, _: u32) -> Option<Box<dyn Shape>> {
        None
    }

    fn mass_properties(&self, density: Real) -> MassProperties {
        self.0.mass_properties(density)
    }

    fn shape_type(&self) -> ShapeType {
        ShapeType::Custom
    }

    fn as_typed_shape(&self) -> TypedShape<'_> {
        TypedShape::Custom(self)
    }

    fn ccd_thickness(&self) -> Real {
        self.0.ccd_thickness()
    }

    fn ccd_angular_thickness(&self) -> Real {
        self.0.ccd_angular_thickness()
    }
}
