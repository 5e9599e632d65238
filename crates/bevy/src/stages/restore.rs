//! Before a fixed step: interpolated transforms return to the state of the last step.

use super::pose_parts::PoseParts;
use crate::body::BodyState;
use crate::world::PhysicsWorld;
use bevy::ecs::system::{Query, Res};
use bevy::transform::components::Transform;

/// Systems in the fixed schedules read exact poses. A translation or rotation that the user edited stays.
pub(crate) fn restore_transforms(
    world: Res<PhysicsWorld>,
    mut bodies: Query<(&mut Transform, &mut BodyState)>,
) {
    for &entity in &world.awake {
        let Ok((mut transform, mut state)) = bodies.get_mut(entity) else {
            continue;
        };
        let edited = PoseParts::of_difference(&transform, &state.shown);
        let interpolated = PoseParts::of_difference(&state.shown, &state.current);
        let parts = interpolated.and(edited.complement());
        if parts.is_any() {
            let current = state.current;
            parts.copy(&current, &mut transform);
            parts.copy(&current, &mut state.shown);
        }
    }
}
