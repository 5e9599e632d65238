//! # Broad phase — who might touch whom?
//!
//! Reads:   enlarged boxes, collider flags, the pairs already known
//! Writes:  the list of new pairs; the trees' notes of who moved
//! Runs:    parallel over colliders that moved; the list is sorted by slots
//! Never:   touches a collider that stayed in its enlarged box

#[cfg(test)]
mod tests;

use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::model::collider::{Collider, ColliderHandle, ColliderSet, may_interact};
use crate::model::tree::{BroadPhaseBvh, TreeKind};

/// Colliders that are worth handing over to another thread together.
const COLLIDERS_PER_TASK: usize = 16;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct BroadPhaseScratch {
    /// One for each task that runs at the same time.
    found: Pool<Vec<(ColliderHandle, ColliderHandle)>>,
}

/// Finds the pairs of colliders that began to overlap with their enlarged boxes.
///
/// Only colliders that have a new box look for neighbours; those that did not move are found by
/// them. Pairs that `is_known` (asked with the two slots, the lower one first) are left out, and so
/// are those that cannot interact: of the same body, of groups or kinds of bodies that do not meet.
/// `out` is overwritten: the collider with the lower slot first, in the order of the slots.
pub(crate) fn find_pairs(
    tasks: Tasks<'_>,
    tree: &mut BroadPhaseBvh,
    colliders: &ColliderSet,
    is_known: impl Fn(u32, u32) -> bool + Sync,
    BroadPhaseScratch { found }: &mut BroadPhaseScratch,
    out: &mut Vec<(ColliderHandle, ColliderHandle)>,
) {
    out.clear();
    tree.tidy();
    let (trees, moved) = (&*tree, tree.moved());
    tasks.par_for(moved.len(), COLLIDERS_PER_TASK, |range| {
        let mut pairs = found.take();
        for &slot in &moved[range] {
            // The collider may be gone since it moved, or disabled.
            if let Some((handle, collider)) = colliders.at_slot(slot) {
                find_neighbours(trees, colliders, (handle, collider), &is_known, &mut pairs);
            }
        }
        found.put(pairs);
    });
    found.for_each(|pairs| out.append(pairs));
    out.sort_unstable();
    tree.clear_moved();
}

/// Adds the new pairs of one collider.
fn find_neighbours(
    tree: &BroadPhaseBvh,
    colliders: &ColliderSet,
    (handle, collider): (ColliderHandle, &Collider),
    is_known: &impl Fn(u32, u32) -> bool,
    out: &mut Vec<(ColliderHandle, ColliderHandle)>,
) {
    let Some(kind) = collider.proxy.tree else { return };
    let (slot, _) = handle.into_raw_parts();
    for other_kind in [TreeKind::Fixed, TreeKind::Movable] {
        if !tree.may_meet(kind, other_kind) {
            continue;
        }
        tree.for_each_overlapping(other_kind, &collider.proxy.fat_aabb, |other_slot| {
            // Of two that moved, each finds the other: the lower slot counts.
            if other_slot == slot || (other_slot < slot && tree.is_moved(other_slot)) {
                return;
            }
            let Some((other_handle, other)) = colliders.at_slot(other_slot) else { return };
            let (low, high) = (slot.min(other_slot), slot.max(other_slot));
            if !may_interact(collider, other) || is_known(low, high) {
                return;
            }
            out.push(if slot < other_slot {
                (handle, other_handle)
            } else {
                (other_handle, handle)
            });
        });
    }
}
