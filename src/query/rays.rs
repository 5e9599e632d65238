//! Rays: what do they hit?

use super::filter::QueryFilter;
use super::view::QueryView;
use crate::base::tasks::Tasks;
use crate::dim::math::{DIM, Real, Vector};
use crate::model::collider::{Collider, ColliderHandle};
use parry::query::{Ray, RayIntersection};

/// Rays that are worth handing over to another thread together.
const RAYS_PER_TASK: usize = 64;

/// A ray as boxes see it.
#[derive(Copy, Clone)]
pub(super) struct Slabs {
    origin: Vector,
    inv_dir: Vector,
}

impl Slabs {
    pub fn of(ray: &Ray) -> Self {
        // A direction of no length along an axis takes for ever, and yet not infinitely long: zero times that
        // is to be zero.
        let mut inv_dir = ray.dir;
        for axis in 0..DIM {
            let dir = ray.dir[axis];
            inv_dir[axis] = if dir.abs() > 1.0 / Real::MAX { 1.0 / dir } else { Real::MAX };
        }
        Self { origin: ray.origin, inv_dir }
    }

    /// When the ray enters a box: zero if it begins inside, infinity if not before `limit`.
    ///
    /// The end is late by the rounding errors of both (Ize, "Robust BVH Ray Traversal", JCGT 2013): a ray along a face is not
    /// to miss the box.
    #[inline]
    pub fn entry(&self, mins: Vector, maxs: Vector, limit: Real) -> Real {
        let (t1, t2) = ((mins - self.origin) * self.inv_dir, (maxs - self.origin) * self.inv_dir);
        let start = t1.min(t2).max_element().max(0.0);
        let end = t1.max(t2).min_element() * (1.0 + 4.0 * Real::EPSILON);
        if start <= end && start <= limit { start } else { Real::INFINITY }
    }

    /// When the ray has left a box: zero if it never enters.
    #[inline]
    pub fn exit(&self, mins: Vector, maxs: Vector) -> Real {
        let (t1, t2) = ((mins - self.origin) * self.inv_dir, (maxs - self.origin) * self.inv_dir);
        (t1.max(t2).min_element() * (1.0 + 4.0 * Real::EPSILON)).max(0.0)
    }
}

/// The limit of a question that has an answer: neither the ray nor the limit is nonsense.
fn sound_limit(ray: &Ray, max_time_of_impact: Real) -> Option<Real> {
    let is_sound = ray.origin.is_finite() && ray.dir.is_finite() && ray.dir.length_squared() > 0.0;
    (is_sound && max_time_of_impact >= 0.0).then_some(max_time_of_impact.min(Real::MAX))
}

impl<'a> QueryView<'a> {
    /// The first collider that a ray hits, and when.
    ///
    /// The time is in units of the ray's direction: the point is `ray.origin + ray.dir * time`, and times beyond
    /// `max_time_of_impact` do not count. A ray that begins inside a `solid` collider hits it at time 0; one that is
    /// not solid is hollow, and hit from within.
    pub fn cast_ray(
        &self,
        ray: &Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, Real)> {
        let limit = sound_limit(ray, max_time_of_impact)?;
        let slabs = Slabs::of(ray);
        self.nearest(
            limit,
            |node, reach| slabs.entry(node.mins(), node.maxs(), reach),
            |collider| {
                let time = time_of_impact(collider, ray, limit, solid)?;
                Some((time, time))
            },
        )
    }

    /// The same, with the normal of the surface (unit length, world space, zero inside of a solid collider) and
    /// the feature that was hit.
    pub fn cast_ray_and_get_normal(
        &self,
        ray: &Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, RayIntersection)> {
        let limit = sound_limit(ray, max_time_of_impact)?;
        let slabs = Slabs::of(ray);
        self.nearest(
            limit,
            |node, reach| slabs.entry(node.mins(), node.maxs(), reach),
            |collider| {
                let hit = intersection(collider, ray, limit, solid)?;
                Some((hit.time_of_impact, hit))
            },
        )
    }

    /// All colliders that a ray hits, each with its first hit, in no particular order.
    pub fn intersect_ray(
        self,
        ray: Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider, RayIntersection)> {
        sound_limit(&ray, max_time_of_impact).into_iter().flat_map(move |limit| {
            let slabs = Slabs::of(&ray);
            let hits =
                self.candidates(move |node| slabs.entry(node.mins(), node.maxs(), limit) <= limit);
            hits.filter_map(move |(handle, collider)| {
                Some((handle, collider, intersection(collider, &ray, limit, solid)?))
            })
        })
    }

    /// [`Self::cast_ray`] for many rays: the answers, in the order of the rays.
    ///
    /// With the feature `parallel` on the threads of the pool in which the caller runs, unless the filter has a
    /// predicate, which may not be fit for several threads.
    pub fn cast_rays(
        &self,
        rays: &[Ray],
        max_time_of_impact: Real,
        solid: bool,
    ) -> Vec<Option<(ColliderHandle, Real)>> {
        let cast = |view: &QueryView<'_>, ray| view.cast_ray(ray, max_time_of_impact, solid);
        if self.filter.predicate.is_some() {
            return rays.iter().map(|ray| cast(self, ray)).collect();
        }
        let (trees, dispatcher, colliders) = (self.trees(), self.dispatcher, self.colliders);
        let QueryFilter { flags, groups, exclude_collider, exclude_rigid_body, .. } = self.filter;
        let mut answers = vec![None; rays.len()];
        Tasks::current().par_fill(&mut answers, RAYS_PER_TASK, |index| {
            let predicate = None;
            let filter =
                QueryFilter { flags, groups, exclude_collider, exclude_rigid_body, predicate };
            cast(&QueryView::new(trees, dispatcher, colliders, filter), &rays[index])
        });
        answers
    }
}

fn time_of_impact(collider: &Collider, ray: &Ray, limit: Real, solid: bool) -> Option<Real> {
    if solid {
        return collider.shape().cast_ray(collider.position(), ray, limit, solid);
    }
    // parry's answer without a normal is wrong for hollow boxes whose wall is beyond the limit: it is the
    // limit, where nothing is.
    intersection(collider, ray, limit, solid).map(|hit| hit.time_of_impact)
}

fn intersection(
    collider: &Collider,
    ray: &Ray,
    limit: Real,
    solid: bool,
) -> Option<RayIntersection> {
    collider.shape().cast_ray_and_get_normal(collider.position(), ray, limit, solid)
}
