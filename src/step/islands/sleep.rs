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
    /// By island: how its bodies are.
    moods: Vec<Mood>,
    /// The awake islands.
    islands: Vec<u32>,
    kinematics: Vec<RigidBodyHandle>,
}

/// How many of an island's bodies could sleep.
#[derive(Copy, Clone, Default)]
struct Mood {
    ready: u32,
    restless: u32,
}

/// Puts islands to sleep all of whose bodies are ready, and kinematic bodies that have stood still
/// with nobody awake around them.
///
/// An island with cut links may be several by now, of which some are still moving. It is split before
/// any part of it sleeps: at once if all of it is ready, and every now and then if a part is. That does
/// not depend on other islands: what happens far away must not decide who sleeps.
pub(crate) fn put_to_sleep(structure: &mut Structure<'_>, scratch: &mut SleepScratch) {
    structure.islands.step = structure.islands.step.wrapping_add(1);
    read_moods(structure, scratch);
    for island in scratch.islands.drain(..) {
        // All moods but those of awake islands stay at their defaults, so that nobody walks the others.
        let mood = core::mem::take(&mut scratch.moods[island as usize]);
        let record = structure.islands.island(island);
        let age = structure.islands.step.wrapping_sub(record.split_at);
        if !record.is_cut {
            if mood.restless == 0 {
                structure.sleep_island(island);
            }
        } else if mood.restless == 0 || (mood.ready > 0 && age >= SPLIT_INTERVAL) {
            structure.split(island);
        }
    }
    for handle in scratch.kinematics.drain(..) {
        if !structure.has_awake_partner(handle) {
            structure.sleep_kinematic(handle);
        }
    }
}

/// Fills the buffers: awake islands with their moods, and kinematic bodies at rest.
fn read_moods(structure: &Structure<'_>, scratch: &mut SleepScratch) {
    let bound = structure.islands.island_bound() as usize;
    if scratch.moods.len() < bound {
        scratch.moods.resize(bound, Mood::default());
    }
    for &handle in &structure.islands.awake {
        let Some(body) = structure.bodies.get(handle) else { continue };
        let is_ready = body.activation.is_eligible_for_sleep();
        if body.link.island == NONE {
            if is_ready {
                scratch.kinematics.push(handle);
            }
            continue;
        }
        let mood = &mut scratch.moods[body.link.island as usize];
        if mood.ready + mood.restless == 0 {
            scratch.islands.push(body.link.island);
        }
        mood.ready += u32::from(is_ready);
        mood.restless += u32::from(!is_ready);
    }
}
