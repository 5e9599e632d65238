//! Turns a world into a drawing: surfaces of colliders, and lines.

use super::islands::Islands;
use super::overlays::Overlays;
use super::palette::color;
use super::scene::{BodyColors, Scene};
use super::surfaces::Surfaces;
use crate::rapier::prelude::*;
use crate::shapes::point;
use drawing::{Color, Drawing, Line, Role};

/// A fixed collider that is this many times larger than all that moves is scenery.
const SCENERY: Real = 1.5;
/// Colour of the outlines of sensors, and of shapes without a surface.
const SENSOR: [f32; 4] = [140.0, 0.70, 0.60, 0.9];
const WIRE: [f32; 4] = [215.0, 0.25, 0.70, 1.0];

/// Draws worlds. It keeps the meshes of shapes, so one artist for a scene is faster than one for a picture.
#[derive(Clone, Default)]
pub struct Artist {
    /// The content besides the surfaces.
    pub overlays: Overlays,
    /// The selected collider: the surfaces of its body are highlighted.
    pub selected: Option<ColliderHandle>,
    surfaces: Surfaces,
    lines: DebugRenderPipeline,
}

impl Artist {
    /// Draws a scene: its world, its joints with its settings, its labels.
    pub fn draw(&mut self, scene: &Scene) -> Drawing {
        self.lines.style.joint_axes_length = scene.joint_axes.unwrap_or(self.overlays.length);
        let joints = DebugRenderMode::JOINTS | DebugRenderMode::JOINT_AXES;
        let added = scene.joint_axes.map_or(DebugRenderMode::empty(), |_| joints);
        let mode = self.overlays.lines | added;
        let mut drawing = self.draw_world(&scene.world, &scene.body_colors, mode);
        for (at, text) in &scene.labels {
            drawing.label(point(*at), text);
        }
        drawing
    }

    /// Draws a world, with the colours of some bodies, and the lines of a mode.
    pub fn draw_world(
        &mut self,
        world: &PhysicsWorld,
        colors: &BodyColors,
        mode: DebugRenderMode,
    ) -> Drawing {
        let mut drawing = Drawing::default();
        let moving = extent_of_moving(world);
        let body_of = |handle| world.colliders.get(handle).and_then(Collider::parent);
        let chosen = self.selected.and_then(body_of);
        let mut islands = self.overlays.islands.then(|| Islands::of(world));
        for (handle, collider) in world.colliders.iter().filter(|(_, c)| !c.is_sensor()) {
            let body = collider.parent().and_then(|parent| world.bodies.get(parent));
            let role = role_of(collider, body, moving);
            let scenery = matches!(role, Role::Scenery | Role::Ground);
            let own = collider.parent().and_then(|parent| {
                let island = islands.as_mut().and_then(|islands| islands.color(parent));
                island.or_else(|| colors.get(&parent).copied())
            });
            let color = own.unwrap_or_else(|| color(handle, body, scenery, self.overlays.sleep));
            if !self.overlays.surfaces && !scenery {
                continue;
            }
            let look = Look {
                color,
                role,
                id: handle.into_raw_parts().0,
                highlighted: self.selected == Some(handle)
                    || (chosen.is_some() && collider.parent() == chosen),
            };
            self.surfaces.add(&mut drawing, collider, &look);
        }
        self.surfaces.drop_unused();
        self.add_lines(world, moving, mode, &mut drawing);
        self.overlays.mark(world, &mut drawing);
        drawing
    }

    fn add_lines(
        &mut self,
        world: &PhysicsWorld,
        moving: Real,
        mode: DebugRenderMode,
        drawing: &mut Drawing,
    ) {
        let Self { overlays, lines, .. } = self;
        // Joints are inside their bodies; the axes are there to be seen.
        let joints_on_top = mode.contains(DebugRenderMode::JOINT_AXES);
        lines.mode = mode | DebugRenderMode::COLLIDER_SHAPES;
        lines.style.contact_normal_length = overlays.length;
        lines.style.rigid_body_axes_length = overlays.length;
        let mut pen = Pen { drawing, moving, world, everything: !overlays.surfaces, joints_on_top };
        world.debug_render(lines, &mut pen);
    }
}

/// Appearance of a collider's surface.
pub(crate) struct Look {
    pub color: Color,
    pub role: Role,
    pub id: u32,
    pub highlighted: bool,
}

/// Half of the largest extent of all that moves (length units).
fn extent_of_moving(world: &PhysicsWorld) -> Real {
    let mut all = Aabb::new_invalid();
    for (_, collider) in world.colliders.iter() {
        let body = collider.parent().and_then(|parent| world.bodies.get(parent));
        if body.is_some_and(|body| !body.is_fixed()) {
            all.merge(&collider.compute_aabb());
        }
    }
    (all.maxs - all.mins).max_element().max(0.0) * 0.5
}

/// The part that a collider plays in the picture.
fn role_of(collider: &Collider, body: Option<&RigidBody>, moving: Real) -> Role {
    if body.is_some_and(|body| !body.is_fixed()) {
        return Role::Moving;
    }
    let aabb = collider.compute_aabb();
    let reach = (aabb.maxs - aabb.mins).max_element() * 0.5;
    // The reach of an endless plane may not be a number.
    let far = reach > SCENERY * moving || !reach.is_finite();
    match (moving > 0.0 && far, has_relief(collider)) {
        (false, _) => Role::Fixed,
        (true, true) => Role::Scenery,
        (true, false) => Role::Ground,
    }
}

/// Returns whether the shape has more than a level top.
fn has_relief(collider: &Collider) -> bool {
    !matches!(collider.shape().as_typed_shape(), TypedShape::Cuboid(_) | TypedShape::HalfSpace(_))
}

/// Collects the lines of the debug-renderer.
struct Pen<'a> {
    drawing: &'a mut Drawing,
    moving: Real,
    world: &'a PhysicsWorld,
    /// Whether the outlines of shapes with a surface are drawn, too.
    everything: bool,
    /// Whether joints show through the surfaces.
    joints_on_top: bool,
}

impl Pen<'_> {
    fn is_wire(collider: &Collider) -> bool {
        let shape = collider.shape().as_typed_shape();
        collider.is_sensor() || matches!(shape, TypedShape::Segment(_) | TypedShape::Polyline(_))
    }
}

impl DebugRenderBackend for Pen<'_> {
    /// Surfaces need no outlines, and a joint that broke joins nothing any more.
    fn filter_object(&self, object: DebugRenderObject) -> bool {
        match object {
            DebugRenderObject::Collider(_, collider) => {
                let body = collider.parent().and_then(|parent| self.world.bodies.get(parent));
                Self::is_wire(collider)
                    || (self.everything && role_of(collider, body, self.moving) != Role::Ground)
            }
            DebugRenderObject::ImpulseJoint(_, joint) => joint.data.is_enabled(),
            _ => true,
        }
    }

    fn draw_line(&mut self, object: DebugRenderObject, a: Vector, b: Vector, color: DebugColor) {
        let ([hue, saturation, lightness, opacity], on_top) = match object {
            DebugRenderObject::Collider(_, collider) if collider.is_sensor() => (SENSOR, false),
            DebugRenderObject::Collider(_, collider) if Self::is_wire(collider) => (WIRE, false),
            DebugRenderObject::Collider(..) | DebugRenderObject::ColliderAabb(..) => (color, false),
            DebugRenderObject::ImpulseJoint(..) | DebugRenderObject::MultibodyJoint(..) => {
                (color, self.joints_on_top)
            }
            _ => (color, true),
        };
        let color = Color::from_hsl(hue, saturation, lightness, opacity);
        self.drawing.line(Line { from: point(a), to: point(b), color, on_top });
    }
}
