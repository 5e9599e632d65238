//! Two bodies on one rope over two pulleys.

use super::super::GenericJoint;
use super::super::kind::{joint_kind, joint_motor_methods};
use super::{Transmission, TransmissionEnd};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Real, Vector};

joint_kind! {
    /// Two bodies on the ends of a rope that runs over two points of the world: `distance1 + ratio ·
    /// distance2 ≤ length`, with the distances of the anchors from those points.
    ///
    /// The rope pulls and never pushes. With a ratio of 2, the second body hangs on a loop of two strands, as
    /// in a block and tackle: it moves half as far as the first, and gets twice the force. A motor drives the
    /// sum `distance1 + ratio · distance2`.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let wheels = [vector![-1.0, 5.0, 0.0], vector![1.0, 5.0, 0.0]];
    /// let pulley = PulleyJoint::new(wheels, 6.0, 1.0);
    /// assert_eq!((pulley.length(), pulley.ratio()), (6.0, 1.0));
    /// ```
    PulleyJoint, PulleyJointBuilder
}
joint_motor_methods!(PulleyJoint, PulleyJointBuilder, [JointAxis::LinX], ());

impl PulleyJoint {
    /// A rope of this length over two points of the world, with the anchors at the origins of the bodies. A
    /// point without usable coordinates, a ratio that is not between 1e-6 and 1e6, or a length that is
    /// negative or NaN is logged and replaced: the points by the origin, the ratio by 1, the length by no
    /// limit.
    pub fn new(over: [Vector; 2], length: Real, ratio: Real) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::empty());
        let ends = [TransmissionEnd::Distance { from: Vector::ZERO }; 2];
        data.set_transmission(Transmission::new(ends, [1.0, 1.0]));
        data.set_limits(JointAxis::LinX, [-Real::MAX, Real::MAX]);
        let mut pulley = Self { data };
        pulley.set_over(over).set_ratio(ratio).set_length(length);
        pulley
    }

    /// The points of the world over which the rope runs.
    pub fn over(&self) -> [Vector; 2] {
        let ends = self.data.transmission.map(|transmission| transmission.ends);
        ends.map_or([Vector::ZERO; 2], |ends| {
            ends.map(|end| match end {
                TransmissionEnd::Distance { from } => from,
                TransmissionEnd::Angle | TransmissionEnd::Shift => Vector::ZERO,
            })
        })
    }

    /// Sets the points of the world over which the rope runs. Points without usable coordinates are refused
    /// with a warning in the log.
    pub fn set_over(&mut self, over: [Vector; 2]) -> &mut Self {
        if let Some(old) = self.data.transmission {
            let ends = over.map(|from| TransmissionEnd::Distance { from });
            self.data.set_transmission(Transmission { ends, ..old });
        }
        self
    }

    /// The length of the rope: the largest `distance1 + ratio · distance2` (length units).
    pub fn length(&self) -> Real {
        self.data.limits[JointAxis::LinX as usize].max
    }

    /// Sets the length of the rope (length units). A length that is negative or NaN is refused with a warning
    /// in the log.
    pub fn set_length(&mut self, length: Real) -> &mut Self {
        match length >= 0.0 {
            true => drop(self.data.set_limits(JointAxis::LinX, [-Real::MAX, length])),
            false => log::warn!("the length of a rope is {length}, but must not be negative"),
        }
        self
    }

    /// Factor of the second distance.
    pub fn ratio(&self) -> Real {
        self.data.transmission.map_or(1.0, |transmission| transmission.ratios[1])
    }

    /// Sets the factor of the second distance. A ratio that is not between 1e-6 and 1e6 is refused with a
    /// warning in the log.
    pub fn set_ratio(&mut self, ratio: Real) -> &mut Self {
        if ratio < 0.0 {
            log::warn!("the ratio of a pulley is {ratio}, but a rope does not push");
        } else if let Some(old) = self.data.transmission {
            self.data.set_transmission(Transmission { ratios: [1.0, ratio], ..old });
        }
        self
    }
}

impl PulleyJointBuilder {
    /// A rope over two points of the world: see [`PulleyJoint::new`].
    pub fn new(over: [Vector; 2], length: Real, ratio: Real) -> Self {
        Self(PulleyJoint::new(over, length, ratio))
    }
}
