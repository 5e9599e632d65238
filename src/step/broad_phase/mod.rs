//! # Broad phase — who might touch whom?
//!
//! Reads:   enlarged boxes, collider flags, the pairs already known
//! Writes:  the list of new pairs; the trees' notes of who moved
//! Runs:    parallel over colliders that moved; the list is sorted by slots
//! Never:   touches a collider that stayed in its enlarged box
//!
//! Of two colliders one *bears* the pair: the smaller one, and of equals the later one. Who bears a pair finds it when both
//! moved, and may bear only so many with others of its size, and as many with larger ones
//! (`IntegrationParameters::max_neighbors_per_collider`): thousands of bodies at one point would else be as many pairs as the square
//! of their number. A platform under thousands of crates bears none of these pairs, so it never has to choose.

mod borne;
mod search;
#[cfg(test)]
mod tests;

use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::tree::BroadPhaseBvh;
use search::{Finds, Search};

/// Colliders that are worth handing over to another thread together.
const COLLIDERS_PER_TASK: usize = 16;
/// How many colliders before it looks around memory is asked for.
const TURNS_AHEAD: usize = 4;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct BroadPhaseScratch {
    /// One for each task that runs at the same time.
    finds: Pool<Finds>,
    late: Vec<u32>,
    refused: Vec<u32>,
}

/// What is known of pairs before the search.
pub(crate) trait KnownPairs: Sync {
    /// The slots of all that the collider at this slot has contact pairs with.
    fn partners(&self, slot: u32) -> &[u32];

    /// The slots of all that it has pairs with because one of the two is a sensor.
    fn sensed(&self, slot: u32) -> &[u32];
}

impl KnownPairs for NarrowPhase {
    fn partners(&self, slot: u32) -> &[u32] {
        self.contacts.partners(slot)
    }

    fn sensed(&self, slot: u32) -> &[u32] {
        self.intersections.partners(slot)
    }
}

/// Finds the pairs of colliders that began to overlap with their enlarged boxes.
///
/// Only colliders that have a new box look for neighbours; those that did not move are found by
/// them. Pairs that are `known` are left out, and so
/// are those that cannot interact: of the same body, of groups or kinds of bodies that do not meet.
/// `out` is overwritten: the collider with the lower slot first, in the order of the slots.
///
/// Colliders that bear as many pairs as they may (`most`) look again in the next step. Returns how many these are.
pub(crate) fn find_pairs(
    tasks: Tasks<'_>,
    (tree, most): (&mut BroadPhaseBvh, usize),
    colliders: &ColliderSet,
    known: &impl KnownPairs,
    scratch: &mut BroadPhaseScratch,
    out: &mut Vec<(ColliderHandle, ColliderHandle)>,
) -> usize {
    let BroadPhaseScratch { finds, late, refused } = scratch;
    out.clear();
    late.clear();
    tree.tidy();
    let search = Search { tree, colliders, known, most, only_borne: false };
    search.run(tasks, tree.moved(), finds);
    finds.for_each(|found| late.append(&mut found.late));
    late.sort_unstable();
    late.dedup();
    Search { only_borne: true, ..search }.run(tasks, late, finds);
    let had_refused = !refused.is_empty();
    refused.clear();
    finds.for_each(|found| {
        out.append(&mut found.pairs);
        refused.append(&mut found.refused);
    });
    out.sort_unstable();
    refused.sort_unstable();
    tree.clear_moved();
    refused.iter().for_each(|&slot| tree.mark_moved(slot));
    if let (Some(slot), false) = (refused.first(), had_refused) {
        let count = refused.len();
        log::warn!(
            "{count} colliders (such as {slot}) have more than {most} neighbours that are not smaller: see `max_neighbors_per_collider`"
        );
    }
    refused.len()
}
