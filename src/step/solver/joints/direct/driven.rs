//! Driven axes of a component: the pieces of their laws, and the rates and impulses of a solution.

use super::dense::{Column, add};
use super::driven_rows::DrivenRow;
use super::jacobians::{JointRows, Motion};
use super::matrix::{Matrix, Rows};
use super::memory::Jacobians;
use super::pattern::Component;
use crate::base::wide::Lane;
use crate::dim::math::{Real, SPATIAL_DIM};
use crate::step::solver::axis_law::{AxisLaw, Equation, Piece};

/// A driven axis in the solution.
pub(super) struct DrivenAxis {
    /// Its joint's position in the component, and its row.
    pub(super) at: [usize; 2],
    pub(super) law: AxisLaw,
    pub(super) piece: Piece,
    /// The parts of the law's `low` and `high` that correct an exceeded limit.
    corrections: [f64; 2],
    /// Before the solution.
    pub(super) impulse: f64,
    pub(super) rate: f64,
    /// By the solution.
    pub(super) solved_rate: f64,
}

impl DrivenAxis {
    pub(super) fn new(at: [usize; 2], from: &DrivenRow, lane: usize, rows: Rows) -> Self {
        let number = |lanes: &Lane| f64::from(lanes.0[lane]);
        let [motor, lower, upper] = [&from.motor, &from.lower, &from.upper].map(number);
        let law = AxisLaw {
            damping: number(&from.damping),
            pull: number(&from.pull),
            bound: number(&from.bound),
            low: number(&from.low),
            high: number(&from.high),
        };
        let (impulse, rate) = (from.impulse(lane), number(&from.rate));
        let piece = match rows {
            Rows::All => law.piece_of(motor, lower, upper),
            Rows::Locked => Piece::Constant(impulse),
        };
        let corrections = [0, 1].map(|side| number(&from.corrections[side]));
        Self { at, law, piece, corrections, impulse, rate, solved_rate: rate }
    }

    /// Begins with an exceeded limit that holds. At rest it has no impulse, and is corrected all the same.
    fn hold_exceeded(&mut self) {
        let is_free = matches!(self.piece, Piece::Motor | Piece::Constant(_));
        match self.corrections {
            [lower, _] if lower > 0.0 && is_free => self.piece = Piece::Lower,
            [_, upper] if upper < 0.0 && is_free => self.piece = Piece::Upper,
            _ => {}
        }
    }

    /// The part of its rate that corrects an exceeded limit.
    pub(super) fn correction(&self) -> f64 {
        match self.piece {
            Piece::Lower => self.corrections[0],
            Piece::Upper => self.corrections[1],
            Piece::Motor | Piece::Constant(_) => 0.0,
        }
    }

    pub(super) fn equation(&self) -> Option<Equation> {
        self.law.equation(self.piece, self.impulse, self.rate)
    }

    /// The rate by which it violates its law.
    pub(super) fn violation(&self) -> f64 {
        let beyond = || self.rate - self.rate.min(self.law.high).max(self.law.low);
        self.equation().map_or_else(beyond, |equation| equation.missing)
    }

    /// Writes its impulses and its rate after this change, if an impulse of 1 changes its rate by `response`.
    pub(super) fn write(&self, to: &mut DrivenRow, lane: usize, change: f64, response: f64) {
        let parts = self.law.parts(self.piece, self.impulse + change, response);
        for (to, part) in [&mut to.motor, &mut to.lower, &mut to.upper].into_iter().zip(parts) {
            to.0[lane] = part as Real;
        }
        to.rate.0[lane] = self.solved_rate as Real;
        to.change.0[lane] = change as Real;
    }
}

impl<const N: usize> Matrix<N> {
    /// Reads the laws of the driven axes.
    pub(super) fn load_laws(&mut self, component: Component<'_>, rows: Rows, memory: &Jacobians) {
        self.driven.clear();
        if !component.has_driven_axes {
            return;
        }
        for (at, member) in component.members.iter().enumerate() {
            let (first, lane) = (member.locked_row_count(), member.lane as usize);
            let axes = memory.driven_of(member).iter().enumerate();
            let axes = axes.map(|(k, from)| DrivenAxis::new([at, first + k], from, lane, rows));
            self.driven.extend(axes);
        }
        if rows == Rows::All {
            self.driven.iter_mut().for_each(DrivenAxis::hold_exceeded);
        }
    }

    /// Takes the changes of constant impulses to the right-hand sides of the other rows.
    pub(super) fn add_constant_impulses(&mut self, component: Component<'_>) {
        self.changes.clear();
        if self.driven.is_empty() {
            return;
        }
        self.changes.resize(component.body_count, [0.0; SPATIAL_DIM]);
        let mut any = false;
        for driven in &self.driven {
            let Piece::Constant(impulse) = driven.piece else { continue };
            let ([at, row], mut x) = (driven.at, [0.0; N]);
            x[row] = impulse - driven.impulse;
            any |= x[row] != 0.0;
            add_changes(component, &self.rows[at], at, &x, &mut self.changes);
        }
        if !any {
            return;
        }
        for (at, member) in component.members.iter().enumerate() {
            for row in 0..member.row_count() {
                self.x[at][row] -= rate_of(component, &self.rows[at], [at, row], &self.changes);
            }
        }
    }

    /// Finds the rates of the driven axes, and takes constant impulses into the solution.
    pub(super) fn find_rates(&mut self, component: Component<'_>) {
        let is_held = |driven: &DrivenAxis| matches!(driven.piece, Piece::Lower | Piece::Upper);
        if !self.driven.iter().all(is_held) {
            for (at, x) in self.x.iter().enumerate() {
                add_changes(component, &self.rows[at], at, x, &mut self.changes);
            }
        }
        for driven in &mut self.driven {
            let [at, row] = driven.at;
            let rate =
                || driven.rate + rate_of(component, &self.rows[at], [at, row], &self.changes);
            driven.solved_rate = match driven.piece {
                Piece::Lower => driven.law.low,
                Piece::Upper => driven.law.high,
                Piece::Motor => rate(),
                Piece::Constant(impulse) => {
                    self.x[at][row] = impulse - driven.impulse;
                    rate()
                }
            };
        }
    }

    /// Moves axes to the pieces of their laws on which the solution is: all, or the first one only. Returns
    /// whether any axis has moved.
    pub(super) fn choose_pieces(&mut self, only_first: bool) -> bool {
        let mut any = false;
        for driven in &mut self.driven {
            let [at, row] = driven.at;
            let impulse = driven.impulse + self.x[at][row];
            let next = driven.law.next(driven.piece, impulse, driven.solved_rate);
            if next != driven.piece {
                driven.piece = next;
                any = true;
                if only_first {
                    break;
                }
            }
        }
        any
    }

    /// Keeps the impulses of driven axes, if no pieces were found: the locked axes must hold in any case.
    /// (The impulse of a rigid motor at a rate that is not its own has no bound.)
    pub(super) fn fix_impulses(&mut self) {
        for driven in &mut self.driven {
            driven.piece = Piece::Constant(driven.impulse);
        }
        self.invalidate();
    }
}

/// Adds the velocity changes by impulses on the rows of the joint `at` a position to those of its bodies.
pub(super) fn add_changes<const N: usize>(
    component: Component<'_>,
    rows: &JointRows<N>,
    at: usize,
    impulses: &Column<N>,
    changes: &mut [Motion],
) {
    for (side, _) in component.members[at].movable() {
        let change = rows.push(side, impulses);
        add(&mut changes[component.bodies[at][side] as usize], &change, 1.0);
    }
}

/// The rate of a row (its joint's position, and its place there) at these velocities of the bodies.
fn rate_of<const N: usize>(
    component: Component<'_>,
    rows: &JointRows<N>,
    [at, row]: [usize; 2],
    velocities: &[Motion],
) -> f64 {
    let sides = component.members[at].movable();
    sides
        .map(|(side, _)| rows.rate(side, row, &velocities[component.bodies[at][side] as usize]))
        .sum()
}
