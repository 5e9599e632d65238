//! Recovery from penetration of the offset: by a moving wall, a rising lift, or an edit of the pose.

use super::mover::Mover;
use super::planes::{Kind, Plane};
use super::polyhedron::{HalfSpace, least_violation};
use super::resolved::ResolvedSettings;
use crate::dim::math::Vector;

/// Contacts are recomputed after each push, because the push may reduce the distance to another obstacle.
const PUSHES_MAX: usize = 4;

impl Mover<'_> {
    /// Pushes the character out of everything that is closer than the offset, and leaves the planes around
    /// the place where it ends up.
    ///
    /// Each push is at most half of the shape's thickness, and every obstacle within that reach is included,
    /// so the shape is pushed through nothing.
    pub fn recover(&mut self) {
        self.update_planes(self.settings.reach());
        let step_up = self.settings.half_thickness.max(self.settings.offset);
        for _ in 0..PUSHES_MAX {
            if self.planes.iter().all(|plane| plane.excess(&self.settings) == 0.0) {
                return;
            }
            self.update_planes(self.settings.offset + step_up);
            let spaces: Vec<_> =
                self.planes.iter().map(|plane| escape(plane, &self.settings)).collect();
            let push: Vector = least_violation(&spaces);
            let length = push.length();
            self.moved += if length > step_up { push * (step_up / length) } else { push };
            self.update_planes(self.settings.reach());
            if length <= self.settings.nothing() {
                return;
            }
        }
    }
}

/// The half space in which the character is far enough from the obstacle behind a plane. Floors push straight
/// up, so that a lift does not displace the character horizontally.
fn escape(plane: &Plane, settings: &ResolvedSettings) -> HalfSpace {
    let excess = plane.excess(settings);
    if excess == 0.0 {
        HalfSpace { normal: plane.normal, at_least: plane.approach_limit(settings) }
    } else if plane.kind == Kind::Floor {
        HalfSpace { normal: settings.up, at_least: excess / plane.rise }
    } else {
        HalfSpace { normal: plane.normal, at_least: excess }
    }
}
