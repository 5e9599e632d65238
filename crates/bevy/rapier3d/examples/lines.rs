//! Debug lines by gizmos: `cargo run -p rapier3d-bevy --features debug-lines --example lines`.
//!
//! This program has no window and counts the lines. With `DefaultPlugins` of Bevy a camera shows them.

use bevy::asset::AssetPlugin;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

fn main() -> AppExit {
    App::new()
        // In place of `GizmoPlugin`, which needs meshes, too.
        .add_plugins((MinimalPlugins, TransformPlugin, AssetPlugin::default()))
        .init_asset::<GizmoAsset>()
        .add_plugins((PhysicsPlugin::default(), PhysicsDebugPlugin::default()))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .add_systems(Startup, spawn)
        .add_systems(First, count)
        .run()
}

fn spawn(mut commands: Commands) {
    commands.spawn((Collider::cuboid(5.0, 0.5, 5.0), Transform::from_xyz(0.0, -0.5, 0.0)));
    commands.spawn((RigidBody::Dynamic, Collider::ball(0.5), Transform::from_xyz(0.0, 2.0, 0.0)));
}

fn count(lines: Res<Assets<GizmoAsset>>, time: Res<Time>, mut exit: MessageWriter<AppExit>) {
    if time.elapsed_secs() > 1.0 {
        let ends: usize = lines.iter().map(|(_, asset)| asset.buffer().list_positions.len()).sum();
        println!("{} lines show a box and a ball", ends / 2);
        assert!(ends / 2 > 12, "a box alone has 12 edges");
        exit.write(AppExit::Success);
    }
}
