//! What every step leaves on all sets that it worked on, to know next time that they still belong together.
//!
//! A body knows its place in the lists of the islands, pairs know colliders and bodies, trees know boxes. Who takes one of the sets and
//! leaves an empty one (`mem::take`), or sets one of them alone back to an older copy, makes all of this wrong: places may lie
//! beyond the end of a list.
//!
//! A seal is a fingerprint of the history of a world, not a number that the process counts: saved worlds must have the same bytes in
//! every run, and a set that is read from a file on its own must not fit a new world. Copies of all sets fit each other, because they
//! have the same history.

use crate::base::hash::MixHasher;
use core::hash::Hasher;

/// The mark of the last step, and of the collision detection that followed it.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Seal {
    /// Zero before the first step.
    step: u64,
    /// Zero behind a step. Detection alone does not write to joints: they keep the seal of the step.
    detection: u64,
    /// On bodies and colliders alone: which colliders were attached and detached since then. That is the one edit that changes two
    /// sets at once, and after which they are not what one of them was before.
    attachments: u64,
}

impl Seal {
    /// The seal of the step that follows, in a world that leaves this trace.
    pub fn after_step(self, trace: &[u64]) -> Self {
        Self { step: mixed(self.step, trace), ..Self::default() }
    }

    /// The seal of a detection of collisions that follows.
    pub fn after_detection(self, trace: &[u64]) -> Self {
        Self { detection: mixed(self.detection, trace), attachments: 0, ..self }
    }

    /// Notes what happened to two sets.
    pub fn note_attachment(seals: [&mut Self; 2], what: &[u64]) {
        seals.into_iter().for_each(|seal| seal.attachments = mixed(seal.attachments, what));
    }

    /// Are both of the same step, and of the same detection of collisions?
    pub fn is_of_same_detection(self, other: Self) -> bool {
        self.is_of_same_step(other) && self.detection == other.detection
    }

    /// Are both of the same step?
    pub fn is_of_same_step(self, other: Self) -> bool {
        self.step == other.step
    }
}

fn mixed(before: u64, trace: &[u64]) -> u64 {
    let mut hasher = MixHasher::default();
    hasher.write_u64(before);
    trace.iter().for_each(|&word| hasher.write_u64(word));
    hasher.finish()
}
