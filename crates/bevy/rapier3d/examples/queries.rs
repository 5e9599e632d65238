//! A drone keeps its height over uneven ground by rays, and looks for crates around it.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugin::default()))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .init_resource::<Found>()
        .add_systems(Startup, spawn)
        .add_systems(FixedUpdate, (fly, search).chain())
        .add_systems(Update, end)
        .run()
}

#[derive(Component)]
struct Drone;

#[derive(Component)]
struct Crate;

#[derive(Resource, Default)]
struct Found(Vec<Entity>);

fn spawn(mut commands: Commands) {
    for step in 0..10 {
        let height = 0.5 * step as f32;
        let place = Transform::from_xyz(2.0 * step as f32, height - 5.0, 0.0);
        commands.spawn((Collider::cuboid(1.0, 5.0, 2.0), place));
        if step % 3 == 0 {
            let place = Transform::from_xyz(2.0 * step as f32, height + 0.3, 1.0);
            commands.spawn((Crate, Collider::cuboid(0.3, 0.3, 0.3), place));
        }
    }
    commands.spawn((
        Drone,
        RigidBody::KinematicPosition,
        Collider::ball(0.3),
        Transform::from_xyz(0.0, 2.0, 0.0),
    ));
}

/// Moves forward, 2 m over the ground.
fn fly(
    time: Res<Time>,
    query: SpatialQuery,
    mut drone: Single<(Entity, &mut Transform), With<Drone>>,
) {
    let (entity, transform) = &mut *drone;
    transform.translation.x += 4.0 * time.delta_secs();
    let filter = SpatialFilter::default().excluding(*entity);
    let [x, y] = [transform.translation.x, transform.translation.y].map(Scalar::from);
    if let Some(hit) = query.cast_ray(Vector::new(x, y, 0.0), -Vector::Y, 20.0, &filter) {
        transform.translation.y = hit.point.y as f32 + 2.0;
    }
}

/// Notes the crates within 2.5 m.
fn search(
    query: SpatialQuery,
    drone: Single<&Transform, With<Drone>>,
    crates: Query<(), With<Crate>>,
    mut found: ResMut<Found>,
) {
    let around = query.intersections_with_shape(&Collider::ball(2.5), &drone, &default());
    for entity in around.into_iter().filter(|entity| crates.contains(*entity)) {
        if !found.0.contains(&entity) {
            println!("a crate at x = {:.1} m", drone.translation.x);
            found.0.push(entity);
        }
    }
}

fn end(
    drone: Single<&Transform, With<Drone>>,
    found: Res<Found>,
    mut exit: MessageWriter<AppExit>,
) {
    if drone.translation.x > 18.0 {
        println!("{} crates; the drone is at {:.2} m", found.0.len(), drone.translation.y);
        assert_eq!(found.0.len(), 4);
        assert!((drone.translation.y - 6.5).abs() < 0.01);
        exit.write(AppExit::Success);
    }
}
