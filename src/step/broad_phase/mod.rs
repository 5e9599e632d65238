//! # Broad phase: overlapping pairs of fat AABBs
//!
//! Reads:   fat AABBs, collider flags, the pairs already known, disabled contacts of joints and multibodies
//! Writes:  the list of new pairs; rebuilt trees; the trees' list of moved colliders
//! Runs:    parallel over moved colliders; the list is sorted by slots
//! Never:   searches for a collider that stayed in its fat AABB, unless its groups changed or its number of
//!     pairs is limited
//!
//! One of two colliders *owns* the pair: the smaller one. Between equal sizes it is the solid collider, and
//! between equal kinds the later one. The owner finds the pair when both moved. The number of pairs that a
//! collider owns is limited, with colliders of its size and with larger ones. Pairs with sensors have a
//! separate limit (`IntegrationParameters::max_neighbors_per_collider`,
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
use crate::model::island::IslandManager;
use crate::model::tree::BroadPhaseBvh;
pub(crate) use search::NeighborLimits;
use search::{Search, SearchResult};

/// Number of colliders per parallel task.
const COLLIDERS_PER_TASK: usize = 16;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct BroadPhaseScratch {
    /// The pairs that were found.
    pub pairs: Vec<(ColliderHandle, ColliderHandle)>,
    /// One for each task that runs at the same time.
    results: Pool<SearchResult>,
    /// Colliders at rest that search in a second pass.
    unmoved: Vec<u32>,
    /// Colliders with more candidates than they may own, of solids and with sensors. They search again in
    /// the next step.
    refused: [Vec<u32>; 2],
}

/// Number of colliders with more candidates than they may own.
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
/// Colliders with a new box search for partners. Colliders at rest near them with the maximum number of
/// partners search in a second pass. The result excludes `known` pairs, and pairs that cannot interact:
/// colliders of one body, and pairs that their groups or body types exclude. It also excludes solid colliders
/// of bodies between which a joint or a multibody disables contacts; sensors detect such bodies nevertheless.
/// `scratch.pairs` contains the result: the collider with the lower slot first, in the order of the slots.
///
/// Colliders with more candidates than they may own (`most`) search again in the next step. Returns their
/// number.
pub(crate) fn find_pairs(
    tasks: Tasks<'_>,
    tree: &mut BroadPhaseBvh,
    most: NeighborLimits,
    colliders: &ColliderSet,
    known: &impl KnownPairs,
    islands: &IslandManager,
    scratch: &mut BroadPhaseScratch,
) -> Crowded {
    let BroadPhaseScratch { pairs, results, unmoved, refused } = scratch;
    pairs.clear();
    unmoved.clear();
    tree.tidy();
    let search = Search { tree, colliders, known, islands, most, only_owned: false };
    search.run(tasks, tree.moved(), results);
    results.for_each(|found| unmoved.append(&mut found.unmoved));
    unmoved.sort_unstable();
    unmoved.dedup();
    Search { only_owned: true, ..search }.run(tasks, unmoved, results);
    let had_refused = refused.each_ref().map(|list| !list.is_empty());
    refused.iter_mut().for_each(Vec::clear);
    results.for_each(|found| {
        pairs.append(&mut found.pairs);
        for (all, some) in refused.iter_mut().zip(&mut found.refused) {
            all.append(some);
        }
    });
    pairs.sort_unstable();
    debug_assert!(pairs.is_sorted_by(|one, other| one < other), "each pair is new once");
    debug_assert!(
        pairs.iter().all(|&(low, high)| colliders.contains(low) && colliders.contains(high)),
        "pairs are of colliders in the set"
    );
    tree.clear_moved();
    for list in refused.iter_mut() {
        list.sort_unstable();
        // A collider may be crowded by its like and by larger ones.
        list.dedup();
        list.iter().for_each(|&slot| tree.mark_moved(slot));
    }
    let [solids, sensors] = &*refused;
    warn(solids, had_refused[0], "max_neighbors_per_collider", most.solids);
    warn(sensors, had_refused[1], "max_sensor_neighbors_per_collider", most.sensors);
    Crowded { solids: solids.len(), sensors: sensors.len() }
}

/// Warns when colliders begin to have more neighbours than a parameter allows.
fn warn(refused: &[u32], had_refused: bool, parameter: &str, most: usize) {
    if let (Some(slot), false) = (refused.first(), had_refused) {
        let count = refused.len();
        log::warn!(
            "{count} colliders (such as {slot}) have more than {most} neighbours that are not smaller: see `{parameter}`"
        );
    }
}
