//! The rows on the degrees of freedom of a multibody, solved together: limits, motors with a largest force,
//! dry friction, gears, and the locked axes of joints that close loops. Such joints connect multibodies to
//! one group.
//!
//! Each row has a law ([`AxisLaw`]), and an impulse on one moves all links. With the rows one after the
//! other, a strong motor pushes the next limit aside. So the rows on the active pieces of their laws form a
//! dense system
//!
//! ```text
//! (A + C) Δλ = missing rates          A_ij = J_i M⁻¹ J_jᵀ
//! ```
//!
//! with the compliances `C` of motors. Few rows are active at a time: limits that hold, and motors below
//! their largest force. The pieces are found as for impulse joints: see `../axis_law.rs`.

use super::rows::{ConstrainedStates, JacobianPool, Row};
use crate::base::symmetric;
use crate::dim::math::Real;
use crate::step::solver::axis_law::{AxisLaw, Equation, Piece};

/// Largest number of times that rows move to another piece of their laws in one solution.
const PIECE_CHANGES_MAX: usize = 32;
/// From this time on, one row moves at a time.
const SIMULTANEOUS_CHANGES_MAX: usize = 6;
/// Largest number of rows of the joints that close loops in one group. The system is dense, and its
/// factorisation takes a millisecond for this many. Further joints are solved alone.
const LOOP_ROWS_MAX: usize = 120;
/// Largest number of rows that are solved together. Larger groups, as of a rope with dry friction, are solved
/// in consecutive parts.
const ROWS_MAX: usize = 240;
/// Smallest compliance of equations and of dry friction, as a fraction of the response of the row to an
/// impulse. Equal rows share a load by it, and the rounding of nearly redundant ones stays small. A load of a
/// thousand times the links' mass moves a row by less than a millimetre per second. Equations correct the
/// error, and friction creeps: by 10⁻⁶ m/s under its own weight.
pub const EQUATION_COMPLIANCE_MIN: f64 = 1.0e-5;
/// The same for motors. Where a gear or a limit leaves a motor no rate, their rows are redundant, and the
/// motor must yield.
pub const MOTOR_COMPLIANCE_MIN: f64 = 1.0e-4;
/// A limit beyond this rate is not reached in the substep: its last impulse was that of another limit.
const FAR_RATE: f64 = 1.0e6;

/// The law of an equation along a row: a rate, with a compliance as a fraction of the row's response.
pub fn equation(row: &Row, rate: Real, compliance: f64) -> AxisLaw {
    if row.mass == 0.0 {
        return AxisLaw::FREE;
    }
    let compliance = compliance.max(EQUATION_COMPLIANCE_MIN) * (1.0 / f64::from(row.mass));
    AxisLaw::equation_of(f64::from(rate), compliance)
}

/// A row in the system.
#[derive(Clone, Debug)]
pub struct SystemRow {
    /// The rows of one group are solved together.
    pub group: usize,
    pub row: Row,
    pub law: AxisLaw,
    pub piece: Piece,
    pub impulse: f64,
    /// Before the solution.
    start: f64,
}

impl SystemRow {
    /// Of these impulses of the motor, of the lower and of the upper limit so far.
    pub fn new(group: usize, row: Row, law: AxisLaw, [motor, lower, upper]: [Real; 3]) -> Self {
        let [motor, lower, upper] = [motor, lower, upper].map(f64::from);
        let held = |part, rate: f64| if rate.abs() < FAR_RATE { part } else { 0.0 };
        let piece = law.piece_of(motor, held(lower, law.low), held(upper, law.high));
        let impulse = motor + lower - upper;
        Self { group, row, law, piece, impulse, start: impulse }
    }

    /// The impulses of the motor, of the lower and of the upper limit.
    pub fn parts(&self) -> [Real; 3] {
        let response = if self.row.mass > 0.0 { 1.0 / f64::from(self.row.mass) } else { 0.0 };
        self.law.parts(self.piece, self.impulse, response).map(|part| part as Real)
    }

    /// Changes the impulse.
    fn push(&mut self, change: f64, jacobians: &JacobianPool, states: &mut ConstrainedStates<'_>) {
        self.impulse += change;
        jacobians.push(&self.row, change as Real, states);
    }
}

/// The rows of all multibodies that are solved now, and the buffers of their systems.
#[derive(Debug, Default)]
pub struct RowSystem {
    pub rows: Vec<SystemRow>,
    /// By multibody: its group.
    groups: Vec<usize>,
    is_connected: bool,
    /// By group: the number of rows of its joints that close loops.
    loop_rows: Vec<usize>,
    /// Groups and positions of the rows, those of one group together.
    order: Vec<[usize; 2]>,
    /// Positions of the rows with an equation.
    active: Vec<usize>,
    /// The lower half of the matrix, row after row; factorised, `L` and `D`.
    matrix: Vec<f64>,
    x: Vec<f64>,
}

impl RowSystem {
    /// Removes all rows. In the next solution, rows are in one group if joints that close loops connect their
    /// multibodies, and otherwise each joint of a loop is alone.
    pub fn clear(&mut self, is_connected: bool) {
        self.rows.clear();
        self.order.clear();
        self.is_connected = is_connected;
    }

    /// Begins a step with this number of multibodies. Each is a group.
    pub fn reset(&mut self, multibody_count: usize) {
        self.groups.clear();
        self.groups.extend(0..multibody_count);
        self.loop_rows.clear();
        self.loop_rows.resize(multibody_count, 0);
    }

    /// The group of the rows of a multibody's own joints.
    pub fn group(&self, multibody: usize) -> usize {
        if self.is_connected { self.groups[multibody] } else { multibody }
    }

    /// The group of the rows of the joint at a position among those that close loops, which is solved with a
    /// multibody's rows or alone.
    pub fn group_of_loop(&self, position: usize, multibody: Option<usize>) -> usize {
        match multibody {
            Some(multibody) if self.is_connected => self.groups[multibody],
            _ => self.groups.len() + position,
        }
    }

    /// Makes one group of the multibodies on which a joint with this number of rows acts. Returns the
    /// multibody with whose rows the joint is solved; `None` if the group would be too large.
    pub fn connect(&mut self, multibodies: [usize; 2], row_count: usize) -> Option<usize> {
        let [to, from] = multibodies.map(|multibody| self.groups[multibody]);
        let others = if from == to { 0 } else { self.loop_rows[from] };
        let count = self.loop_rows[to] + others + row_count;
        if count > LOOP_ROWS_MAX {
            return None;
        }
        self.groups.iter_mut().filter(|group| **group == from).for_each(|group| *group = to);
        self.loop_rows[to] = count;
        Some(multibodies[0])
    }

    /// Solves all groups.
    pub fn solve(&mut self, jacobians: &mut JacobianPool, states: &mut ConstrainedStates<'_>) {
        let mut order = core::mem::take(&mut self.order);
        order.extend(self.rows.iter().enumerate().map(|(k, row)| [row.group, k]));
        order.sort_unstable();
        debug_assert_eq!(order.len(), self.rows.len(), "each row is solved once");
        for group in order.chunk_by(|[a, _], [b, _]| a == b) {
            let has_loops = self.loop_rows.get(group[0][0]).is_some_and(|count| *count > 0);
            if self.is_connected && has_loops {
                // Rows of loops follow the links. A matrix of responses at different poses has no solution.
                for &[_, position] in group {
                    jacobians.respond_again(&self.rows[position].row, states.multibodies);
                }
            }
            for part in group.chunks(ROWS_MAX) {
                self.solve_part(part, jacobians, states);
            }
        }
        self.order = order;
    }

    fn solve_part(
        &mut self,
        group: &[[usize; 2]],
        jacobians: &JacobianPool,
        states: &mut ConstrainedStates<'_>,
    ) {
        for change in 0..PIECE_CHANGES_MAX {
            self.push_constants(group, jacobians, states);
            self.solve_active(group, jacobians, states);
            let only_first = change >= SIMULTANEOUS_CHANGES_MAX;
            if !self.choose_pieces(group, only_first, jacobians, states) {
                return;
            }
        }
        // No pieces were found. Gears and loops must hold in any case; the others keep their impulses.
        for &[_, position] in group {
            let row = &mut self.rows[position];
            if !row.law.is_equation() {
                row.piece = Piece::Constant(row.start);
            }
        }
        self.push_constants(group, jacobians, states);
        self.solve_active(group, jacobians, states);
    }

    /// Sets the impulses of rows on a constant piece.
    fn push_constants(
        &mut self,
        group: &[[usize; 2]],
        jacobians: &JacobianPool,
        states: &mut ConstrainedStates<'_>,
    ) {
        for &[_, position] in group {
            let row = &mut self.rows[position];
            if let Piece::Constant(impulse) = row.piece
                && impulse != row.impulse
            {
                row.push(impulse - row.impulse, jacobians, states);
            }
        }
    }

    /// Solves the equations of the active rows.
    fn solve_active(
        &mut self,
        group: &[[usize; 2]],
        jacobians: &JacobianPool,
        states: &mut ConstrainedStates<'_>,
    ) {
        let Self { rows, active, matrix, x, .. } = self;
        active.clear();
        matrix.clear();
        x.clear();
        for &[_, position] in group {
            let row = &rows[position];
            let rate = f64::from(jacobians.velocity(&row.row, states));
            let Some(equation) = row.law.equation(row.piece, row.impulse, rate) else { continue };
            let Equation { compliance, missing } = equation;
            let coupling = |other: &SystemRow| jacobians.coupling(&row.row, &other.row);
            matrix.extend(active.iter().map(|&other| coupling(&rows[other])));
            matrix.push(coupling(row) + compliance);
            x.push(missing);
            active.push(position);
        }
        debug_assert_eq!(matrix.len(), x.len() * (x.len() + 1) / 2, "the lower half");
        symmetric::factorize(matrix, x.len());
        symmetric::solve(matrix, x);
        for (&position, &change) in active.iter().zip(&*x) {
            rows[position].push(change, jacobians, states);
        }
    }

    /// Moves rows to the pieces of their laws on which they are: all, or the first one only. Returns whether
    /// any row has moved.
    fn choose_pieces(
        &mut self,
        group: &[[usize; 2]],
        only_first: bool,
        jacobians: &JacobianPool,
        states: &ConstrainedStates<'_>,
    ) -> bool {
        let mut any = false;
        for &[_, position] in group {
            let row = &mut self.rows[position];
            let rate = f64::from(jacobians.velocity(&row.row, states));
            let next = row.law.next(row.piece, row.impulse, rate);
            any |= next != row.piece;
            row.piece = next;
            if any && only_first {
                break;
            }
        }
        any
    }
}
