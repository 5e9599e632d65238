//! Before a fixed step: interpolated transforms return to the state of the last step.

use super::write_back::{has_pose_of, set_pose};
use crate::body::BodyState;
use crate::world::PhysicsWorld;
use bevy::ecs::system::{Query, Res};
use bevy::transform::components::Transform;

/// Systems in the fixed schedules read exact poses. A transform that the user edited stays.
pub(crate) fn restore_transforms(
    world: Res<PhysicsWorld>,
    mut bodies: Query<(&mut Transform, &mut BodyState)>,
) {
    for &entity in &world.awake {
        let Ok((mut transform, mut state)) = bodies.get_mut(entity) else {
            continue;
        };
        if has_pose_of(&transform, &state.shown) && !has_pose_of(&state.shown, &state.current) {
            let current = state.current;
            set_pose(&mut transform, &current);
            state.shown = current;
        }
    }
}
