//! The surroundings of the character: colliders that a query finds, as planes.

use super::hooks::HookContext;
use super::plane_pruning::prune_planes;
use super::planes::Plane;
use super::resolved::ResolvedSettings;
use super::touch::Touch;
use crate::base::wide::Simd;
use crate::collide::{ManifoldScratch, ShapePair, compute_manifolds};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::RigidBodyType;
use crate::model::collider::{Collider, ColliderHandle};
use crate::model::contact::ContactManifold;
use crate::query::{QueryFilter, QueryView};
use parry::bounding_volume::BoundingVolume;
use parry::query::Ray;
use parry::shape::Shape;
use smallvec::SmallVec;

type Manifolds = SmallVec<[ContactManifold; 1]>;

/// The obstacles of a character.
pub(super) struct Obstacles<'a> {
    pub queries: QueryView<'a>,
    pub shape: &'a dyn Shape,
    pub hook_context: Option<HookContext<'a>>,
    scratch: ManifoldScratch,
    manifolds: Manifolds,
}

/// A surface below a point.
pub(super) struct Surface {
    /// Unit normal, upwards.
    pub normal: Vector,
    /// Distance from the point.
    pub depth: Real,
    pub is_dynamic: bool,
}

impl<'a> Obstacles<'a> {
    pub fn new(
        queries: QueryView<'a>,
        shape: &'a dyn Shape,
        hook_context: Option<HookContext<'a>>,
    ) -> Self {
        let (scratch, manifolds) = (ManifoldScratch::default(), Manifolds::new());
        Self { queries, shape, hook_context, scratch, manifolds }
    }

    /// Returns whether the character can collide with this collider, independent of the contact point.
    pub fn may_meet(&self, handle: ColliderHandle, collider: &Collider) -> bool {
        let lets_meet = |hook_context: &HookContext<'_>| hook_context.lets_meet(handle, collider);
        !collider.is_sensor() && self.hook_context.as_ref().is_none_or(lets_meet)
    }

    /// All planes within `reach` of the shape, pruned.
    pub fn planes(
        &mut self,
        pose: &Pose,
        reach: Real,
        settings: &ResolvedSettings,
        out: &mut Vec<Plane>,
    ) {
        self.near(pose, reach, settings, out);
        prune_planes(out, settings);
    }

    /// All planes within `reach` of the shape.
    pub fn near(
        &mut self,
        pose: &Pose,
        reach: Real,
        settings: &ResolvedSettings,
        out: &mut Vec<Plane>,
    ) {
        out.clear();
        let around = self.shape.compute_aabb(pose).loosened(reach);
        let mut near: SmallVec<[(ColliderHandle, &Collider); 8]> =
            self.queries.intersect_aabb_conservative(around).collect();
        // The tree's order depends on its history.
        near.sort_unstable_by_key(|(handle, _)| handle.into_raw_parts().0);
        for (handle, collider) in near {
            if self.may_meet(handle, collider) {
                self.compute(collider, pose, reach, settings);
                for manifold in &mut self.manifolds {
                    // Hooks are called for touching obstacles; other obstacles block.
                    let is_touched = manifold.deepest_dist() <= settings.reach();
                    let is_solid =
                        |hooks: &HookContext<'_>| hooks.is_solid(handle, collider, manifold, pose);
                    if !is_touched || self.hook_context.as_ref().is_none_or(is_solid) {
                        let touch = Touch { handle, collider, pose, shape: self.shape };
                        out.extend(touch.plane(manifold, reach, settings));
                    }
                }
            }
        }
    }

    /// The surface below a point, no deeper than `depth`.
    pub fn surface_below(&self, point: Vector, up: Vector, depth: Real) -> Option<Surface> {
        let filter = self.queries.filter;
        let predicate = |handle, collider: &_| {
            filter.predicate.is_none_or(|passes| passes(handle, collider))
                && self.may_meet(handle, collider)
        };
        let filter = QueryFilter { predicate: Some(&predicate), ..filter };
        let ray = Ray::new(point, -up);
        let queries = self.queries.with_filter(filter);
        let (handle, hit) = queries.cast_ray_and_get_normal(&ray, depth, false)?;
        let is_dynamic = |collider: &Collider| collider.parent_type == Some(RigidBodyType::Dynamic);
        // Surfaces have two sides.
        let normal = if hit.normal.dot(up) < 0.0 { -hit.normal } else { hit.normal };
        let is_dynamic = self.queries.colliders.get(handle).is_some_and(is_dynamic);
        Some(Surface { normal, depth: hit.time_of_impact, is_dynamic })
    }

    fn compute(
        &mut self,
        collider: &Collider,
        pose: &Pose,
        reach: Real,
        settings: &ResolvedSettings,
    ) {
        let pair = ShapePair {
            pos12: collider.position().inv_mul(pose),
            shapes: [collider.shape(), self.shape],
            motion: Vector::ZERO,
            prediction: reach,
            step_height_tolerance: settings.tolerance,
            neighbors: [&[], &[]],
            simd: Simd::detect(),
        };
        compute_manifolds(&pair, &[], None, &mut self.scratch, &mut self.manifolds);
    }
}
