//! What the time of a step is measured with.
//!
//! With one thread it is the time that the program spent on a processor, so that the other programs of
//! a busy machine take nothing from anyone; it counts all threads, so that none can work unseen. With
//! several threads it is the time on the wall, because work shared out is the point.

use std::time::{Duration, Instant};

/// A running measurement.
pub enum Clock {
    /// Time on the wall.
    Wall(Instant),
    /// Time on a processor.
    #[cfg(unix)]
    Processor(Duration),
}

impl Clock {
    /// Starts measuring what is done with this number of threads.
    pub fn start(threads: usize) -> Self {
        if threads == 1 { Self::start_processor() } else { Self::start_wall(threads) }
    }

    /// Starts measuring the time on the wall, whatever the number of threads.
    pub fn start_wall(_: usize) -> Self {
        Clock::Wall(Instant::now())
    }

    /// Starts measuring the time that all threads spend on processors, or that on the wall where the system does not tell.
    pub fn start_processor() -> Self {
        #[cfg(unix)]
        return Clock::Processor(processor_time());
        #[cfg(not(unix))]
        Clock::Wall(Instant::now())
    }

    /// Time since the start (ms).
    pub fn milliseconds(&self) -> f64 {
        let elapsed = match self {
            Clock::Wall(start) => start.elapsed(),
            #[cfg(unix)]
            Clock::Processor(start) => processor_time().saturating_sub(*start),
        };
        elapsed.as_secs_f64() * 1e3
    }
}

/// Time that all threads of the program have spent on processors.
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
    fn the_wall_clock_sees_sleep() {
        let clock = Clock::start(2);
        std::thread::sleep(Duration::from_millis(20));
        assert!(clock.milliseconds() >= 20.0);
    }

    #[test]
    fn the_processor_clock_sees_work() {
        let clock = Clock::start(1);
        let mut sum = 0u64;
        while clock.milliseconds() < 5.0 {
            sum = std::hint::black_box(sum.wrapping_mul(3) + 1);
        }
        assert!(clock.milliseconds() < 10_000.0);
    }
}
