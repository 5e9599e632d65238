//! A spring by its frequency.

use super::InvalidJoint;
use super::motor::check_factor;
use crate::dim::math::Real;

/// How soft the locked axes of a joint are: a spring and a damper by what one sees of them, whatever
/// the masses.
///
/// A joint without one is as stiff as the solver can make it.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SpringCoefficients<N = Real> {
    /// Oscillations per second of the spring without damping (Hz).
    pub natural_frequency: N,
    /// 1: comes back as fast as it can without swinging past the target; less: swings.
    pub damping_ratio: N,
}

impl SpringCoefficients {
    /// From its frequency (Hz) and its damping ratio.
    pub const fn new(natural_frequency: Real, damping_ratio: Real) -> Self {
        Self { natural_frequency, damping_ratio }
    }

    /// The frequency as radians per second: `2π` times the natural frequency.
    pub fn angular_frequency(&self) -> Real {
        self.natural_frequency * (2.0 * core::f64::consts::PI as Real)
    }

    /// Are both numbers usable?
    pub(super) fn check(&self) -> Result<(), InvalidJoint> {
        check_factor("the natural frequency of a joint", self.natural_frequency)?;
        check_factor("the damping ratio of a joint", self.damping_ratio)
    }
}
