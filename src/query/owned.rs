//! Queries with separate trees: between steps, or without any step.

use super::filter::{QueryFilter, Traits};
use super::view::QueryView;
use crate::base::bvh::BoxProbe;
use crate::collide::Dispatcher;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::{Bookmark, Collider, ColliderHandle, ColliderSet};
use crate::model::tree::{BoxMargin, TreeKind, Trees, shape_box};
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::query::{
    NonlinearRigidMotion, PointProjection, Ray, RayIntersection, ShapeCastHit, ShapeCastOptions,
};
use parry::shape::{FeatureId, Shape};

/// Relative margin of boxes around shapes, as a fraction of the smallest half extent: more than rounding.
const MARGIN_FRACTION: Real = 0.01;

/// The same for flat boxes, as a fraction of their distance from the origin.
const POSITION_MARGIN_FRACTION: Real = 64.0 * Real::EPSILON;

/// Queries of a set of colliders: ray casts, nearest points, shape casts.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut colliders = ColliderSet::new();
/// let ball = colliders.insert(ColliderBuilder::ball(1.0));
///
/// let mut query_pipeline = QueryPipeline::new();
/// query_pipeline.update(&colliders);
/// let ray = Ray::new(Vector::new(0.0, 5.0, 0.0), -Vector::Y);
/// let hit = query_pipeline.cast_ray(&colliders, &ray, 100.0, true, QueryFilter::default());
/// assert_eq!(hit, Some((ball, 4.0)));
/// ```
///
/// It contains the colliders as of the last [`Self::update`], which processes insertions, removals, moves and
/// new shapes, without cost for other colliders. Only boxes are stored; results are computed from the current
/// collider. A world that queries after each step does not need this pipeline: see
/// [`BroadPhaseBvh::as_query_pipeline`](crate::model::tree::BroadPhaseBvh::as_query_pipeline).
#[derive(Clone, Default, Debug)]
pub struct QueryPipeline {
    trees: Trees,
    /// By slot.
    entries: Vec<Option<Entry>>,
    read: Bookmark,
}

/// Stored data of a collider.
#[derive(Copy, Clone, Debug)]
struct Entry {
    handle: ColliderHandle,
    traits: Traits,
}

impl QueryPipeline {
    /// An empty pipeline.
    pub fn new() -> Self {
        Self::default()
    }

    /// Updates the boxes from a set of colliders.
    ///
    /// A collider follows an edit of its body only with the next step: its pose changes then, and it is
    /// removed with a removed body.
    pub fn update(&mut self, colliders: &ColliderSet) {
        let (changed, end) = colliders.changed_since(self.read);
        match changed {
            Some([]) => {}
            Some(slots) => {
                // The journal may contain a collider several times.
                let mut slots = slots.to_vec();
                slots.sort_unstable();
                slots.dedup();
                slots.iter().for_each(|&slot| self.refresh(slot, colliders));
            }
            None => self.rebuild(colliders),
        }
        self.read = end;
        self.trees.tidy();
    }

    fn rebuild(&mut self, colliders: &ColliderSet) {
        *self = Self::default();
        for (handle, _) in colliders.iter() {
            self.refresh(handle.into_raw_parts().0, colliders);
        }
    }

    /// Updates the entry of a slot.
    fn refresh(&mut self, slot: u32, colliders: &ColliderSet) {
        if slot as usize >= self.entries.len() {
            self.entries.resize(slot as usize + 1, None);
        }
        let placed = colliders
            .at_slot(slot)
            .filter(|(_, collider)| collider.is_enabled())
            .and_then(|(handle, collider)| Some((handle, collider, whereabouts(collider)?)));
        let Some((handle, collider, aabb)) = placed else {
            self.entries[slot as usize] = None;
            self.trees.remove(slot);
            return;
        };
        let kind = TreeKind::of(collider.parent_type);
        self.trees.put(slot, kind, &aabb);
        self.entries[slot as usize] = Some(Entry { handle, traits: Traits::of(collider) });
    }

    /// A view of the colliders, which has more queries. `colliders` must be the set of the last
    /// [`Self::update`].
    pub fn view<'a>(
        &'a self,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryView<'a> {
        QueryView::new(self.trees.all(), &Dispatcher, colliders, filter)
    }
}

/// A box that a collider cannot leave without an update: around its pose, and its box in the broad phase.
fn whereabouts(collider: &Collider) -> Option<Aabb> {
    let tight = shape_box(collider.shape(), collider.position());
    let size = tight.mins.abs().max(tight.maxs.abs()).max_element();
    let reach =
        (MARGIN_FRACTION * tight.half_extents().min_element()).max(POSITION_MARGIN_FRACTION * size);
    let here = BoxMargin { reach, travel: Vector::ZERO }.needed(&tight);
    let kept = collider.proxy.tree.map(|_| collider.proxy.fat_aabb);
    match (here, kept) {
        (Some(here), Some(kept)) => Some(here.merged(&kept)),
        (here, kept) => here.or(kept),
    }
}

/// Calls back until the callback returns `false`.
fn for_each<T>(items: impl Iterator<Item = T>, mut callback: impl FnMut(T) -> bool) {
    for item in items {
        if !callback(item) {
            return;
        }
    }
}

/// Queries of the colliders that pass the filter. [`QueryView`] has methods of the same names.
impl QueryPipeline {
    /// The first collider that a ray hits, and the time of the hit: see [`QueryView::cast_ray`].
    pub fn cast_ray(
        &self,
        colliders: &ColliderSet,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, Real)> {
        self.view(colliders, filter).cast_ray(ray, max_toi, solid)
    }

    /// The first collider that a ray hits, with the time of the hit and the normal there: see
    /// [`QueryView::cast_ray_and_get_normal`].
    pub fn cast_ray_and_get_normal(
        &self,
        colliders: &ColliderSet,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, RayIntersection)> {
        self.view(colliders, filter).cast_ray_and_get_normal(ray, max_toi, solid)
    }

    /// The results of [`Self::cast_ray`] for many rays, in their order: see [`QueryView::cast_rays`].
    pub fn cast_rays(
        &self,
        colliders: &ColliderSet,
        rays: &[Ray],
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'_>,
    ) -> Vec<Option<(ColliderHandle, Real)>> {
        self.view(colliders, filter).cast_rays(rays, max_toi, solid)
    }

    /// Calls the callback for all colliders that a ray hits, in no particular order, until it returns
    /// `false`: see [`QueryView::intersect_ray`].
    pub fn intersections_with_ray(
        &self,
        colliders: &ColliderSet,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'_>,
        mut callback: impl FnMut(ColliderHandle, RayIntersection) -> bool,
    ) {
        let hits = self.view(colliders, filter).intersect_ray(*ray, max_toi, solid);
        for_each(hits, |(handle, _, hit)| callback(handle, hit));
    }

    /// The collider that is nearest to a point, and the nearest point on it: see
    /// [`QueryView::project_point`].
    pub fn project_point(
        &self,
        colliders: &ColliderSet,
        point: &Vector,
        solid: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, PointProjection)> {
        self.view(colliders, filter).project_point(*point, Real::MAX, solid)
    }

    /// The collider whose surface is nearest to a point, the nearest point on it and the feature there: see
    /// [`QueryView::project_point_and_get_feature`].
    pub fn project_point_and_get_feature(
        &self,
        colliders: &ColliderSet,
        point: &Vector,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, PointProjection, FeatureId)> {
        self.view(colliders, filter).project_point_and_get_feature(*point, Real::MAX)
    }

    /// Calls the callback for all colliders that contain a point, in no particular order, until it returns
    /// `false`: see [`QueryView::intersect_point`].
    pub fn intersections_with_point(
        &self,
        colliders: &ColliderSet,
        point: Vector,
        filter: QueryFilter<'_>,
        mut callback: impl FnMut(ColliderHandle) -> bool,
    ) {
        let around = self.view(colliders, filter).intersect_point(point);
        for_each(around, |(handle, _)| callback(handle));
    }

    /// Calls the callback for all colliders whose boxes overlap a box, in no particular order, until it
    /// returns `false`.
    ///
    /// The stored boxes are larger than the colliders: after a step, by a tenth of their size and ahead of
    /// their motion. The filter's predicate is not called, because it requires access to the colliders;
    /// [`QueryView::intersect_aabb_conservative`] calls the predicate.
    pub fn colliders_with_aabb_intersecting_aabb(
        &self,
        aabb: &Aabb,
        filter: QueryFilter<'_>,
        callback: impl FnMut(ColliderHandle) -> bool,
    ) {
        let trees = self.trees.all().into_iter();
        let slots = trees.flat_map(|tree| tree.leaves(BoxProbe(*aabb), Real::MAX));
        let found = slots.filter_map(|slot| {
            let entry = self.entries.get(slot as usize)?.as_ref()?;
            filter.test_traits(entry.handle, &entry.traits).then_some(entry.handle)
        });
        for_each(found, callback);
    }

    /// Any collider that a shape intersects.
    pub fn intersection_with_shape(
        &self,
        colliders: &ColliderSet,
        shape_pos: &Pose,
        shape: &dyn Shape,
        filter: QueryFilter<'_>,
    ) -> Option<ColliderHandle> {
        let mut found = self.view(colliders, filter).intersect_shape(*shape_pos, shape);
        found.next().map(|(handle, _)| handle)
    }

    /// Calls the callback for all colliders that a shape intersects, in no particular order, until it returns
    /// `false`: see [`QueryView::intersect_shape`].
    pub fn intersections_with_shape(
        &self,
        colliders: &ColliderSet,
        shape_pos: &Pose,
        shape: &dyn Shape,
        filter: QueryFilter<'_>,
        mut callback: impl FnMut(ColliderHandle) -> bool,
    ) {
        let found = self.view(colliders, filter).intersect_shape(*shape_pos, shape);
        for_each(found, |(handle, _)| callback(handle));
    }

    /// The first collider that a shape hits at constant velocity, without rotation: see
    /// [`QueryView::cast_shape`].
    ///
    /// With `stop_at_penetration`, a shape that starts inside a collider hits it at time 0. Otherwise it hits
    /// only if it moves deeper.
    #[expect(clippy::too_many_arguments, reason = "the documented parameters")]
    pub fn cast_shape(
        &self,
        colliders: &ColliderSet,
        shape_pos: &Pose,
        shape_vel: &Vector,
        shape: &dyn Shape,
        max_toi: Real,
        stop_at_penetration: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        let options = ShapeCastOptions {
            max_time_of_impact: max_toi,
            stop_at_penetration,
            ..ShapeCastOptions::default()
        };
        self.view(colliders, filter).cast_shape(shape_pos, *shape_vel, shape, options)
    }

    /// The first collider that a shape hits between two times of a motion with rotation: see
    /// [`QueryView::cast_shape_nonlinear`].
    #[expect(clippy::too_many_arguments, reason = "those of `cast_shape`, and a time more")]
    pub fn cast_shape_nonlinear(
        &self,
        colliders: &ColliderSet,
        shape_motion: &NonlinearRigidMotion,
        shape: &dyn Shape,
        start_time: Real,
        end_time: Real,
        stop_at_penetration: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        let view = self.view(colliders, filter);
        view.cast_shape_nonlinear(shape_motion, shape, start_time, end_time, stop_at_penetration)
    }
}
