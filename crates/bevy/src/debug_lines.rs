//! Debug lines through Bevy's gizmos.

use crate::dim::to_gizmo;
use crate::world::PhysicsWorld;
use bevy::app::{App, Plugin, PostUpdate};
use bevy::color::Color;
use bevy::ecs::resource::Resource;
use bevy::ecs::system::{Res, ResMut};
use bevy::gizmos::AppGizmoBuilder;
use bevy::gizmos::config::GizmoConfigGroup;
use bevy::gizmos::gizmos::Gizmos;
use bevy::reflect::Reflect;
use rapier::math as engine;
use rapier::prelude::{
    DebugColor, DebugRenderBackend, DebugRenderMode, DebugRenderObject, DebugRenderPipeline,
    DebugRenderStyle,
};

/// Gizmos of the simulation. The colour depends on the type and the state of the body, as the engine's
/// `DebugRenderStyle` lists.
///
/// `GizmoConfigStore` has the width of the lines, and switches them off.
#[derive(Default, Reflect, GizmoConfigGroup)]
pub struct PhysicsGizmos;

/// Draws colliders, joints and more as lines. `GizmoPlugin` of Bevy must be present, as in `DefaultPlugins`.
pub struct PhysicsDebugPlugin {
    /// The drawn objects.
    pub mode: DebugRenderMode,
}

impl Default for PhysicsDebugPlugin {
    fn default() -> Self {
        Self { mode: DebugRenderMode::COLLIDER_SHAPES | DebugRenderMode::JOINTS }
    }
}

impl Plugin for PhysicsDebugPlugin {
    fn build(&self, app: &mut App) {
        let pipeline = DebugRenderPipeline::new(DebugRenderStyle::default(), self.mode);
        app.init_gizmo_group::<PhysicsGizmos>()
            .insert_resource(Lines(pipeline))
            .add_systems(PostUpdate, draw_lines);
    }
}

/// Outlines of shapes that were drawn before.
#[derive(Resource)]
struct Lines(DebugRenderPipeline);

fn draw_lines(
    world: Res<PhysicsWorld>,
    mut lines: ResMut<Lines>,
    mut gizmos: Gizmos<PhysicsGizmos>,
) {
    let engine = &world.engine;
    lines.0.render(
        &mut GizmoBackend(&mut gizmos),
        &engine.bodies,
        &engine.colliders,
        &engine.impulse_joints,
        &engine.multibody_joints,
        &engine.narrow_phase,
    );
}

struct GizmoBackend<'a, 'w, 's>(&'a mut Gizmos<'w, 's, PhysicsGizmos>);

impl DebugRenderBackend for GizmoBackend<'_, '_, '_> {
    fn draw_line(
        &mut self,
        _: DebugRenderObject,
        a: engine::Vector,
        b: engine::Vector,
        [hue, saturation, lightness, alpha]: DebugColor,
    ) {
        let color = Color::hsla(hue, saturation, lightness, alpha);
        self.0.line(to_gizmo(a), to_gizmo(b), color);
    }
}
