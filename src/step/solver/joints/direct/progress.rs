//! Convergence of the rounds of a solution.

use super::driven::DrivenAxis;
use super::jacobians::locked_axes;
use super::matrix::{Matrix, Rows};
use super::memory::Jacobians;
use super::pattern::Component;
use crate::dim::math::Real;

/// Convergence of stiff joints: the norm of their velocity errors, an energy, as a fraction of the first
/// round's. Convergence is quadratic: a machine of light bars goes from 1 to 10⁻⁴ and to 10⁻⁹. For a chain at
/// rest, 10⁻⁵ is rounding.
const STIFF_RESIDUAL_FRACTION_MAX: f64 = 1.0e-4;

/// Convergence of other joints: the residual as a fraction of the total effect of their impulses. Both
/// are energies.
const CONVERGED_FRACTION_MAX: f64 = 1.0e-9;

/// Rounding error of anchor positions, relative to the moment arms.
const ANCHOR_ROUNDING: f64 = 4.0 * Real::EPSILON as f64;

/// With a larger residual fraction, the joints are not converged.
const RESIDUAL_FRACTION_MAX: f64 = 1.0e-3;

/// The rounds diverge if a residual exceeds the last one by this factor: convergence is quadratic. The total
/// effect of the impulses is no measure, because it grows with the impulses.
const RESIDUAL_GROWTH_MAX: f64 = 2.0;
/// The same for the second round, the first that includes the curvature, if the residual exceeds the total
/// effect of the impulses.
const FIRST_GROWTH_MAX: f64 = 100.0;

/// Progress of the rounds of a solution.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) enum Progress {
    Done,
    /// Sufficient; another round would reduce the error.
    Near,
    /// Another round is required.
    Far,
    /// The rounds diverge.
    Diverging,
}

impl<const N: usize> Matrix<N> {
    /// Returns whether the residual of the last stiff solution is negligible against the first one. Then no
    /// impulses change.
    pub fn has_converged(&mut self, component: Component<'_>, memory: &Jacobians) -> bool {
        let is_done =
            self.size_of_rates(component, memory) <= STIFF_RESIDUAL_FRACTION_MAX * self.first_size;
        if is_done {
            self.x.fill([0.0; N]);
            // The rows have the impulses of the last solution.
            self.driven.clear();
        }
        is_done
    }

    /// The progress of the rounds, after at least two. Convergence is quadratic, so the ratio of a round's
    /// residual to its input is taken to be the ratio of this input to the previous input.
    pub fn progress(
        &self,
        rounds: usize,
        component: Component<'_>,
        memory: &Jacobians,
        inv_h: Real,
    ) -> Progress {
        let [before, last] = self.sizes;
        let rest = if last < before { last * (last / before) } else { last };
        let (load, noise) = self.size_of_load(component, memory, f64::from(inv_h));
        let grows = match rounds {
            ..=2 => last > load && last > FIRST_GROWTH_MAX * before,
            _ => last > RESIDUAL_GROWTH_MAX * before,
        };
        if rest <= CONVERGED_FRACTION_MAX * load + noise {
            Progress::Done
        } else if grows {
            Progress::Diverging
        } else if rest > RESIDUAL_FRACTION_MAX * load {
            Progress::Far
        } else {
            Progress::Near
        }
    }

    /// As [`Self::size_of_rates`], for the total effect of the impulses and for the rounding errors of rates.
    fn size_of_load(&self, component: Component<'_>, memory: &Jacobians, inv_h: f64) -> (f64, f64) {
        let (mut load, mut noise) = (0.0, 0.0);
        for ((member, own), rows) in component.members.iter().zip(&self.own).zip(&self.rows) {
            let (from, lane) = (&memory.blocks[member.block as usize], member.lane as usize);
            for (row, axis) in
                locked_axes::<N>(member).enumerate().filter(|(row, _)| own[*row] > 0.0)
            {
                let impulse = from.impulses[axis].0[lane] + from.changes[axis].0[lane];
                load += own[row] * f64::from(impulse) * f64::from(impulse);
                let rounding = ANCHOR_ROUNDING * rows.size_of(row) * inv_h;
                noise += rounding * rounding / own[row];
            }
            if !component.has_driven_axes {
                continue;
            }
            let first = member.locked_row_count();
            for (row, from) in (first..).zip(memory.driven_of(member)) {
                let impulse = from.impulse(lane);
                load += own[row] * impulse * impulse;
                let rounding = ANCHOR_ROUNDING * rows.size_of(row) * inv_h;
                noise += if own[row] > 0.0 { rounding * rounding / own[row] } else { 0.0 };
            }
        }
        (load, noise)
    }

    /// The sum of `b²/a` over all rows, with the right-hand sides `b` and the diagonal `a`: an energy.
    pub(super) fn size_of_rates(&self, component: Component<'_>, memory: &Jacobians) -> f64 {
        let mut sum = 0.0;
        for (member, own) in component.members.iter().zip(&self.own) {
            let (from, lane) = (&memory.blocks[member.block as usize], member.lane as usize);
            for (own, axis) in own.iter().zip(locked_axes::<N>(member)) {
                let rate = f64::from(from.rates[axis].0[lane]);
                sum += if *own > 0.0 { rate * rate / own } else { 0.0 };
            }
            if !component.has_driven_axes {
                continue;
            }
            let axes = memory.driven_of(member).iter().zip(&own[member.locked_row_count()..]);
            for (from, own) in axes.filter(|(_, own)| **own > 0.0) {
                let violation = DrivenAxis::new([0; 2], from, lane, Rows::All).violation();
                sum += violation * violation / own;
            }
        }
        sum
    }
}
