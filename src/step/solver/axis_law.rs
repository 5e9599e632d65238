//! The law of a driven axis: the impulse of its motor and its limits as a function of its rate.
//!
//! A free axis has a motor, limits or both along one row of the Jacobian. Their impulses decrease with the
//! rate `v` at the end of the pass, so the sum is a polygon of linear pieces:
//!
//! ```text
//! motor     λ = -(g v + p), between -B and B
//! limits    low ≤ v ≤ high
//!
//!        λ
//!        │Lower
//!    B   └────────┐      Constant(B)
//!                  ╲     Motor
//!   -B              └───────┐      Constant(-B)
//!                           │Upper
//!        low              high      v
//! ```
//!
//! Each piece is a linear equation. A motor is a row with the compliance `1/g`, a limit that holds is a row
//! like those of locked axes, and a constant impulse is no row. The law is monotone, so connected joints have
//! one solution (Cottle, Pang and Stone, "The Linear Complementarity Problem", 1992, sections 3.3 and 4.2).
//! The solver selects the pieces with Newton's method: it solves the equations of the present pieces, moves
//! each axis to the piece on which its solution is, and repeats (Hintermüller, Ito and Kunisch, "The
//! primal-dual active set strategy as a semismooth Newton method", 2002). The pieces of the last substep are
//! nearly always right. Newton's method may cycle, so late changes move the first axis only (Murty's
//! rule).

use crate::dim::math::Real;

/// Largest rate by which a motor and a limit that oppose each other would each change the rate of their axis.
/// A rigid motor against a limit has an impulse of any size. Those of both are stored in the engine's
/// precision, and their sum must keep its digits.
pub(super) const OPPOSED_RATE_MAX: Real = 1.0e3;

/// A rigid motor whose rate is that of a limit makes both pieces right. Rounding would select one after the
/// other. Rates that differ by less than this fraction are equal there.
const RATE_TOLERANCE: f64 = 16.0 * Real::EPSILON as f64;

/// Returns whether any of these numbers is negative. NaN is not: a diverging world may contain NaN until the
/// divergence check.
fn is_negative(numbers: &[f64]) -> bool {
    numbers.iter().any(|&number| number < 0.0)
}

/// A linear piece of the law.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) enum Piece {
    /// The lower limit holds.
    Lower,
    /// The upper limit holds.
    Upper,
    /// The motor follows its spring and damper.
    Motor,
    /// The motor gives its largest impulse, or there is no motor.
    Constant(f64),
}

/// The law of one axis.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) struct AxisLaw {
    /// `g`: impulse per unit of rate.
    pub damping: f64,
    /// `p`: the opposite of the impulse at rest.
    pub pull: f64,
    /// `B`: largest impulse of the motor.
    pub bound: f64,
    pub low: f64,
    pub high: f64,
}

impl AxisLaw {
    /// The motor's impulse at a rate.
    pub fn motor(&self, rate: f64) -> f64 {
        self.bounded(-(self.damping * rate + self.pull))
    }

    /// The nearest impulse that the motor can give. (`clamp` panics if the bound is NaN.)
    pub fn bounded(&self, impulse: f64) -> f64 {
        impulse.min(self.bound).max(-self.bound)
    }

    /// The piece of these impulses of the motor, of the lower and of the upper limit.
    pub fn piece_of(&self, motor: f64, lower: f64, upper: f64) -> Piece {
        if lower > 0.0 {
            Piece::Lower
        } else if upper > 0.0 {
            Piece::Upper
        } else if self.damping > 0.0 && motor.abs() < self.bound {
            Piece::Motor
        } else {
            Piece::Constant(self.bounded(motor))
        }
    }

    /// The piece on which a solution is, if a solution of the equation of this `piece` has this impulse and
    /// this rate.
    pub fn next(&self, piece: Piece, impulse: f64, rate: f64) -> Piece {
        match piece {
            // Equal limits are one equation.
            Piece::Lower | Piece::Upper if self.low >= self.high => piece,
            Piece::Lower if impulse >= self.motor(self.low + self.tolerance(self.low)) => piece,
            Piece::Lower => self.piece_of_motor(self.low),
            Piece::Upper if impulse <= self.motor(self.high - self.tolerance(self.high)) => piece,
            Piece::Upper => self.piece_of_motor(self.high),
            Piece::Motor | Piece::Constant(_) if rate < self.low - self.tolerance(self.low) => {
                Piece::Lower
            }
            Piece::Motor | Piece::Constant(_) if rate > self.high + self.tolerance(self.high) => {
                Piece::Upper
            }
            // Only to the next piece: an axis that skipped the one between would cycle.
            Piece::Constant(of_piece) if self.motor(rate) == of_piece => piece,
            Piece::Constant(_) if self.damping > 0.0 => Piece::Motor,
            Piece::Constant(_) => piece,
            // The impulse decides, because a stiff motor multiplies the rounding of the rate.
            Piece::Motor if impulse.abs() <= self.bound => piece,
            Piece::Motor => Piece::Constant(self.bounded(impulse)),
        }
    }

    /// The rate that is rounding at a limit of this rate, where there is a motor.
    fn tolerance(&self, limit: f64) -> f64 {
        if self.damping > 0.0 && limit.is_finite() {
            RATE_TOLERANCE * (limit.abs() + self.pull.abs() / self.damping)
        } else {
            0.0
        }
    }

    fn piece_of_motor(&self, rate: f64) -> Piece {
        let impulse = -(self.damping * rate + self.pull);
        if self.damping > 0.0 && impulse.abs() <= self.bound {
            Piece::Motor
        } else {
            Piece::Constant(self.bounded(impulse))
        }
    }
}

impl AxisLaw {
    /// The law of an axis without limits and without a motor.
    pub const FREE: Self =
        Self { damping: 0.0, pull: 0.0, bound: 0.0, low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// The law of an equation that holds at any impulse: this rate, with a compliance.
    pub fn equation_of(rate: f64, compliance: f64) -> Self {
        debug_assert!(!is_negative(&[compliance]));
        let damping = 1.0 / compliance;
        match damping.is_finite() {
            true => Self { damping, pull: -rate * damping, bound: f64::INFINITY, ..Self::FREE },
            false => Self { low: rate, high: rate, ..Self::FREE },
        }
    }

    /// Returns whether it must hold in any case.
    pub fn is_equation(&self) -> bool {
        self.bound == f64::INFINITY || self.low >= self.high
    }
}

/// The equation of a row on its law, when it has this impulse and this rate.
pub(super) struct Equation {
    /// Compliance of the row.
    pub compliance: f64,
    /// The change of the rate that is missing, with the compliance of the impulse.
    pub missing: f64,
}

impl AxisLaw {
    /// The equation of a piece; `None` if its impulse is constant.
    pub fn equation(&self, piece: Piece, impulse: f64, rate: f64) -> Option<Equation> {
        match piece {
            Piece::Lower => Some(Equation { compliance: 0.0, missing: self.low - rate }),
            Piece::Upper => Some(Equation { compliance: 0.0, missing: self.high - rate }),
            Piece::Motor => {
                let missing = -rate - (self.pull + impulse) / self.damping;
                Some(Equation { compliance: 1.0 / self.damping, missing })
            }
            Piece::Constant(_) => None,
        }
    }

    /// The parts of an impulse on a piece that the motor, the lower and the upper limit give. An impulse of 1
    /// changes the rate by `response`.
    pub fn parts(&self, piece: Piece, impulse: f64, response: f64) -> [f64; 3] {
        debug_assert!(!is_negative(&[response, self.damping, self.bound]));
        let room = f64::from(OPPOSED_RATE_MAX) / response.max(f64::MIN_POSITIVE);
        let motor = match piece {
            // What the tolerance of the rate leaves is no impulse of the other limit.
            Piece::Lower if self.low < self.high => self.motor(self.low).min(impulse),
            Piece::Upper if self.low < self.high => self.motor(self.high).max(impulse),
            Piece::Lower | Piece::Upper => self.motor(self.low),
            Piece::Motor | Piece::Constant(_) => self.bounded(impulse),
        };
        let motor = self.bounded(motor.min(impulse + room).max(impulse - room));
        let of_limits = impulse - motor;
        [motor, of_limits.max(0.0), (-of_limits).max(0.0)]
    }
}
