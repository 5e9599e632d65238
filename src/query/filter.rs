//! Filters of queries.

use crate::model::body::{RigidBodyHandle, RigidBodyType};
use crate::model::collider::{Collider, ColliderHandle, InteractionGroups};

bitflags::bitflags! {
    /// Kinds of colliders that a query excludes.
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Default, Hash)]
    pub struct QueryFilterFlags: u32 {
        /// Excludes colliders of fixed bodies, and colliders without a body.
        const EXCLUDE_FIXED = 1 << 1;
        /// Excludes colliders of kinematic bodies.
        const EXCLUDE_KINEMATIC = 1 << 2;
        /// Excludes colliders of dynamic bodies.
        const EXCLUDE_DYNAMIC = 1 << 3;
        /// Excludes sensors.
        const EXCLUDE_SENSORS = 1 << 4;
        /// Excludes all colliders that are not sensors.
        const EXCLUDE_SOLIDS = 1 << 5;
        /// Excludes all colliders except those of dynamic bodies.
        const ONLY_DYNAMIC = Self::EXCLUDE_FIXED.bits() | Self::EXCLUDE_KINEMATIC.bits();
        /// Excludes all colliders except those of kinematic bodies.
        const ONLY_KINEMATIC = Self::EXCLUDE_DYNAMIC.bits() | Self::EXCLUDE_FIXED.bits();
        /// Excludes all colliders except those of fixed bodies and those without a body.
        const ONLY_FIXED = Self::EXCLUDE_DYNAMIC.bits() | Self::EXCLUDE_KINEMATIC.bits();
    }
}

impl QueryFilterFlags {
    /// Returns whether colliders of this kind pass the filter.
    fn test(self, traits: &Traits) -> bool {
        if self.is_empty() {
            return true;
        }
        let body = match traits.body_type {
            RigidBodyType::Fixed => Self::EXCLUDE_FIXED,
            RigidBodyType::Dynamic => Self::EXCLUDE_DYNAMIC,
            RigidBodyType::KinematicPositionBased | RigidBodyType::KinematicVelocityBased => {
                Self::EXCLUDE_KINEMATIC
            }
        };
        let matter = if traits.is_sensor { Self::EXCLUDE_SENSORS } else { Self::EXCLUDE_SOLIDS };
        !self.intersects(body | matter)
    }
}

/// A condition of a query: returns whether a collider may be found.
pub type QueryPredicate<'a> = &'a dyn Fn(ColliderHandle, &Collider) -> bool;

/// Filter of a query: the conjunction of its conditions.
///
/// ```
/// # use rapier3d::prelude::*;
/// # let player = RigidBodyHandle::default();
/// let filter = QueryFilter::default().exclude_sensors().exclude_rigid_body(player);
/// ```
///
/// Disabled colliders are never found.
#[derive(Copy, Clone, Default)]
pub struct QueryFilter<'a> {
    /// Excluded kinds of colliders.
    pub flags: QueryFilterFlags,
    /// Memberships and filter of the query, tested against the collision groups of the colliders.
    pub groups: Option<InteractionGroups>,
    /// One excluded collider.
    pub exclude_collider: Option<ColliderHandle>,
    /// A body whose colliders are all excluded.
    pub exclude_rigid_body: Option<RigidBodyHandle>,
    /// Condition that is tested last, after all others; `false` excludes the collider.
    pub predicate: Option<QueryPredicate<'a>>,
}

impl core::fmt::Debug for QueryFilter<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("QueryFilter")
            .field("flags", &self.flags)
            .field("groups", &self.groups)
            .field("exclude_collider", &self.exclude_collider)
            .field("exclude_rigid_body", &self.exclude_rigid_body)
            .field("predicate", &self.predicate.map(|_| "…"))
            .finish()
    }
}

impl From<QueryFilterFlags> for QueryFilter<'_> {
    fn from(flags: QueryFilterFlags) -> Self {
        Self { flags, ..Self::default() }
    }
}

impl From<InteractionGroups> for QueryFilter<'_> {
    fn from(groups: InteractionGroups) -> Self {
        Self { groups: Some(groups), ..Self::default() }
    }
}

impl<'a> QueryFilter<'a> {
    /// A filter that excludes nothing.
    pub fn new() -> Self {
        Self::default()
    }

    fn excluding(self, flags: QueryFilterFlags) -> Self {
        Self { flags: self.flags | flags, ..self }
    }

    /// Excludes colliders of fixed bodies, and colliders without a body.
    #[must_use]
    pub fn exclude_fixed(self) -> Self {
        self.excluding(QueryFilterFlags::EXCLUDE_FIXED)
    }

    /// Excludes colliders of kinematic bodies.
    #[must_use]
    pub fn exclude_kinematic(self) -> Self {
        self.excluding(QueryFilterFlags::EXCLUDE_KINEMATIC)
    }

    /// Excludes colliders of dynamic bodies.
    #[must_use]
    pub fn exclude_dynamic(self) -> Self {
        self.excluding(QueryFilterFlags::EXCLUDE_DYNAMIC)
    }

    /// Excludes all colliders except those of dynamic bodies.
    #[must_use]
    pub fn only_dynamic(self) -> Self {
        self.excluding(QueryFilterFlags::ONLY_DYNAMIC)
    }

    /// Excludes all colliders except those of kinematic bodies.
    #[must_use]
    pub fn only_kinematic(self) -> Self {
        self.excluding(QueryFilterFlags::ONLY_KINEMATIC)
    }

    /// Excludes all colliders except those of fixed bodies and those without a body.
    #[must_use]
    pub fn only_fixed(self) -> Self {
        self.excluding(QueryFilterFlags::ONLY_FIXED)
    }

    /// Excludes sensors.
    #[must_use]
    pub fn exclude_sensors(self) -> Self {
        self.excluding(QueryFilterFlags::EXCLUDE_SENSORS)
    }

    /// Excludes all colliders that are not sensors.
    #[must_use]
    pub fn exclude_solids(self) -> Self {
        self.excluding(QueryFilterFlags::EXCLUDE_SOLIDS)
    }

    /// Excludes colliders whose collision groups do not interact with the given groups.
    #[must_use]
    pub fn groups(self, groups: InteractionGroups) -> Self {
        Self { groups: Some(groups), ..self }
    }

    /// Excludes one collider. A second call replaces the first.
    #[must_use]
    pub fn exclude_collider(self, collider: ColliderHandle) -> Self {
        Self { exclude_collider: Some(collider), ..self }
    }

    /// Excludes all colliders of a body. A second call replaces the first.
    #[must_use]
    pub fn exclude_rigid_body(self, body: RigidBodyHandle) -> Self {
        Self { exclude_rigid_body: Some(body), ..self }
    }

    /// Excludes colliders for which the predicate returns `false`. A second call replaces the first.
    #[must_use]
    pub fn predicate(self, predicate: QueryPredicate<'a>) -> Self {
        Self { predicate: Some(predicate), ..self }
    }

    /// Returns whether a collider passes the filter.
    ///
    /// The type of its body is the one of the last step, or of the moment when the collider was attached.
    pub fn test(&self, handle: ColliderHandle, collider: &Collider) -> bool {
        self.test_traits(handle, &Traits::of(collider))
            && self.predicate.is_none_or(|predicate| predicate(handle, collider))
    }

    /// Returns whether all conditions except the predicate hold.
    pub(super) fn test_traits(&self, handle: ColliderHandle, traits: &Traits) -> bool {
        self.flags.test(traits)
            && self.exclude_collider != Some(handle)
            && (self.exclude_rigid_body.is_none() || self.exclude_rigid_body != traits.body)
            && self.groups.is_none_or(|groups| traits.groups.test(groups))
    }
}

/// The input of a filter.
#[derive(Copy, Clone, Debug)]
pub(super) struct Traits {
    body: Option<RigidBodyHandle>,
    body_type: RigidBodyType,
    is_sensor: bool,
    groups: InteractionGroups,
}

impl Traits {
    pub fn of(collider: &Collider) -> Self {
        Self {
            body: collider.parent(),
            body_type: collider.parent_type.unwrap_or(RigidBodyType::Fixed),
            is_sensor: collider.is_sensor(),
            groups: collider.collision_groups(),
        }
    }
}
