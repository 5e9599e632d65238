//! Options of a collider's pairs: the body types it collides with, the user's hooks, and the events.

use crate::model::body::RigidBodyType;

bitflags::bitflags! {
    /// Pairs of body types for which a collider's pairs are computed. A collider without a body counts as
    /// attached to a fixed one.
    ///
    /// A pair is computed if either of its colliders requests it. The default is dynamic against everything;
    /// the other combinations exert no forces and only serve events, queries of contacts and sensors.
    #[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct ActiveCollisionTypes: u16 {
        /// Two dynamic bodies.
        const DYNAMIC_DYNAMIC = bit(ROW_DYNAMIC, ROW_DYNAMIC);
        /// A dynamic and a kinematic body.
        const DYNAMIC_KINEMATIC = bit(ROW_DYNAMIC, ROW_POSITION_BASED) | bit(ROW_DYNAMIC, ROW_VELOCITY_BASED);
        /// A dynamic and a fixed body.
        const DYNAMIC_FIXED = bit(ROW_DYNAMIC, ROW_FIXED);
        /// Two kinematic bodies.
        const KINEMATIC_KINEMATIC = bit(ROW_POSITION_BASED, ROW_POSITION_BASED)
            | bit(ROW_POSITION_BASED, ROW_VELOCITY_BASED)
            | bit(ROW_VELOCITY_BASED, ROW_POSITION_BASED)
            | bit(ROW_VELOCITY_BASED, ROW_VELOCITY_BASED);
        /// A kinematic and a fixed body.
        const KINEMATIC_FIXED = bit(ROW_POSITION_BASED, ROW_FIXED) | bit(ROW_VELOCITY_BASED, ROW_FIXED);
        /// Two fixed bodies.
        const FIXED_FIXED = bit(ROW_FIXED, ROW_FIXED);
    }
}

// Rows and columns of the 4 × 4 table of body types in the 16 bits.
const ROW_DYNAMIC: u16 = 0;
const ROW_FIXED: u16 = 1;
const ROW_POSITION_BASED: u16 = 2;
const ROW_VELOCITY_BASED: u16 = 3;

const fn bit(row: u16, column: u16) -> u16 {
    1 << (4 * row + column)
}

const fn row(body_type: RigidBodyType) -> u16 {
    match body_type {
        RigidBodyType::Dynamic => ROW_DYNAMIC,
        RigidBodyType::Fixed => ROW_FIXED,
        RigidBodyType::KinematicPositionBased => ROW_POSITION_BASED,
        RigidBodyType::KinematicVelocityBased => ROW_VELOCITY_BASED,
    }
}

impl ActiveCollisionTypes {
    /// Returns whether pairs of bodies of these types are computed. The order does not matter.
    #[inline]
    pub const fn test(self, type1: RigidBodyType, type2: RigidBodyType) -> bool {
        let (row1, row2) = (row(type1), row(type2));
        self.bits() & (bit(row1, row2) | bit(row2, row1)) != 0
    }
}

impl Default for ActiveCollisionTypes {
    fn default() -> Self {
        Self::DYNAMIC_DYNAMIC | Self::DYNAMIC_KINEMATIC | Self::DYNAMIC_FIXED
    }
}

bitflags::bitflags! {
    /// The user's hooks for the pairs of a collider. The default is none.
    #[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct ActiveHooks: u32 {
        /// Call [`contact_pair_flags`](crate::model::hooks::PhysicsHooks::contact_pair_flags), by default
        /// [`filter_contact_pair`](crate::model::hooks::PhysicsHooks::filter_contact_pair), for the pairs.
        const FILTER_CONTACT_PAIRS = 1;
        /// Call [`filter_intersection_pair`](crate::model::hooks::PhysicsHooks::filter_intersection_pair) for
        /// pairs with a sensor.
        const FILTER_INTERSECTION_PAIR = 1 << 1;
        /// Call [`modify_solver_contact`](crate::model::hooks::PhysicsHooks::modify_solver_contact) before
        /// the contacts are solved.
        const MODIFY_SOLVER_CONTACTS = 1 << 2;
    }
}

bitflags::bitflags! {
    /// The events of the pairs of a collider. The default is none.
    #[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct ActiveEvents: u32 {
        /// Events of two colliders that begin or stop to touch or intersect.
        const COLLISION_EVENTS = 1;
        /// Events of every step in which the contact forces of a pair sum up to at least the collider's
        /// threshold, and not to zero.
        const CONTACT_FORCE_EVENTS = 1 << 1;
    }
}

#[cfg(test)]
mod tests {
    use super::ActiveCollisionTypes as Types;
    use crate::model::body::RigidBodyType::{
        Dynamic, Fixed, KinematicPositionBased as ByPosition, KinematicVelocityBased as ByVelocity,
    };

    #[test]
    fn each_flag_switches_its_pairs_and_no_other() {
        let table = [
            (Types::DYNAMIC_DYNAMIC, vec![(Dynamic, Dynamic)]),
            (Types::DYNAMIC_KINEMATIC, vec![(Dynamic, ByPosition), (Dynamic, ByVelocity)]),
            (Types::DYNAMIC_FIXED, vec![(Dynamic, Fixed)]),
            (
                Types::KINEMATIC_KINEMATIC,
                vec![(ByPosition, ByPosition), (ByPosition, ByVelocity), (ByVelocity, ByVelocity)],
            ),
            (Types::KINEMATIC_FIXED, vec![(ByPosition, Fixed), (ByVelocity, Fixed)]),
            (Types::FIXED_FIXED, vec![(Fixed, Fixed)]),
        ];
        for (flag, pairs) in &table {
            for (other, others_pairs) in &table {
                for &(a, b) in others_pairs {
                    let expected = flag == other && pairs.contains(&(a, b));
                    assert_eq!(flag.test(a, b), expected, "{flag:?} {a:?} {b:?}");
                    assert_eq!(flag.test(b, a), expected, "{flag:?} {b:?} {a:?}");
                }
            }
        }
    }

    #[test]
    fn by_default_dynamic_bodies_collide_with_everything() {
        let default = Types::default();
        for other in [Dynamic, Fixed, ByPosition, ByVelocity] {
            assert!(default.test(Dynamic, other) && default.test(other, Dynamic));
            assert!(other == Dynamic || !default.test(Fixed, other));
        }
    }
}
