//! When a body may fall asleep, and whether it does.
//!
//! A body is a candidate for sleep while it moves slower than both thresholds. Once every body of an
//! island has been a candidate for long enough, the whole island sleeps and costs nothing.

use crate::dim::math::Real;

/// Whether a body sleeps, and how calm it must be to fall asleep.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct RigidBodyActivation {
    /// Linear speed below which the body may fall asleep, as a multiple of
    /// `IntegrationParameters::length_unit` per second. Negative: never.
    pub normalized_linear_threshold: Real,
    /// Angular speed below which the body may fall asleep (rad/s). Negative: never.
    pub angular_threshold: Real,
    /// How long the body must stay below both thresholds before it may sleep (seconds).
    pub time_until_sleep: Real,
    /// How long the body has been below both thresholds (seconds).
    pub time_since_can_sleep: Real,
    /// Does the body sleep?
    pub sleeping: bool,
}

impl Default for RigidBodyActivation {
    fn default() -> Self {
        Self::active()
    }
}

impl RigidBodyActivation {
    /// The default of [`Self::normalized_linear_threshold`]: 0.4 length units per second.
    pub const fn default_normalized_linear_threshold() -> Real {
        0.4
    }

    /// The default of [`Self::angular_threshold`]: 0.5 rad/s.
    pub const fn default_angular_threshold() -> Real {
        0.5
    }

    /// The default of [`Self::time_until_sleep`]: half a second.
    ///
    /// It has to outlast whatever is slow for a moment only. A body thrown upwards is slower than
    /// 0.4 m/s for 0.08 s around the top of its flight (with a gravity of 9.81 m/s²), a rocking box at
    /// each turning point for about as long: half a second is several times that, and still short
    /// enough for piles to cost nothing soon after they settled. Box2D has settled on it, too.
    pub const fn default_time_until_sleep() -> Real {
        0.5
    }

    /// An awake body that may fall asleep.
    pub const fn active() -> Self {
        Self {
            normalized_linear_threshold: Self::default_normalized_linear_threshold(),
            angular_threshold: Self::default_angular_threshold(),
            time_until_sleep: Self::default_time_until_sleep(),
            time_since_can_sleep: 0.0,
            sleeping: false,
        }
    }

    /// A sleeping body.
    pub const fn inactive() -> Self {
        Self {
            time_since_can_sleep: Self::default_time_until_sleep(),
            sleeping: true,
            ..Self::active()
        }
    }

    /// An awake body that never falls asleep by itself.
    pub const fn cannot_sleep() -> Self {
        Self { normalized_linear_threshold: -1.0, angular_threshold: -1.0, ..Self::active() }
    }

    /// Is the body awake?
    pub const fn is_active(&self) -> bool {
        !self.sleeping
    }

    /// Has the body been calm for long enough to sleep?
    pub fn is_eligible_for_sleep(&self) -> bool {
        self.time_since_can_sleep >= self.time_until_sleep
    }

    /// Wakes the body. A `strong` wake-up also starts the time until it may sleep afresh.
    pub const fn wake_up(&mut self, strong: bool) {
        self.sleeping = false;
        if strong {
            self.time_since_can_sleep = 0.0;
        }
    }

    /// Puts the body to sleep.
    pub const fn sleep(&mut self) {
        self.sleeping = true;
        self.time_since_can_sleep = self.time_until_sleep;
    }
}
