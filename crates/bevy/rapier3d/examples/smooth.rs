//! Interpolation: 240 frames per second show even motion of a simulation with 20 steps per second.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin))
        .add_plugins(PhysicsPlugin::default().with_gravity(Vector::ZERO))
        .insert_resource(Time::<Fixed>::from_hz(20.0))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs(1) / 240))
        .add_systems(Startup, spawn)
        .add_systems(PostUpdate, watch)
        .run()
}

fn spawn(mut commands: Commands) {
    let velocity = Velocity::linear(Vector::X * 12.0);
    commands.spawn((RigidBody::Dynamic, Collider::ball(0.5), velocity));
}

/// Distances between the frames: 12 m/s are 50 mm in 1/240 s.
fn watch(
    time: Res<Time<Virtual>>,
    ball: Single<&Transform, With<RigidBody>>,
    mut last: Local<f32>,
    mut range: Local<Option<(f32, f32)>>,
    mut exit: MessageWriter<AppExit>,
) {
    let x = ball.translation.x;
    let distance = x - *last;
    *last = x;
    if time.elapsed_secs() > 0.5 {
        let (least, most) = range.unwrap_or((distance, distance));
        *range = Some((least.min(distance), most.max(distance)));
    }
    if time.elapsed_secs() > 3.0 {
        let (least, most) = range.expect("frames were counted");
        println!("frames are {:.2} mm to {:.2} mm apart", least * 1000.0, most * 1000.0);
        assert!(least > 0.0498 && most < 0.0502);
        exit.write(AppExit::Success);
    }
}
