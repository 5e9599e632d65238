//! Ray casts.

use super::filter::QueryFilter;
use super::hits::{intersection, time_of_impact};
use super::view::QueryView;
use crate::base::bvh::SlabProbe;
use crate::base::tasks::Tasks;
use crate::dim::math::{Real, Vector};
use crate::model::collider::{Collider, ColliderHandle};
use parry::query::{Ray, RayIntersection};

/// Smallest number of rays that justifies a transfer to another thread.
const RAYS_PER_TASK: usize = 64;

/// The probe of a ray for box tests.
fn slabs(ray: &Ray) -> SlabProbe {
    SlabProbe::new(ray.origin, ray.dir, Vector::ZERO)
}

/// The limit of a valid query; `None` for an invalid ray or limit.
fn sound_limit(ray: &Ray, max_time_of_impact: Real) -> Option<Real> {
    let is_sound = ray.origin.is_finite() && ray.dir.is_finite() && ray.dir.length_squared() > 0.0;
    (is_sound && max_time_of_impact >= 0.0).then_some(max_time_of_impact.min(Real::MAX))
}

impl<'a> QueryView<'a> {
    /// The first collider that a ray hits, and the time of the hit.
    ///
    /// The time is in units of the ray's direction: the point is `ray.origin + ray.dir * time`. Hits after
    /// `max_time_of_impact` are ignored. If `solid` is `true`, a ray that starts inside a collider hits it at
    /// time 0. Otherwise colliders are hollow, and the ray hits the surface from within.
    pub fn cast_ray(
        &self,
        ray: &Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, Real)> {
        self.first_hit(ray, max_time_of_impact, |collider, limit| {
            let time = time_of_impact(collider.shape(), collider.position(), ray, limit, solid)?;
            Some((time, time))
        })
    }

    /// [`Self::cast_ray`] with the normal of the surface (unit length, world space; zero for a start inside a
    /// solid collider) and the feature at the hit.
    pub fn cast_ray_and_get_normal(
        &self,
        ray: &Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, RayIntersection)> {
        self.first_hit(ray, max_time_of_impact, |collider, limit| {
            let hit = intersection(collider.shape(), collider.position(), ray, limit, solid)?;
            Some((hit.time_of_impact, hit))
        })
    }

    /// The first hit collider, for the times that `time_of_impact` returns for each, up to a limit.
    fn first_hit<T>(
        &self,
        ray: &Ray,
        max_time_of_impact: Real,
        time_of_impact: impl Fn(&Collider, Real) -> Option<(Real, T)>,
    ) -> Option<(ColliderHandle, T)> {
        let limit = sound_limit(ray, max_time_of_impact)?;
        self.nearest([0.0, limit], &slabs(ray), |collider| time_of_impact(collider, limit))
    }

    /// All colliders that a ray hits, each with its first hit, in no particular order.
    pub fn intersect_ray(
        self,
        ray: Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider, RayIntersection)> {
        sound_limit(&ray, max_time_of_impact).into_iter().flat_map(move |limit| {
            self.candidates(slabs(&ray), limit).filter_map(move |(handle, collider)| {
                let (shape, pose) = (collider.shape(), collider.position());
                Some((handle, collider, intersection(shape, pose, &ray, limit, solid)?))
            })
        })
    }

    /// The results of [`Self::cast_ray`] for many rays, in the order of the rays.
    ///
    /// With the feature `parallel` it runs on the threads of the caller's pool, unless the filter has a
    /// predicate, which may not be thread-safe.
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
        let answer = |index: usize| {
            let predicate = None;
            let filter =
                QueryFilter { flags, groups, exclude_collider, exclude_rigid_body, predicate };
            cast(&QueryView::new(trees, dispatcher, colliders, filter), &rays[index])
        };
        Tasks::open(|tasks| tasks.par_fill(&mut answers, RAYS_PER_TASK, answer));
        answers
    }
}
