//! The user's backend, which draws lines.

use super::style::DebugColor;
use crate::dim::math::{Pose, Vector};
use crate::model::body::{RigidBody, RigidBodyHandle};
use crate::model::collider::{Collider, ColliderHandle};
use crate::model::contact::ContactPair;
use crate::model::joint::{ImpulseJoint, ImpulseJointHandle};
use crate::model::multibody::{Multibody, MultibodyJointHandle, MultibodyLink};
use parry::bounding_volume::Aabb;

/// The object that a line belongs to.
#[derive(Copy, Clone)]
#[non_exhaustive]
pub enum DebugRenderObject<'a> {
    /// A rigid body: its axes.
    RigidBody(RigidBodyHandle, &'a RigidBody),
    /// A collider: its shape.
    Collider(ColliderHandle, &'a Collider),
    /// A collider's box in world space.
    ColliderAabb(ColliderHandle, &'a Collider, &'a Aabb),
    /// The contacts of two colliders.
    ContactPair(&'a ContactPair, &'a Collider, &'a Collider),
    /// An impulse joint.
    ImpulseJoint(ImpulseJointHandle, &'a ImpulseJoint),
    /// A joint of a multibody: the one between this link and its parent.
    MultibodyJoint(MultibodyJointHandle, &'a Multibody, &'a MultibodyLink),
}

/// A backend that draws lines. [`Self::draw_line`] is the only required method.
pub trait DebugRenderBackend {
    /// Returns whether the object is drawn. Called before any of its lines.
    fn filter_object(&self, object: DebugRenderObject) -> bool {
        let _ = object;
        true
    }

    /// Draws a straight line between two points of the world.
    fn draw_line(&mut self, object: DebugRenderObject, a: Vector, b: Vector, color: DebugColor);

    /// Draws lines between pairs of `vertices`: `indices` are positions in it. The world position of a vertex
    /// `v` is `transform * (v * scale)`. A pair with an index out of range is skipped.
    fn draw_polyline(
        &mut self,
        object: DebugRenderObject,
        vertices: &[Vector],
        indices: &[[u32; 2]],
        transform: &Pose,
        scale: &Vector,
        color: DebugColor,
    ) {
        for &[a, b] in indices {
            if let (Some(&a), Some(&b)) = (vertices.get(a as usize), vertices.get(b as usize)) {
                let [a, b] = [a, b].map(|vertex| *transform * (vertex * *scale));
                self.draw_line(object, a, b, color);
            }
        }
    }

    /// Draws lines from each vertex to the next, and from the last to the first if `closed`. The world
    /// position of a vertex `v` is `transform * (v * scale)`.
    fn draw_line_strip(
        &mut self,
        object: DebugRenderObject,
        vertices: &[Vector],
        transform: &Pose,
        scale: &Vector,
        color: DebugColor,
        closed: bool,
    ) {
        let place = |vertex: Vector| *transform * (vertex * *scale);
        for pair in vertices.windows(2) {
            self.draw_line(object, place(pair[0]), place(pair[1]), color);
        }
        if let (true, [first, _, .., last]) = (closed, vertices) {
            self.draw_line(object, place(*last), place(*first), color);
        }
    }
}
