//! A constraint row between links of multibodies, ordinary bodies and the world.
//!
//! The relative velocity of a row is `Ċ = Σ J v` over its two sides. For an ordinary body `v` is its spatial
//! velocity. For the links of a multibody it is the list of all its generalised velocities `q̇`. An impulse
//! on one link moves all of them. An impulse `λ` adds `W λ` with the response `W = M⁻¹ Jᵀ`, and the row
//! resists with `K = J W`.
//!
//! `J` and `W` are lists with one number per degree of freedom, computed once a step in time proportional to
//! the number of links. (Moment arms and inertias of contacts are frozen during a step; multibodies that
//! rotate far or have loops are updated in each substep.) An iteration multiplies two lists over the span
//! where `J` is not zero, which is one number for a limit. If the impulse changes, it also adds a multiple of
//! `W`.

use super::Moving;
use crate::dim::math::{Real, SpatialVector};
use crate::dim::spatial::{angular, join, linear};
use crate::dim::state::{BodyState, READ_ONLY};
use crate::step::solver::impact_time::ImpactTime;

/// One side of a row, or two sides of the same multibody.
#[derive(Copy, Clone, Debug)]
pub enum Part {
    /// Something that stands still.
    Nothing,
    /// Links of a multibody (its position among the awake ones); its numbers begin at `start`. They are
    /// movable or immovable. Only the numbers of `J` for the degrees of freedom in `span` are not zero.
    Links { multibody: usize, start: usize, span: [usize; 2], is_movable: bool },
    /// An ordinary body, by its index in the solver.
    Body { index: u32, jacobian: SpatialVector, response: SpatialVector },
}

/// See the [module](self).
#[derive(Copy, Clone, Debug)]
pub struct Row {
    pub parts: [Part; 2],
    /// `1 / K`; zero if both sides are immovable.
    pub mass: Real,
}

impl Row {
    /// The same row with at least this compliance.
    pub fn with_compliance_min(self, k: Real) -> Self {
        Self { mass: if k > 0.0 { self.mass.min(1.0 / k) } else { self.mass }, ..self }
    }

    /// The least number that its multibodies have.
    pub fn least_of(&self, multibodies: &[Moving], number: impl Fn(&Moving) -> Real) -> Real {
        let of_part = |part: &Part| match part {
            Part::Links { multibody, .. } => number(&multibodies[*multibody]),
            Part::Nothing | Part::Body { .. } => 1.0,
        };
        of_part(&self.parts[0]).min(of_part(&self.parts[1]))
    }

    /// Makes the row anew, of the same multibody, with its numbers where the old ones were.
    pub fn rewrite(
        &mut self,
        jacobians: &mut JacobianPool,
        make: impl FnOnce(&mut JacobianPool) -> Self,
    ) {
        let Some(start) = self.parts.iter().find_map(Part::start) else { return };
        jacobians.rewrite_from(start);
        *self = make(jacobians);
        jacobians.append();
    }
}

impl Part {
    /// First of its numbers, if it has any.
    fn start(&self) -> Option<usize> {
        match self {
            Self::Links { start, .. } => Some(*start),
            Self::Nothing | Self::Body { .. } => None,
        }
    }
}

/// The numbers of all rows.
#[derive(Debug, Default)]
pub struct JacobianPool {
    jacobians: Vec<Real>,
    responses: Vec<Real>,
    /// Position of the next numbers; at the end, unless they are overwritten.
    next: usize,
    /// Largest possible size of each number of the current part.
    sizes: Vec<Real>,
}

/// Values below this fraction of their largest possible size are rounding. If the joints leave a row nothing
/// to move, all of `J` is rounding, and `1/K` would be arbitrary.
const ROUNDING: Real = 64.0 * Real::EPSILON;

/// Everything that rows act on.
pub struct ConstrainedStates<'a> {
    pub multibodies: &'a mut [Moving],
    pub states: &'a mut [BodyState],
}

impl JacobianPool {
    /// No rows yet.
    pub fn clear(&mut self) {
        self.truncate(0);
    }

    /// The number of entries.
    pub fn len(&self) -> usize {
        self.jacobians.len()
    }

    /// Removes all numbers except the first ones.
    pub fn truncate(&mut self, len: usize) {
        self.jacobians.truncate(len);
        self.responses.truncate(len);
        self.next = len;
    }

    /// Overwrites the next numbers from a position on, with the same count.
    pub fn rewrite_from(&mut self, start: usize) {
        self.next = start;
    }

    /// Ends that.
    pub fn append(&mut self) {
        debug_assert!(self.next <= self.jacobians.len(), "a row that is made anew keeps its count");
        self.next = self.jacobians.len();
    }

    /// A part whose Jacobian `fill` adds to zeros, with how large its numbers could be. Impulses move it only
    /// if it `is_movable`.
    pub fn add_links(
        &mut self,
        multibodies: &mut [Moving],
        multibody: usize,
        is_movable: bool,
        fill: impl FnOnce(&Moving, &mut [Real], &mut [Real]),
    ) -> Part {
        let moving = &mut multibodies[multibody];
        debug_assert_eq!(self.jacobians.len(), self.responses.len());
        let start = self.next;
        let end = start + moving.motion.rates.len();
        self.next = end;
        let len = end.max(self.jacobians.len());
        self.jacobians.resize(len, 0.0);
        self.responses.resize(len, 0.0);
        self.sizes.clear();
        self.sizes.resize(end - start, 0.0);
        let (jacobian, response) =
            (&mut self.jacobians[start..end], &mut self.responses[start..end]);
        jacobian.fill(0.0);
        fill(moving, jacobian, &mut self.sizes);
        for (number, size) in jacobian.iter_mut().zip(&self.sizes) {
            *number = if number.abs() < ROUNDING * size { 0.0 } else { *number };
        }
        response.copy_from_slice(jacobian);
        if is_movable {
            moving.motion.respond(response);
        }
        let first = jacobian.iter().position(|&number| number != 0.0).unwrap_or(0);
        let behind = jacobian.iter().rposition(|&number| number != 0.0).map_or(0, |last| last + 1);
        debug_assert!(first <= behind && behind <= jacobian.len());
        Part::Links { multibody, start, span: [first, behind], is_movable }
    }

    /// Recomputes the response of a row where the links are now.
    pub fn respond_again(&mut self, row: &Row, multibodies: &mut [Moving]) {
        for part in &row.parts {
            let Part::Links { multibody, start, is_movable: true, .. } = part else { continue };
            let motion = &mut multibodies[*multibody].motion;
            let range = *start..start + motion.rates.len();
            let response = &mut self.responses[range.clone()];
            response.copy_from_slice(&self.jacobians[range]);
            motion.respond(response);
        }
    }

    /// A row of these parts.
    pub fn row(&self, parts: [Part; 2]) -> Row {
        let mut row = Row { parts, mass: 0.0 };
        let k = self.coupling(&row, &row) as Real;
        let inverse = 1.0 / k;
        if k > 0.0 && inverse.is_finite() {
            row.mass = inverse;
        }
        row
    }

    /// `J_i W_j`: the velocity of the first row by an impulse of 1 on the second, which must be of the same
    /// two sides.
    pub fn coupling(&self, first: &Row, second: &Row) -> f64 {
        let of = |one: &Part, other: &Part| match (one, other) {
            (
                Part::Links { multibody, start: i, span: [first, behind], .. },
                Part::Links { multibody: other, start: j, is_movable: true, .. },
            ) if multibody == other => exact_product(
                &self.jacobians[i + first..i + behind],
                &self.responses[j + first..j + behind],
            ),
            (Part::Body { index, jacobian, .. }, Part::Body { index: other, response, .. })
                if index == other =>
            {
                exact_product(jacobian, response)
            }
            _ => 0.0,
        };
        let with = |one: &Part| of(one, &second.parts[0]) + of(one, &second.parts[1]);
        with(&first.parts[0]) + with(&first.parts[1])
    }

    /// Adds the work that an impulse does on multibodies to their [work](Moving::work).
    pub fn note_work(&self, row: &Row, impulse: Real, states: &mut ConstrainedStates<'_>) {
        for part in &row.parts {
            let Part::Links { multibody, .. } = part else { continue };
            let work = impulse * self.rate(part, states);
            states.multibodies[*multibody].work += work.max(0.0);
        }
    }

    /// Adds the work of the other side on a link. The other side, or the belt on it, keeps its velocity, and
    /// the link moves at least as fast.
    pub fn note_shove(
        &self,
        row: &Row,
        impulse: Real,
        surface: Real,
        states: &mut ConstrainedStates<'_>,
    ) {
        let [first, second] = &row.parts;
        for (link, other) in [(first, second), (second, first)] {
            let Part::Links { multibody, is_movable: true, .. } = link else { continue };
            let work = impulse * (surface - self.rate(other, states));
            states.multibodies[*multibody].work += work.max(0.0);
        }
    }

    /// `Ċ`.
    pub fn velocity(&self, row: &Row, states: &ConstrainedStates<'_>) -> Real {
        self.sum(row, |part| self.rate(part, states))
    }

    /// Contribution of one side of a row to `Ċ`.
    fn rate(&self, part: &Part, states: &ConstrainedStates<'_>) -> Real {
        match part {
            Part::Nothing => 0.0,
            Part::Links { multibody, start, span: [first, behind], .. } => {
                let rates = &states.multibodies[*multibody].motion.rates;
                product(&self.jacobians[start + first..start + behind], &rates[*first..*behind])
            }
            Part::Body { index, jacobian, .. } => {
                let (linvel, angvel) = states.states[at(*index)].velocity();
                product(jacobian, &join(linvel, angvel))
            }
        }
    }

    /// Change of `C` since the step began.
    pub fn displacement(&self, row: &Row, states: &ConstrainedStates<'_>) -> Real {
        self.sum(row, |part| match part {
            Part::Nothing => 0.0,
            Part::Links { multibody, start, span: [first, behind], .. } => {
                let shift = &states.multibodies[*multibody].shift;
                product(&self.jacobians[start + first..start + behind], &shift[*first..*behind])
            }
            Part::Body { index, jacobian, .. } => {
                let (shift, rotvec) = states.states[at(*index)].displacement();
                product(jacobian, &join(shift, rotvec))
            }
        })
    }

    fn sum(&self, row: &Row, of: impl Fn(&Part) -> Real) -> Real {
        of(&row.parts[0]) + of(&row.parts[1])
    }

    /// Applies an impulse along the row.
    pub fn push(&self, row: &Row, impulse: Real, states: &mut ConstrainedStates<'_>) {
        self.each_response(row, impulse, states, |moving, jacobian, response| {
            add(&mut moving.motion.rates, response, impulse);
            moving.note_push(jacobian, response, impulse);
            moving.motion.note_external_impulse(&jacobian[..moving.root_pushed.len()], impulse);
        });
    }

    /// Applies an impulse that is no warm-start load for the next substep: that of an impact.
    pub fn apply_impact(&self, row: &Row, impulse: Real, states: &mut ConstrainedStates<'_>) {
        self.each_response(row, impulse, states, |moving, jacobian, response| {
            add(&mut moving.motion.rates, response, impulse);
            moving.motion.note_external_impulse(&jacobian[..moving.root_pushed.len()], impulse);
            moving.motion.note_impact();
        });
    }

    /// Returns whether both sides of a row are moved to the time of impact.
    pub fn goes_back(&self, row: &Row, states: &ConstrainedStates<'_>) -> bool {
        row.parts.iter().all(|part| match part {
            Part::Links { multibody, .. } => states.multibodies[*multibody].has_rigid_motion(),
            Part::Nothing | Part::Body { .. } => true,
        })
    }

    /// Notes the time of an impact (s) in the multibodies of a row, and whether it may add energy.
    pub fn note_time(
        &self,
        row: &Row,
        time: Real,
        gains: bool,
        states: &mut ConstrainedStates<'_>,
    ) {
        let [first, second] = &row.parts;
        for (part, other) in [(first, second), (second, first)] {
            if let Part::Links { multibody, is_movable: true, .. } = part {
                let may_gain = gains || !matches!(other, Part::Nothing);
                states.multibodies[*multibody].before_impact.note(time, may_gain);
            }
        }
    }

    /// Adds an impact of a row to the impact times of its bodies.
    pub fn note_body_time(&self, row: &Row, time: ImpactTime, times: &mut [ImpactTime]) {
        for part in &row.parts {
            match part {
                Part::Body { index, .. } if index & READ_ONLY == 0 => times[at(*index)] += time,
                _ => {}
            }
        }
    }

    /// Pushes with an impulse before the first substep: bodies get it at once, multibodies when the substep
    /// begins.
    pub fn push_early(&self, row: &Row, impulse: Real, states: &mut ConstrainedStates<'_>) {
        self.each_response(row, impulse, states, |moving, jacobian, response| {
            moving.note_push(jacobian, response, impulse);
        });
    }

    fn each_response(
        &self,
        row: &Row,
        impulse: Real,
        states: &mut ConstrainedStates<'_>,
        push_links: impl Fn(&mut Moving, &[Real], &[Real]),
    ) {
        if impulse == 0.0 {
            return;
        }
        for part in &row.parts {
            match part {
                Part::Nothing => {}
                Part::Links { is_movable: false, .. } => {}
                Part::Links { multibody, start, .. } => {
                    let moving = &mut states.multibodies[*multibody];
                    let end = start + moving.pushed.len();
                    let (jacobian, response) =
                        (&self.jacobians[*start..end], &self.responses[*start..end]);
                    push_links(moving, jacobian, response);
                }
                Part::Body { index, response, .. } if index & READ_ONLY == 0 => {
                    let state = &mut states.states[at(*index)];
                    let (linvel, angvel) = state.velocity();
                    state.set_velocity(
                        linvel + linear(response) * impulse,
                        angvel + angular(response) * impulse,
                    );
                }
                Part::Body { .. } => {}
            }
        }
    }
}

impl Moving {
    /// Stores the effect of an impulse.
    fn note_push(&mut self, jacobian: &[Real], response: &[Real], impulse: Real) {
        add(&mut self.pushed, response, impulse);
        add(&mut self.root_pushed, jacobian, impulse);
    }
}

/// The place of a body's state.
fn at(index: u32) -> usize {
    (index & !READ_ONLY) as usize
}

/// [`product`] without rounding: the small pivots of a system are differences of large couplings.
fn exact_product(a: &[Real], b: &[Real]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
}

fn product(a: &[Real], b: &[Real]) -> Real {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

fn add(target: &mut [Real], change: &[Real], factor: Real) {
    for (number, more) in target.iter_mut().zip(change) {
        *number += more * factor;
    }
}
