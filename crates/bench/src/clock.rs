//! Clocks for the time of a step.
//!
//! With one thread, the clock measures the processor time of the process, so that other programs of a busy
//! machine do not count. This time includes all threads, so hidden threads count as well. With several
//! threads, the clock measures wall time, because parallel work shortens only that.

use std::time::{Duration, Instant};

/// Running measurement.
pub enum Clock {
    /// Wall time.
    Wall(Instant),
    /// Processor time.
    #[cfg(unix)]
    Processor(Duration),
}

impl Clock {
    /// Starts the clock for work on this number of threads.
    pub fn start(threads: usize) -> Self {
        if threads == 1 { Self::start_processor() } else { Self::start_wall(threads) }
    }

    /// Starts a clock of wall time, for any number of threads.
    pub fn start_wall(_: usize) -> Self {
        Clock::Wall(Instant::now())
    }

    /// Starts a clock of the processor time of all threads, or of wall time on systems without it.
    pub fn start_processor() -> Self {
        #[cfg(unix)]
        return Clock::Processor(processor_time());
        #[cfg(not(unix))]
        Clock::Wall(Instant::now())
    }

    /// Returns the time since the start (ms).
    pub fn milliseconds(&self) -> f64 {
        let elapsed = match self {
            Clock::Wall(start) => start.elapsed(),
            #[cfg(unix)]
            Clock::Processor(start) => processor_time().saturating_sub(*start),
        };
        elapsed.as_secs_f64() * 1e3
    }
}

/// Returns the processor time of all threads of the program.
#[cfg(unix)]
fn processor_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
    Duration::new(seconds, u32::try_from(time.tv_nsec).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::Clock;
    use std::time::Duration;

    #[test]
    fn wall_time_includes_sleep() {
        let clock = Clock::start(2);
        std::thread::sleep(Duration::from_millis(20));
        assert!(clock.milliseconds() >= 20.0);
    }

    #[test]
    fn processor_time_includes_work() {
        let clock = Clock::start(1);
        let mut sum = 0u64;
        while clock.milliseconds() < 5.0 {
            sum = std::hint::black_box(sum.wrapping_mul(3) + 1);
        }
        assert!(clock.milliseconds() < 10_000.0);
    }
}
