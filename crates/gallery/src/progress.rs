//! Progress line of a scene. A terminal redraws it in place; other outputs (a file, a build log) get nothing
//! until the scene is done.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// Shortest time between two redraws, so that drawing takes negligible time.
const REDRAW_INTERVAL: Duration = Duration::from_millis(50);
/// Cells of the bar.
const BAR_WIDTH: usize = 28;
/// Left edge to full, in eighths of a cell.
const EIGHTHS: [&str; 8] = ["", "▏", "▎", "▍", "▌", "▋", "▊", "▉"];

/// The progress of one scene.
pub struct Progress<'a> {
    label: &'a str,
    /// Width of all labels in columns, so that the bars are aligned.
    label_width: usize,
    steps: usize,
    started: Instant,
    /// Time of the last redraw; `None` without a terminal.
    drawn: Option<Instant>,
}

impl<'a> Progress<'a> {
    /// Progress over `steps` steps of the scene called `label`.
    pub fn new(label: &'a str, label_width: usize, steps: usize) -> Self {
        let started = Instant::now();
        let drawn = io::stderr().is_terminal().then_some(started);
        Self { label, label_width, steps, started, drawn }
    }

    /// Shows that `done` steps are complete.
    pub fn advance(&mut self, done: usize) {
        let Some(drawn) = self.drawn else { return };
        if drawn.elapsed() < REDRAW_INTERVAL {
            return;
        }
        self.drawn = Some(Instant::now());
        let line = format!(
            "\r  {:width$}  {}  {done}/{} steps, {} left\x1b[K",
            self.label,
            bar(done, self.steps),
            self.steps,
            seconds(self.time_left(done)),
            width = self.label_width,
        );
        // A failure to draw the bar does not stop the run.
        let _ = io::stderr().write_all(line.as_bytes());
    }

    /// Clears the bar, if there is one.
    pub fn clear(&self) {
        if self.drawn.is_some() {
            let _ = io::stderr().write_all(b"\r\x1b[K");
        }
    }

    fn time_left(&self, done: usize) -> Duration {
        let per_step = self.started.elapsed().as_secs_f64() / done.max(1) as f64;
        Duration::from_secs_f64(per_step * self.steps.saturating_sub(done) as f64)
    }
}

/// A bar of fixed width, filled in proportion to `done / total`.
fn bar(done: usize, total: usize) -> String {
    let eighths = BAR_WIDTH * 8 * done.min(total) / total.max(1);
    let mut bar = "█".repeat(eighths / 8);
    bar.push_str(EIGHTHS[eighths % 8]);
    let cells = bar.chars().count();
    bar.push_str(&"·".repeat(BAR_WIDTH - cells));
    bar
}

/// Formats a duration.
pub(crate) fn seconds(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    match seconds {
        s if s < 10.0 => format!("{s:.1} s"),
        s if s < 100.0 => format!("{s:.0} s"),
        s => format!("{} min {:02} s", s as u64 / 60, s as u64 % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bar_keeps_its_width() {
        for done in 0..=37 {
            assert_eq!(bar(done, 37).chars().count(), BAR_WIDTH, "at {done} of 37");
        }
        assert_eq!(bar(0, 5), "·".repeat(BAR_WIDTH));
        assert_eq!(bar(5, 5), "█".repeat(BAR_WIDTH));
    }

    #[test]
    fn durations_have_suitable_units() {
        assert_eq!(seconds(Duration::from_millis(1240)), "1.2 s");
        assert_eq!(seconds(Duration::from_secs(61)), "61 s");
        assert_eq!(seconds(Duration::from_secs(125)), "2 min 05 s");
    }
}
