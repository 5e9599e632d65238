//! Awake bodies and islands.

use super::awake::AwakeBodies;
use super::groups::BodyGroups;
use super::link::NONE;
use super::motion::BodyMotion;
use super::pace::Pace;
use crate::base::fault::{Fault, ensure};
use crate::base::id_set::IdSet;
use crate::base::in_place::clone_in_place;
use crate::model::body::{RigidBodyHandle, RigidBodySet};
use crate::model::collider::Collider;
use crate::model::constraint_graph::ConstraintGraph;
use crate::model::joint::JointLinks;
use crate::model::stamp::WorldStamp;

/// Dynamic bodies that contacts or joints connect, directly or through other dynamic bodies.
///
/// Islands persist. They merge at once when two of them touch, and are split lazily, when one with cut links
/// is ready to sleep. Finding them anew each step would cost all awake contacts.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Island {
    /// Dynamic bodies. The link of each body contains its position here.
    pub bodies: Vec<RigidBodyHandle>,
    /// Whether links were cut since the island was last known to be connected.
    pub is_cut: bool,
    /// Whether the island is asleep, outside of all per-step lists.
    pub sleeping: bool,
    /// The step in which it was last split, or came out of a split.
    pub split_at: u32,
}

clone_in_place!(Island { bodies, is_cut, sleeping, split_at });

/// Islands of the simulation: the awake bodies, and the bodies that fall asleep together.
///
/// Every enabled dynamic body belongs to one island. Bodies of an island fall asleep together, once each of
/// them has been at rest for its
/// [`time_until_sleep`](crate::model::body::RigidBodyActivation::time_until_sleep), and wake together.
/// Sleeping bodies are free: no per-step loop visits them.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct IslandManager {
    /// Awake dynamic and kinematic bodies.
    pub(crate) awake: AwakeBodies,
    /// All islands, with holes.
    islands: Vec<Island>,
    free: Vec<u32>,
    /// The colours of solved manifolds.
    pub(crate) graph: ConstraintGraph,
    /// The same for joints, by their slots.
    pub(crate) joint_graph: ConstraintGraph<u32>,
    /// The joints that the step has applied.
    pub(crate) joints: JointLinks,
    /// Bodies that multibodies hold together.
    pub(crate) groups: BodyGroups,
    /// Step count, for the time since an island was split.
    pub(crate) step: u32,
    pub(crate) pace: Pace,
    /// By body slot: the motion of the body in the last step.
    pub(crate) motion: Vec<BodyMotion>,
    /// Slots of the sleeping bodies that the user inserted or moved since the last step.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(crate) placed_asleep: IdSet,
    pub(crate) stamp: WorldStamp,
}

clone_in_place!(IslandManager {
    awake,
    islands,
    free,
    graph,
    joint_graph,
    joints,
    groups,
    step,
    pace,
    motion,
    placed_asleep,
    stamp
});

impl IslandManager {
    /// An empty manager.
    pub fn new() -> Self {
        Self::default()
    }

    /// Handles of all awake dynamic and kinematic bodies.
    pub fn active_bodies(&self) -> &[RigidBodyHandle] {
        &self.awake
    }

    /// Number of awake dynamic and kinematic bodies.
    pub fn num_active_bodies(&self) -> usize {
        self.awake.len()
    }

    /// Wakes a body and its island at once. The island has all dynamic bodies that contacts or joints connect
    /// to it, directly or through others. They are awake when this returns. Nothing happens if the handle is
    /// stale.
    ///
    /// A woken island stays awake for its full time until sleep, independent of `strong`. With the old time
    /// it would fall asleep again in the next step, before any force could move it. If the body is awake,
    /// `strong` restarts its time, and a weak wake-up has no effect.
    pub fn wake_up(&mut self, bodies: &mut RigidBodySet, handle: RigidBodyHandle, strong: bool) {
        let Some(body) = bodies.get_mut(handle) else { return };
        body.wake_up(strong);
        let island = self.islands.get(body.link.island as usize).filter(|island| island.sleeping);
        for &member in island.iter().flat_map(|island| &island.bodies) {
            if let Some(body) = bodies.get_mut(member) {
                body.wake_up(strong);
            }
        }
    }

    /// The island with this id.
    pub(crate) fn island(&self, id: u32) -> &Island {
        &self.islands[id as usize]
    }

    /// The island with this id.
    pub(crate) fn island_mut(&mut self, id: u32) -> &mut Island {
        &mut self.islands[id as usize]
    }

    /// Ids below this bound may be islands.
    pub(crate) fn island_bound(&self) -> u32 {
        self.islands.len() as u32
    }

    /// Makes an empty island.
    pub(crate) fn create_island(&mut self) -> u32 {
        let id = self.free.pop().unwrap_or_else(|| {
            self.islands.push(Island::default());
            self.islands.len() as u32 - 1
        });
        self.islands[id as usize].split_at = self.step;
        id
    }

    /// Gives an empty island's id back; its buffer is kept for the next island.
    pub(crate) fn destroy_island(&mut self, id: u32) {
        let island = self.island_mut(id);
        debug_assert!(island.bodies.is_empty());
        island.is_cut = false;
        island.sleeping = false;
        self.free.push(id);
    }

    /// Checks that empty islands are free, and no others.
    pub(crate) fn check_free(&self) -> Result<(), Fault> {
        ensure!(self.pace.is_valid(), "{:?}", self.pace);
        let mut is_free = vec![false; self.islands.len()];
        for &id in &self.free {
            let free = is_free.get_mut(id as usize);
            let was_free = free.map(|free| core::mem::replace(free, true));
            ensure!(
                was_free == Some(false),
                "island {id} is in the free list twice, or does not exist"
            );
        }
        let wrong = (0..).zip(&self.islands).find(|(id, island)| {
            let is_plain = !island.sleeping && !island.is_cut;
            island.bodies.is_empty() != is_free[*id] || is_free[*id] && !is_plain
        });
        ensure!(wrong.is_none(), "{wrong:?} is free, or not");
        Ok(())
    }

    /// Returns whether a joint or a multibody disables contacts between the colliders of these two bodies.
    ///
    /// Contact pairs exist only of bodies for which this is `false`.
    pub(crate) fn part(&self, body_slot1: u32, body_slot2: u32) -> bool {
        self.joints.part(body_slot1, body_slot2) || self.groups.part(body_slot1, body_slot2)
    }

    /// Returns whether a joint or a multibody disables contacts between two colliders. The two searches for
    /// colliders that meet call this, the broad phase and the path search.
    pub(crate) fn part_colliders(&self, collider1: &Collider, collider2: &Collider) -> bool {
        collider1.parent().zip(collider2.parent()).is_some_and(|(body1, body2)| {
            self.part(body1.into_raw_parts().0, body2.into_raw_parts().0)
        })
    }

    /// Returns whether welds hold the bodies of two colliders rigidly at each other.
    pub(crate) fn weld_colliders(&self, collider1: &Collider, collider2: &Collider) -> bool {
        collider1.parent().zip(collider2.parent()).is_some_and(|(body1, body2)| {
            self.joints.weld([body1, body2].map(|body| body.into_raw_parts().0))
        })
    }

    /// The motion of the body in a slot in the last step.
    #[inline]
    pub(crate) fn motion_of(&self, body_slot: u32) -> &BodyMotion {
        if body_slot == NONE {
            &BodyMotion::NONE
        } else {
            self.motion.get(body_slot as usize).unwrap_or(&BodyMotion::NONE)
        }
    }

    /// Marks the last motion as applied to all pairs.
    pub(crate) fn clear_motion(&mut self) {
        for position in 0..self.awake.len() {
            let slot = self.awake[position].into_raw_parts().0;
            self.set_motion(slot, BodyMotion::NONE);
        }
    }

    /// The motions of the bodies in the last step, for at least `slot_count` slots.
    pub(crate) fn motions_mut(&mut self, slot_count: usize) -> &mut [BodyMotion] {
        self.motion.resize(slot_count.max(self.motion.len()), BodyMotion::NONE);
        &mut self.motion
    }

    /// Stores the motion of the body in a slot.
    pub(crate) fn set_motion(&mut self, body_slot: u32, motion: BodyMotion) {
        let slot = body_slot as usize;
        if slot >= self.motion.len() {
            self.motion.resize(slot + 1, BodyMotion::NONE);
        }
        self.motion[slot] = motion;
    }
}
