//! The account of an island: the entries of a substep, and the fraction of the impulses that it keeps.

use crate::dim::math::Real;

/// The bound of the balance, as a fraction of the kinetic energy. The energy of a chain oscillates as its
/// links rotate: what a substep gains, the next one loses.
const ERROR_MAX: f64 = 0.025;
/// Relative rounding error of the terms.
const ROUNDING: f64 = 8.0 * Real::EPSILON as f64;

/// The frame in which the energy of an island is measured: that of the bodies which hold or touch its bodies
/// and cannot be moved.
///
/// Constraints with a body that translates do no work in the frame of that body. Those between two other
/// bodies do none in any frame, because their impulses are opposite and the rates of their rows are relative.
/// In a frame that rotates, the centrifugal force does work while an entry lasts.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub enum Frame {
    /// There are no such bodies.
    #[default]
    Any,
    /// That of bodies at rest.
    Rest,
    /// That of a body that translates, by its index.
    Body(u32),
    /// Something does work in each frame: a body rotates, several bodies have different frames, or surfaces
    /// move. The island is left out.
    None,
}

/// What bounds an entry.
#[derive(Copy, Clone, Debug, PartialEq)]
pub enum Entry {
    /// The impulses with which a substep starts.
    Start,
    /// Those of the solve pass, too, which correct errors.
    Correction,
    /// Those that remain after the relax pass.
    End,
}

/// Numbers of a body, and sums over bodies: `T(v)`, `b`, `a`, and the mass.
pub type Terms<T> = [T; 4];

/// The energy with a fraction of the impulses.
fn energy_with([t, b, a, _]: Terms<f64>, fraction: f64) -> f64 {
    t + fraction * (b + 0.5 * fraction * a)
}

/// The largest fraction of the impulses with an energy of at most `bound`; if there is none, the one of the
/// least energy.
fn largest_fraction([t, b, a, _]: Terms<f64>, bound: f64) -> Real {
    let root = (b * b - 2.0 * a * (t - bound)).max(0.0).sqrt();
    let fraction = (root - b) / a;
    // Without an effect of the impulses there is nothing to take back.
    if fraction.is_finite() { fraction.clamp(0.0, 1.0) as Real } else { 1.0 }
}

/// The account of one island.
#[derive(Copy, Clone, Debug, Default)]
pub struct Account {
    pub frame: Frame,
    pub has_joints: bool,
    /// Whether it has bodies without joints.
    pub has_free_bodies: bool,
    /// The numbers of deep contacts between its bodies, and of bodies with deep contacts.
    pub deep_contacts: usize,
    pub deep_bodies: usize,
    pub has_motors: bool,
    /// `T(v)` of the substep.
    energy: f64,
    /// The most energy that motors can give in the substep.
    pub drive: f64,
    /// Energy that impulses have added.
    pub balance: f64,
    /// Whether impulses were taken back in this step.
    pub is_exceeded: bool,
    /// Sums over all bodies, and over those that may have to return impulses.
    pub all: Terms<f64>,
    pub suspect: Terms<f64>,
    /// The fraction of their impulses that these keep.
    pub kept: Real,
}

impl Account {
    /// The account of an island without bodies.
    pub fn empty() -> Self {
        Self { balance: f64::NEG_INFINITY, ..Self::default() }
    }

    /// Measures the energy in a frame, too.
    pub fn include_frame(&mut self, frame: Frame) {
        self.frame = match (self.frame, frame) {
            (own, Frame::Any) => own,
            (Frame::Any, other) => other,
            (own, other) if own == other => own,
            _ => Frame::None,
        };
    }

    pub fn is_open(&self) -> bool {
        let is_loose = self.deep_contacts > self.deep_bodies;
        (self.is_jointed() || is_loose) && self.frame != Frame::None
    }

    /// Returns whether each of its bodies has a joint.
    fn is_jointed(&self) -> bool {
        self.has_joints && !self.has_free_bodies
    }

    /// Returns whether a body may have to return impulses. Impulses act on pairs: all bodies of an island
    /// with joints return the same fraction.
    pub fn suspects(&self, is_deep: bool) -> bool {
        self.is_jointed() || is_deep
    }

    /// Makes an entry for corrections of up to these velocities of joints and of contacts.
    pub fn enter(&mut self, entry: Entry, speeds: [f64; 2]) {
        let [of_joints, of_contacts] = speeds;
        let speed = if self.has_joints { of_joints.max(of_contacts) } else { of_contacts };
        let [energy, .., mass] = self.all;
        if entry == Entry::Start {
            self.energy = energy;
        }
        let bound = match entry {
            Entry::Start if self.has_motors => f64::INFINITY,
            Entry::Start => 2.0 * self.energy,
            Entry::Correction => 2.0 * self.energy + 0.5 * mass * speed * speed + self.drive,
            Entry::End => self.energy + (self.band() - self.known_balance()).max(0.0) + self.drive,
        };
        self.limit(bound);
        if entry == Entry::End {
            self.settle();
        }
    }

    /// Finds the fraction with which the island keeps to its bound.
    fn limit(&mut self, bound: f64) {
        let [t, b, a, _] = self.all;
        let now = energy_with(self.all, 1.0);
        let exceeds = now > bound + ROUNDING * (t + b.abs() + a);
        self.kept = if exceeds {
            let others = now - energy_with(self.suspect, 1.0);
            largest_fraction(self.suspect, bound - others)
        } else {
            1.0
        };
        debug_assert!((0.0..=1.0).contains(&self.kept), "impulses neither grow nor reverse");
    }

    /// The bound of the balance, in both directions.
    fn band(&self) -> f64 {
        ERROR_MAX * self.energy
    }

    /// The balance without losses beyond the band, which do not return.
    fn known_balance(&self) -> f64 {
        self.balance.max(-self.band())
    }

    /// Adds the gain of the substep to the balance.
    fn settle(&mut self) {
        let taken =
            energy_with(self.suspect, 1.0) - energy_with(self.suspect, f64::from(self.kept));
        let change = energy_with(self.all, 1.0) - taken - self.energy;
        // What motors could have given, and did not, is no loss.
        let gain = if change > 0.0 { (change - self.drive).max(0.0) } else { change };
        let balance = self.known_balance() + gain;
        self.balance = if balance.is_finite() { balance.max(-self.band()) } else { 0.0 };
        debug_assert!(self.balance.is_finite() && self.balance >= -self.band().max(0.0));
        self.is_exceeded |= self.kept < 1.0;
    }
}
