//! The world stamp: which sets belong together.
//!
//! The sets of a world refer to each other by position: a body stores its place in the list of awake bodies, a manifold its place in the
//! constraint graph, a collider its place in a tree. Replacing one set (`mem::take`, an older copy, the set of a similar world) invalidates
//! these references: positions may lie beyond the end of a list, and constraints of one colour may share bodies.
//!
//! Every step leaves the same stamp on all sets that it worked on, made of [unique numbers](crate::base::unique). So sets fit each other if
//! and only if the same step was the last one that changed them, however similar other worlds are. Copies of a set keep its stamp: copies of all
//! sets, made at one time, fit each other, and get a stamp of their own by their own next step.
//!
//! Edits between steps are noted in the edited set, relative to the state after the last step, and need no stamp. Attaching a
//! collider is the exception: it edits the bodies and the colliders at once. Neither set fits the other's earlier copies afterwards.
//!
//! Stamps are not saved: saved worlds have the same bytes in every run. A loaded set is unverified until a step has checked all
//! references between the sets ([`Structure::check`](crate::model::structure::Structure::check)).

use crate::base::unique::unique_number;

/// The stamp of a set that was loaded. No step draws this number.
const UNVERIFIED: u64 = u64::MAX;

/// The stamp of the last step, and of the collision detection that followed it.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct WorldStamp {
    /// Zero before the first step.
    step: u64,
    /// Zero after a step. Detection alone does not write to joints: they keep the stamp of the step.
    detection: u64,
    /// On bodies and colliders alone: the last attachment or detachment of a collider since then.
    attachment: u64,
}

impl WorldStamp {
    /// The stamp of a set that was loaded.
    #[cfg(feature = "serde-serialize")]
    pub const fn unverified() -> Self {
        Self { step: UNVERIFIED, detection: 0, attachment: 0 }
    }

    /// Returns whether the set was loaded, and no step has checked it yet.
    pub const fn is_unverified(self) -> bool {
        self.step == UNVERIFIED
    }

    /// The stamp of a new step. It differs from all stamps before it.
    pub fn of_new_step() -> Self {
        Self { step: unique_number(), ..Self::default() }
    }

    /// The stamp of a new collision detection after the step of this stamp.
    pub fn after_detection(self) -> Self {
        let step = if self.is_unverified() { unique_number() } else { self.step };
        Self { step, detection: unique_number(), attachment: 0 }
    }

    /// Returns whether collisions were detected since the step.
    pub const fn has_detected(self) -> bool {
        self.detection != 0
    }

    /// Marks two sets that are edited together. If other sets were edited together with one of them before, the two do not fit each other
    /// afterwards: each contains attachments that the other lacks.
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
        let (one, two) = (WorldStamp::of_new_step(), WorldStamp::of_new_step());
        assert!(!one.is_of_same_step(two) && !one.is_of_same_step(WorldStamp::default()));
        let detected = one.after_detection();
        assert!(detected.is_of_same_step(one) && !detected.is_of_same_detection(one));
        assert!(!detected.is_of_same_detection(one.after_detection()));
    }

    #[test]
    fn attachments_mark_two_sets_together() {
        let step = WorldStamp::of_new_step();
        let [mut bodies, mut colliders, mut other] = [step; 3];
        WorldStamp::note_attachment([&mut bodies, &mut colliders]);
        assert!(bodies == colliders && bodies != other && bodies.is_of_same_detection(other));
        // The other colliders lack the first attachment, the first ones lack the second.
        WorldStamp::note_attachment([&mut bodies, &mut other]);
        assert!(bodies != colliders && bodies != other);
    }
}
