//! Gears: degrees of freedom of one multibody that move together.
//!
//! ```text
//! C = q₂ - r q₁ - c        Ċ = q̇₂ - r q̇₁        J = (… -r … 1 …)        K = J M⁻¹ Jᵀ
//! ```
//!
//! with the ratio `r` and the offset `c`. `C` is linear in the coordinates, so the row is exact all through a
//! step, unlike those that follow links round curves. An impulse of either sign holds it. The gears of a
//! multibody are solved together with its limits and motors: see `system.rs`.

use super::Moving;
use super::rows::{ConstrainedStates, JacobianPool, Part, Row};
use super::system::{RowSystem, SystemRow, equation};
use crate::dim::math::Real;

/// One coupling.
#[derive(Debug)]
struct Gear {
    multibody: usize,
    /// Its position among the couplings of the multibody.
    position: usize,
    row: Row,
    error: Real,
    impulse: Real,
}

/// All couplings of the multibodies that are solved now.
#[derive(Debug, Default)]
pub struct Gears {
    gears: Vec<Gear>,
    /// Velocity per unit of error (1/s).
    bias_rate: Real,
}

impl Gears {
    /// Makes the rows.
    pub fn prepare(
        &mut self,
        jacobians: &mut JacobianPool,
        moving: &mut [Moving],
        bias_rate: Real,
    ) {
        self.bias_rate = bias_rate;
        self.gears.clear();
        for multibody in 0..moving.len() {
            for position in 0..moving[multibody].multibody.couplings().len() {
                let body = &moving[multibody].multibody;
                let coupling = body.couplings()[position];
                let Some([first, second]) = body.coupled_dofs(&coupling) else { continue };
                let error = body.coupling_error(&coupling);
                let part = jacobians.add_links(moving, multibody, true, |_, jacobian, _| {
                    jacobian[first] = -coupling.coeff;
                    jacobian[second] = 1.0;
                });
                let row = jacobians.row([part, Part::Nothing]);
                let impulse = coupling.impulse;
                self.gears.push(Gear { multibody, position, row, error, impulse });
            }
        }
    }

    /// Starts the step with the last one's impulses.
    pub fn warm_start(&self, jacobians: &JacobianPool, states: &mut ConstrainedStates<'_>) {
        for gear in &self.gears {
            jacobians.push_early(&gear.row, gear.impulse, states);
        }
    }

    /// Scales the impulses with which the next substep starts, by a factor for each row.
    pub fn scale_impulses(&mut self, factor: impl Fn(&Row) -> Real) {
        self.gears.iter_mut().for_each(|gear| gear.impulse *= factor(&gear.row));
    }

    /// Adds the laws of all rows to a system; with `bias`, position errors are corrected.
    pub fn add_to(
        &self,
        system: &mut RowSystem,
        jacobians: &JacobianPool,
        states: &ConstrainedStates<'_>,
        bias: bool,
    ) {
        for gear in &self.gears {
            let error = gear.error + jacobians.displacement(&gear.row, states);
            let correction = if bias { -error * self.bias_rate } else { 0.0 };
            let law = equation(&gear.row, correction, 0.0);
            let impulses = [gear.impulse, 0.0, 0.0];
            system.rows.push(SystemRow::new(system.group(gear.multibody), gear.row, law, impulses));
        }
    }

    /// Takes the impulses of the rows, in the order of [`Self::add_to`].
    pub fn take_from<'a>(&mut self, solved: &mut impl Iterator<Item = &'a SystemRow>) {
        for (gear, solved) in self.gears.iter_mut().zip(solved) {
            gear.impulse = solved.impulse as Real;
        }
    }

    /// Writes the impulses to the couplings.
    pub fn store(&self, moving: &mut [Moving]) {
        for gear in &self.gears {
            let impulse = if gear.impulse.is_finite() { gear.impulse } else { 0.0 };
            moving[gear.multibody].multibody.couplings[gear.position].impulse = impulse;
        }
    }
}
