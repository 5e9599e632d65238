//! Pictures of the gallery on a graphics adapter.

use drawing::{Camera, Drawing, Image};
use gallery::Painter;
use render::Offscreen;

/// Paints on a graphics adapter, without a window.
pub struct AdapterPainter(Offscreen);

impl AdapterPainter {
    /// A painter on the best adapter of this machine, if there is one that works.
    pub fn new() -> Option<Self> {
        Offscreen::new().map(Self)
    }
}

impl Painter for AdapterPainter {
    fn device(&self) -> String {
        self.0.name().to_owned()
    }

    fn paint(&mut self, drawing: &Drawing, camera: &Camera, size: [usize; 2]) -> Image {
        self.0.picture(drawing, camera, size)
    }
}
