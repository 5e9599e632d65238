//! The bodies that an impact may change: their velocities when its round began, and the times of its impacts.

use crate::dim::state::{BodyState, READ_ONLY};
use crate::step::solver::impact_time::ImpactTime;
use core::ops::Range;

/// The set is usually small. The states at the start are stored, and compared for these bodies alone.
#[derive(Default)]
pub(super) struct Touched {
    /// The list has no duplicates. The bodies that every round may change come first.
    pub bodies: Vec<u32>,
    /// The number of bodies that every round may change.
    always: usize,
    /// Number of this round, from two. One marks bodies that are listed before the first round.
    round: u32,
    /// By the index of a body: the last round that may change it, zero for those that are not among them.
    rounds: Vec<u32>,
    /// Velocities when the round began. At rest, for others.
    pub start: Vec<BodyState>,
    /// By the index of a body: the time of its impacts in this round. Zero for others.
    pub times: Vec<ImpactTime>,
}

impl Touched {
    /// Begins an impact among so many bodies.
    pub fn begin(&mut self, count: usize) {
        for body in self.bodies.drain(..) {
            self.rounds[body as usize] = 0;
            self.start[body as usize] = BodyState::default();
            self.times[body as usize] = ImpactTime::default();
        }
        debug_assert!(
            self.rounds.iter().all(|&round| round == 0),
            "no body of the last impact is left"
        );
        self.round = 1;
        self.rounds.resize(count, 0);
        self.start.resize(count, BodyState::default());
        self.times.resize(count, ImpactTime::default());
    }

    /// Makes the added bodies part of all rounds.
    pub fn keep(&mut self) {
        self.always = self.bodies.len();
    }

    /// Begins a round.
    pub fn begin_round(&mut self) {
        self.round += 1;
        for &body in &self.bodies[..self.always] {
            self.rounds[body as usize] = self.round;
        }
    }

    /// Adds bodies that may change, except read-only ones.
    pub fn add(&mut self, bodies: impl Iterator<Item = u32>) {
        for body in bodies.filter(|body| body & READ_ONLY == 0) {
            if core::mem::replace(&mut self.rounds[body as usize], self.round) == 0 {
                self.bodies.push(body);
            }
        }
    }

    /// The same, for all of these.
    pub fn add_all(&mut self, bodies: impl IntoIterator<Item = Range<usize>>) {
        bodies.into_iter().for_each(|range| self.add(range.map(|body| body as u32)));
    }

    /// Returns whether this round may change a body.
    pub fn is_changed(&self, body: u32) -> bool {
        self.rounds[body as usize] == self.round
    }

    /// Notes how bodies move before the round.
    pub fn note_start(&mut self, states: &[BodyState]) {
        for &body in &self.bodies {
            self.start[body as usize] = states[body as usize];
            self.times[body as usize] = ImpactTime::default();
        }
    }
}
