//! A ball falls, bounces and comes to rest.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugin::default()))
        // Without a window, time passes as fast as the processor allows.
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .add_systems(Startup, spawn)
        .add_systems(Update, report)
        .run()
}

fn spawn(mut commands: Commands) {
    commands.spawn((Collider::cuboid(10.0, 0.5, 10.0), Transform::from_xyz(0.0, -0.5, 0.0)));
    commands.spawn((
        RigidBody::Dynamic,
        Collider::ball(0.5),
        Restitution::new(1.0),
        Transform::from_xyz(0.0, 4.0, 0.0),
    ));
}

fn report(
    time: Res<Time>,
    ball: Single<(&Transform, &Velocity, &Sleeping), With<RigidBody>>,
    mut exit: MessageWriter<AppExit>,
    mut bounces: Local<u32>,
    mut last: Local<Scalar>,
) {
    let (transform, velocity, sleeping) = *ball;
    let (height, speed) = (transform.translation.y, velocity.linear.y);
    if *last < 0.0 && speed > 0.1 {
        *bounces += 1;
        println!("{:.2} s: bounce {} at {speed:.2} m/s", time.elapsed_secs(), *bounces);
    }
    *last = speed;
    if sleeping.is_sleeping() {
        println!("{:.2} s: the ball rests at {height:.3} m", time.elapsed_secs());
        assert!(*bounces >= 3 && (height - 0.5).abs() < 0.01);
        exit.write(AppExit::Success);
    }
    assert!(time.elapsed_secs() < 30.0, "the ball never rests");
}
