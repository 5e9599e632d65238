//! The bodies that an impact may change, and how they moved when its round began.

use crate::dim::state::{BodyState, READ_ONLY};
use core::ops::Range;

/// Often a few of all. What they were is kept, and looked at again, for these alone.
#[derive(Default)]
pub(super) struct Touched {
    /// Each once; first those that any round may change, wherever it falls.
    pub bodies: Vec<u32>,
    /// The number of these.
    always: usize,
    /// By the index of a body: is it among them?
    is_listed: Vec<bool>,
    /// The same, of this round alone.
    pub is_changed: Vec<bool>,
    /// How they moved when the round began. At rest, for others.
    pub start: Vec<BodyState>,
    /// In place of a velocity: the sum of impulses in this round, and of impulse times time. Nothing, for others.
    pub delays: Vec<BodyState>,
}

impl Touched {
    /// Begins an impact among so many bodies.
    pub fn begin(&mut self, count: usize) {
        for body in self.bodies.drain(..) {
            self.is_listed[body as usize] = false;
            self.is_changed[body as usize] = false;
            self.start[body as usize] = BodyState::default();
            self.delays[body as usize] = BodyState::default();
        }
        self.is_listed.resize(count, false);
        self.is_changed.resize(count, false);
        self.start.resize(count, BodyState::default());
        self.delays.resize(count, BodyState::default());
    }

    /// What has been added is part of all rounds.
    pub fn keep(&mut self) {
        self.always = self.bodies.len();
    }

    /// Begins a round.
    pub fn begin_round(&mut self) {
        for (index, &body) in self.bodies.iter().enumerate() {
            self.is_changed[body as usize] = index < self.always;
        }
    }

    /// These bodies may change, but for those that are read-only.
    pub fn add(&mut self, bodies: impl Iterator<Item = u32>) {
        for body in bodies.filter(|body| body & READ_ONLY == 0) {
            self.is_changed[body as usize] = true;
            if !core::mem::replace(&mut self.is_listed[body as usize], true) {
                self.bodies.push(body);
            }
        }
    }

    /// The same, for all of these.
    pub fn add_all(&mut self, bodies: impl IntoIterator<Item = Range<usize>>) {
        bodies.into_iter().for_each(|range| self.add(range.map(|body| body as u32)));
    }

    /// Notes how bodies move before the round.
    pub fn note_start(&mut self, states: &[BodyState]) {
        for &body in &self.bodies {
            self.start[body as usize] = states[body as usize];
            self.delays[body as usize] = BodyState::default();
        }
    }
}
