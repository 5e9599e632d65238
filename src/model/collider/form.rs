//! The data of a shape that the narrow phase reads in each step, stored in the collider to save a cache miss.

bitflags::bitflags! {
    /// Kind of a collider's shape.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug)]
    pub(crate) struct ShapeForm: u8 {
        /// It is convex, and its own only part.
        const CONVEX = 1;
        /// It can roll.
        const ROUND = 1 << 1;
    }
}

impl ShapeForm {
    /// Default for a shape that the step has not measured yet.
    pub const UNKNOWN: Self = Self::ROUND;
}
