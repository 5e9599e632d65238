//! Which islands have been still for long enough.

use crate::model::body::RigidBodyHandle;
use crate::model::island::NONE;
use crate::model::structure::Structure;

/// Steps between two attempts to split an island of which only a part is ready to sleep. An attempt
/// costs as much as the island is large, and in a heap that is stirred something is ready all the time.
const SPLIT_INTERVAL: u32 = 30;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SleepScratch {
    /// By island: how many of its bodies are not ready to sleep.
    restless: Vec<u32>,
    /// What is to go to sleep.
    islands: Vec<u32>,
    kinematics: Vec<RigidBodyHandle>,
}

/// Puts islands to sleep all of whose bodies are ready, and kinematic bodies that have stood still
/// with nobody awake around them.
///
/// An island with cut links may be several by now, of which some are still moving. It is split before
/// any part of it sleeps; one island per step, so that no step is slow because many bodies come to
/// rest at once.
pub(crate) fn put_to_sleep(structure: &mut Structure<'_>, scratch: &mut SleepScratch) {
    structure.islands.step = structure.islands.step.wrapping_add(1);
    count_restless(structure, scratch);
    let mut split = None;
    for island in scratch.islands.drain(..) {
        if scratch.restless[island as usize] > 0 {
            continue;
        }
        if structure.islands.island(island).cut_links > 0 {
            split = split.or(Some(island));
        } else {
            structure.sleep_island(island);
        }
    }
    let split = split.or_else(|| partly_ready_island(structure));
    if let Some(island) = split {
        structure.split(island);
    }
    for handle in scratch.kinematics.drain(..) {
        if !structure.has_awake_partner(handle) {
            structure.sleep_kinematic(handle);
        }
    }
}

/// Fills the buffers: awake islands with their restless bodies, and kinematic bodies at rest.
fn count_restless(structure: &Structure<'_>, scratch: &mut SleepScratch) {
    scratch.restless.clear();
    scratch.restless.resize(structure.islands.island_bound() as usize, NONE);
    for &handle in &structure.islands.awake {
        let Some(body) = structure.bodies.get(handle) else { continue };
        let ready = body.activation.is_eligible_for_sleep();
        if body.link.island == NONE {
            if ready {
                scratch.kinematics.push(handle);
            }
            continue;
        }
        let restless = &mut scratch.restless[body.link.island as usize];
        if *restless == NONE {
            *restless = 0;
            scratch.islands.push(body.link.island);
        }
        *restless += u32::from(!ready);
    }
}

/// An island with cut links whose sleepiest body is ready: the part around that body may sleep.
fn partly_ready_island(structure: &Structure<'_>) -> Option<u32> {
    let mut best = None;
    let mut longest = 0.0;
    for &handle in &structure.islands.awake {
        let Some(body) = structure.bodies.get(handle) else { continue };
        let time = body.activation.time_since_can_sleep;
        let island = body.link.island;
        if island == NONE || time <= longest || !body.activation.is_eligible_for_sleep() {
            continue;
        }
        let record = structure.islands.island(island);
        let age = structure.islands.step.wrapping_sub(record.split_at);
        if record.cut_links > 0 && age >= SPLIT_INTERVAL {
            (best, longest) = (Some(island), time);
        }
    }
    best
}
