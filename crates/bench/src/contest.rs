//! One scene, several engines, by turns.

use crate::args::Options;
use crate::catalog::Scene;
use crate::clock::Clock;
use crate::engine::{Kind, Stats, Template, Unsupported};
use crate::memory::live_bytes;
use gallery::Progress;

/// What became of one scene with one number of threads.
pub struct Contest {
    /// `3d/large_pyramid`
    pub scene: String,
    /// Bodies that move by themselves.
    pub dynamic_bodies: usize,
    /// Number of threads.
    pub threads: usize,
    /// One for each engine, in the order they took turns.
    pub results: Vec<(Kind, Result<Score, Unsupported>)>,
}

/// What an engine has achieved.
pub struct Score {
    /// How long each step but the first took (ms), for each round.
    pub rounds: Vec<Vec<f64>>,
    /// How long it took to make the world and to take the first step (ms), for each round: some engines do at once what others do then.
    pub setups: Vec<f64>,
    /// The world after the last round.
    pub stats: Stats,
    /// Bytes that the world held at the end.
    pub bytes: usize,
}

impl Score {
    /// Mean over the steps (ms) of the median over the rounds.
    ///
    /// A step does the same work in every round, so what disturbs one step of one round is ignored.
    pub fn median(&self) -> f64 {
        self.mean_of_steps(|sorted| {
            let middle = sorted.len() / 2;
            if sorted.len() % 2 == 1 {
                sorted[middle]
            } else {
                0.5 * (sorted[middle - 1] + sorted[middle])
            }
        })
    }

    /// Mean over the steps (ms) of the fastest round: the least disturbed that this machine has to offer.
    pub fn best(&self) -> f64 {
        self.mean_of_steps(|sorted| sorted[0])
    }

    /// The fastest of all rounds to make the world and take the first step (ms).
    pub fn setup(&self) -> f64 {
        self.setups.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Mean over the steps of what `choose` makes of the step's sorted durations in all rounds.
    fn mean_of_steps(&self, choose: impl Fn(&[f64]) -> f64) -> f64 {
        let steps = self.rounds[0].len();
        let chosen = (0..steps).map(|step| {
            let mut durations: Vec<f64> = self.rounds.iter().map(|round| round[step]).collect();
            durations.sort_by(f64::total_cmp);
            choose(&durations)
        });
        chosen.sum::<f64>() / steps as f64
    }
}

impl Contest {
    /// The score of this engine, if it took part.
    pub fn ours(&self) -> Option<&Score> {
        self.results.iter().find(|(kind, _)| *kind == Kind::This)?.1.as_ref().ok()
    }
}

/// Lets the engines take turns.
pub fn run(scene: &Scene, threads: usize, options: &Options) -> Contest {
    let template = (scene.build)();
    // The first step belongs to the making of the world.
    let steps = options.steps.unwrap_or(scene.steps).max(2);
    let mut results: Vec<(Kind, Result<Score, Unsupported>)> = Vec::new();
    for round in 0..options.rounds {
        for (position, &kind) in options.engines.iter().enumerate() {
            let label = format!(
                "{}, {threads} thread(s), round {} of {}, {}",
                scene.title(),
                round + 1,
                options.rounds,
                scene.engine_name(kind)
            );
            match results.get_mut(position) {
                None => results.push((kind, play(&*template, kind, threads, steps, &label))),
                Some((_, Ok(so_far))) => {
                    if let Ok(score) = play(&*template, kind, threads, steps, &label) {
                        so_far.rounds.extend(score.rounds);
                        so_far.setups.extend(score.setups);
                        so_far.stats = score.stats;
                        so_far.bytes = score.bytes;
                    }
                }
                Some((_, Err(_))) => {}
            }
        }
    }
    let dynamic_bodies = template.dynamic_bodies();
    Contest { scene: scene.title(), dynamic_bodies, threads, results }
}

/// One round of one engine.
fn play(
    template: &dyn Template,
    kind: Kind,
    threads: usize,
    steps: usize,
    label: &str,
) -> Result<Score, Unsupported> {
    let mut progress = Progress::new(label, label.len(), steps);
    let mut durations = Vec::with_capacity(steps);
    let bytes_before = live_bytes();
    let clock = Clock::start(threads);
    let mut engine = template.start(kind, threads)?;
    engine.step();
    let setup = clock.milliseconds();
    for done in 2..=steps {
        let clock = Clock::start(threads);
        engine.step();
        durations.push(clock.milliseconds());
        progress.advance(done);
    }
    progress.clear();
    let bytes = live_bytes().saturating_sub(bytes_before) + engine.foreign_bytes();
    let (rounds, setups) = (vec![durations], vec![setup]);
    Ok(Score { rounds, setups, stats: engine.stats(), bytes })
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
    fn two_rounds_meet_in_the_middle() {
        assert_eq!(score(&[&[4.0], &[2.0]]).median(), 3.0);
        assert_eq!(score(&[&[7.0]]).median(), 7.0);
    }
}
