//! Sleep of islands that have been at rest for long enough.

use crate::model::body::RigidBodyHandle;
use crate::model::island::NONE;
use crate::model::structure::Structure;

/// Steps between two attempts to split an island of which only a part is ready to sleep. An attempt
/// costs as much as the island is large, and in a heap that is stirred something is ready all the time.
const SPLIT_INTERVAL: u32 = 30;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SleepScratch {
    /// By island: the number of its sleepy bodies.
    sleepy: Vec<usize>,
    /// The islands with any.
    islands: Vec<u32>,
    kinematics: Vec<RigidBodyHandle>,
}

/// Puts islands to sleep if all their bodies are ready, and kinematic bodies at rest without an awake
/// partner.
///
/// An island with cut links may be several by now, of which some are still moving. It is split before any
/// part of it sleeps: at once if all of it is ready, at intervals if a part is. The interval is independent
/// of other islands: remote events must not affect sleep.
///
/// `sleepy` contains, for each awake body, whether it has been at rest for long enough.
pub(crate) fn put_to_sleep(
    structure: &mut Structure<'_>,
    sleepy: &[bool],
    scratch: &mut SleepScratch,
) {
    debug_assert_eq!(sleepy.len(), structure.islands.awake.len(), "every awake body has advanced");
    structure.islands.step = structure.islands.step.wrapping_add(1);
    count_sleepy(structure, sleepy, scratch);
    for island in scratch.islands.drain(..) {
        // The counts of all other islands are zero already: only these are reset.
        let count = core::mem::take(&mut scratch.sleepy[island as usize]);
        let record = structure.islands.island(island);
        let age = structure.islands.step.wrapping_sub(record.split_at);
        debug_assert!(count <= record.bodies.len(), "islands share no body");
        let are_all = count == record.bodies.len();
        if !record.is_cut {
            if are_all {
                structure.sleep_island(island);
            }
        } else if are_all || age >= SPLIT_INTERVAL {
            structure.split(island);
        }
    }
    for handle in scratch.kinematics.drain(..) {
        if !structure.has_awake_partner(handle) {
            structure.sleep_kinematic(handle);
        }
    }
}

/// Fills the buffers: islands with sleepy bodies, and kinematic bodies at rest.
fn count_sleepy(structure: &Structure<'_>, sleepy: &[bool], scratch: &mut SleepScratch) {
    let bound = structure.islands.island_bound() as usize;
    if scratch.sleepy.len() < bound {
        scratch.sleepy.resize(bound, 0);
    }
    let awake = structure.islands.awake.iter().zip(sleepy);
    for &handle in awake.filter(|&(_, &is_sleepy)| is_sleepy).map(|(handle, _)| handle) {
        let Some(body) = structure.bodies.get(handle) else { continue };
        if body.link.island == NONE {
            scratch.kinematics.push(handle);
            continue;
        }
        let count = &mut scratch.sleepy[body.link.island as usize];
        if *count == 0 {
            scratch.islands.push(body.link.island);
        }
        *count += 1;
    }
}
