//! # Broad phase: overlapping pairs of fat AABBs
//!
//! Reads:   fat AABBs, collider flags, the pairs already known
//! Writes:  the list of new pairs; the trees' notes of moved colliders
//! Runs:    parallel over moved colliders; the list is sorted by slots
//! Never:   visits a collider that stayed in its fat AABB
//!
//! One of two colliders *owns* the pair: the smaller one; of equals the one that is no sensor, or else the
//! later one. The owner finds the pair when both moved. The number of pairs that a collider owns is limited,
//! with colliders of its size and with larger ones. Pairs with sensors have a separate limit
//! (`IntegrationParameters::max_neighbors_per_collider`,
//! `IntegrationParameters::max_sensor_neighbors_per_collider`). Without limits, bodies at one point have a
//! number of pairs quadratic in their number. A platform under thousands of crates owns none of these pairs,
//! so it misses none. The same holds for a sensor that contains thousands of bodies of at most its size.

mod owned_pairs;
mod search;
#[cfg(test)]
mod tests;

use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::tree::BroadPhaseBvh;
pub(crate) use search::NeighborLimits;
use search::{Finds, Search};

/// Colliders that are worth handing over to another thread together.
const COLLIDERS_PER_TASK: usize = 16;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct BroadPhaseScratch {
    /// One for each task that runs at the same time.
    finds: Pool<Finds>,
    late: Vec<u32>,
    /// Colliders that own the maximum of pairs, of solids and with sensors.
    refused: [Vec<u32>; 2],
}

/// Number of colliders that own the maximum of pairs and overlap others besides.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Crowded {
    /// Pairs of solid colliders.
    pub solids: usize,
    /// Pairs with sensors.
    pub sensors: usize,
}

/// The pairs that exist before the search.
pub(crate) trait KnownPairs: Sync {
    /// The slots of the contact partners of the collider at this slot.
    fn partners(&self, slot: u32) -> &[u32];

    /// The slots of its partners in pairs with a sensor.
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

/// Finds the pairs of colliders whose fat AABBs began to overlap.
///
/// Only colliders with a new box search for partners, and find the others. The result excludes `known` pairs,
/// and pairs that cannot interact: colliders of one body, and pairs that their groups or body types exclude.
/// `out` is overwritten: the collider with the lower slot first, in the order of the slots.
///
/// Colliders that own the maximum of pairs (`most`) search again in the next step. Returns how many these
/// are.
pub(crate) fn find_pairs(
    tasks: Tasks<'_>,
    (tree, most): (&mut BroadPhaseBvh, NeighborLimits),
    colliders: &ColliderSet,
    known: &impl KnownPairs,
    scratch: &mut BroadPhaseScratch,
    out: &mut Vec<(ColliderHandle, ColliderHandle)>,
) -> Crowded {
    let BroadPhaseScratch { finds, late, refused } = scratch;
    out.clear();
    late.clear();
    tree.tidy();
    let search = Search { tree, colliders, known, most, only_owned: false };
    search.run(tasks, tree.moved(), finds);
    finds.for_each(|found| late.append(&mut found.late));
    late.sort_unstable();
    late.dedup();
    Search { only_owned: true, ..search }.run(tasks, late, finds);
    let had_refused = refused.each_ref().map(|list| !list.is_empty());
    refused.iter_mut().for_each(Vec::clear);
    finds.for_each(|found| {
        out.append(&mut found.pairs);
        for (all, some) in refused.iter_mut().zip(&mut found.refused) {
            all.append(some);
        }
    });
    out.sort_unstable();
    tree.clear_moved();
    for list in refused.iter_mut() {
        list.sort_unstable();
        // A collider may be crowded by its like and by larger ones.
        list.dedup();
        list.iter().for_each(|&slot| tree.mark_moved(slot));
    }
    let [solids, sensors] = &*refused;
    warn(solids, had_refused[0], ("max_neighbors_per_collider", most.solids));
    warn(sensors, had_refused[1], ("max_sensor_neighbors_per_collider", most.sensors));
    Crowded { solids: solids.len(), sensors: sensors.len() }
}

/// Warns when colliders begin to have more neighbours than a parameter allows.
fn warn(refused: &[u32], had_refused: bool, (parameter, most): (&str, usize)) {
    if let (Some(slot), false) = (refused.first(), had_refused) {
        let count = refused.len();
        log::warn!(
            "{count} colliders (such as {slot}) have more than {most} neighbours that are not smaller: see `{parameter}`"
        );
    }
}
