//! How time and memory grow: with bodies that are awake, that stand still, or that sleep; with contacts; with threads.
//!
//! Each curve is a row of worlds that differ in one thing. All engines take the same steps in each by turns, as in a contest.

mod curve;
mod page;

pub use curve::Curve;

use crate::args::Options;
use crate::catalog::{Scene, engine_name};
use crate::clock::Clock;
use crate::contest::{Outcome, Score, Turn, scores, take_turns};
use crate::engine::{Counts, Engine, Kind, Stats, Template, Unsupported};
use crate::pool;
use crate::units::counted;
use curve::Setting;
use gallery::Progress;
use std::io;

/// Steps in each world, if the user does not say, the first one too: enough for a mean, and for heaps to come to rest.
const STEPS: usize = 40;

/// Steps that are taken before where bodies have to fall asleep. They do after [`CALM`] seconds, which is 30 steps; some engines look at
/// some of the bodies in each step only.
const SETTLE: usize = 90;

/// How long a body has been calm when it falls asleep, where it may (s): what Box2D and Box3D know no other number than.
pub const CALM: f32 = 0.5;

/// Worlds of so many bodies get one round only: it takes minutes, and what disturbs it is small beside it.
const LARGE: usize = 1_000_000;

/// An engine whose world takes longer to make and to settle than this (ms) is left out of the larger ones of the curve: ten times the
/// bodies, and at least ten times as long. That of 100 000 bodies that fall asleep takes Rapier twenty seconds in 3D, and all others six at
/// most; so who goes on to a million is the same on most machines, and all curves with one round take some seven minutes.
const PATIENCE: f64 = 10_000.0;

/// A world that grows.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum World {
    /// Boxes in heaps.
    Heaps {
        /// All boxes.
        bodies: usize,
        /// Boxes of a heap.
        each: usize,
        /// Do the boxes of a layer touch each other?
        dense: bool,
    },
    /// Fixed blocks, with boxes that move on some of them.
    Static {
        /// The blocks.
        bodies: usize,
        /// The boxes.
        awake: usize,
    },
    /// Boxes that fall asleep, and others among them that may not.
    Sleeping {
        /// Those that sleep.
        bodies: usize,
        /// Those that do not.
        awake: usize,
    },
}

/// What became of one curve in one dimension.
pub struct Growth {
    curve: Curve,
    dimension: &'static str,
    spots: Vec<Spot>,
}

/// One world of a curve.
struct Spot {
    setting: Setting,
    /// One for each engine, in the order they took turns.
    outcomes: Vec<Outcome>,
}

/// Measures all chosen curves, prints them, and writes the page if that is asked for.
pub fn run(scenes: &[Scene], options: &Options) -> io::Result<()> {
    let chosen =
        |dimension: &str| options.scenes.iter().any(|&index| scenes[index].dimension == dimension);
    let mut growths = Vec::new();
    for &curve in &options.curves {
        for dimension in ["3d", "2d"].into_iter().filter(|dimension| chosen(dimension)) {
            let growth = measure(curve, dimension, options)?;
            page::print(&mut io::stdout().lock(), &growth)?;
            growths.push(growth);
        }
    }
    if options.write { page::write(&growths, options) } else { Ok(()) }
}

/// All engines in all worlds of a curve.
fn measure(curve: Curve, dimension: &'static str, options: &Options) -> io::Result<Growth> {
    let settle = if curve == Curve::Sleeping { SETTLE } else { 1 };
    // At least one is measured.
    let steps = options.steps.unwrap_or(STEPS).max(2) + settle - 1;
    let settings = curve.settings(options);
    let label = format!("{dimension} {}", curve.name());
    let turns = settings.iter().map(|setting| setting.rounds(options) * options.engines.len());
    let all = turns.sum::<usize>() * steps;
    let mut progress = Progress::new(&label, label.len(), all);
    let mut done = 0;
    let mut spots: Vec<Spot> = Vec::new();
    for setting in settings {
        let visit = || {
            let template = grown(dimension, setting.world);
            let clock = if curve == Curve::Threads { Clock::start_wall } else { Clock::start };
            let threads = setting.threads;
            let outcomes = take_turns(&options.engines, setting.rounds(options), |_, kind| {
                if let Some(slow) = spots.last().and_then(|spot| spot.too_slow(kind)) {
                    return Err(slow);
                }
                let turn = Turn { template: &*template, kind, threads, settle, steps, clock, look };
                let score = turn.play(&mut |step| progress.advance(done + step));
                done += steps;
                score
            });
            Spot { setting, outcomes }
        };
        spots.push(pool::of(setting.threads)?.install(visit));
    }
    progress.clear();
    Ok(Growth { curve, dimension, spots })
}

impl Spot {
    /// Why an engine shall not go on to the next world, if there is a reason.
    fn too_slow(&self, kind: Kind) -> Option<Unsupported> {
        match &self.outcomes.iter().find(|(other, _)| *other == kind)?.1 {
            Ok(score) if score.setup() > PATIENCE => Some(Unsupported::because(format!(
                "{} took it {:.0} s to make and settle, and larger worlds were not tried",
                self.setting.title(),
                score.setup() / 1e3
            ))),
            Ok(_) => None,
            Err(reason) => Some(reason.clone()),
        }
    }
}

fn grown(dimension: &str, world: World) -> Box<dyn Template> {
    if dimension == "2d" { crate::flat::grown(world) } else { crate::solid::grown(world) }
}

/// Counts alone: the overlaps of a million bodies take longer than all the steps.
fn look(engine: &dyn Engine) -> Stats {
    Stats { counts: engine.counts(), ..Stats::default() }
}

impl Growth {
    /// All scores, with their settings.
    fn scores(&self) -> impl Iterator<Item = (&Setting, Kind, &Score)> {
        self.spots.iter().flat_map(|spot| {
            scores(&spot.outcomes).map(|(kind, score)| (&spot.setting, kind, score))
        })
    }

    /// Who did not take part, and why; and whose work differs from the first engine's.
    fn remarks(&self) -> Vec<String> {
        let mut remarks = Vec::new();
        for spot in &self.spots {
            let first = scores(&spot.outcomes).next();
            for (kind, outcome) in &spot.outcomes {
                let name = engine_name(*kind, self.dimension);
                let remark = match outcome {
                    Err(reason) => Some(format!("without {name}: {}", reason.0)),
                    Ok(score) => first.and_then(|(_, first)| {
                        let difference = difference(&score.stats.counts, &first.stats.counts)?;
                        Some(format!(
                            "NOT EQUAL: {}: {name} has {difference}",
                            spot.setting.title()
                        ))
                    }),
                };
                remarks.extend(remark.filter(|remark| !remarks.contains(remark)));
            }
        }
        remarks
    }
}

/// How an engine's work differs from another's, but for the contacts, which the table has.
fn difference(counts: &Counts, other: &Counts) -> Option<String> {
    let numbers = [
        (counts.bodies, other.bodies, "bodies"),
        (counts.awake, other.awake, "awake bodies"),
        (counts.substeps, other.substeps, "substeps"),
    ];
    let (number, wanted, noun) = numbers.into_iter().find(|(number, other, _)| number != other)?;
    Some(format!("{number} {noun}, not {wanted}"))
}

impl Setting {
    /// So many rounds of each engine.
    fn rounds(&self, options: &Options) -> usize {
        if self.world.bodies() < LARGE { options.rounds } else { 1 }
    }

    /// `1000 bodies, 1 thread`
    fn title(&self) -> String {
        format!("{} bodies, {}", self.world.bodies(), counted(self.threads, "thread"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_is_too_slow_stays_away() {
        let score = |setup: f64| Score {
            rounds: vec![vec![1.0]],
            setups: vec![setup],
            stats: Stats::default(),
            bytes: 0,
        };
        let world = World::Static { bodies: 100, awake: 10 };
        let setting = Setting { world, threads: 1, grows: Some(100) };
        let quick = (Kind::This, Ok(score(0.5 * PATIENCE)));
        let slow = (Kind::Rapier, Ok(score(2.0 * PATIENCE)));
        let absent = (Kind::Box, Err(Unsupported::because("absent")));
        let spot = Spot { setting, outcomes: vec![quick, slow, absent] };
        assert_eq!(spot.too_slow(Kind::This), None);
        let reason = spot.too_slow(Kind::Rapier).unwrap().0;
        assert!(reason.starts_with("100 bodies, 1 thread took it 20 s"), "{reason}");
        assert_eq!(spot.too_slow(Kind::Box), Some(Unsupported::because("absent")));
    }

    #[test]
    fn other_work_is_told() {
        let counts = Counts { bodies: 31, awake: 30, substeps: 4, pairs: 1, points: 2 };
        assert_eq!(difference(&counts, &Counts { pairs: 9, ..counts }), None);
        let told = difference(&Counts { awake: 0, ..counts }, &counts);
        assert_eq!(told.as_deref(), Some("0 awake bodies, not 30"));
    }
}
