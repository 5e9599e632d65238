//! Growth of time and memory with the numbers of awake, fixed and sleeping bodies, of contacts, and of
//! threads.
//!
//! Each curve is a series of worlds that differ in one quantity. All engines run the same steps in each by
//! turns, as in a contest.

pub mod curve;
mod page;
pub mod world;

use crate::args::Options;
use crate::catalog::{Scene, engine_name};
use crate::clock::Clock;
use crate::contest::{Outcome, Score, Turn, scores, take_turns};
use crate::engine::{Counts, Engine, Kind, Stats, Unsupported};
use crate::pool;
use crate::scenes::grown;
use crate::units::counted;
use curve::{Curve, Setting};
use gallery::Progress;
use std::io;

/// Default number of steps in each world, including the first one: enough for a mean, and for heaps to come
/// to rest.
const STEPS: usize = 40;

/// Number of steps before the measurement in worlds with sleeping bodies. Bodies fall asleep after
/// [`world::SLEEP_DELAY`] seconds, which is 30 steps. Some engines check only some of the bodies in each
/// step.
const SETTLE: usize = 90;

/// Number of bodies from which a world gets one round only. A round takes minutes, so disturbances are small.
const ONE_ROUND_BODIES_MIN: usize = 1_000_000;

/// Largest time of building and settling a world (ms) for an engine to take part in the next, ten times
/// larger world. Rapier takes twenty seconds for 100 000 sleeping bodies in 3D; all other engines take at
/// most six. The limit selects the same engines on most machines, and all curves with one round take about
/// seven minutes.
const SETUP_TIME_MAX: f64 = 10_000.0;

/// Results of one curve in one dimension.
pub struct Growth {
    curve: Curve,
    dimension: &'static str,
    spots: Vec<Spot>,
}

/// Results of one world of a curve.
struct Spot {
    setting: Setting,
    /// Outcomes, in the order of the engines' turns.
    outcomes: Vec<Outcome>,
}

/// Measures all chosen curves, prints them, and writes the page on request.
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

/// Measures all engines in all worlds of a curve.
fn measure(curve: Curve, dimension: &'static str, options: &Options) -> io::Result<Growth> {
    let settle = if curve == Curve::Sleeping { SETTLE } else { 1 };
    // At least one step is measured.
    let steps = options.steps.unwrap_or(STEPS).max(2) + settle - 1;
    let settings = curve.settings(&options.threads, options.bodies_max);
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
                let turn = Turn {
                    template: &*template,
                    kind,
                    threads,
                    settle,
                    steps,
                    clock,
                    stats: counts_only,
                };
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
    /// Returns the reason why an engine does not run the next world, if there is one.
    fn too_slow(&self, kind: Kind) -> Option<Unsupported> {
        match &self.outcomes.iter().find(|(other, _)| *other == kind)?.1 {
            Ok(score) if score.setup() > SETUP_TIME_MAX => Some(Unsupported::because(format!(
                "the setup of {} took {:.0} s, so larger worlds were not tried",
                self.setting.title(),
                score.setup() / 1e3
            ))),
            Ok(_) => None,
            Err(reason) => Some(reason.clone()),
        }
    }
}

/// Returns the counts only: the overlaps of a million bodies take longer than all the steps.
fn counts_only(engine: &dyn Engine) -> Stats {
    Stats { counts: engine.counts(), ..Stats::default() }
}

impl Growth {
    /// Returns all scores, with their settings.
    fn scores(&self) -> impl Iterator<Item = (&Setting, Kind, &Score)> {
        self.spots.iter().flat_map(|spot| {
            scores(&spot.outcomes).map(|(kind, score)| (&spot.setting, kind, score))
        })
    }

    /// Returns the absent engines with their reasons, and the engines with other work than the first engine.
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

/// Returns the first difference of two engines' counts, without the contacts, which are in the table.
fn difference(counts: &Counts, other: &Counts) -> Option<String> {
    let numbers = [
        (counts.bodies, other.bodies, "bodies"),
        (counts.awake, other.awake, "awake bodies"),
        (counts.substeps, other.substeps, "substeps"),
    ];
    let (number, expected, noun) =
        numbers.into_iter().find(|(number, other, _)| number != other)?;
    Some(format!("{number} {noun}, not {expected}"))
}

impl Setting {
    /// Returns the number of rounds of each engine.
    fn rounds(&self, options: &Options) -> usize {
        if self.world.bodies() < ONE_ROUND_BODIES_MIN { options.rounds } else { 1 }
    }

    /// Formats the setting: `1000 bodies, 1 thread`.
    fn title(&self) -> String {
        format!("{} bodies, {}", self.world.bodies(), counted(self.threads, "thread"))
    }
}

#[cfg(test)]
mod tests {
    use super::world::World;
    use super::*;

    #[test]
    fn slow_engines_skip_larger_worlds() {
        let score = |setup: f64| Score {
            rounds: vec![vec![1.0]],
            setups: vec![setup],
            stats: Stats::default(),
            bytes: 0,
        };
        let world = World::Static { bodies: 100, awake: 10 };
        let setting = Setting { world, threads: 1, grows: Some(100) };
        let quick = (Kind::This, Ok(score(0.5 * SETUP_TIME_MAX)));
        let slow = (Kind::Rapier, Ok(score(2.0 * SETUP_TIME_MAX)));
        let absent = (Kind::Box, Err(Unsupported::because("absent")));
        let spot = Spot { setting, outcomes: vec![quick, slow, absent] };
        assert_eq!(spot.too_slow(Kind::This), None);
        let reason = spot.too_slow(Kind::Rapier).unwrap().0;
        assert!(reason.starts_with("the setup of 100 bodies, 1 thread took 20 s"), "{reason}");
        assert_eq!(spot.too_slow(Kind::Box), Some(Unsupported::because("absent")));
    }

    #[test]
    fn different_work_is_remarked() {
        let counts = Counts { bodies: 31, awake: 30, substeps: 4, pairs: 1, points: 2 };
        assert_eq!(difference(&counts, &Counts { pairs: 9, ..counts }), None);
        let reported = difference(&Counts { awake: 0, ..counts }, &counts);
        assert_eq!(reported.as_deref(), Some("0 awake bodies, not 30"));
    }
}
