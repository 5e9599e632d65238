//! Sets of axes of the plane.

use crate::dim::math::{AngVector, Real, Vector};

bitflags::bitflags! {
    /// Axes along and about which a controller acts.
    ///
    /// The bits are those of the 3D engine, so that saved masks have the same meaning in both.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Hash)]
    pub struct AxesMask: u8 {
        /// Along X.
        const LIN_X = 1 << 0;
        /// Along Y.
        const LIN_Y = 1 << 1;
        /// The only rotation in 2D.
        const ANG_Z = 1 << 5;
    }
}

impl AxesMask {
    fn one_if(self, axis: Self) -> Real {
        if self.contains(axis) { 1.0 } else { 0.0 }
    }

    /// 1 along the chosen axes, 0 along the others.
    pub(crate) fn linear(self) -> Vector {
        Vector::new(self.one_if(Self::LIN_X), self.one_if(Self::LIN_Y))
    }

    /// 1 about the chosen axis, 0 about the others.
    pub(crate) fn angular(self) -> AngVector {
        self.one_if(Self::ANG_Z)
    }
}
