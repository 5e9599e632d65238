//! Painters: they make a picture of a drawing.

use drawing::{Camera, Drawing, Image, raster};

/// Makes pictures.
pub trait Painter {
    /// The name of the device that paints.
    fn device(&self) -> String;

    /// Paints a drawing: a picture of a size in pixels, without labels.
    fn paint(&mut self, drawing: &Drawing, camera: &Camera, size: [usize; 2]) -> Image;
}

/// Paints on the processor.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct Rasteriser;

impl Painter for Rasteriser {
    fn device(&self) -> String {
        "the processor".to_owned()
    }

    fn paint(&mut self, drawing: &Drawing, camera: &Camera, size: [usize; 2]) -> Image {
        raster::picture(drawing, camera, size)
    }
}
