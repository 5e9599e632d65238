//! Debug lines, without a renderer.

use crate::dim::cube;
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::asset::AssetPlugin;
use bevy::prelude::*;

/// Ends of all lines that the renderer would draw.
fn line_ends(app: &App) -> usize {
    let assets = app.world().resource::<Assets<GizmoAsset>>();
    assets.iter().map(|(_, lines)| lines.buffer().list_positions.len()).sum()
}

#[test]
fn every_collider_has_lines() {
    let mut app = App::new();
    // Bevy's `GizmoPlugin` needs meshes, too.
    app.add_plugins((MinimalPlugins, TransformPlugin, AssetPlugin::default()))
        .init_asset::<GizmoAsset>()
        .add_plugins((PhysicsPlugin::default(), PhysicsDebugPlugin::default()));
    frame_length(&mut app, 1.0);
    run(&mut app, 3);
    assert_eq!(line_ends(&app), 0);
    app.world_mut().spawn((RigidBody::Dynamic, cube(0.5)));
    run(&mut app, 3);
    let one = line_ends(&app);
    assert!(one >= 8, "a square has 4 lines with 2 ends");
    app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(5.0, 0.0)));
    run(&mut app, 3);
    assert_eq!(line_ends(&app), 2 * one);
}
