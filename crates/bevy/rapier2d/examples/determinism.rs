//! Two worlds with the same tower have the same bits after each step, at different frame rates.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier2d_bevy::prelude::*;
use std::time::Duration;

fn main() {
    let [slow, fast] = [30, 144].map(hashes);
    let steps = slow.len().min(fast.len());
    assert!(steps > 250);
    let different = (0..steps).find(|&step| slow[step] != fast[step]);
    println!("{steps} steps, the last with the hash {:016x}", slow[steps - 1]);
    assert_eq!(different, None);
}

#[derive(Resource, Default)]
struct Hashes(Vec<u64>);

/// The hashes of the steps of five seconds.
fn hashes(frames_per_second: u32) -> Vec<u64> {
    let frame = Duration::from_secs(1) / frames_per_second;
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugin::default()))
        .insert_resource(TimeUpdateStrategy::ManualDuration(frame))
        .init_resource::<Hashes>()
        .add_systems(Startup, spawn)
        .add_systems(FixedLast, |physics: Res<PhysicsWorld>, mut hashes: ResMut<Hashes>| {
            hashes.0.push(physics.engine.hash());
        });
    for _ in 0..5 * frames_per_second {
        app.update();
    }
    core::mem::take(&mut app.world_mut().resource_mut::<Hashes>().0)
}

fn spawn(mut commands: Commands) {
    commands.spawn((Collider::cuboid(20.0, 1.0), Transform::from_xyz(0.0, -1.0, 0.0)));
    for i in 0..60 {
        let (column, row) = ((i % 6) as f32, (i / 6) as f32);
        let place = Transform::from_xyz(0.9 * column + 0.3 * (row % 2.0), 0.5 + row, 0.0);
        commands.spawn((RigidBody::Dynamic, Collider::cuboid(0.5, 0.5), place));
    }
}
