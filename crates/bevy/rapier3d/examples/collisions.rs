//! Targets observe the balls that hit them, and the force of the hit.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin))
        .add_plugins(PhysicsPlugin::default().with_gravity(Vector::ZERO))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .add_systems(Startup, spawn)
        .add_systems(Update, end)
        .run()
}

/// Hits that a target survives.
#[derive(Component)]
struct Health(u32);

fn spawn(mut commands: Commands) {
    for (lane, health) in [1, 3].into_iter().enumerate() {
        let z = lane as f32 * 5.0;
        commands
            .spawn((
                Name::new(format!("target {lane}")),
                Health(health),
                Collider::cuboid(0.5, 1.0, 1.0),
                CollisionEvents,
                ContactForceEvents { threshold: 100.0 },
                Transform::from_xyz(10.0, 0.0, z),
            ))
            .observe(lose_health)
            .observe(report_force);
        for ball in 0..2 {
            commands.spawn((
                Name::new(format!("ball {ball}")),
                RigidBody::Dynamic,
                Collider::ball(0.25),
                ColliderMass::Mass(1.0),
                Restitution::new(0.5),
                Velocity::linear(Vector::X * 10.0),
                Transform::from_xyz(-3.0 * ball as f32, 0.0, z),
            ));
        }
    }
}

fn lose_health(
    hit: On<CollisionStarted>,
    names: Query<&Name>,
    mut targets: Query<&mut Health>,
    mut commands: Commands,
) -> Result {
    let mut health = targets.get_mut(hit.entity)?;
    health.0 -= 1;
    println!("{} hits {}: {} left", names.get(hit.other)?, names.get(hit.entity)?, health.0);
    if health.0 == 0 {
        commands.entity(hit.entity).despawn();
    }
    Ok(())
}

fn report_force(hit: On<ContactForce>, names: Query<&Name>) -> Result {
    println!("{} takes {:.0} N", names.get(hit.entity)?, hit.total_magnitude);
    assert!(hit.total_force.x > 0.0, "the force acts along the flight");
    Ok(())
}

fn end(time: Res<Time>, targets: Query<&Health>, mut exit: MessageWriter<AppExit>) {
    if time.elapsed_secs() > 3.0 {
        let left: Vec<_> = targets.iter().map(|health| health.0).collect();
        println!("targets that stand, with their health: {left:?}");
        assert_eq!(left, [1]);
        exit.write(AppExit::Success);
    }
}
