//! # The rasteriser: pictures without a graphics adapter
//!
//! Triangles fill a depth buffer at twice the size of the picture. They are shaded per pixel with the shadow
//! of the sun, and averaged down, which smooths the borders. The same drawing gives the same bytes on every
//! machine: all arithmetic is scalar, in a fixed order, on one thread.

mod canvas;
mod clip;
mod fill;
mod letters;
mod shade;
mod shadow;
mod stroke;

use crate::vector::smoothstep;
use crate::{Camera, Drawing, Image, Label, Role, light};
use canvas::Canvas;
use shade::Shader;
use shadow::ShadowMap;

/// Fine pixels along each side of a pixel of the finished picture.
const FINENESS: usize = 2;

/// Paints a drawing: a picture of a size in pixels.
pub fn picture(drawing: &Drawing, camera: &Camera, size: [usize; 2]) -> Image {
    let mut canvas = Canvas::new(size, FINENESS);
    let shadow = (!camera.flat).then(|| ShadowMap::new(drawing, camera));
    let shader = Shader::new(camera, shadow.as_ref(), canvas.height);
    for (mesh, instance) in drawing.instances() {
        shader.paint(&mut canvas, mesh, instance);
    }
    for line in &drawing.lines {
        stroke::line(&mut canvas, camera, line);
    }
    canvas.into_image()
}

/// Writes labels at their places, and a caption into the upper left corner: a large line and a small one.
pub fn write(image: &Image, camera: &Camera, labels: &[Label], caption: &[String; 2]) -> Image {
    let mut canvas = Canvas::from_image(image);
    for label in labels {
        letters::label(&mut canvas, camera, label.at, &label.text);
    }
    letters::caption(&mut canvas, caption);
    canvas.into_image()
}

/// The instance that is visible at each pixel: its role and its number.
pub fn visible(drawing: &Drawing, camera: &Camera, size: [usize; 2]) -> Vec<Option<(Role, u32)>> {
    let mut nearest = vec![0.0_f32; size[0] * size[1]];
    let mut seen = vec![None; size[0] * size[1]];
    for (mesh, instance) in drawing.instances() {
        fill::instance(camera, size, mesh, instance, |pixel| {
            let index = pixel.y * size[0] + pixel.x;
            if pixel.nearness >= nearest[index] {
                nearest[index] = pixel.nearness;
                seen[index] = Some((instance.role, instance.id));
            }
        });
    }
    seen
}

/// Returns the fraction of a surface's own light at a distance; the rest is haze.
fn clarity(camera: &Camera, w: f32) -> f32 {
    if camera.flat {
        return 1.0;
    }
    1.0 - light::HAZE * smoothstep(camera.depth[0], 1.6 * camera.depth[1], w)
}

/// Returns the pixels with their middle in a range.
fn whole([low, high]: [f32; 2], limit: usize) -> std::ops::Range<usize> {
    let first = low.floor().max(0.0) as usize;
    let end = (high.ceil().max(0.0) as usize).min(limit);
    first..end
}

#[cfg(test)]
mod tests;
