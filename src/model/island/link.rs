//! A body's positions in the step's lists.

/// "Not in this list."
pub(crate) const NONE: u32 = u32::MAX;

/// Positions of a body in the islands and in the solver. It is stored inside the body, and updated by all
/// code that moves list entries.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct BodyLink {
    /// Position in the list of awake bodies; [`NONE`] for fixed, sleeping and disabled bodies.
    pub awake: u32,
    /// The island it belongs to; [`NONE`] for all but dynamic bodies that are enabled.
    pub island: u32,
    /// Position in the island's list of bodies.
    pub island_position: u32,
    /// The body's slot in its set; [`NONE`] outside of a set.
    pub slot: u32,
}

impl BodyLink {
    /// The link of the body in a slot, in no list.
    pub fn of_slot(slot: u32) -> Self {
        Self { awake: NONE, island: NONE, island_position: NONE, slot }
    }
}

impl Default for BodyLink {
    fn default() -> Self {
        Self::of_slot(NONE)
    }
}
