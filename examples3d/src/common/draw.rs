//! Draws a world: lines from the debug renderer, and the surfaces between them.

use super::scene::Scene;
use crate::rapier::prelude::*;
use crate::solid::{Solid, point, solid};
use gallery::{Color, Line, Pen, Triangle as Face};

/// How far the hue of single colliders strays from the colour of their kind (degrees).
const HUE_RANGE: f32 = 56.0;
/// A fixed collider that reaches this many times farther than everything that moves is scenery.
const SCENERY: Real = 1.5;
/// Opacity, in 3D, of the lines of fixed colliders, and of those that are scenery.
const FIXED_LINES: f32 = 0.5;
const SCENERY_LINES: f32 = 0.3;
/// Hue of sensors.
const SENSOR_HUE: f32 = 140.0;

/// Draws everything in the world.
pub(super) fn draw(scene: &Scene, pen: &mut dyn Pen) {
    let Scene { world, joint_axes, labels, .. } = scene;
    let moving = extent_of_moving(world);
    for (at, text) in labels {
        pen.label(point(*at), text);
    }
    let mut artist = Artist { world, pen, moving, joints_on_top: joint_axes.is_some() };
    artist.draw_surfaces();
    let mut pipeline = DebugRenderPipeline::default();
    if let Some(length) = *joint_axes {
        pipeline.style.joint_axes_length = length;
        pipeline.mode |= DebugRenderMode::JOINT_AXES;
    }
    world.debug_render(&mut pipeline, &mut artist);
}

/// Half of the largest extent of all that moves (length units).
fn extent_of_moving(world: &PhysicsWorld) -> Real {
    let mut all = Aabb::new_invalid();
    for (_, collider) in world.colliders.iter().filter(|(_, c)| moves(world, c)) {
        all.merge(&collider.compute_aabb());
    }
    (all.maxs - all.mins).max_element().max(0.0) * 0.5
}

/// Does the collider belong to a body that is not fixed?
fn moves(world: &PhysicsWorld, collider: &Collider) -> bool {
    let body = collider.parent().and_then(|parent| world.bodies.get(parent));
    body.is_some_and(|body| !body.is_fixed())
}

struct Artist<'a> {
    world: &'a PhysicsWorld,
    pen: &'a mut dyn Pen,
    /// Half of the largest extent of all that moves.
    moving: Real,
    /// Do joints show through everything?
    joints_on_top: bool,
}

impl Artist<'_> {
    /// Draws a line of a joint.
    fn draw_joint_line(&mut self, ends: [Vector; 2], [h, s, l, opacity]: DebugColor) {
        let (color, [from, to]) = (Color::from_hsl(h, s, l, opacity), ends.map(point));
        let on_top = self.joints_on_top;
        self.pen.line(Line { from, to, color, scenery: false, on_top });
    }

    fn is_scenery(&self, collider: &Collider) -> bool {
        let aabb = collider.compute_aabb();
        let reach = (aabb.maxs - aabb.mins).max_element() * 0.5;
        // The reach of an endless plane may not be a number.
        let far = reach > SCENERY * self.moving || !reach.is_finite();
        !moves(self.world, collider) && self.moving > 0.0 && far
    }

    /// Fills the shapes, unless one should see through them.
    fn draw_surfaces(&mut self) {
        let style = DebugRenderStyle::default();
        for (handle, collider) in self.world.colliders.iter().filter(|(_, c)| !c.is_sensor()) {
            let body = collider.parent().and_then(|parent| self.world.bodies.get(parent));
            let color = match body {
                Some(body) if body.is_dynamic() => style.collider_dynamic_color,
                Some(body) if body.is_kinematic() => style.collider_kinematic_color,
                _ => style.collider_fixed_color,
            };
            let asleep = body.is_some_and(RigidBody::is_sleeping);
            let multiplier = if asleep { style.sleep_color_multiplier } else { [1.0; 4] };
            let hsla = std::array::from_fn(|i| color[i] * multiplier[i]);
            let scenery = self.is_scenery(collider);
            let mut surface = Solid::default();
            solid(&mut surface, collider.position(), &collider.shape().as_typed_shape());
            for corners in surface.triangles {
                let color = shifted(handle, collider, hsla);
                let floor = scenery && !has_relief(collider);
                self.pen.triangle(Face { corners, color, scenery, floor });
            }
        }
    }
}

impl DebugRenderBackend for Artist<'_> {
    /// The outline of a floor would be a harsh line where the floor fades out, and a joint that broke joins nothing any more.
    fn filter_object(&self, object: DebugRenderObject) -> bool {
        match object {
            DebugRenderObject::Collider(_, collider) => {
                DIM == 2 || !self.is_scenery(collider) || has_relief(collider)
            }
            DebugRenderObject::ImpulseJoint(_, joint) => joint.data.is_enabled(),
            _ => true,
        }
    }

    fn draw_line(&mut self, object: DebugRenderObject, a: Vector, b: Vector, color: DebugColor) {
        let DebugRenderObject::Collider(handle, collider) = object else {
            return self.draw_joint_line([a, b], color);
        };
        let mut color = shifted(handle, collider, color);
        let scenery = self.is_scenery(collider);
        if DIM == 3 && !moves(self.world, collider) {
            // The net of a landscape must not outshine what stands on it.
            color.opacity *= if scenery { SCENERY_LINES } else { FIXED_LINES };
        }
        self.pen.line(Line { from: point(a), to: point(b), color, scenery, on_top: false });
    }
}

/// Is there more to the shape than a plane?
fn has_relief(collider: &Collider) -> bool {
    !matches!(collider.shape().as_typed_shape(), TypedShape::Cuboid(_) | TypedShape::HalfSpace(_))
}

/// A colour of the same kind, a little different for each collider. Fixed ones all look the same, and
/// sensors have a colour of their own.
fn shifted(handle: ColliderHandle, collider: &Collider, color: DebugColor) -> Color {
    let [hue, saturation, lightness, opacity] = color;
    if collider.is_sensor() {
        return Color::from_hsl(SENSOR_HUE, 0.7, 0.6, 0.8);
    }
    // Multiples of the golden section spread evenly, however many there are.
    let share = (handle.into_raw_parts().0 as f32 * 0.618_034).fract() - 0.5;
    let hue = if saturation < 0.3 { hue } else { hue + HUE_RANGE * share };
    Color::from_hsl(hue, saturation, lightness, opacity)
}
