//! Sweep: straight motion until an obstacle.
//!
//! Conservative advancement with separating planes (B. Mirtich 1996, "Impulse-based Dynamic Simulation of
//! Rigid Body Systems"). The manifold of two convex parts has a normal along which they are a gap apart.
//! While one of them moves by `displacement`, that gap shrinks by at most `-displacement·n`. The path is free
//! until the gap of some plane would be used up; there the contacts are recomputed. Along a floor no gap
//! shrinks, and one evaluation is sufficient. Support and sweep use the same contacts, so the two never
//! contradict each other. A search for the time of impact alone would sometimes find a floor in the path of a
//! walking character.

use super::obstacles::Obstacles;
use super::planes::Plane;
use super::resolved::ResolvedSettings;
use crate::dim::math::{Pose, Real, Vector};

/// A motion along a plane at less than this sine passes it.
const SINE_MIN: Real = 1.0e-4;
/// Largest number of contact computations on a piece of the path.
const EVALUATIONS_MAX: usize = 32;
/// A path is divided into pieces of the shape's thickness, so that only near obstacles are evaluated, up to
/// this number.
const PIECES_MAX: Real = 32.0;

/// Result of a sweep.
pub(super) struct Swept {
    /// Fraction of the translation.
    pub fraction: Real,
    /// The obstacle at this pose.
    pub hit: Option<Plane>,
}

/// A sweep: from a pose along a path, up to a distance of `within`.
#[derive(Copy, Clone)]
struct Sweep<'a> {
    pose: &'a Pose,
    displacement: Vector,
    length: Real,
    within: Real,
    settings: &'a ResolvedSettings,
}

impl Sweep<'_> {
    fn pose_at(&self, time: Real) -> Pose {
        Pose::from_parts(self.pose.translation + self.displacement * time, self.pose.rotation)
    }

    /// Length by which a translation by the whole path shortens the gap of a plane.
    fn approach(&self, plane: &Plane) -> Real {
        -self.displacement.dot(plane.normal)
    }

    /// The plane whose gap is used up first, and when, if all normals stay.
    fn first_of(&self, planes: &[Plane], time: Real) -> Option<(Real, Plane)> {
        let approached =
            planes.iter().filter(|plane| self.approach(plane) > SINE_MIN * self.length);
        let times = approached.map(|plane| {
            let room = (plane.gap - self.within).max(0.0);
            (time + room / self.approach(plane), plane)
        });
        let (time, plane) = times.min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((time, plane.clone()))
    }
}

impl Obstacles<'_> {
    /// Moves along `displacement` until the gap to an obstacle has become the offset.
    ///
    /// The sweep stops at `within` less than the offset, and is moved back. An obstacle along the path at the
    /// offset itself is then no hit, independent of rounding.
    pub fn sweep(
        &mut self,
        pose: &Pose,
        displacement: Vector,
        within: Real,
        settings: &ResolvedSettings,
    ) -> Swept {
        let length = displacement.length();
        let free = Swept { fraction: 1.0, hit: None };
        if length == 0.0 {
            return free;
        }
        let sweep = Sweep { pose, displacement, length, within, settings };
        let piece =
            (2.0 * settings.half_thickness).max(4.0 * settings.offset).max(length / PIECES_MAX);
        let mut time: Real = 0.0;
        loop {
            let end = (time + piece / length).min(1.0);
            if let Some((time, plane)) = self.first_plane(&sweep, time, end) {
                let back = (settings.offset - within) / sweep.approach(&plane);
                return Swept { fraction: (time - back).max(0.0), hit: Some(plane) };
            }
            time = end;
            if time >= 1.0 {
                return free;
            }
        }
    }

    /// The first time in `time..end` when a plane is as close as `within`, and the plane.
    ///
    /// Contacts that are searched from afar may be planes that separate two parts without being closest to
    /// them. Before such a plane ends the path, contacts are computed at a small distance, where only real
    /// ones exist.
    fn first_plane(&mut self, sweep: &Sweep<'_>, time: Real, end: Real) -> Option<(Real, Plane)> {
        let (mut time, mut planes) = (time, Vec::new());
        let (near, tolerance) = (sweep.settings.reach(), sweep.settings.tolerance);
        let mut reach = sweep.within + (end - time) * sweep.length + tolerance;
        let mut first = None;
        for _ in 0..EVALUATIONS_MAX {
            self.near(&sweep.pose_at(time), reach, sweep.settings, &mut planes);
            let horizon = time + (reach - sweep.within) / sweep.length;
            first = sweep.first_of(&planes, time).filter(|&(then, _)| then < horizon.min(end));
            let then = first.as_ref().map_or(horizon, |&(then, _)| then);
            let is_stalled = (then - time) * sweep.length <= 0.5 * tolerance;
            if is_stalled && reach <= near {
                break;
            }
            if is_stalled {
                reach = (0.25 * reach).max(near);
                continue;
            }
            if then >= end {
                return None;
            }
            time = then;
            reach = (2.0 * reach).min(sweep.within + (end - time) * sweep.length + tolerance);
            reach = reach.max(near);
        }
        first
    }
}
