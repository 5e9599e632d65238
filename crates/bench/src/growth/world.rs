//! Worlds of the growth measurement.

/// Time without motion after which a body falls asleep (s). Box2D and Box3D have this value as a constant.
pub const SLEEP_DELAY: f32 = 0.5;

/// Growing world.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum World {
    /// Boxes in heaps.
    Heaps {
        /// Number of all boxes.
        bodies: usize,
        /// Number of boxes per heap.
        each: usize,
        /// Whether the boxes of a layer touch each other.
        dense: bool,
    },
    /// Fixed blocks, with dynamic boxes on some of them.
    Static {
        /// Number of blocks.
        bodies: usize,
        /// Number of boxes.
        awake: usize,
    },
    /// Boxes that fall asleep, and among them some that may not sleep.
    Sleeping {
        /// Number of sleeping boxes.
        bodies: usize,
        /// Number of awake boxes.
        awake: usize,
    },
}

impl World {
    /// Returns the number of bodies that the curve varies.
    pub fn bodies(self) -> usize {
        match self {
            Self::Heaps { bodies, .. }
            | Self::Static { bodies, .. }
            | Self::Sleeping { bodies, .. } => bodies,
        }
    }
}
