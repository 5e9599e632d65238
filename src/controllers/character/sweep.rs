//! Going straight until something is in the way.
//!
//! Conservative advancement with separating planes (B. Mirtich 1996, "Impulse-based Dynamic Simulation of Rigid Body Systems"):
//! the manifold of two convex parts has a normal along which they are a gap apart, and while one of them moves by `way`, that gap
//! shrinks by no more than `-way·n`. So until the gap of some plane would be used up, the way is free; there the contacts are
//! computed again. Along a floor no gap shrinks, and one look is enough. Everything rests on the contacts that also hold the
//! character when it stands, so the two never contradict each other; a search for the time of impact alone would sometimes see a
//! floor in the way of who walks on it.

use super::obstacles::Obstacles;
use super::planes::Plane;
use super::resolved::ResolvedSettings;
use crate::dim::math::{Pose, Real, Vector};

/// Who goes along a plane at less than this sine goes past it.
const SINE_MIN: Real = 1.0e-4;
/// So often are contacts computed on a piece of the way.
const LOOKS_MAX: usize = 32;
/// A way is gone in pieces that are as long as the shape is thick, so that only what is near is looked at, or in so many.
const PIECES_MAX: Real = 32.0;

/// How far a sweep came.
pub(super) struct Swept {
    /// Share of the translation.
    pub fraction: Real,
    /// What was in the way, at this place.
    pub hit: Option<Plane>,
}

/// A sweep: from a pose along a way, up to a distance of `within`.
#[derive(Copy, Clone)]
struct Sweep<'a> {
    pose: &'a Pose,
    way: Vector,
    length: Real,
    within: Real,
    settings: &'a ResolvedSettings,
}

impl Sweep<'_> {
    fn pose_at(&self, time: Real) -> Pose {
        Pose::from_parts(self.pose.translation + self.way * time, self.pose.rotation)
    }

    /// Length by which a translation by the whole way shortens the gap of a plane.
    fn approach(&self, plane: &Plane) -> Real {
        -self.way.dot(plane.normal)
    }

    /// The plane whose gap is used up first, and when, if all normals stay.
    fn first_of(&self, planes: &[Plane], time: Real) -> Option<(Real, Plane)> {
        let in_the_way =
            planes.iter().filter(|plane| self.approach(plane) > SINE_MIN * self.length);
        let times = in_the_way.map(|plane| {
            let room = (plane.gap - self.within).max(0.0);
            (time + room / self.approach(plane), plane)
        });
        let (time, plane) = times.min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((time, plane.clone()))
    }
}

impl Obstacles<'_> {
    /// Moves along `way` until the gap to something that is in the way has become the offset.
    ///
    /// The sweep looks for what comes `within` less than the offset, and is taken back: what the character goes along at
    /// the offset itself is then no hit, however it is rounded.
    pub fn sweep(
        &mut self,
        pose: &Pose,
        way: Vector,
        within: Real,
        settings: &ResolvedSettings,
    ) -> Swept {
        let length = way.length();
        let free = Swept { fraction: 1.0, hit: None };
        if length == 0.0 {
            return free;
        }
        let sweep = Sweep { pose, way, length, within, settings };
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
    /// Contacts that are looked for from afar may be planes that separate two parts without being closest to them. Before such
    /// a plane ends the way, contacts are looked for from so near that only what is really there shows up.
    fn first_plane(&mut self, sweep: &Sweep<'_>, time: Real, end: Real) -> Option<(Real, Plane)> {
        let (mut time, mut planes) = (time, Vec::new());
        let (near, tolerance) = (sweep.settings.reach(), sweep.settings.tolerance);
        let mut reach = sweep.within + (end - time) * sweep.length + tolerance;
        let mut first = None;
        for _ in 0..LOOKS_MAX {
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
