//! Comparison of the engines' work: bodies, awake bodies, steps, substeps and contacts. An engine with less
//! work would be faster without merit.

use crate::contest::{Contest, Score};
use crate::engine::Kind;
use crate::units::counted;
use gallery::grouped;

/// Contact counts that differ by more than this fraction, and by more than [`DIFFERENCE_MIN`], get a note.
/// Smaller differences come from each engine's way of counting.
const RELATIVE_DIFFERENCE_MAX: f64 = 0.3;

/// Differences of contact counts up to this number get no note: so few contacts mean nothing.
const DIFFERENCE_MIN: usize = 20;

/// Returns the notes on the engines' work.
pub fn notes(contests: &[Contest]) -> Vec<String> {
    let mut notes = Vec::new();
    let (mut compared, mut same) = (0, 0);
    for contest in contests {
        let mut scores = contest.scores();
        let Some((first, reference)) = scores.next() else { continue };
        let mut equal = true;
        let mut others = 0;
        for (kind, score) in scores {
            others += 1;
            let wrong = differences(contest, (first, reference), (kind, score));
            equal &= wrong.is_empty();
            notes.extend(wrong);
            notes.extend(contacts(contest, (first, reference), (kind, score)));
        }
        compared += usize::from(others > 0);
        same += usize::from(others > 0 && equal);
    }
    if compared > 0 {
        let all = format!(
            "Equal work: in {same} of {compared} contests all engines had the same bodies, as many of them awake, steps and substeps."
        );
        notes.insert(0, all);
    }
    notes
}

/// Returns the counts that must be equal and differ.
fn differences(
    contest: &Contest,
    (first, reference): (Kind, &Score),
    (kind, score): (Kind, &Score),
) -> Vec<String> {
    let numbers = |score: &Score| {
        let counts = &score.stats.counts;
        [
            ("bodies", counts.bodies),
            ("awake bodies", counts.awake),
            ("steps", score.steps()),
            ("substeps", counts.substeps),
        ]
    };
    let pairs = numbers(score).into_iter().zip(numbers(reference));
    let wrong = pairs.filter(|((_, number), (_, other))| number != other);
    let line = |((noun, number), (_, other)): ((&str, usize), (&str, usize))| {
        format!(
            "NOT EQUAL: {}: {} has {} {noun}, {} {}",
            title(contest),
            contest.engine_name(kind),
            grouped(number),
            contest.engine_name(first),
            grouped(other),
        )
    };
    wrong.map(line).collect()
}

/// Returns contact counts that are much smaller or larger than those of the first engine.
fn contacts(
    contest: &Contest,
    (first, reference): (Kind, &Score),
    (kind, score): (Kind, &Score),
) -> Vec<String> {
    let (counts, others) = (&score.stats.counts, &reference.stats.counts);
    let numbers = [
        ("touching pairs", counts.pairs, others.pairs),
        ("contact points", counts.points, others.points),
    ];
    let differing = numbers.into_iter().filter(|&(_, number, other)| {
        let difference = number.abs_diff(other);
        difference > DIFFERENCE_MIN && difference as f64 > RELATIVE_DIFFERENCE_MAX * other as f64
    });
    let line = |(noun, number, other): (&str, usize, usize)| {
        let percentage = if other > 0 {
            format!(" ({:+.0} %)", (number as f64 / other as f64 - 1.0) * 100.0)
        } else {
            String::new()
        };
        format!(
            "Contacts differ: {}: {} has {} {noun}{percentage}, {} {}",
            title(contest),
            contest.engine_name(kind),
            grouped(number),
            contest.engine_name(first),
            grouped(other),
        )
    };
    differing.map(line).collect()
}

/// `3d/tower, 2 threads`
fn title(contest: &Contest) -> String {
    format!("{}, {}", contest.scene, counted(contest.threads, "thread"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{Counts, Stats};

    fn contest(ours: Counts, theirs: Counts, their_steps: usize) -> Contest {
        let score = |counts: Counts, steps: usize| Score {
            rounds: vec![vec![1.0; steps - 1]],
            setups: vec![1.0],
            stats: Stats { counts, ..Stats::default() },
            bytes: 0,
        };
        Contest {
            scene: "3d/tower".into(),
            dynamic_bodies: 30,
            threads: 1,
            outcomes: vec![
                (Kind::This, Ok(score(ours, 10))),
                (Kind::Box, Ok(score(theirs, their_steps))),
            ],
        }
    }

    const COUNTS: Counts = Counts { bodies: 31, awake: 30, substeps: 4, pairs: 100, points: 400 };

    #[test]
    fn equal_work_gives_one_note() {
        let contests = [contest(COUNTS, COUNTS, 10), contest(COUNTS, COUNTS, 10)];
        let notes = notes(&contests);
        assert_eq!(notes.len(), 1, "{notes:?}");
        assert!(notes[0].contains("in 2 of 2 contests"), "{notes:?}");
    }

    #[test]
    fn less_work_gives_notes() {
        let fewer = Counts { bodies: 30, awake: 29, substeps: 2, ..COUNTS };
        let notes = notes(&[contest(COUNTS, fewer, 9)]);
        assert_eq!(notes.len(), 5, "{notes:?}");
        assert!(notes[0].contains("in 0 of 1 contests"), "{notes:?}");
        assert_eq!(notes[1], "NOT EQUAL: 3d/tower, 1 thread: Box3D has 30 bodies, this engine 31");
    }

    #[test]
    fn large_differences_of_contacts_give_notes() {
        let near = Counts { pairs: 81, points: 500, ..COUNTS };
        assert_eq!(notes(&[contest(COUNTS, near, 10)]).len(), 1);
        let differing = Counts { points: 200, ..COUNTS };
        let notes = notes(&[contest(COUNTS, differing, 10)]);
        let line = "Contacts differ: 3d/tower, 1 thread: Box3D has 200 contact points (-50 %), this engine 400";
        assert_eq!(notes[1..], [line]);
    }
}
