//! Means, and readable numbers.

/// Returns the median of sorted numbers: for an even count, the mean of the two in the middle.
pub fn middle(sorted: &[f64]) -> f64 {
    let middle = sorted.len() / 2;
    if sorted.len() % 2 == 1 { sorted[middle] } else { 0.5 * (sorted[middle - 1] + sorted[middle]) }
}

/// Returns the mean over the steps of `choose`, applied to the step's sorted durations in all rounds.
pub fn mean_of_steps(rounds: &[Vec<f64>], choose: impl Fn(&[f64]) -> f64) -> f64 {
    let steps = rounds[0].len();
    let chosen = (0..steps).map(|step| {
        let mut durations: Vec<f64> = rounds.iter().map(|round| round[step]).collect();
        durations.sort_by(f64::total_cmp);
        choose(&durations)
    });
    chosen.sum::<f64>() / steps as f64
}

/// Returns the geometric mean of ratios: twice and half give one. `None` without ratios.
pub fn geometric_mean(ratios: &[f64]) -> Option<f64> {
    let logarithms = ratios.iter().map(|ratio| ratio.ln()).sum::<f64>();
    (!ratios.is_empty()).then(|| (logarithms / ratios.len() as f64).exp())
}

/// Formats a number with its noun: `1 thread`, `2 threads`.
pub fn counted(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twice_and_half_make_one() {
        let mean = geometric_mean(&[2.0, 0.5]).unwrap();
        assert!((mean - 1.0).abs() < 1e-12, "{mean}");
        let mean = geometric_mean(&[1.0, 8.0, 27.0]).unwrap();
        assert!((mean - 6.0).abs() < 1e-12, "{mean}");
        assert_eq!(geometric_mean(&[]), None);
    }

    #[test]
    fn one_is_singular() {
        assert_eq!(
            (counted(1, "thread"), counted(2, "thread")),
            ("1 thread".into(), "2 threads".into())
        );
    }
}
