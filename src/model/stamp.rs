//! The world stamp marks sets that belong together.
//!
//! The sets of a world refer to each other by position. A body stores its place in the list of awake bodies.
//! A manifold stores its place in the constraint graph, and a collider its place in a tree. Replacing one set
//! (`mem::take`, an older copy, the set of a similar world) invalidates these references. Positions may lie
//! beyond the end of a list, and constraints of one colour may have a common body.
//!
//! Every step leaves the same stamp on all sets that it worked on, made of [unique
//! numbers](crate::base::unique). So sets fit each other if and only if the same step was the last one that
//! changed them, however similar other worlds are. Copies of a set keep its stamp. Copies of all sets, made
//! at one time, fit each other, and get their own stamp by their own next step.
//!
//! Edits between steps are noted in the edited set, relative to the state after the last step, and need no
//! stamp. Attaching a collider is the exception: it edits the bodies and the colliders at once. Neither set
//! fits the other's earlier copies afterwards.
//!
//! The numbers are not saved: saved worlds have the same bytes in every run. The saved value is a fingerprint
//! of the world's history, which is the same in every run, too. It distinguishes sets of different times, but
//! not those of similar worlds. So a loaded set is unverified until a step has checked all references between
//! the sets ([`Structure::check_world`](crate::model::structure::Structure::check_world)).

use crate::base::hash::MixHasher;
use crate::base::unique::unique_number;
use core::hash::Hasher;

/// The stamp of a set that was loaded. No step draws this number.
const STAMP_UNVERIFIED: u64 = u64::MAX;

/// The stamp of the last step, and of the collision detection that followed it.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(from = "[u64; 2]", into = "[u64; 2]"))]
pub(crate) struct WorldStamp {
    /// Zero before the first step.
    step: u64,
    /// Zero after a step. Detection alone does not write to joints: they keep the stamp of the step.
    detection: u64,
    /// On bodies and colliders alone: the last attachment or detachment of a collider since then.
    attachment: u64,
    /// Fingerprints of the history up to the last step, and of the collision detections since then.
    history: [u64; 2],
}

/// A set was loaded.
impl From<[u64; 2]> for WorldStamp {
    fn from(history: [u64; 2]) -> Self {
        Self { step: STAMP_UNVERIFIED, history, ..Self::default() }
    }
}

/// A set is saved.
impl From<WorldStamp> for [u64; 2] {
    fn from(stamp: WorldStamp) -> Self {
        stamp.history
    }
}

fn mixed(before: u64, trace: &[u64]) -> u64 {
    let mut hasher = MixHasher::default();
    hasher.write_u64(before);
    trace.iter().for_each(|&word| hasher.write_u64(word));
    hasher.finish()
}

impl WorldStamp {
    /// Returns whether the set was loaded, and no step has checked it yet.
    pub const fn is_unverified(self) -> bool {
        self.step == STAMP_UNVERIFIED
    }

    /// The stamp of a new step of a world that leaves this trace. It differs from all earlier stamps.
    pub fn after_step(self, trace: &[u64]) -> Self {
        let history = [mixed(self.history[0], trace), 0];
        Self { step: unique_number(), history, ..Self::default() }
    }

    /// The stamp of a new collision detection after the step of this stamp.
    pub fn after_detection(self, trace: &[u64]) -> Self {
        let step = if self.is_unverified() { unique_number() } else { self.step };
        let history = [self.history[0], mixed(self.history[1], trace)];
        Self { step, detection: unique_number(), attachment: 0, history }
    }

    /// The stamp of a set that is being changed. It fits no other.
    pub fn of_unfinished_step() -> Self {
        Self { step: unique_number(), ..Self::default() }
    }

    /// Returns whether both have the same history up to the last step.
    pub fn has_same_steps(self, other: Self) -> bool {
        self.history[0] == other.history[0]
    }

    /// Returns whether both have the same history.
    pub fn has_same_history(self, other: Self) -> bool {
        self.history == other.history
    }

    /// Returns whether collisions were detected since the step.
    pub const fn has_detected(self) -> bool {
        self.detection != 0
    }

    /// Marks two sets that are edited together. If other sets were edited together with one of them before,
    /// the two do not fit each other afterwards. Each contains attachments that the other lacks.
    pub fn note_attachment([one, two]: [&mut Self; 2]) {
        let fit = one.attachment == two.attachment;
        one.attachment = unique_number();
        two.attachment = if fit { one.attachment } else { unique_number() };
    }

    /// Returns whether both are of the same step, and of the same collision detection.
    pub fn is_of_same_detection(self, other: Self) -> bool {
        self.is_of_same_step(other) && self.detection == other.detection
    }

    /// Returns whether both are of the same step.
    pub fn is_of_same_step(self, other: Self) -> bool {
        self.step == other.step
    }
}

#[cfg(test)]
mod tests {
    use super::WorldStamp;

    #[test]
    fn stamps_of_two_steps_differ() {
        let first = WorldStamp::default();
        let (one, two) = (first.after_step(&[7]), first.after_step(&[7]));
        assert!(!one.is_of_same_step(two) && !one.is_of_same_step(first));
        assert!(one.has_same_history(two) && !one.has_same_steps(first));
        let detected = one.after_detection(&[7]);
        assert!(detected.is_of_same_step(one) && !detected.is_of_same_detection(one));
        assert!(!detected.is_of_same_detection(one.after_detection(&[7])));
        assert!(detected.has_same_steps(one) && !detected.has_same_history(one));
    }

    #[test]
    fn saved_bytes_are_equal_in_every_run() {
        let saved =
            || <[u64; 2]>::from(WorldStamp::default().after_step(&[7]).after_detection(&[8]));
        assert_eq!(saved(), saved());
        let loaded = WorldStamp::from(saved());
        assert!(loaded.is_unverified() && saved() == <[u64; 2]>::from(loaded));
    }

    #[test]
    fn attachments_mark_two_sets_together() {
        let step = WorldStamp::default().after_step(&[]);
        let [mut bodies, mut colliders, mut other] = [step; 3];
        WorldStamp::note_attachment([&mut bodies, &mut colliders]);
        assert!(bodies == colliders && bodies != other && bodies.is_of_same_detection(other));
        // The other colliders lack the first attachment, the first ones lack the second.
        WorldStamp::note_attachment([&mut bodies, &mut other]);
        assert!(bodies != colliders && bodies != other);
    }
}
