//! A scene that several engines run in turns.

use crate::args::Options;
use crate::catalog::{Scene, engine_name};
use crate::clock::Clock;
use crate::engine::{Engine, Kind, Stats, Template, Unsupported};
use crate::memory::live_bytes;
use crate::units::{counted, mean_of_steps, middle};
use gallery::Progress;

/// Results of one scene with one number of threads.
pub struct Contest {
    /// `3d/large_pyramid`
    pub scene: String,
    /// Number of dynamic bodies.
    pub dynamic_bodies: usize,
    /// Number of threads.
    pub threads: usize,
    /// Outcomes, in the order of the engines' turns.
    pub outcomes: Vec<Outcome>,
}

/// Outcome of an engine: its score, or the reason why it did not take part.
pub type Outcome = (Kind, Result<Score, Unsupported>);

/// Returns the scores of the engines that took part.
pub fn scores(outcomes: &[Outcome]) -> impl Iterator<Item = (Kind, &Score)> {
    outcomes.iter().filter_map(|(kind, outcome)| Some((*kind, outcome.as_ref().ok()?)))
}

/// Measurements of an engine.
pub struct Score {
    /// Times of all steps but the first (ms), for each round.
    pub rounds: Vec<Vec<f64>>,
    /// Time of building the world and of the first step (ms), for each round. Some engines insert bodies at
    /// once, and others insert them in the first step.
    pub setups: Vec<f64>,
    /// The world after the last round.
    pub stats: Stats,
    /// Bytes of the world at the end.
    pub bytes: usize,
}

impl Score {
    /// Returns the mean over the steps (ms) of the median over the rounds.
    ///
    /// A step does the same work in every round, so a disturbance of one step in one round is ignored.
    pub fn median(&self) -> f64 {
        mean_of_steps(&self.rounds, middle)
    }

    /// Returns the mean over the steps (ms) of the fastest round, the least disturbed one on this machine.
    pub fn best(&self) -> f64 {
        mean_of_steps(&self.rounds, |sorted| sorted[0])
    }

    /// Adds a round.
    fn add(&mut self, round: Score) {
        self.rounds.extend(round.rounds);
        self.setups.extend(round.setups);
        self.stats = round.stats;
        self.bytes = round.bytes;
    }

    /// Returns the number of steps of a round, the first one included.
    pub fn steps(&self) -> usize {
        self.rounds[0].len() + 1
    }

    /// Returns the fastest time of building the world and of the first step (ms).
    pub fn setup(&self) -> f64 {
        self.setups.iter().copied().fold(f64::INFINITY, f64::min)
    }
}

impl Contest {
    /// Returns the score of this engine, if it took part.
    pub fn ours(&self) -> Option<&Score> {
        self.score(Kind::This)
    }

    /// Returns the score of an engine, if it took part.
    pub fn score(&self, kind: Kind) -> Option<&Score> {
        self.scores().find(|(other, _)| *other == kind).map(|(_, score)| score)
    }

    /// Returns all scores, in the order of the engines' turns.
    pub fn scores(&self) -> impl Iterator<Item = (Kind, &Score)> {
        scores(&self.outcomes)
    }

    /// Returns the peer with the smallest median, and the median (ms).
    pub fn fastest_peer(&self) -> Option<(Kind, f64)> {
        let peers = self.scores().filter(|(kind, _)| kind.is_peer());
        peers.map(|(kind, score)| (kind, score.median())).min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Returns the dimension, `2d` or `3d`.
    pub fn dimension(&self) -> &str {
        self.scene.split('/').next().unwrap_or_default()
    }

    /// Returns the scene's name without the dimension.
    pub fn name(&self) -> &str {
        self.scene.split_once('/').map_or(&self.scene, |(_, name)| name)
    }

    /// Returns the name of an engine in this dimension.
    pub fn engine_name(&self, kind: Kind) -> &'static str {
        engine_name(kind, self.dimension())
    }
}

/// Runs a scene in all engines by turns.
pub fn run(scene: &Scene, threads: usize, options: &Options) -> Contest {
    let template = (scene.build)();
    // The first step counts as setup.
    let steps = options.steps.unwrap_or(scene.steps).max(2);
    let outcomes = take_turns(&options.engines, options.rounds, |round, kind| {
        let label = format!(
            "{}, {}, round {} of {}, {}",
            scene.title(),
            counted(threads, "thread"),
            round + 1,
            options.rounds,
            scene.engine_name(kind)
        );
        let mut progress = Progress::new(&label, label.len(), steps);
        let (clock, stats) = (Clock::start, |engine: &dyn Engine| engine.stats());
        let turn = Turn { template: &*template, kind, threads, settle: 1, steps, clock, stats };
        let score = turn.play(&mut |done| progress.advance(done));
        progress.clear();
        score
    });
    let dynamic_bodies = template.dynamic_bodies();
    Contest { scene: scene.title(), dynamic_bodies, threads, outcomes }
}

/// Runs one round of each engine, then the next round. `play` gets the round and the engine. An engine that
/// fails in one round is left out of the next rounds.
pub fn take_turns(
    engines: &[Kind],
    rounds: usize,
    mut play: impl FnMut(usize, Kind) -> Result<Score, Unsupported>,
) -> Vec<Outcome> {
    let mut outcomes: Vec<Outcome> = Vec::new();
    for round in 0..rounds {
        for (position, &kind) in engines.iter().enumerate() {
            match outcomes.get_mut(position) {
                None => outcomes.push((kind, play(round, kind))),
                Some((_, Ok(so_far))) => {
                    if let Ok(score) = play(round, kind) {
                        so_far.add(score);
                    }
                }
                Some((_, Err(_))) => {}
            }
        }
    }
    outcomes
}

/// Task of an engine in a fresh world.
pub struct Turn<'t> {
    /// Template of the world.
    pub template: &'t dyn Template,
    /// The engine.
    pub kind: Kind,
    /// Number of threads.
    pub threads: usize,
    /// Number of first steps that count as setup.
    pub settle: usize,
    /// Number of steps, including the first ones.
    pub steps: usize,
    /// Starts the clock for this number of threads.
    pub clock: fn(usize) -> Clock,
    /// Measures the world at the end.
    pub stats: fn(&dyn Engine) -> Stats,
}

impl Turn<'_> {
    /// Runs the steps and returns a score of one round.
    pub fn play(&self, after_step: &mut dyn FnMut(usize)) -> Result<Score, Unsupported> {
        let mut durations = Vec::with_capacity(self.steps - self.settle);
        let bytes_before = live_bytes();
        let clock = (self.clock)(self.threads);
        let mut engine = self.template.start(self.kind, self.threads)?;
        for done in 1..=self.settle {
            engine.step();
            after_step(done);
        }
        let setup = clock.milliseconds();
        for done in self.settle + 1..=self.steps {
            let clock = (self.clock)(self.threads);
            engine.step();
            durations.push(clock.milliseconds());
            after_step(done);
        }
        let bytes = live_bytes().saturating_sub(bytes_before) + engine.foreign_bytes();
        let (rounds, setups) = (vec![durations], vec![setup]);
        Ok(Score { rounds, setups, stats: (self.stats)(&*engine), bytes })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn score(rounds: &[&[f64]]) -> Score {
        let rounds = rounds.iter().map(|round| round.to_vec()).collect();
        Score { rounds, setups: vec![2.0, 1.0], stats: Stats::default(), bytes: 0 }
    }

    #[test]
    fn disturbed_steps_are_ignored() {
        let score = score(&[&[3.0, 90.0], &[80.0, 5.0], &[3.5, 7.0]]);
        assert_eq!(score.median(), (3.5 + 7.0) / 2.0);
        assert_eq!(score.best(), (3.0 + 5.0) / 2.0);
        assert_eq!(score.setup(), 1.0);
    }

    #[test]
    fn an_engine_without_support_is_tried_once() {
        let mut calls = Vec::new();
        let outcomes = take_turns(&[Kind::This, Kind::Box], 3, |round, kind| {
            calls.push((round, kind));
            let absent = Err(Unsupported::because("absent"));
            if kind == Kind::This { Ok(score(&[&[round as f64]])) } else { absent }
        });
        let rounds = outcomes[0].1.as_ref().map(|score| score.rounds.len());
        assert_eq!((rounds, outcomes[1].1.is_err()), (Ok(3), true));
        assert_eq!(calls.len(), 4);
    }

    #[test]
    fn two_rounds_meet_in_the_middle() {
        assert_eq!(score(&[&[4.0], &[2.0]]).median(), 3.0);
        assert_eq!(score(&[&[7.0]]).median(), 7.0);
    }
}
