//! A stopwatch with a total.

use core::time::Duration;

/// A stopwatch: it sums up the durations of one or several stretches.
///
/// `wasm32-unknown-unknown` has no clock: without `Timer::set_clock` all durations are zero there.
#[derive(Copy, Clone, Debug, Default)]
pub struct Timer {
    enabled: bool,
    total: Duration,
    started: Option<Moment>,
}

impl Timer {
    /// A timer that has measured nothing yet; it runs only when `enabled`.
    pub const fn new(enabled: bool) -> Self {
        Self { enabled, total: Duration::ZERO, started: None }
    }

    /// Switches the timer on or off. A timer that is off has no cost and keeps its total.
    pub fn set_enabled(&mut self, enabled: bool) {
        if !enabled {
            self.pause();
        }
        self.enabled = enabled;
    }

    /// Resets the measured time.
    pub fn reset(&mut self) {
        self.total = Duration::ZERO;
        self.started = None;
    }

    /// Starts from zero.
    pub fn start(&mut self) {
        self.reset();
        self.resume();
    }

    /// Continues the measurement.
    pub fn resume(&mut self) {
        if self.enabled {
            self.started = Some(Moment::now());
        }
    }

    /// Stops measuring until the next [`Self::resume`] or [`Self::start`].
    pub fn pause(&mut self) {
        if let Some(started) = self.started.take() {
            self.total += started.elapsed();
        }
    }

    /// Runs `work` and adds the time it took.
    pub fn measure<R>(&mut self, work: impl FnOnce() -> R) -> R {
        self.resume();
        let result = work();
        self.pause();
        result
    }

    /// The measured time, without a running interval.
    pub fn time(&self) -> Duration {
        self.total
    }

    /// The measured time, without a running interval (ms).
    pub fn time_ms(&self) -> f64 {
        self.total.as_secs_f64() * 1000.0
    }
}

#[cfg(not(all(target_arch = "wasm32", target_os = "unknown")))]
use std::time::Instant as Moment;

/// A time of the clock that the program supplied, in milliseconds. [`std::time::Instant`] panics where there
/// is no clock.
#[cfg(all(target_arch = "wasm32", target_os = "unknown"))]
#[derive(Copy, Clone, Debug)]
struct Moment(f64);

/// The clock that the program supplied.
#[cfg(all(target_arch = "wasm32", target_os = "unknown"))]
static CLOCK: std::sync::OnceLock<fn() -> f64> = std::sync::OnceLock::new();

#[cfg(all(target_arch = "wasm32", target_os = "unknown"))]
impl Timer {
    /// Supplies the clock of all timers: a function that returns the time in milliseconds. Only the first
    /// call has an effect.
    pub fn set_clock(clock: fn() -> f64) {
        let _ = CLOCK.set(clock);
    }
}

#[cfg(all(target_arch = "wasm32", target_os = "unknown"))]
impl Moment {
    fn now() -> Self {
        Self(CLOCK.get().map_or(0.0, |clock| clock()))
    }

    fn elapsed(self) -> Duration {
        Duration::from_secs_f64(((Self::now().0 - self.0) / 1000.0).max(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::Timer;
    use core::time::Duration;

    const SLEEP: Duration = Duration::from_millis(2);

    #[test]
    fn stretches_add_up() {
        let mut timer = Timer::new(true);
        let answer = timer.measure(|| {
            std::thread::sleep(SLEEP);
            42
        });
        assert_eq!(answer, 42);
        timer.measure(|| std::thread::sleep(SLEEP));
        assert!(timer.time() >= 2 * SLEEP, "{:?}", timer.time());
        assert!(timer.time_ms() >= 4.0);
        timer.start();
        assert_eq!(timer.time(), Duration::ZERO);
    }

    #[test]
    fn disabled_timer_measures_nothing() {
        let mut timer = Timer::new(false);
        timer.measure(|| std::thread::sleep(SLEEP));
        assert_eq!(timer.time(), Duration::ZERO);
        timer.set_enabled(true);
        timer.measure(|| std::thread::sleep(SLEEP));
        timer.set_enabled(false);
        assert!(timer.time() >= SLEEP);
    }
}
