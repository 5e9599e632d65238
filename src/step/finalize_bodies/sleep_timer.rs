//! Time that each body has been at rest.
//!
//! A body is at rest within a window of time under two conditions. No point of it drifts farther than a limit
//! from its position at the start of the window. Its smoothed path is no longer than that limit. Speed alone
//! is the wrong measure: a trembling body in a pile is faster than most visible motions, and stays in its
//! place. Drift alone is wrong too: a low bounce or a short spring stays within the limit at any speed, and
//! would freeze, even in mid-air.

use crate::dim::math::{Real, ang_length_squared};
use crate::model::body::{RestPose, RigidBody};
use crate::model::params::IntegrationParameters;

/// The longest window (s) over which drift is measured. The limits grow with it, and something that swings to
/// and fro would be allowed a larger amplitude; a short one counts trembling as motion. In 0.25 s, and with
/// the default threshold, a point may get 12 mm far.
const WINDOW_MAX: Real = 0.25;

/// Largest drift of a body at rest within a window, and largest length of its smoothed path.
struct Limits {
    /// Duration of the window (s).
    window: Real,
    /// Largest displacement of a point (length units).
    distance: Real,
    /// Largest rotation in any direction (rad).
    angle: Real,
}

impl Limits {
    /// The limits of a body; `None` if it never sleeps, which a negative threshold means.
    fn of(body: &RigidBody, params: &IntegrationParameters) -> Option<Self> {
        let activation = &body.activation;
        let (linear, angular) =
            (activation.normalized_linear_threshold, activation.angular_threshold);
        let window = activation.time_until_sleep.min(WINDOW_MAX).max(params.dt);
        let [distance, angle] = [linear * params.length_unit * window, angular * window];
        (linear >= 0.0 && angular >= 0.0).then_some(Self { window, distance, angle })
    }

    /// Returns whether the body kept the limits in a step in which its points moved by at most `motion`.
    ///
    /// The single step is checked first: a body that turns by whole turns from step to step would seem not to
    /// turn.
    fn are_kept(&self, body: &mut RigidBody, motion: Real, dt: Real) -> bool {
        let step_angle = ang_length_squared(body.vels.angvel) * (dt * dt);
        if motion > self.distance || step_angle > self.angle * self.angle {
            return false;
        }
        if body.activation.time_since_can_sleep == 0.0 {
            return true;
        }
        let mut rest = body.rest;
        rest.extend_path(body, dt);
        body.rest = rest;
        [rest.path, rest.drift(body)]
            .iter()
            .all(|motion| motion.distance <= self.distance && motion.angle <= self.angle)
    }
}

/// Updates the sleep timer of a body whose points moved by at most `motion` in this step. Returns whether the
/// body may sleep.
pub(super) fn update_sleep_timer(
    body: &mut RigidBody,
    motion: Real,
    params: &IntegrationParameters,
) -> bool {
    let rests = if body.body_type.is_kinematic() {
        body.activation.normalized_linear_threshold >= 0.0
            && body.vels.linvel.length_squared() == 0.0
            && ang_length_squared(body.vels.angvel) == 0.0
    } else {
        Limits::of(body, params).is_some_and(|limits| {
            let rests = limits.are_kept(body, motion, params.dt);
            if rests {
                continue_window(body, limits.window, params.dt);
            }
            rests
        })
    };
    let activation = &mut body.activation;
    activation.time_since_can_sleep =
        if rests { activation.time_since_can_sleep + params.dt } else { 0.0 };
    rests && activation.is_eligible_for_sleep()
}

/// Begins a new window when the body comes to rest, and whenever one is over. A body that is ready to sleep
/// before its island may therefore drift slowly for any time.
fn continue_window(body: &mut RigidBody, window: Real, dt: Real) {
    if body.activation.time_since_can_sleep == 0.0 || body.rest.age >= window {
        body.rest = RestPose::of(body);
    }
    body.rest.age += dt;
}
