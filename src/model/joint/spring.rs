//! Springs in terms of frequency and damping ratio.

use super::InvalidJoint;
use super::motor::check_factor;
use crate::dim::math::Real;
use crate::model::params::Softness;

/// Softness of the locked axes of a joint: a spring and a damper in mass-independent form.
///
/// A joint without softness is as stiff as the solver allows.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SpringCoefficients<N = Real> {
    /// Oscillations per second of the spring without damping (Hz).
    pub natural_frequency: N,
    /// Damping ratio: 1 is critical damping, smaller values oscillate.
    pub damping_ratio: N,
}

impl SpringCoefficients {
    /// A spring with this frequency (Hz) and damping ratio.
    pub const fn new(natural_frequency: Real, damping_ratio: Real) -> Self {
        Self { natural_frequency, damping_ratio }
    }

    /// The spring of contacts in Rapier 0.32. The engine's own contacts follow
    /// [`IntegrationParameters::erp`](crate::model::params::IntegrationParameters::erp).
    pub const fn contact_defaults() -> Self {
        Self::new(30.0, 5.0)
    }

    /// A spring that is nearly rigid: the softness of joints in Rapier 0.32.
    pub const fn joint_defaults() -> Self {
        Self::new(1.0e6, 1.0)
    }

    /// The frequency as radians per second: `2π` times the natural frequency.
    pub fn angular_frequency(&self) -> Real {
        self.natural_frequency * (2.0 * core::f64::consts::PI as Real)
    }

    /// The fraction of an error that the spring removes per second, in steps of `dt` seconds: `ω / (dt ω + 2
    /// ζ)`.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// // A step that is much longer than the spring's period removes all of the error, and the spring does not yield.
    /// let stiff = SpringCoefficients::new(1.0e6, 1.0);
    /// assert!((stiff.erp(1.0 / 60.0) - 1.0).abs() < 1.0e-4);
    /// assert!(stiff.cfm_coeff(1.0 / 60.0) < 1.0e-6);
    /// ```
    pub fn erp_inv_dt(&self, dt: Real) -> Real {
        self.in_steps_of(dt).bias_rate
    }

    /// The fraction of an error that the spring removes in a step of `dt` seconds.
    pub fn erp(&self, dt: Real) -> Real {
        dt * self.erp_inv_dt(dt)
    }

    /// The compliance of the spring in a step of `dt` seconds, in units of the inverse of the mass that it
    /// moves: `1 / (dt ω (2 ζ + dt ω))`. Infinite for a spring without force.
    pub fn cfm_coeff(&self, dt: Real) -> Real {
        self.in_steps_of(dt).compliance()
    }

    /// The resulting fraction of a constraint's effective mass: `1 / (1 + cfm_coeff)`.
    pub fn cfm_factor(&self, dt: Real) -> Real {
        1.0 / (1.0 + self.cfm_coeff(dt))
    }

    /// The solver's coefficients of the spring.
    pub(crate) fn in_steps_of(&self, dt: Real) -> Softness {
        Softness::spring(self.angular_frequency(), self.damping_ratio, dt)
    }

    /// Returns whether both numbers are usable.
    pub(super) fn check(&self) -> Result<(), InvalidJoint> {
        check_factor("the natural frequency of a joint", self.natural_frequency)?;
        check_factor("the damping ratio of a joint", self.damping_ratio)
    }
}

/// The softness of a joint: a spring, or `None` for a joint that is as stiff as the solver allows.
#[cfg(not(feature = "upstream-signatures"))]
mod softness {
    use super::SpringCoefficients;

    pub type JointSoftness = Option<SpringCoefficients>;
    pub const STIFFEST: JointSoftness = None;

    /// The spring of a joint that is not as stiff as possible.
    pub const fn spring_of(softness: JointSoftness) -> Option<SpringCoefficients> {
        softness
    }
}

/// The softness of a joint, as in Rapier: a spring. Rapier's default stands for a joint that is as stiff as
/// the solver allows.
#[cfg(feature = "upstream-signatures")]
mod softness {
    use super::SpringCoefficients;

    pub type JointSoftness = SpringCoefficients;
    pub const STIFFEST: JointSoftness = SpringCoefficients::joint_defaults();

    /// The spring of a joint that is not as stiff as possible.
    pub fn spring_of(softness: JointSoftness) -> Option<SpringCoefficients> {
        (softness != STIFFEST).then_some(softness)
    }
}
pub use softness::{JointSoftness, STIFFEST, spring_of};

#[cfg(test)]
mod tests {
    use super::SpringCoefficients;
    use crate::dim::math::Real;

    /// With `a = dt ω`: `erp = a / (a + 2 ζ)` and `cfm = 1 / (a (a + 2 ζ))` for every spring; all are finite.
    #[test]
    fn springs_are_those_of_the_formulas() {
        let dt = 1.0 / 240.0;
        for (frequency, ratio) in [(1.0, 0.0), (30.0, 1.0), (5.0, 10.0), (1.0e4, 0.5)] {
            let spring = SpringCoefficients::new(frequency, ratio);
            let near = |a: Real, b: Real| (a - b).abs() <= 1.0e-5 * b.abs();
            let turn = dt * spring.angular_frequency();
            let stiffness = turn + 2.0 * ratio;
            assert!(near(spring.erp_inv_dt(dt), turn / stiffness / dt));
            assert!(near(spring.cfm_coeff(dt), 1.0 / (turn * stiffness)));
            assert!(near(spring.cfm_factor(dt), 1.0 / (1.0 + 1.0 / (turn * stiffness))));
        }
        let slack = SpringCoefficients::new(0.0, 0.0);
        assert_eq!((slack.erp(dt), slack.cfm_factor(dt)), (0.0, 0.0));
    }
}
