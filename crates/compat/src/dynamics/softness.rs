//! Springs in place of hard constraints.

use engine::math::Real;

/// Frequency and damping of a spring.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SpringCoefficients<N> {
    /// Oscillations per second.
    pub natural_frequency: N,
    /// Damping as a multiple of the critical damping.
    pub damping_ratio: N,
}

impl SpringCoefficients<Real> {
    /// A spring with this frequency (Hz) and damping ratio.
    pub fn new(natural_frequency: Real, damping_ratio: Real) -> Self {
        Self { natural_frequency, damping_ratio }
    }

    /// The default of contacts.
    pub fn contact_defaults() -> Self {
        Self::new(30.0, 5.0)
    }

    /// The default of joints: rigid.
    pub fn joint_defaults() -> Self {
        Self::new(1.0e6, 1.0)
    }

    fn to_engine(self) -> engine::dynamics::SpringCoefficients {
        engine::dynamics::SpringCoefficients::new(self.natural_frequency, self.damping_ratio)
    }

    /// Angular frequency (rad/s).
    pub fn angular_frequency(&self) -> Real {
        self.to_engine().angular_frequency()
    }

    /// Fraction of the error that is removed per second, for steps of `dt`.
    pub fn erp_inv_dt(&self, dt: Real) -> Real {
        self.to_engine().erp_inv_dt(dt)
    }

    /// Fraction of the error that a step of `dt` removes.
    pub fn erp(&self, dt: Real) -> Real {
        self.to_engine().erp(dt)
    }

    /// Compliance for steps of `dt`.
    pub fn cfm_coeff(&self, dt: Real) -> Real {
        self.to_engine().cfm_coeff(dt)
    }

    /// Scale of the effective mass for steps of `dt`.
    pub fn cfm_factor(&self, dt: Real) -> Real {
        self.to_engine().cfm_factor(dt)
    }
}

impl From<SpringCoefficients<Real>> for engine::dynamics::SpringCoefficients {
    fn from(coefficients: SpringCoefficients<Real>) -> Self {
        coefficients.to_engine()
    }
}
