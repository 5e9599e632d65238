//! Bounds that a scene keeps.

use super::scene::Scene;
use crate::rapier::prelude::*;
use gallery::SceneRun;

/// Bounds of the dynamic bodies of a scene, at the end of its steps and after three times as many: a stack
/// stands for good. [`Law::NONE`] has no bound.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Law {
    /// Deepest overlap of two colliders (length units).
    pub overlap_max: f64,
    /// Lowest height of the middle of a body: nothing falls through the ground.
    pub height_min: f64,
    /// Largest loss of height of the highest body since the start: the stack stands.
    pub top_loss_max: f64,
    /// Largest horizontal distance from the origin: nothing leaves.
    pub reach_max: f64,
    /// Largest speed: everything is at rest.
    pub speed_max: f64,
    /// Largest distance of two points that a joint holds together.
    pub gap_max: f64,
}

impl Law {
    /// A law without bounds.
    pub const NONE: Self = Self {
        overlap_max: f64::INFINITY,
        height_min: f64::NEG_INFINITY,
        top_loss_max: f64::INFINITY,
        reach_max: f64::INFINITY,
        speed_max: f64::INFINITY,
        gap_max: f64::INFINITY,
    };

    /// Checks a scene against its start.
    ///
    /// # Errors
    /// A value is beyond its bound, or is NaN; the text names both.
    pub fn check(&self, start: &Scene, scene: &Scene) -> Result<(), String> {
        let within = |name: &str, value: f64, bound: f64| {
            if value <= bound { Ok(()) } else { Err(format!("{name} {value} is beyond {bound}")) }
        };
        within("the overlap", scene.stats().penetration, self.overlap_max)?;
        within("the gap of a joint", gap(&scene.world), self.gap_max)?;
        for (_, body) in scene.world.bodies.iter().filter(|(_, body)| body.is_dynamic()) {
            let place = body.translation();
            within("the depth", -f64::from(place.y), -self.height_min)?;
            let level = place - Vector::Y * place.y;
            within("the reach", f64::from(level.length()), self.reach_max)?;
            within("the speed", f64::from(body.linvel().length()), self.speed_max)?;
        }
        // Without a body there is no top.
        let loss = top(start).zip(top(scene)).map_or(0.0, |(before, now)| before - now);
        within("the fall of the top", loss, self.top_loss_max)
    }
}

/// Returns the height of the highest dynamic body.
fn top(scene: &Scene) -> Option<f64> {
    let bodies = scene.world.bodies.iter().filter(|(_, body)| body.is_dynamic());
    bodies.map(|(_, body)| f64::from(body.translation().y)).reduce(f64::max)
}

/// The largest distance of two points that joints hold together, of joints that lock at least two
/// translations.
pub fn gap(world: &PhysicsWorld) -> f64 {
    let mut largest: Real = 0.0;
    for (_, joint) in world.impulse_joints.iter() {
        let locked = joint.data.locked_axes & JointAxesMask::LIN_AXES;
        if !joint.data.is_enabled() || locked.bits().count_ones() < 2 {
            continue;
        }
        let [body1, body2] = [joint.body1(), joint.body2()].map(|body| &world.bodies[body]);
        let frame = *body1.position() * joint.data.local_frame1;
        let place = *body2.position() * joint.data.local_anchor2();
        let seen = frame.inverse() * place;
        for (axis, direction) in Vector::AXES.into_iter().enumerate() {
            if locked.bits() >> axis & 1 == 1 {
                largest = largest.max(seen.dot(direction).abs());
            }
        }
    }
    f64::from(largest)
}
