//! A platform carries a box to a gate, which is a sensor.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier2d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugin::default()))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .add_systems(Startup, spawn)
        .add_systems(FixedUpdate, ride)
        .add_systems(Update, end)
        .run()
}

#[derive(Component)]
struct Platform;

#[derive(Component)]
struct Cargo;

fn spawn(mut commands: Commands) {
    commands.spawn((
        Platform,
        RigidBody::KinematicPosition,
        Collider::cuboid(1.5, 0.2),
        Friction::new(1.0),
    ));
    commands.spawn((
        Cargo,
        RigidBody::Dynamic,
        Collider::cuboid(0.4, 0.4),
        Transform::from_xyz(0.0, 0.6, 0.0),
    ));
    commands
        .spawn((
            Collider::cuboid(0.1, 2.0),
            Sensor,
            CollisionEvents,
            CollisionGroups::new(Group::ALL, Group::GROUP_1),
            Transform::from_xyz(6.0, 2.5, 0.0),
        ))
        .observe(|on: On<CollisionStarted>, mut cargo: Query<&mut GravityScale, With<Cargo>>| {
            println!("the gate reports {}", on.other);
            // The gate lifts the cargo off its platform.
            if let Ok(mut scale) = cargo.get_mut(on.other) {
                scale.0 = -0.5;
            }
        });
}

/// Moves the platform by 2 m each second.
fn ride(time: Res<Time>, mut platform: Single<&mut Transform, With<Platform>>) {
    platform.translation.x += 2.0 * time.delta_secs();
}

fn end(
    time: Res<Time>,
    platform: Single<&Transform, With<Platform>>,
    cargo: Single<&Transform, With<Cargo>>,
    mut exit: MessageWriter<AppExit>,
) {
    if time.elapsed_secs() > 4.0 {
        let (place, platform) = (cargo.translation, platform.translation);
        println!("the platform is at x = {:.2} m, the cargo at {place:.2} m", platform.x);
        assert!((platform.x - 8.0).abs() < 0.1);
        assert!(place.x > 6.0 && place.y > 2.0);
        exit.write(AppExit::Success);
    }
}
