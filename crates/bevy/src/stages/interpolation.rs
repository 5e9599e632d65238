//! Between the fixed steps: transforms for the picture.
//!
//! A frame lies between two steps. It shows the pose at the same fraction between the last two states, one
//! step late, so that bodies move evenly at any frame rate.

use super::pose_parts::PoseParts;
use crate::body::BodyState;
use crate::world::PhysicsWorld;
use bevy::ecs::system::{Query, Res};
use bevy::time::{Fixed, Time};
use bevy::transform::components::Transform;

/// Writes transforms between the last two steps. A translation or rotation that the user edited stays.
pub(crate) fn interpolate_transforms(
    world: Res<PhysicsWorld>,
    time: Res<Time<Fixed>>,
    mut bodies: Query<(&mut Transform, &mut BodyState)>,
) {
    let fraction = time.overstep_fraction();
    for &entity in &world.awake {
        let Ok((mut transform, mut state)) = bodies.get_mut(entity) else {
            continue;
        };
        let edited = PoseParts::of_difference(&transform, &state.shown);
        let moved = PoseParts::of_difference(&state.previous, &state.current);
        let parts = moved.and(edited.complement());
        if parts.is_any() {
            let between = between(&state.previous, &state.current, fraction);
            parts.copy(&between, &mut transform);
            parts.copy(&between, &mut state.shown);
        }
    }
}

fn between(previous: &Transform, current: &Transform, fraction: f32) -> Transform {
    Transform {
        translation: previous.translation.lerp(current.translation, fraction),
        rotation: previous.rotation.slerp(current.rotation, fraction),
        scale: current.scale,
    }
}
