//! Flags of query filters, with the bits of Rapier 0.32.

use crate::dynamics::RigidBodySet;
use crate::geometry::Collider;
use engine::pipeline::QueryFilterFlags as EngineFlags;

bitflags::bitflags! {
    /// Kinds of colliders that a query excludes.
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Default)]
    pub struct QueryFilterFlags: u32 {
        /// Excludes colliders of fixed bodies, and colliders without a body.
        const EXCLUDE_FIXED = 1;
        /// Excludes colliders of kinematic bodies.
        const EXCLUDE_KINEMATIC = 1 << 1;
        /// Excludes colliders of dynamic bodies.
        const EXCLUDE_DYNAMIC = 1 << 2;
        /// Excludes sensors.
        const EXCLUDE_SENSORS = 1 << 3;
        /// Excludes all colliders that are not sensors.
        const EXCLUDE_SOLIDS = 1 << 4;
        /// Excludes all colliders except those of dynamic bodies.
        const ONLY_DYNAMIC = Self::EXCLUDE_FIXED.bits() | Self::EXCLUDE_KINEMATIC.bits();
        /// Excludes all colliders except those of kinematic bodies.
        const ONLY_KINEMATIC = Self::EXCLUDE_FIXED.bits() | Self::EXCLUDE_DYNAMIC.bits();
        /// Excludes all colliders except those of fixed bodies and those without a body.
        const ONLY_FIXED = Self::EXCLUDE_KINEMATIC.bits() | Self::EXCLUDE_DYNAMIC.bits();
    }
}

/// The engine's bits are one place higher.
const SHIFT: u32 = 1;
const _: () = {
    assert!(EngineFlags::EXCLUDE_FIXED.bits() == QueryFilterFlags::EXCLUDE_FIXED.bits() << SHIFT);
    assert!(EngineFlags::ONLY_DYNAMIC.bits() == QueryFilterFlags::ONLY_DYNAMIC.bits() << SHIFT);
    assert!(EngineFlags::ONLY_FIXED.bits() == QueryFilterFlags::ONLY_FIXED.bits() << SHIFT);
    assert!(
        EngineFlags::EXCLUDE_SENSORS.bits() == QueryFilterFlags::EXCLUDE_SENSORS.bits() << SHIFT
    );
    assert!(EngineFlags::EXCLUDE_SOLIDS.bits() == QueryFilterFlags::EXCLUDE_SOLIDS.bits() << SHIFT);
};

impl From<QueryFilterFlags> for EngineFlags {
    fn from(flags: QueryFilterFlags) -> Self {
        Self::from_bits_truncate(flags.bits() << SHIFT)
    }
}

impl QueryFilterFlags {
    /// Returns whether a collider passes. The type of its body is that of the body in `bodies`.
    pub fn test(&self, bodies: &RigidBodySet, collider: &Collider) -> bool {
        let matter =
            if collider.is_sensor() { Self::EXCLUDE_SENSORS } else { Self::EXCLUDE_SOLIDS };
        !self.intersects(matter | Self::of_body(bodies, collider))
    }

    /// The flag that excludes the body type of a collider. None excludes a collider of an absent body.
    fn of_body(bodies: &RigidBodySet, collider: &Collider) -> Self {
        let Some(parent) = collider.parent() else { return Self::EXCLUDE_FIXED };
        match bodies.get(parent) {
            Some(body) if body.is_fixed() => Self::EXCLUDE_FIXED,
            Some(body) if body.is_kinematic() => Self::EXCLUDE_KINEMATIC,
            Some(_) => Self::EXCLUDE_DYNAMIC,
            None => Self::empty(),
        }
    }
}
