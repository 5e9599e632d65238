//! # Quarantine: bodies with unusable numbers are disabled, and the step is repeated
//!
//! Reads:   edited bodies; the solver's note of bodies that it could not store; their user input and joint
//!     loads
//! Writes:  enabled flags of bodies; clears the bounds of motion and the notes of the failed attempt
//! Runs:    serial, before the first stage for edited bodies, and after a failed step
//! Never:   restores pairs, islands or colours
//!
//! Numbers overflow: forces add up, motors are stiff beyond reason, speeds grow. A body that is not finite
//! would spread that to all bodies that it touches, and from these to their neighbours. The solver therefore
//! stores no body if it cannot store all of them. This stage finds the [causes] and disables them, as a user
//! would disable them. The step is then repeated without them. The failed attempt leaves no impulses. Its
//! events about pairs that begin and end because of the disabled bodies cancel out.
//!
//! Edits are the usual cause. Before the first attempt, edited bodies that diverge on their own are therefore
//! disabled. The rest of the world is as if the user had disabled them.
//!
//! A step may also fail because of values that grew, or of constraints. It is then repeated from the current
//! state. Poses, velocities and impulses are those of the step's beginning. Contacts that began in the failed
//! attempt have colours already, and bodies that it woke are awake. The order of contacts may therefore
//! differ from a step without the causes.

mod causes;

use crate::base::hash::FastHashMap;
use crate::model::body::{QuarantineCause, RigidBodyHandle, RigidBodySet};
use crate::model::event::{CollisionEvent, QuarantineEvent};
use crate::step::notes::StepNotes;
use crate::step::world::World;
use causes::Causes;

/// The bodies that were disabled in this step.
#[derive(Default)]
pub(crate) struct Quarantine {
    taken: Vec<(RigidBodyHandle, QuarantineCause)>,
    /// Number of failed attempts.
    failures: usize,
    /// Number of events that failed attempts emitted.
    emitted: usize,
}

impl Quarantine {
    /// Before the first attempt: disables edited bodies that diverge on their own.
    pub fn open(&mut self, world: &mut World<'_>) {
        self.taken.clear();
        (self.failures, self.emitted) = (0, 0);
        Causes { world, diverged: &[] }.find_in_edits(&mut self.taken);
        self.disable(world);
    }

    /// Disables the causes in a world in which a step has failed, for the repetition.
    pub fn take_out(&mut self, world: &mut World<'_>, notes: &mut StepNotes) {
        let before = self.taken.len();
        Causes { world, diverged: &notes.diverged }.find(self.failures, &mut self.taken);
        self.failures += 1;
        // All pairs already include the last motion.
        world.structure.islands.clear_motion();
        notes.clear_attempt();
        self.emitted = notes.events.len();
        self.disable(world);
        debug_assert!(self.taken.len() > before, "a failed step has a cause that is still enabled");
    }

    /// Disables the bodies in the order of their handles, so that manual disabling of the same bodies gives
    /// the same result.
    fn disable(&mut self, world: &mut World<'_>) {
        self.taken.sort_by_key(|(handle, _)| handle.into_raw_parts());
        self.taken.dedup_by_key(|(handle, _)| *handle);
        for &(handle, cause) in &self.taken {
            if let Some(body) = world.structure.bodies.get_mut(handle) {
                body.put_in_quarantine(cause);
            }
        }
    }

    /// Reports the disabled bodies. Returns their number.
    pub fn close(&self, bodies: &RigidBodySet, notes: &mut StepNotes) -> usize {
        if self.failures > 0 {
            cancel_out(&mut notes.events, self.emitted);
        }
        for &(handle, cause) in &self.taken {
            let Some(body) = bodies.get(handle) else { continue };
            log::error!("{handle:?} is disabled, because it cannot be simulated: {cause}");
            let (position, velocity) = (body.pose, body.vels);
            notes.quarantined.push(QuarantineEvent::Body {
                body: handle,
                cause,
                position,
                velocity,
            });
        }
        self.taken.len()
    }
}

/// Cancels pairs of events: contacts that began in a failed attempt and ended because one body was disabled.
/// Failed attempts emitted the first `emitted` events. Contacts that began later and ended in the same step
/// (a crossed sensor) keep both events.
fn cancel_out(events: &mut Vec<CollisionEvent>, emitted: usize) {
    let mut began = FastHashMap::default();
    let mut is_void = vec![false; events.len()];
    for (index, event) in events.iter().enumerate() {
        let pair = (event.collider1(), event.collider2());
        if event.started() && index < emitted {
            began.insert(pair, index);
        } else if let Some(start) = began.remove(&pair) {
            (is_void[start], is_void[index]) = (true, true);
        }
    }
    let mut is_void = is_void.into_iter();
    events.retain(|_| !is_void.next().unwrap_or_default());
}

#[cfg(test)]
mod tests {
    use super::cancel_out;
    use crate::model::collider::ColliderHandle;
    use crate::model::event::{CollisionEvent, CollisionEventFlags};

    fn pair(slot: u32) -> (ColliderHandle, ColliderHandle, CollisionEventFlags) {
        let other = ColliderHandle::from_raw_parts(slot, 0);
        (ColliderHandle::from_raw_parts(99, 0), other, CollisionEventFlags::empty())
    }

    fn started(slot: u32) -> CollisionEvent {
        let (collider1, collider2, flags) = pair(slot);
        CollisionEvent::Started(collider1, collider2, flags)
    }

    fn stopped(slot: u32) -> CollisionEvent {
        let (collider1, collider2, flags) = pair(slot);
        CollisionEvent::Stopped(collider1, collider2, flags)
    }

    #[test]
    fn contacts_that_begin_and_end_in_attempts_send_no_event() {
        let mut events = vec![
            stopped(1),
            started(2),
            started(3),
            stopped(2),
            stopped(4),
            started(4),
            started(5),
        ];
        events.extend([stopped(4), stopped(3), started(1)]);
        cancel_out(&mut events, 7);
        assert_eq!(events, [stopped(1), stopped(4), started(5), started(1)]);
    }

    /// The begin event was not cancelled: the contact existed before, and has ended.
    #[test]
    fn sensors_passed_after_all_attempts_are_reported() {
        let mut events = vec![started(1), stopped(1), started(2), stopped(2)];
        cancel_out(&mut events, 1);
        assert_eq!(events, [started(2), stopped(2)]);
    }
}
