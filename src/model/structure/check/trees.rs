//! Boxes in the trees.

use super::{Structure, Verdict};
use crate::base::fault::ensure;
use crate::model::tree::{BroadPhaseBvh, TreeKind};
use std::collections::BTreeSet;

impl Structure<'_> {
    /// Each collider's box is in the tree that the collider names, and the lists beside the trees agree
    /// with the collider. There are no other boxes but those of removed colliders.
    pub(super) fn check_trees(&self, tree: &BroadPhaseBvh) -> Verdict {
        tree.check_moved()?;
        let removed: BTreeSet<u32> =
            self.colliders.removed().map(|handle| handle.into_raw_parts().0).collect();
        let mut found = 0;
        for (handle, collider) in self.colliders.iter() {
            let (slot, proxy) = (handle.into_raw_parts().0, &collider.proxy);
            ensure!(proxy.slot == slot, "{handle:?} stores slot {}", proxy.slot);
            ensure!(
                proxy.clearance.is_finite(),
                "{handle:?} has the clearance {}",
                proxy.clearance
            );
            tree.check_filters(collider)?;
            for kind in TreeKind::ALL {
                let aabb = tree.boxes(kind).get(slot);
                if proxy.tree == Some(kind) {
                    ensure!(aabb == Some(proxy.fat_aabb), "{handle:?} is in the box {aabb:?}");
                    found += 1;
                } else {
                    let is_other = aabb.is_none() || removed.contains(&slot);
                    ensure!(is_other, "{handle:?} is in a tree that is not its own");
                }
            }
        }
        for kind in TreeKind::ALL {
            found += removed.iter().filter(|&&slot| self.is_left(slot, kind, tree)).count();
        }
        let all: usize = TreeKind::ALL.into_iter().map(|kind| tree.boxes(kind).len()).sum();
        ensure!(found == all, "{found} of {all} boxes are those of colliders");
        Ok(())
    }

    /// Returns whether a tree has the box of a collider that was removed from a slot.
    fn is_left(&self, slot: u32, kind: TreeKind, tree: &BroadPhaseBvh) -> bool {
        let tenant = self.colliders.at_slot(slot).and_then(|(_, collider)| collider.proxy.tree);
        tree.boxes(kind).get(slot).is_some() && tenant != Some(kind)
    }
}
