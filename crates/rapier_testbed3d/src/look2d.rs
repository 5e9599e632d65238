//! The view of a testbed in 2D.

use crate::Testbed;
use crate::camera::OrbitCamera;

/// Height of the picture in pixels to which a zoom refers.
const HEIGHT: f32 = 720.0;

impl Testbed {
    /// Looks at a point, with so many pixels to a length unit in a picture 720 pixels high.
    pub fn look_at(&mut self, middle: impl Into<[f32; 2]>, zoom: f32) {
        let [x, y] = middle.into();
        let distance = 0.5 * HEIGHT / zoom.max(1.0e-6);
        self.camera = Some(OrbitCamera { target: [x, y, 0.0], distance, yaw: 0.0, pitch: 0.0 });
    }
}
