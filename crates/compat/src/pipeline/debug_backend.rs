//! The user's backend, which draws lines, and its adaptor for the engine.

use crate::dynamics::{
    ImpulseJoint, ImpulseJointHandle, Multibody, MultibodyJointHandle, MultibodyLink, RigidBody,
    RigidBodyHandle,
};
use crate::geometry::{Aabb, Collider, ColliderHandle, ContactPair, to_pair};
use crate::math::{Pose, Vector};
use engine::pipeline::DebugRenderObject as EngineObject;

pub use engine::pipeline::DebugColor;

/// The object that a line belongs to.
#[derive(Copy, Clone)]
pub enum DebugRenderObject<'a> {
    /// A body: its axes.
    RigidBody(RigidBodyHandle, &'a RigidBody),
    /// A collider: its shape.
    Collider(ColliderHandle, &'a Collider),
    /// A collider's box in world space.
    ColliderAabb(ColliderHandle, &'a Collider, &'a Aabb),
    /// An impulse joint.
    ImpulseJoint(ImpulseJointHandle, &'a ImpulseJoint),
    /// A joint of a multibody.
    MultibodyJoint(MultibodyJointHandle, &'a Multibody, &'a MultibodyLink),
    /// The contacts of two colliders.
    ContactPair(&'a ContactPair, &'a Collider, &'a Collider),
    /// A soft body: never drawn, because the engine has none.
    #[cfg(rapier036)]
    SoftBody(crate::dynamics::SoftBodyHandle, &'a crate::dynamics::SoftBody),
}

/// A backend that draws lines. [`Self::draw_line`] is the only required function.
pub trait DebugRenderBackend {
    /// Returns whether an object is drawn.
    fn filter_object(&self, _object: DebugRenderObject) -> bool {
        true
    }

    /// Draws a line between two points of the world.
    fn draw_line(&mut self, object: DebugRenderObject, a: Vector, b: Vector, color: DebugColor);

    /// Draws lines between pairs of vertices, which are scaled and then moved by `transform`.
    fn draw_polyline(
        &mut self,
        object: DebugRenderObject,
        vertices: &[Vector],
        indices: &[[u32; 2]],
        transform: &Pose,
        scale: Vector,
        color: DebugColor,
    ) {
        for ends in indices {
            if let [Some(a), Some(b)] = ends.map(|end| vertices.get(end as usize)) {
                self.draw_line(object, *transform * (*a * scale), *transform * (*b * scale), color);
            }
        }
    }

    /// Draws lines from each vertex to the next, and from the last to the first if `closed`.
    fn draw_line_strip(
        &mut self,
        object: DebugRenderObject,
        vertices: &[Vector],
        transform: &Pose,
        scale: Vector,
        color: DebugColor,
        closed: bool,
    ) {
        let count = vertices.len() as u32;
        let edges: Vec<_> = (1..count).map(|end| [end - 1, end]).collect();
        self.draw_polyline(object, vertices, &edges, transform, scale, color);
        if closed && count > 2 {
            self.draw_polyline(object, vertices, &[[count - 1, 0]], transform, scale, color);
        }
    }
}

/// A backend for the engine.
pub(super) struct Backend<'a, B>(pub &'a mut B);

/// Calls a function with an object of the engine in upstream's form. An unknown kind of object is skipped.
fn with_object<R>(
    object: EngineObject<'_>,
    call: impl FnOnce(DebugRenderObject<'_>) -> R,
) -> Option<R> {
    Some(match object {
        EngineObject::RigidBody(handle, body) => call(DebugRenderObject::RigidBody(handle, body)),
        EngineObject::Collider(handle, collider) => {
            call(DebugRenderObject::Collider(handle, collider))
        }
        EngineObject::ColliderAabb(handle, collider, aabb) => {
            call(DebugRenderObject::ColliderAabb(handle, collider, aabb))
        }
        EngineObject::ImpulseJoint(handle, joint) => {
            call(DebugRenderObject::ImpulseJoint(handle, joint))
        }
        EngineObject::MultibodyJoint(handle, multibody, link) => {
            call(DebugRenderObject::MultibodyJoint(handle, Multibody::wrap(multibody), link))
        }
        EngineObject::ContactPair(pair, collider1, collider2) => {
            call(DebugRenderObject::ContactPair(&to_pair(pair), collider1, collider2))
        }
        _ => return None,
    })
}

impl<B: DebugRenderBackend> engine::pipeline::DebugRenderBackend for Backend<'_, B> {
    fn filter_object(&self, object: EngineObject) -> bool {
        with_object(object, |object| self.0.filter_object(object)).unwrap_or(false)
    }

    fn draw_line(&mut self, object: EngineObject, a: Vector, b: Vector, color: DebugColor) {
        with_object(object, |object| self.0.draw_line(object, a, b, color));
    }

    fn draw_polyline(
        &mut self,
        object: EngineObject,
        vertices: &[Vector],
        indices: &[[u32; 2]],
        transform: &Pose,
        scale: &Vector,
        color: DebugColor,
    ) {
        with_object(object, |object| {
            self.0.draw_polyline(object, vertices, indices, transform, *scale, color);
        });
    }

    fn draw_line_strip(
        &mut self,
        object: EngineObject,
        vertices: &[Vector],
        transform: &Pose,
        scale: &Vector,
        color: DebugColor,
        closed: bool,
    ) {
        with_object(object, |object| {
            self.0.draw_line_strip(object, vertices, transform, *scale, color, closed);
        });
    }
}
