//! Sets of axes of 3D space.

use crate::dim::math::{AngVector, Real, Vector};

bitflags::bitflags! {
    /// Axes along and about which a controller acts.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Hash)]
    pub struct AxesMask: u8 {
        /// Along X.
        const LIN_X = 1 << 0;
        /// Along Y.
        const LIN_Y = 1 << 1;
        /// Along Z.
        const LIN_Z = 1 << 2;
        /// About X.
        const ANG_X = 1 << 3;
        /// About Y.
        const ANG_Y = 1 << 4;
        /// About Z.
        const ANG_Z = 1 << 5;
    }
}

impl AxesMask {
    fn one_if(self, axis: Self) -> Real {
        if self.contains(axis) { 1.0 } else { 0.0 }
    }

    /// 1 along the chosen axes, 0 along the others.
    pub(crate) fn linear(self) -> Vector {
        Vector::new(self.one_if(Self::LIN_X), self.one_if(Self::LIN_Y), self.one_if(Self::LIN_Z))
    }

    /// 1 about the chosen axes, 0 about the others.
    pub(crate) fn angular(self) -> AngVector {
        AngVector::new(self.one_if(Self::ANG_X), self.one_if(Self::ANG_Y), self.one_if(Self::ANG_Z))
    }
}
