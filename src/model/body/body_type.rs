//! The cause of a body's motion.

/// The cause of a body's motion.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum RigidBodyType {
    /// Forces, gravity, contacts and joints move the body.
    #[default]
    Dynamic,
    /// It never moves: the ground, a wall.
    Fixed,
    /// The user sets its pose at the end of the next step
    /// ([`RigidBody::set_next_kinematic_position`](super::RigidBody::set_next_kinematic_position)). The step
    /// derives its velocity, so that it pushes and carries touching bodies.
    KinematicPositionBased,
    /// The user sets its velocity ([`RigidBody::set_linvel`](super::RigidBody::set_linvel)). Contacts do not
    /// slow it down.
    KinematicVelocityBased,
}

impl RigidBodyType {
    /// Returns whether forces move the body.
    pub const fn is_dynamic(self) -> bool {
        matches!(self, Self::Dynamic)
    }

    /// Returns whether the body never moves.
    pub const fn is_fixed(self) -> bool {
        matches!(self, Self::Fixed)
    }

    /// Returns whether the user alone moves the body.
    pub const fn is_kinematic(self) -> bool {
        matches!(self, Self::KinematicPositionBased | Self::KinematicVelocityBased)
    }

    /// Returns whether the body can move.
    pub const fn is_dynamic_or_kinematic(self) -> bool {
        !self.is_fixed()
    }
}
