//! Ray casts.

use super::filter::QueryFilter;
use super::view::QueryView;
use crate::base::bvh::SlabProbe;
use crate::base::tasks::Tasks;
use crate::collide::{intersection, time_of_impact};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::{Collider, ColliderHandle};
use parry::query::{Ray, RayIntersection};
use parry::shape::Shape;

/// Smallest number of rays that justifies a transfer to another thread.
const RAYS_PER_TASK: usize = 64;

/// The probe of a ray for box tests.
fn slabs(ray: &Ray) -> SlabProbe {
    SlabProbe::new(ray.origin, ray.dir, Vector::ZERO)
}

/// A ray whose direction can be squared, with the limit of its times.
#[derive(Copy, Clone)]
struct SoundRay {
    ray: Ray,
    limit: Real,
    /// The time of the given ray is that of this one divided by `scale`.
    scale: Real,
}

impl SoundRay {
    /// `None` for an invalid ray or limit.
    fn new(ray: &Ray, max_time_of_impact: Real) -> Option<Self> {
        let is_sound = ray.origin.is_finite() && ray.dir.is_finite() && max_time_of_impact >= 0.0;
        let size = ray.dir.abs().max_element();
        let is_usual = ray.dir.length_squared().is_normal() || size == 0.0;
        let scale = if is_usual { 1.0 } else { size };
        let limit = (max_time_of_impact * scale).min(Real::MAX);
        // Dividing twice keeps the quotient of the smallest numbers finite.
        let dir = if is_usual { ray.dir } else { ray.dir / scale.sqrt() / scale.sqrt() };
        is_sound.then_some(Self { ray: Ray::new(ray.origin, dir), limit, scale })
    }

    /// The time of the given ray, if it is a number.
    fn time(&self, time: Real) -> Option<Real> {
        Some(time / self.scale).filter(|time| time.is_finite())
    }

    fn hit(&self, hit: RayIntersection) -> Option<RayIntersection> {
        Some(RayIntersection { time_of_impact: self.time(hit.time_of_impact)?, ..hit })
    }
}

/// The hit of a ray on one shape at a pose, without a collider.
///
/// The parameters and the result are those of [`QueryView::cast_ray_and_get_normal`]. `None` also if the ray
/// or the limit is invalid. The methods of the shape itself are the geometry library's, which miss the inside
/// of oriented meshes and rays without direction.
///
/// ```
/// # use rapier3d::prelude::*;
/// let ray = Ray::new(Vector::new(0.0, 5.0, 0.0), -Vector::Y);
/// let hit = cast_ray_on_shape(&Ball::new(1.0), &Pose::IDENTITY, &ray, 100.0, true);
/// assert_eq!(hit.map(|hit| hit.time_of_impact), Some(4.0));
/// ```
pub fn cast_ray_on_shape(
    shape: &dyn Shape,
    pose: &Pose,
    ray: &Ray,
    max_time_of_impact: Real,
    solid: bool,
) -> Option<RayIntersection> {
    let sound = SoundRay::new(ray, max_time_of_impact)?;
    sound.hit(intersection(shape, pose, &sound.ray, sound.limit, solid)?)
}

impl<'a> QueryView<'a> {
    /// The first collider that a ray hits, and the time of the hit.
    ///
    /// The time is in units of the ray's direction: the point is `ray.origin + ray.dir * time`. Hits after
    /// `max_time_of_impact` are ignored. If `solid` is `true`, a ray that starts inside a collider hits it at
    /// time 0. Otherwise colliders are hollow, and the ray hits the surface from within. A ray without a
    /// direction (zero) is a point: with `solid` it hits the collider that contains it, at time 0.
    pub fn cast_ray(
        &self,
        ray: &Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, Real)> {
        let sound = SoundRay::new(ray, max_time_of_impact)?;
        self.first_hit(&sound, |collider| {
            let (shape, pose) = (collider.shape(), collider.position());
            let time = time_of_impact(shape, pose, &sound.ray, sound.limit, solid)?;
            Some((time, sound.time(time)?))
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
        let sound = SoundRay::new(ray, max_time_of_impact)?;
        self.first_hit(&sound, |collider| {
            let (shape, pose) = (collider.shape(), collider.position());
            let hit = intersection(shape, pose, &sound.ray, sound.limit, solid)?;
            Some((hit.time_of_impact, sound.hit(hit)?))
        })
    }

    /// The first hit collider, for the times that `time_of_impact` returns for each.
    fn first_hit<T>(
        &self,
        sound: &SoundRay,
        time_of_impact: impl Fn(&Collider) -> Option<(Real, T)>,
    ) -> Option<(ColliderHandle, T)> {
        self.nearest([0.0, sound.limit], &slabs(&sound.ray), time_of_impact)
    }

    /// All colliders that a ray hits, each with its first hit, in no particular order.
    pub fn intersect_ray(
        self,
        ray: Ray,
        max_time_of_impact: Real,
        solid: bool,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider, RayIntersection)> {
        SoundRay::new(&ray, max_time_of_impact).into_iter().flat_map(move |sound| {
            let SoundRay { ray, limit, .. } = sound;
            self.candidates(slabs(&ray), limit).filter_map(move |(handle, collider)| {
                let (shape, pose) = (collider.shape(), collider.position());
                let hit = intersection(shape, pose, &ray, limit, solid)?;
                Some((handle, collider, sound.hit(hit)?))
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
