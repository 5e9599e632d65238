//! The renderer of a world as lines.

use super::backend::{DebugRenderBackend, DebugRenderObject};
use super::outlines::Outlines;
use super::sketch::box_outline;
use super::style::{AXIS_HUES, DebugColor, DebugRenderStyle, times};
use crate::base::outline::Detail;
use crate::dim::math::{Pose, Vector};
use crate::dim::outline::pseudo_normals;
use crate::model::body::{RigidBody, RigidBodySet, RigidBodyType};
use crate::model::collider::{Collider, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;

bitflags::bitflags! {
    /// The drawn parts.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Hash)]
    pub struct DebugRenderMode: u32 {
        /// The shapes of colliders.
        const COLLIDER_SHAPES = 1 << 0;
        /// The axes of bodies, at their centres of mass.
        const RIGID_BODY_AXES = 1 << 1;
        /// The boxes of colliders.
        const COLLIDER_AABBS = 1 << 2;
        /// Contacts: from the point on one surface to the point on the other, and the normal.
        const CONTACTS = 1 << 3;
        /// Contacts of the solver: a normal at the point between the two surfaces.
        const SOLVER_CONTACTS = 1 << 4;
        /// The pseudo-normals of meshes and polylines, which determine their inside, if they have them.
        const PSEUDO_NORMALS = 1 << 5;
        /// Impulse joints: lines from each body to its anchor, and between the two anchors.
        const IMPULSE_JOINTS = 1 << 6;
        /// Multibody joints, drawn as impulse joints are.
        const MULTIBODY_JOINTS = 1 << 7;
        /// Joints of both kinds.
        const JOINTS = Self::IMPULSE_JOINTS.bits() | Self::MULTIBODY_JOINTS.bits();
        /// The free axes of the drawn joints, within their limits.
        const JOINT_AXES = 1 << 8;
    }
}

impl Default for DebugRenderMode {
    fn default() -> Self {
        Self::COLLIDER_SHAPES | Self::JOINTS
    }
}

/// A renderer of a world as coloured lines.
///
/// Reuse it for all frames: it caches the outlines of large meshes.
#[derive(Clone, Default)]
pub struct DebugRenderPipeline {
    /// Colours and lengths.
    pub style: DebugRenderStyle,
    /// The drawn parts.
    pub mode: DebugRenderMode,
    outlines: Outlines,
}

impl DebugRenderPipeline {
    /// A pipeline that draws in this style the parts that `mode` selects.
    pub fn new(style: DebugRenderStyle, mode: DebugRenderMode) -> Self {
        Self { style, mode, outlines: Outlines::default() }
    }

    /// A pipeline that draws everything in this style.
    pub fn render_all(style: DebugRenderStyle) -> Self {
        Self::new(style, DebugRenderMode::all())
    }

    #[cfg(test)]
    pub(super) fn outlines_kept(&self) -> usize {
        self.outlines.len()
    }

    /// Draws everything that the mode selects.
    pub fn render(
        &mut self,
        backend: &mut dyn DebugRenderBackend,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        impulse_joints: &ImpulseJointSet,
        multibody_joints: &MultibodyJointSet,
        narrow_phase: &NarrowPhase,
    ) {
        self.render_rigid_bodies(backend, bodies);
        self.render_colliders(backend, bodies, colliders);
        self.render_joints(backend, bodies, impulse_joints, multibody_joints);
        self.render_contacts(backend, colliders, narrow_phase);
    }

    /// Draws the axes of all bodies, at their centres of mass.
    pub fn render_rigid_bodies(
        &mut self,
        backend: &mut dyn DebugRenderBackend,
        bodies: &RigidBodySet,
    ) {
        if !self.mode.contains(DebugRenderMode::RIGID_BODY_AXES) {
            return;
        }
        for (handle, body) in bodies.iter() {
            let object = DebugRenderObject::RigidBody(handle, body);
            if !backend.filter_object(object) {
                continue;
            }
            let (center, rotation) = (body.center_of_mass(), body.position().rotation);
            for (axis, hue) in Vector::AXES.into_iter().zip(AXIS_HUES) {
                let tip = center + rotation * axis * self.style.rigid_body_axes_length;
                let color = self.body_color(body, [hue, 1.0, 0.6, 1.0]);
                backend.draw_line(object, center, tip, color);
            }
        }
    }

    /// Draws the shapes, boxes and pseudo-normals of all colliders, whichever the mode selects.
    pub fn render_colliders(
        &mut self,
        backend: &mut dyn DebugRenderBackend,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
    ) {
        for (handle, collider) in colliders.iter() {
            let object = DebugRenderObject::Collider(handle, collider);
            let modes = DebugRenderMode::COLLIDER_SHAPES | DebugRenderMode::PSEUDO_NORMALS;
            if self.mode.intersects(modes) && backend.filter_object(object) {
                self.render_shape(backend, object, bodies, collider);
            }
            if self.mode.contains(DebugRenderMode::COLLIDER_AABBS) {
                let aabb = collider.compute_aabb();
                let object = DebugRenderObject::ColliderAabb(handle, collider, &aabb);
                if backend.filter_object(object) {
                    let pose = Pose::from_translation(aabb.center());
                    let edges = box_outline(aabb.half_extents(), &pose);
                    let color = self.style.collider_aabb_color;
                    draw(backend, object, (&edges.points, &edges.lines), &Pose::IDENTITY, color);
                }
            }
        }
        self.outlines.drop_unused();
    }

    fn render_shape(
        &mut self,
        backend: &mut dyn DebugRenderBackend,
        object: DebugRenderObject,
        bodies: &RigidBodySet,
        collider: &Collider,
    ) {
        let pose = collider.position();
        if self.mode.contains(DebugRenderMode::COLLIDER_SHAPES) {
            let color = self.collider_color(bodies, collider);
            let detail = Detail::new(self.style.subdivisions, self.style.border_subdivisions);
            let sketch = self.outlines.of(collider.shared_shape(), detail);
            draw(backend, object, (&sketch.points, &sketch.lines), pose, color);
        }
        if self.mode.contains(DebugRenderMode::PSEUDO_NORMALS) {
            let [at_vertices, at_edges] = pseudo_normals(&collider.shape().as_typed_shape());
            let style = &self.style;
            for (normals, color) in [
                (at_vertices, style.vertex_pseudo_normal_color),
                (at_edges, style.edge_pseudo_normal_color),
            ] {
                for (foot, normal) in normals {
                    // The mesh keeps weighted sums of the normals of faces.
                    let tip = foot + normal.normalize_or_zero() * style.pseudo_normal_length;
                    backend.draw_line(object, *pose * foot, *pose * tip, color);
                }
            }
        }
    }

    /// Draws the contacts of all pairs.
    pub fn render_contacts(
        &mut self,
        backend: &mut dyn DebugRenderBackend,
        colliders: &ColliderSet,
        narrow_phase: &NarrowPhase,
    ) {
        let (depths, points) = (
            self.mode.contains(DebugRenderMode::CONTACTS),
            self.mode.contains(DebugRenderMode::SOLVER_CONTACTS),
        );
        if !depths && !points {
            return;
        }
        let style = &self.style;
        for (handle1, handle2, pair) in narrow_phase.contact_pairs() {
            let (Some(collider1), Some(collider2)) =
                (colliders.get(handle1), colliders.get(handle2))
            else {
                continue;
            };
            let object = DebugRenderObject::ContactPair(pair, collider1, collider2);
            if !backend.filter_object(object) {
                continue;
            }
            for manifold in &pair.manifolds {
                let normal = manifold.data.normal * style.contact_normal_length;
                for contact in &manifold.data {
                    let p1 = *collider1.position() * contact.local_p1;
                    let p2 = *collider2.position() * contact.local_p2;
                    if depths {
                        backend.draw_line(object, p1, p2, style.contact_depth_color);
                        backend.draw_line(object, p1, p1 + normal, style.contact_normal_color);
                    }
                    if points {
                        let tip = contact.point + normal;
                        backend.draw_line(object, contact.point, tip, style.contact_normal_color);
                    }
                }
            }
        }
    }

    /// The colour of a collider: by the type of its body, dimmed if it sleeps or is disabled.
    fn collider_color(&self, bodies: &RigidBodySet, collider: &Collider) -> DebugColor {
        let style = &self.style;
        let body = collider.parent().and_then(|parent| bodies.get(parent));
        let color = match body.map(RigidBody::body_type) {
            None => style.collider_parentless_color,
            Some(RigidBodyType::Dynamic) => style.collider_dynamic_color,
            Some(RigidBodyType::Fixed) => style.collider_fixed_color,
            Some(_) => style.collider_kinematic_color,
        };
        match body {
            _ if !collider.is_enabled() => times(color, style.disabled_color_multiplier),
            Some(body) => self.body_color(body, color),
            None => color,
        }
    }

    /// A colour, dimmed if the body sleeps or is disabled.
    fn body_color(&self, body: &RigidBody, color: DebugColor) -> DebugColor {
        let style = &self.style;
        let activation = body.activation();
        if !body.is_enabled() {
            times(color, style.disabled_color_multiplier)
        } else if body.is_sleeping() {
            times(color, style.sleep_color_multiplier)
        } else if body.is_dynamic() && activation.is_eligible_for_sleep() {
            times(color, style.sleep_eligible_color_multiplier)
        } else {
            color
        }
    }
}

/// Draws the lines between points of a sketch.
fn draw(
    backend: &mut dyn DebugRenderBackend,
    object: DebugRenderObject,
    (points, lines): (&[Vector], &[[u32; 2]]),
    pose: &Pose,
    color: DebugColor,
) {
    backend.draw_polyline(object, points, lines, pose, &Vector::ONE, color);
}
