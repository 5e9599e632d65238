//! Joints between two bodies.

use crate::dim::{Vector, to_engine};
use crate::precision::Scalar;
use bevy::ecs::component::Component;
use bevy::ecs::entity::Entity;
use rapier::prelude::{
    FixedJoint, GenericJoint, JointAxis, PrismaticJoint, RopeJoint, SpringJoint,
};

/// A joint between the bodies of two entities. The component belongs to an entity of its own or to one of the
/// bodies; its removal removes the joint.
///
/// ```
/// # use bevy::prelude::*;
#[doc = concat!("# use ", env!("CARGO_CRATE_NAME"), "::prelude::*;")]
/// fn hang(mut commands: Commands) {
///     let post = commands.spawn(RigidBody::Fixed).id();
///     let lamp = commands.spawn((RigidBody::Dynamic, Collider::ball(0.2))).id();
///     commands.spawn(Joint::rope(post, lamp, 2.0));
/// }
/// # bevy::ecs::system::assert_is_system(hang);
/// ```
#[derive(Component, Copy, Clone, Debug)]
pub struct Joint {
    /// The entity of the first body.
    pub body1: Entity,
    /// The entity of the second body.
    pub body2: Entity,
    /// The engine's description: frames, axes, limits, motors.
    pub data: GenericJoint,
}

/// Joints of both dimensions. The hinge (`revolute`) has an axis in 3D.
impl Joint {
    /// Any joint of the engine.
    pub fn generic(body1: Entity, body2: Entity, data: impl Into<GenericJoint>) -> Self {
        Self { body1, body2, data: data.into() }
    }

    /// A rigid connection.
    pub fn fixed(body1: Entity, body2: Entity) -> Self {
        Self::generic(body1, body2, FixedJoint::new())
    }

    /// A slider along an axis, in the local space of both bodies.
    pub fn prismatic(body1: Entity, body2: Entity, axis: Vector) -> Self {
        Self::generic(body1, body2, PrismaticJoint::new(to_engine(axis)))
    }

    /// A rope: the anchors are at most `max_distance` apart.
    pub fn rope(body1: Entity, body2: Entity, max_distance: Scalar) -> Self {
        Self::generic(body1, body2, RopeJoint::new(max_distance))
    }

    /// A damped spring between the anchors.
    pub fn spring(
        body1: Entity,
        body2: Entity,
        rest_length: Scalar,
        stiffness: Scalar,
        damping: Scalar,
    ) -> Self {
        let anchor = to_engine(Vector::ZERO);
        let mut spring = SpringJoint::new(anchor, anchor, rest_length, stiffness);
        spring.set_damping(damping);
        Self::generic(body1, body2, spring)
    }

    /// Sets the anchors, in the local space of each body.
    #[must_use]
    pub fn with_anchors(mut self, anchor1: Vector, anchor2: Vector) -> Self {
        self.data.set_local_anchor1(to_engine(anchor1));
        self.data.set_local_anchor2(to_engine(anchor2));
        self
    }

    /// Sets the range of an axis (length units or radians).
    #[must_use]
    pub fn with_limits(mut self, axis: JointAxis, limits: [Scalar; 2]) -> Self {
        self.data.set_limits(axis, limits);
        self
    }

    /// Drives an axis at a velocity. `factor` is the damping of the motor.
    #[must_use]
    pub fn with_motor_velocity(
        mut self,
        axis: JointAxis,
        velocity: Scalar,
        factor: Scalar,
    ) -> Self {
        self.data.set_motor_velocity(axis, velocity, factor);
        self
    }

    /// Drives an axis to a position, like a damped spring.
    #[must_use]
    pub fn with_motor_position(
        mut self,
        axis: JointAxis,
        position: Scalar,
        stiffness: Scalar,
        damping: Scalar,
    ) -> Self {
        self.data.set_motor_position(axis, position, stiffness, damping);
        self
    }

    /// Sets whether the colliders of the two bodies collide with each other. They do by default.
    #[must_use]
    pub fn with_contacts(mut self, enabled: bool) -> Self {
        self.data.set_contacts_enabled(enabled);
        self
    }

    /// Sets the force and the torque above which the joint breaks. [`JointBroken`](crate::JointBroken) is
    /// then triggered.
    #[must_use]
    pub fn with_break_thresholds(mut self, force: Scalar, torque: Scalar) -> Self {
        self.data.set_break_thresholds(force, torque);
        self
    }
}
