//! Hooks: doors that let one team pass, and ice under one body only.

use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    let physics = PhysicsPlugin::default().with_hooks::<Rules>();
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin, physics))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .add_systems(Startup, spawn)
        .add_systems(Update, end)
        .run()
}

#[derive(Component, Copy, Clone, Debug, PartialEq)]
enum Team {
    Red,
    Blue,
}

/// The hooks are a system parameter, with the access of a system.
#[derive(SystemParam)]
struct Rules<'w, 's> {
    teams: Query<'w, 's, &'static Team>,
}

impl CollisionHooks for Rules<'_, '_> {
    fn filter_contacts(&self, pair: &ContactPair) -> bool {
        match self.teams.get_many([pair.collider1, pair.collider2]) {
            Ok([door, guest]) => door != guest,
            Err(_) => true,
        }
    }

    fn modify_contacts(&self, pair: &ContactPair, contacts: &mut ModifiedContacts<'_, '_>) {
        let is_red = |entity| self.teams.get(entity).is_ok_and(|team| *team == Team::Red);
        if is_red(pair.collider1) || is_red(pair.collider2) {
            contacts.set_friction(0.0);
        }
    }
}

fn spawn(mut commands: Commands) {
    commands.spawn((
        Collider::cuboid(50.0, 0.5, 10.0),
        HookedPairs(ActiveHooks::MODIFY_SOLVER_CONTACTS),
        Transform::from_xyz(0.0, -0.5, 0.0),
    ));
    for (lane, team) in [Team::Red, Team::Blue].into_iter().enumerate() {
        let z = lane as f32 * 4.0;
        commands.spawn((
            team,
            RigidBody::Dynamic,
            Collider::cuboid(0.5, 0.5, 0.5),
            Velocity::linear(Vector::X * 6.0),
            Transform::from_xyz(0.0, 0.5, z),
        ));
        commands.spawn((
            Team::Red,
            Collider::cuboid(0.1, 2.0, 1.5),
            HookedPairs(ActiveHooks::FILTER_CONTACT_PAIRS),
            Transform::from_xyz(3.0, 2.0, z),
        ));
    }
}

fn end(
    time: Res<Time>,
    bodies: Query<(&Team, &Transform, &Velocity), With<RigidBody>>,
    mut exit: MessageWriter<AppExit>,
) {
    if time.elapsed_secs() < 4.0 {
        return;
    }
    for (team, transform, velocity) in &bodies {
        let (x, speed) = (transform.translation.x, velocity.linear.x);
        println!("{team:?} is at {x:.2} m and slides at {speed:.2} m/s");
        match team {
            Team::Red => assert!(x > 20.0 && speed > 5.9, "through the door, on ice"),
            Team::Blue => assert!(x < 2.5 && speed.abs() < 0.01, "stopped by the door"),
        }
    }
    exit.write(AppExit::Success);
}
