//! Animation of the last steps of a run.

use crate::catalog::SceneRun;
use crate::painter::Painter;
use drawing::{Animation, Camera, Drawing, Point, View};

/// Size of an animation in pixels: wide enough for a third of a page, for small files.
const SIZE: [usize; 2] = [480, 270];
/// Steps from one frame to the next.
const STRIDE: usize = 2;

/// Drawings of a run, painted after its end. Only then are all points known that the camera has to frame.
pub(crate) struct Recording {
    /// Number of steps before the first frame.
    start: usize,
    drawings: Vec<Drawing>,
}

impl Recording {
    /// A recording of the last frames of a run.
    pub(crate) fn new(frames: usize, steps: usize) -> Self {
        Self { start: steps.saturating_sub(frames * STRIDE), drawings: Vec::new() }
    }

    /// Adds a frame if one is due.
    pub(crate) fn after_step(&mut self, scene: &mut dyn SceneRun, done: usize) {
        if done > self.start && (done - self.start).is_multiple_of(STRIDE) {
            self.drawings.push(scene.draw());
        }
    }

    /// Paints all frames with one camera.
    pub(crate) fn paint(&self, painter: &mut dyn Painter, view: &View) -> Animation {
        let ends = [self.drawings.first(), self.drawings.last()];
        let points: Vec<Point> =
            ends.into_iter().flatten().flat_map(Drawing::points_to_frame).collect();
        let camera = Camera::fit(view, &points, SIZE[0] as f32 / SIZE[1] as f32);
        let mut animation = Animation::default();
        for drawing in &self.drawings {
            animation.push(painter.paint(drawing, &camera, SIZE));
        }
        animation
    }
}
