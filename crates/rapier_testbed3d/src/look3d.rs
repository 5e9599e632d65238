//! The view of a testbed in 3D.

use crate::Testbed;
use crate::camera::OrbitCamera;
use drawing::Point;

impl Testbed {
    /// Looks from a point to another one.
    pub fn look_at(&mut self, eye: impl Into<Point>, target: impl Into<Point>) {
        self.camera = Some(OrbitCamera::looking(eye.into(), target.into()));
    }
}
