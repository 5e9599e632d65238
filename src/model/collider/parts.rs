//! The smaller parts of a collider's record.

use super::{ActiveCollisionTypes, ActiveEvents, ActiveHooks, InteractionGroups};
use crate::dim::math::Pose;
use crate::model::body::RigidBodyHandle;

/// The body of a collider, and the collider's pose relative to the body.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ColliderParent {
    /// The body.
    pub handle: RigidBodyHandle,
    /// Collider frame → body frame.
    pub pos_wrt_parent: Pose,
}

/// Whether a collider takes part in the simulation and in queries.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum ColliderEnabled {
    /// The collider takes part.
    #[default]
    Enabled,
    /// The collider does not take part, because its body is disabled.
    DisabledByParent,
    /// The collider does not take part: disabled by the user.
    Disabled,
}

/// Interaction settings and events of a collider.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ColliderFlags {
    /// Pairs of body types with which it collides.
    pub active_collision_types: ActiveCollisionTypes,
    /// Groups for contacts.
    pub collision_groups: InteractionGroups,
    /// Groups for contact forces.
    pub solver_groups: InteractionGroups,
    /// Hooks for its pairs.
    pub active_hooks: ActiveHooks,
    /// Events of its pairs.
    pub active_events: ActiveEvents,
    /// Whether the collider takes part in the simulation and in queries.
    pub enabled: ColliderEnabled,
}

bitflags::bitflags! {
    /// Edits of a collider since the last step.
    #[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct ColliderChanges: u32 {
        /// The set's list of modified colliders contains it, for any modification.
        const IN_MODIFIED_SET = 1;
        /// It was attached to another body, or detached.
        const PARENT = 1 << 1;
        /// Its pose in the world or on its body.
        const POSITION = 1 << 2;
        /// Its collision or solver groups.
        const GROUPS = 1 << 3;
        /// Its shape or its contact skin.
        const SHAPE = 1 << 4;
        /// Whether it is a sensor.
        const TYPE = 1 << 5;
        /// Its body's dominance group.
        const PARENT_EFFECTIVE_DOMINANCE = 1 << 6;
        /// Its mass or mass distribution: the body's mass must be recomputed.
        const LOCAL_MASS_PROPERTIES = 1 << 7;
        /// It was enabled or disabled.
        const ENABLED_OR_DISABLED = 1 << 8;
        /// Vertices of its shape moved, but the shape consists of the same parts as before.
        const DEFORMED = 1 << 9;
        /// Its friction, restitution, or combination rules.
        const MATERIAL = 1 << 10;
        /// The kinds of bodies it collides with.
        const INTERACTIONS = 1 << 11;
        /// Its shape was borrowed mutably, and must be checked.
        const UNCHECKED_SHAPE = 1 << 12;
        /// Its hooks.
        const HOOKS = 1 << 13;
        /// Its events.
        const EVENTS = 1 << 14;
    }
}

impl Default for ColliderChanges {
    fn default() -> Self {
        Self::empty()
    }
}

impl ColliderChanges {
    /// Edits that affect the set of possible partners, or the kind of the pairs.
    pub(crate) const PARTNER_CHANGES: Self = Self::PARENT
        .union(Self::TYPE)
        .union(Self::ENABLED_OR_DISABLED)
        .union(Self::GROUPS)
        .union(Self::INTERACTIONS);
    /// Edits that may change the forces of contacts that persist.
    pub(crate) const CONTACT_CHANGES: Self = Self::POSITION
        .union(Self::SHAPE)
        .union(Self::DEFORMED)
        .union(Self::MATERIAL)
        .union(Self::GROUPS)
        .union(Self::HOOKS);

    /// All changes of a collider that is new to the step, except its place in the change list and the check
    /// of its shape.
    pub(crate) const fn everything() -> Self {
        Self::all().difference(Self::IN_MODIFIED_SET.union(Self::UNCHECKED_SHAPE))
    }

    /// Returns whether anything changed that affects the broad phase.
    pub const fn needs_broad_phase_update(self) -> bool {
        const BROAD_PHASE_CHANGES: ColliderChanges = ColliderChanges::PARENT
            .union(ColliderChanges::POSITION)
            .union(ColliderChanges::SHAPE)
            .union(ColliderChanges::TYPE)
            .union(ColliderChanges::ENABLED_OR_DISABLED)
            .union(ColliderChanges::DEFORMED);
        self.intersects(BROAD_PHASE_CHANGES)
    }

    /// Returns whether anything changed that affects the contacts.
    pub const fn needs_narrow_phase_update(self) -> bool {
        const IRRELEVANT_CHANGES: ColliderChanges = ColliderChanges::IN_MODIFIED_SET
            .union(ColliderChanges::LOCAL_MASS_PROPERTIES)
            .union(ColliderChanges::UNCHECKED_SHAPE);
        self.intersects(IRRELEVANT_CHANGES.complement())
    }
}
