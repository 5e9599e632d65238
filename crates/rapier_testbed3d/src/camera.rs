//! The camera of the window: orbit, pan, zoom, follow.

use crate::rapier::math::DIM;
use drawing::camera::back;
use drawing::vector::{add_scaled, dot, sub};
use drawing::{Camera, Point, View};

/// Degrees of rotation for a point of motion of the mouse.
const TURN: f32 = 0.35;
/// Steepest angle of sight (degrees).
pub(crate) const STEEPEST: f32 = 89.0;
/// Factor on the distance for a notch of the wheel.
const ZOOM: f32 = 0.0016;

/// A camera that turns about a target.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(crate) struct OrbitCamera {
    pub target: Point,
    /// Distance to the target; half the height of the picture for a flat scene.
    pub distance: f32,
    /// Angles in degrees, as in [`View::orbit`].
    pub yaw: f32,
    pub pitch: f32,
}

impl OrbitCamera {
    /// The camera that frames points with the settings of a view.
    pub(crate) fn framing(view: &View, points: &[Point], aspect: f32) -> Self {
        let fit = Camera::fit(view, points, aspect);
        if fit.flat {
            let target = [fit.eye[0], fit.eye[1], 0.0];
            return Self { target, distance: 1.0 / fit.scale[1], yaw: 0.0, pitch: 0.0 };
        }
        let [yaw, pitch] = view.angles();
        let along = dot(sub(fit.center, fit.eye), fit.forward).max(0.1);
        let target = add_scaled(fit.eye, fit.forward, along);
        Self { target, distance: along, yaw, pitch }
    }

    /// The camera for a picture.
    pub(crate) fn camera(&self, aspect: f32) -> Camera {
        if DIM == 2 {
            return Camera::level([self.target[0], self.target[1]], self.distance, aspect);
        }
        Camera::looking(self.eye(), self.target, aspect)
    }

    pub(crate) fn eye(&self) -> Point {
        add_scaled(self.target, back(self.yaw, self.pitch), self.distance)
    }

    /// Turns by a motion of the mouse, in points.
    pub(crate) fn turn(&mut self, [x, y]: [f32; 2]) {
        self.yaw -= TURN * x;
        self.pitch = (self.pitch + TURN * y).clamp(-STEEPEST, STEEPEST);
    }

    /// Moves along the picture by a motion of the mouse, in heights of the picture.
    pub(crate) fn pan(&mut self, [x, y]: [f32; 2], aspect: f32) {
        let camera = self.camera(aspect);
        let height = camera.pixel_at(if DIM == 2 { 1.0 } else { self.distance }, 1.0);
        self.target = add_scaled(self.target, camera.right, -x * height);
        self.target = add_scaled(self.target, camera.up, y * height);
    }

    /// Zooms by a motion of the wheel.
    pub(crate) fn zoom(&mut self, wheel: f32) {
        self.distance = (self.distance * (-ZOOM * wheel).exp()).clamp(1.0e-2, 1.0e6);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn framed_points_are_in_the_picture() {
        let view = if DIM == 2 { View::flat() } else { View::orbit(30.0, 20.0) };
        let points = [[-4.0, 0.0, 0.0], [6.0, 5.0, 0.0]];
        let camera = OrbitCamera::framing(&view, &points, 1.5).camera(1.5);
        for point in points {
            let seen = camera.see(point);
            assert!(seen.x.abs() <= seen.w && seen.y.abs() <= seen.w, "{seen:?}");
        }
    }
}
