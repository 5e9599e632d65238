//! The step, and its events.

use crate::event::Recorder;
use crate::hooks::{CollisionHooks, EngineHooks};
use crate::precision::Scalar;
use crate::world::PhysicsWorld;
use bevy::ecs::system::{Commands, Res, ResMut, StaticSystemParam, SystemParam, SystemParamItem};
use bevy::time::{Fixed, Time};

/// Moves the engine's world forward by Bevy's fixed time step.
pub(crate) fn step<H>(
    mut world: ResMut<PhysicsWorld>,
    hooks: StaticSystemParam<H>,
    time: Res<Time<Fixed>>,
) where
    H: SystemParam + 'static,
    for<'w, 's> SystemParamItem<'w, 's, H>: CollisionHooks,
{
    let recorder = Recorder::default();
    // Colliders that are removed between this step and its events end their pairs in the next step.
    world.removed_before_step = core::mem::take(&mut world.removed);
    world.engine.integration_parameters.dt = time.timestep().as_secs_f64() as Scalar;
    world.engine.step_with_events(&EngineHooks(&*hooks), &recorder);
    world.events = recorder.into_events();
}

/// Triggers the events of the step, in the engine's order.
pub(crate) fn send_events(mut world: ResMut<PhysicsWorld>, mut commands: Commands) {
    for event in core::mem::take(&mut world.events) {
        event.trigger(&world, &mut commands);
    }
}
