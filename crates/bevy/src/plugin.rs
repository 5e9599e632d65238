//! The plugin: settings, and the order of its systems.

use crate::body::{
    Damping, ExternalForce, ExternalImpulse, GravityScale, RigidBody, Sleeping, Velocity,
};
use crate::collider::{ColliderMass, CollisionEvents, ContactForceEvents, Sensor};
use crate::dim::Vector;
use crate::hooks::CollisionHooks;
use crate::stages;
use crate::world::PhysicsWorld;
use bevy::app::{
    App, FixedFirst, FixedPostUpdate, Plugin, RunFixedMainLoop, RunFixedMainLoopSystems,
};
use bevy::ecs::schedule::{IntoScheduleConfigs, SystemSet};
use bevy::ecs::system::{SystemParam, SystemParamItem};
use core::marker::PhantomData;

/// Physics in Bevy's fixed schedule.
///
/// The systems run in `FixedPostUpdate`, so systems in `FixedUpdate` set forces for the coming step and read
/// the result of the last one. The time step is that of `Time<Fixed>`, 1/64 s by default.
///
/// `H` is the type of the [hooks](CollisionHooks).
pub struct PhysicsPlugin<H = ()> {
    gravity: Vector,
    interpolates: bool,
    hooks: PhantomData<fn() -> H>,
}

impl Default for PhysicsPlugin {
    fn default() -> Self {
        let gravity = Vector::Y * -9.81;
        Self { gravity, interpolates: true, hooks: PhantomData }
    }
}

impl PhysicsPlugin {
    /// Calls hooks of this type for pairs with [`HookedPairs`](crate::HookedPairs).
    #[must_use]
    pub fn with_hooks<H>(self) -> PhysicsPlugin<H> {
        let Self { gravity, interpolates, .. } = self;
        PhysicsPlugin { gravity, interpolates, hooks: PhantomData }
    }
}

impl<H> PhysicsPlugin<H> {
    /// Sets the gravity (length/s²). 9.81 along -y by default.
    #[must_use]
    pub fn with_gravity(self, gravity: Vector) -> Self {
        Self { gravity, ..self }
    }

    /// Shows the state of the last step in every frame, without interpolation.
    #[must_use]
    pub fn without_interpolation(self) -> Self {
        Self { interpolates: false, ..self }
    }
}

/// The stages of a step, in this order. Systems of the program are ordered relative to them.
#[derive(SystemSet, Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum PhysicsSystems {
    /// In `FixedFirst`: replaces interpolated transforms by the state of the last step.
    Restore,
    /// In `FixedPostUpdate`: copies edits of the user into the engine.
    Prepare,
    /// In `FixedPostUpdate`: moves the world forward.
    Step,
    /// In `FixedPostUpdate`: writes poses, velocities and sleep states.
    WriteBack,
    /// In `FixedPostUpdate`: triggers the events.
    Report,
    /// In `RunFixedMainLoop`, after the steps of a frame: writes interpolated transforms.
    Interpolate,
}

impl<H> Plugin for PhysicsPlugin<H>
where
    H: SystemParam + 'static,
    for<'w, 's> SystemParamItem<'w, 's, H>: CollisionHooks,
{
    fn build(&self, app: &mut App) {
        use PhysicsSystems::{Interpolate, Prepare, Report, Restore, Step, WriteBack};
        app.insert_resource(PhysicsWorld::new(self.gravity));
        stages::observe_lifecycle(app);
        stages::observe_required(app);
        stages::queue_existing_entities(app);
        let after = RunFixedMainLoopSystems::AfterFixedMainLoop;
        app.configure_sets(FixedPostUpdate, (Prepare, Step, WriteBack, Report).chain())
            .configure_sets(RunFixedMainLoop, Interpolate.in_set(after));
        let prepare = (
            stages::edit_bodies,
            stages::carry_nested_bodies,
            stages::insert_bodies,
            stages::move_colliders,
            stages::describe_colliders,
            stages::sync_joints,
            stages::apply_impulses,
        );
        let write_back = (stages::write_transforms, stages::write_nested_transforms);
        app.add_systems(FixedPostUpdate, prepare.chain().in_set(Prepare))
            .add_systems(FixedPostUpdate, stages::step::<H>.in_set(Step))
            .add_systems(FixedPostUpdate, write_back.chain().in_set(WriteBack))
            .add_systems(FixedPostUpdate, stages::send_events.in_set(Report));
        if self.interpolates {
            let interpolate = stages::interpolate_transforms.in_set(Interpolate);
            app.add_systems(FixedFirst, stages::restore_transforms.in_set(Restore))
                .add_systems(RunFixedMainLoop, interpolate);
        }
        register_types(app);
    }
}

/// Registers the components of plain data for editors and scenes. Those that own an engine type (`Collider`,
/// `Joint`, `LockedAxes`, `Friction`, `Restitution`, `CollisionGroups`, `HookedPairs`) have no reflection.
fn register_types(app: &mut App) {
    app.register_type::<RigidBody>()
        .register_type::<Velocity>()
        .register_type::<GravityScale>()
        .register_type::<Damping>()
        .register_type::<ExternalForce>()
        .register_type::<ExternalImpulse>()
        .register_type::<Sleeping>()
        .register_type::<ColliderMass>()
        .register_type::<Sensor>()
        .register_type::<CollisionEvents>()
        .register_type::<ContactForceEvents>();
}
