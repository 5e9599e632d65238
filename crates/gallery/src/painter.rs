//! Painters, which turn a drawing into a picture.

use drawing::{Camera, Drawing, Image, raster};

/// Renders pictures.
pub trait Painter {
    /// Returns the name of the device.
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
