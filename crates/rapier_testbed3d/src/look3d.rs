//! The view of a testbed in 3D.

use crate::Testbed;
use crate::camera::{OrbitCamera, STEEPEST};
use drawing::Point;
use drawing::vector::{dot, sub};

impl Testbed {
    /// Looks from a point to another one.
    pub fn look_at(&mut self, eye: impl Into<Point>, target: impl Into<Point>) {
        self.camera = Some(OrbitCamera::looking(eye.into(), target.into()));
    }
}

impl OrbitCamera {
    /// The camera that looks from one point to another.
    fn looking(eye: Point, target: Point) -> Self {
        let offset = sub(eye, target);
        let distance = dot(offset, offset).sqrt().max(1.0e-3);
        let yaw = offset[0].atan2(offset[2]).to_degrees();
        let pitch = (offset[1] / distance).clamp(-1.0, 1.0).asin().to_degrees();
        Self { target, distance, yaw, pitch: pitch.clamp(-STEEPEST, STEEPEST) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looking_keeps_the_eye() {
        let camera = OrbitCamera::looking([3.0, 4.0, -5.0], [1.0, 1.0, 1.0]);
        let eye = camera.eye();
        assert!(sub(eye, [3.0, 4.0, -5.0]).iter().all(|c| c.abs() < 1.0e-4), "{eye:?}");
    }
}
