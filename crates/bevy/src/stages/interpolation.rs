//! Between the fixed steps: transforms for the picture.
//!
//! A frame lies between two steps. It shows the pose at the same fraction between the last two states, one
//! step late, so that bodies move evenly at any frame rate. Systems in the fixed schedules read exact poses.

use super::pose_parts::PoseParts;
use crate::body::BodyState;
use crate::world::PhysicsWorld;
use bevy::ecs::change_detection::Mut;
use bevy::ecs::system::{Query, Res};
use bevy::time::{Fixed, Time};
use bevy::transform::components::Transform;

/// Before a step: writes the state of the last step.
pub(crate) fn restore_transforms(
    world: Res<PhysicsWorld>,
    mut bodies: Query<(Mut<Transform>, &mut BodyState)>,
) {
    for &(entity, _) in &world.awake {
        if let Ok((transform, mut state)) = bodies.get_mut(entity) {
            let current = state.current;
            state.show(&current, transform);
        }
    }
}

/// After the steps of a frame: writes transforms between the last two states.
pub(crate) fn interpolate_transforms(
    world: Res<PhysicsWorld>,
    time: Res<Time<Fixed>>,
    mut bodies: Query<(Mut<Transform>, &mut BodyState)>,
) {
    let fraction = time.overstep_fraction();
    for &(entity, _) in &world.awake {
        if let Ok((transform, mut state)) = bodies.get_mut(entity) {
            let between = state.between(fraction);
            state.show(&between, transform);
        }
    }
}

impl BodyState {
    /// Writes a pose to the body's transform. A translation or rotation that the user edited stays.
    fn show(&mut self, pose: &Transform, mut transform: Mut<Transform>) {
        let edited = PoseParts::of_difference(&transform, &self.shown);
        let parts = PoseParts::of_difference(&self.shown, pose).and(edited.complement());
        if parts.is_any() {
            parts.copy(pose, &mut transform);
            parts.copy(pose, &mut self.shown);
        }
    }

    /// The pose at a fraction between the last two states. A part without motion keeps its bits.
    fn between(&self, fraction: f32) -> Transform {
        let Self { previous, current, .. } = self;
        let mut between = *current;
        let moved = PoseParts::of_difference(previous, current);
        if moved.translation {
            between.translation = previous.translation.lerp(current.translation, fraction);
        }
        if moved.rotation {
            between.rotation = previous.rotation.slerp(current.rotation, fraction);
        }
        between
    }
}
