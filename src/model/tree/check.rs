//! Invariants of the lists beside the trees of a loaded world.
//!
//! The boxes themselves are checked with the colliders, in `structure/check/trees.rs`.

use super::{BroadPhaseBvh, TreeKind, exponent};
use crate::base::fault::{Fault, ensure};
use crate::model::collider::{ActiveCollisionTypes, Collider};

impl BroadPhaseBvh {
    /// Checks that the list of moved slots holds each slot once, and the bits are those of the list.
    pub(crate) fn check_moved(&self) -> Result<(), Fault> {
        let mut unlisted = self.moved_bits.clone();
        for &slot in &self.moved {
            let (word, bit) = (slot as usize / 64, 1_u64 << (slot % 64));
            let is_marked = unlisted.get(word).is_some_and(|word| word & bit != 0);
            ensure!(is_marked, "slot {slot} has moved twice, or without a mark");
            unlisted[word] &= !bit;
        }
        let more: u32 = unlisted.iter().map(|word| word.count_ones()).sum();
        ensure!(more == 0, "{more} slots are marked as moved, and not listed");
        Ok(())
    }

    /// Checks the data of a collider that the pair search reads: the size of its box, the sensor flag, its
    /// groups and types. Only the size is known of a collider with edits.
    pub(crate) fn check_filters(&self, collider: &Collider) -> Result<(), Fault> {
        let (slot, tree) = (collider.proxy.slot, collider.proxy.tree);
        let size = exponent(collider.proxy.fat_aabb.extents().max_element());
        let known = self.size(slot);
        ensure!(tree.is_none() || known == size, "the box in slot {slot} has the size {known}");
        if !collider.changes.is_empty() {
            return Ok(());
        }
        let is_sensor = collider.is_sensor();
        let agrees = self.is_sensor(slot) == is_sensor && (self.has_sensors || !is_sensor);
        ensure!(agrees, "the collider in slot {slot} is a sensor: {is_sensor}");
        let (all, own) = (self.groups, collider.collision_groups());
        let has_own = all.is_some_and(|all| all.union(own) == all);
        ensure!(has_own, "the groups {all:?} are without those of slot {slot}, {own:?}");
        let types = collider.active_collision_types();
        let meets_fixed =
            tree == Some(TreeKind::Fixed) && types.intersects(ActiveCollisionTypes::FIXED_FIXED);
        ensure!(self.fixed_meet || !meets_fixed, "the collider in slot {slot} meets fixed ones");
        Ok(())
    }
}
