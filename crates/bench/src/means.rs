//! Summary of a run of contests: the geometric mean over the scenes, for each dimension and number of
//! threads.

use crate::contest::Contest;
use crate::engine::Kind;
use crate::units::{counted, geometric_mean};

/// Target upper bound of time in double precision divided by time in single precision: twice the bytes, and
/// half as many numbers in a register.
const DOUBLE_TIME_RATIO_MAX: f64 = 2.2;

/// Geometric mean of a ratio over all scenes of one dimension with one number of threads.
struct Mean<'c> {
    dimension: &'c str,
    threads: usize,
    ratios: Vec<(&'c Contest, f64)>,
}

/// Returns a sentence for each mean: first the means to the fastest peer, then those of double precision.
pub fn lines(contests: &[Contest]) -> Vec<String> {
    let mut lines: Vec<String> =
        means(contests, ratio_to_fastest).iter().filter_map(line_of_peers).collect();
    lines.extend(means(contests, ratio_of_double).iter().filter_map(line_of_double));
    lines
}

/// Returns the fastest peer's time divided by this engine's: above 1 this engine is faster.
pub fn ratio_to_fastest(contest: &Contest) -> Option<f64> {
    Some(contest.fastest_peer()?.1 / contest.ours()?.median())
}

/// Returns the time in double precision divided by that in single precision.
fn ratio_of_double(contest: &Contest) -> Option<f64> {
    Some(contest.score(Kind::Double)?.median() / contest.ours()?.median())
}

/// Returns the means of a ratio, in the order of their first contests.
fn means(contests: &[Contest], ratio: fn(&Contest) -> Option<f64>) -> Vec<Mean<'_>> {
    let mut means: Vec<Mean<'_>> = Vec::new();
    for contest in contests {
        let Some(ratio) = ratio(contest) else { continue };
        let (dimension, threads) = (contest.dimension(), contest.threads);
        let place = means.iter().position(|m| (m.dimension, m.threads) == (dimension, threads));
        match place {
            Some(place) => means[place].ratios.push((contest, ratio)),
            None => means.push(Mean { dimension, threads, ratios: vec![(contest, ratio)] }),
        }
    }
    means
}

impl Mean<'_> {
    fn value(&self) -> Option<f64> {
        let ratios: Vec<f64> = self.ratios.iter().map(|(_, ratio)| *ratio).collect();
        geometric_mean(&ratios)
    }

    /// Formats the title: `3D, 1 thread, 23 scenes`.
    fn title(&self) -> String {
        let [threads, scenes] =
            [counted(self.threads, "thread"), counted(self.ratios.len(), "scene")];
        format!("{}, {threads}, {scenes}", self.dimension.to_uppercase())
    }
}

fn line_of_peers(mean: &Mean<'_>) -> Option<String> {
    let ahead =
        mean.ratios.iter().filter(|(_, ratio)| *ratio < 1.0).filter_map(|(contest, ratio)| {
            let peer = contest.engine_name(contest.fastest_peer()?.0);
            Some(format!("{} ({ratio:.2}, {peer})", contest.name()))
        });
    let ahead: Vec<String> = ahead.collect();
    let ahead = match ahead.as_slice() {
        [] => "a peer is ahead in none".to_owned(),
        scenes => format!("a peer is ahead in {}: {}", scenes.len(), scenes.join(", ")),
    };
    Some(format!(
        "{}: geometric mean of fastest peer / this engine {:.2}; {ahead}",
        mean.title(),
        mean.value()?
    ))
}

fn line_of_double(mean: &Mean<'_>) -> Option<String> {
    let more = mean.ratios.iter().filter(|(_, ratio)| *ratio > DOUBLE_TIME_RATIO_MAX);
    let more: Vec<String> =
        more.map(|(contest, ratio)| format!("{} ({ratio:.2})", contest.name())).collect();
    let more = match more.as_slice() {
        [] => String::new(),
        scenes => format!("; more in {}: {}", scenes.len(), scenes.join(", ")),
    };
    Some(format!(
        "{}: geometric mean of f64 / f32 {:.2}, expected at most {DOUBLE_TIME_RATIO_MAX}{more}",
        mean.title(),
        mean.value()?
    ))
}

#[cfg(test)]
mod tests {
    use super::lines;
    use crate::contest::{Contest, Score};
    use crate::engine::{Kind, Stats, Unsupported};

    fn contest(scene: &str, times: [f64; 4]) -> Contest {
        let score = |ms: f64| Score {
            rounds: vec![vec![ms]],
            setups: vec![1.0],
            stats: Stats::default(),
            bytes: 0,
        };
        let outcome =
            |ms: f64| if ms > 0.0 { Ok(score(ms)) } else { Err(Unsupported("absent".into())) };
        let outcomes = Kind::ALL.into_iter().zip(times.map(outcome)).collect();
        Contest { scene: scene.into(), dynamic_bodies: 1, threads: 1, outcomes }
    }

    #[test]
    fn the_fastest_peer_counts() {
        let contests = [
            contest("3d/a", [1.0, 4.0, 2.0, 1.0]),
            contest("3d/b", [1.0, 0.5, 0.0, 4.0]),
            contest("2d/a", [2.0, 0.0, 6.0, 0.0]),
            // No peer took part.
            contest("2d/b", [2.0, 0.0, 0.0, 0.0]),
        ];
        assert_eq!(
            lines(&contests),
            [
                "3D, 1 thread, 2 scenes: geometric mean of fastest peer / this engine 1.00; \
                 a peer is ahead in 1: b (0.50, Rapier 0.36.1)",
                "2D, 1 thread, 1 scene: geometric mean of fastest peer / this engine 3.00; \
                 a peer is ahead in none",
                "3D, 1 thread, 2 scenes: geometric mean of f64 / f32 2.00, expected at most 2.2; \
                 more in 1: b (4.00)",
            ]
        );
    }
}
