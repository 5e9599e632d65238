//! A table of a plate and four legs is one body. It grows by its scale, and a ball on it rises.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugin::default()))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .add_systems(Startup, spawn)
        .add_systems(FixedUpdate, grow)
        .add_systems(Update, end)
        .run()
}

#[derive(Component)]
struct Table;

#[derive(Component)]
struct Ball;

fn spawn(mut commands: Commands) {
    commands.spawn((Collider::cuboid(20.0, 0.5, 20.0), Transform::from_xyz(0.0, -0.5, 0.0)));
    let plate = (Collider::cuboid(1.0, 0.05, 1.0), Transform::from_xyz(0.0, 0.95, 0.0));
    let leg = |x: f32, z: f32| {
        (Collider::cuboid(0.05, 0.45, 0.05), Transform::from_xyz(0.9 * x, 0.45, 0.9 * z))
    };
    commands.spawn((
        Table,
        RigidBody::Dynamic,
        children![plate, leg(-1.0, -1.0), leg(-1.0, 1.0), leg(1.0, -1.0), leg(1.0, 1.0)],
    ));
    commands.spawn((
        Ball,
        RigidBody::Dynamic,
        Collider::ball(0.2),
        Damping { linear: 0.5, angular: 0.5 },
        Transform::from_xyz(0.0, 1.5, 0.0),
    ));
}

/// From the second second on, the table grows to twice its size within two seconds.
fn grow(time: Res<Time>, mut table: Single<&mut Transform, With<Table>>) {
    let size = (time.elapsed_secs() * 0.5).clamp(1.0, 2.0);
    if table.scale != Vec3::splat(size) {
        table.scale = Vec3::splat(size);
    }
}

fn end(
    time: Res<Time>,
    physics: Res<PhysicsWorld>,
    ball: Single<&Transform, With<Ball>>,
    table: Single<Entity, With<Table>>,
    mut exit: MessageWriter<AppExit>,
) {
    if time.elapsed_secs() > 8.0 {
        let body = physics.body(*table).expect("the table is a body");
        let (parts, mass) = (body.colliders().len(), body.mass());
        println!("{parts} parts of {mass:.2} kg; the ball lies at {:.2} m", ball.translation.y);
        assert_eq!(parts, 5);
        assert!((ball.translation.y - 2.2).abs() < 0.05);
        exit.write(AppExit::Success);
    }
}
