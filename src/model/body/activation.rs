//! Sleep state of a body, and the thresholds of sleep.
//!
//! A body is a candidate for sleep while it does not drift. In each window of time, the displacement of every
//! point and the length of its path must stay below the threshold. Once every body of an island has been a
//! candidate for long enough, the whole island falls asleep, and no per-step loop visits its bodies.

use crate::dim::math::Real;

/// Whether a body sleeps, and its thresholds for sleep.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct RigidBodyActivation {
    /// Mean speed below which every point of the body must stay for the body to fall asleep, as a multiple of
    /// `IntegrationParameters::length_unit` per second. Negative: never.
    ///
    /// The mean is taken over windows of a quarter of a second for [`Self::time_until_sleep`]. In a window,
    /// two quantities are limited: the displacement of every point and the length of its path. The limit is
    /// the threshold times the length of the window. Rotations count with the size of the body. Velocities
    /// that alternate from step to step cancel, so a trembling body may be faster.
    pub normalized_linear_threshold: Real,
    /// Mean angular speed below which the body must stay to fall asleep (rad/s), independent of its size.
    /// Negative: never.
    pub angular_threshold: Real,
    /// Time below both thresholds after which the body may sleep (seconds).
    pub time_until_sleep: Real,
    /// Time that the body has been below both thresholds (seconds).
    pub time_since_can_sleep: Real,
    /// Whether the body sleeps.
    pub sleeping: bool,
}

impl Default for RigidBodyActivation {
    fn default() -> Self {
        Self::active()
    }
}

impl RigidBodyActivation {
    /// The default of [`Self::normalized_linear_threshold`]: 0.05 length units per second.
    ///
    /// A ball that rolls has no resistance, and its top is twice as fast as its centre. At 0.01, heaps of
    /// balls do not sleep while one ball rolls at 1 cm/s.
    pub const fn default_normalized_linear_threshold() -> Real {
        0.05
    }

    /// The default of [`Self::angular_threshold`]: 0.5 rad/s. It matters for bodies with an extent below a
    /// tenth of a length unit; larger ones reach the linear threshold first.
    pub const fn default_angular_threshold() -> Real {
        0.5
    }

    /// The default of [`Self::time_until_sleep`]: a second.
    ///
    /// It must exceed momentary slow motions. Examples are a body at the top of its flight, a pendulum at its
    /// turning point, and a domino that begins to tip.
    pub const fn default_time_until_sleep() -> Real {
        1.0
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

    /// An awake body that never falls asleep automatically.
    pub const fn cannot_sleep() -> Self {
        Self { normalized_linear_threshold: -1.0, angular_threshold: -1.0, ..Self::active() }
    }

    /// Returns whether the body is awake.
    pub const fn is_active(&self) -> bool {
        !self.sleeping
    }

    /// Returns whether the body has been below both thresholds for long enough to sleep.
    pub fn is_eligible_for_sleep(&self) -> bool {
        self.time_since_can_sleep >= self.time_until_sleep
    }

    /// Wakes the body. A `strong` wake-up also resets [`Self::time_since_can_sleep`].
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
