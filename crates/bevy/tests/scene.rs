//! An app without window, whose frames last exactly one fixed step.

use crate::plugin::prelude::*;
use bevy::ecs::component::Mutable;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use std::time::Duration;

/// Bevy's default time step (s).
pub const DT: Scalar = 1.0 / 64.0;

/// Magnitude of the default gravity.
pub const G: Scalar = 9.81;

/// An app with the default plugin, without interpolation.
pub fn app() -> App {
    app_with(PhysicsPlugin::default().without_interpolation())
}

/// An app without gravity.
pub fn weightless() -> App {
    app_with(PhysicsPlugin::default().with_gravity(Vector::ZERO).without_interpolation())
}

/// An app with this plugin.
pub fn app_with(plugin: impl Plugin) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, TransformPlugin, plugin));
    frame_length(&mut app, 1.0);
    app.finish();
    // The first frame has no duration.
    app.update();
    app
}

/// Sets the length of a frame in fixed steps.
pub fn frame_length(app: &mut App, steps: f64) {
    let duration = Duration::from_secs_f64(steps / 64.0);
    app.insert_resource(TimeUpdateStrategy::ManualDuration(duration));
}

/// Runs some frames.
pub fn run(app: &mut App, frames: usize) {
    for _ in 0..frames {
        app.update();
    }
}

/// The transform at a point of the plane.
pub fn at(x: f32, y: f32) -> Transform {
    Transform::from_xyz(x, y, 0.0)
}

/// A component of an entity.
pub fn get<C: Component>(app: &App, entity: Entity) -> &C {
    app.world().get(entity).expect("the entity has the component")
}

/// A component of an entity, marked as changed.
pub fn edit<C: Component<Mutability = Mutable>>(app: &mut App, entity: Entity) -> Mut<'_, C> {
    app.world_mut().get_mut(entity).expect("the entity has the component")
}

/// Position of an entity relative to its parent.
pub fn position(app: &App, entity: Entity) -> Vec3 {
    get::<Transform>(app, entity).translation
}

/// The simulation.
pub fn physics(app: &App) -> &PhysicsWorld {
    app.world().resource()
}

/// Numbers of bodies, colliders and joints in the engine.
pub fn counts(app: &App) -> [usize; 3] {
    let engine = &physics(app).engine;
    [engine.bodies.len(), engine.colliders.len(), engine.impulse_joints.len()]
}

/// Asserts that two numbers differ by at most `tolerance`.
#[track_caller]
pub fn assert_near(value: impl Into<f64>, expected: impl Into<f64>, tolerance: f64) {
    let (value, expected) = (value.into(), expected.into());
    assert!((value - expected).abs() <= tolerance, "{value} instead of {expected}");
}
