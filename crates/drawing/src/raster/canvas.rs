//! The canvas: light and nearness for every fine pixel.

use crate::Image;
use crate::color::encode;
use crate::light::BACKGROUND;

/// A canvas.
pub(super) struct Canvas {
    pub width: usize,
    pub height: usize,
    /// Fine pixels along each side of a pixel of the finished picture.
    pub fineness: usize,
    /// Amounts of red, green and blue light.
    light: Vec<[f32; 3]>,
    /// One over the distance of the surface, 0 for the background. It is linear across the image of a plane,
    /// and the distance is not.
    nearness: Vec<f32>,
}

/// Paint of one fine pixel.
#[derive(Copy, Clone)]
pub(super) struct Dab {
    pub light: [f32; 3],
    pub opacity: f32,
    pub nearness: f32,
}

impl Canvas {
    /// A canvas for a picture of this size, with the background painted.
    pub(super) fn new(size: [usize; 2], fineness: usize) -> Self {
        let [width, height] = size.map(|s| s * fineness);
        let mut light = Vec::with_capacity(width * height);
        for y in 0..height {
            let row = background(y as f32 / height as f32);
            light.extend(std::iter::repeat_n(row, width));
        }
        Self { width, height, fineness, light, nearness: vec![0.0; width * height] }
    }

    /// A canvas with a finished picture on it.
    pub(super) fn from_image(image: &Image) -> Self {
        let light =
            image.pixels.chunks_exact(3).map(|p| [p[0], p[1], p[2]].map(crate::color::decode_byte));
        let (width, height) = (image.width, image.height);
        Self {
            width,
            height,
            fineness: 1,
            light: light.collect(),
            nearness: vec![0.0; width * height],
        }
    }

    /// Returns the fine pixel of a position in the picture (both coordinates from -1 to 1, y up).
    pub(super) fn place(&self, x: f32, y: f32) -> [f32; 2] {
        [(x * 0.5 + 0.5) * self.width as f32, (0.5 - y * 0.5) * self.height as f32]
    }

    /// Returns the position in the picture of a fine pixel's middle: the inverse of [`Canvas::place`].
    pub(super) fn place_of(&self, x: usize, y: usize) -> [f32; 2] {
        [
            (x as f32 + 0.5) / self.width as f32 * 2.0 - 1.0,
            1.0 - (y as f32 + 0.5) / self.height as f32 * 2.0,
        ]
    }

    /// The light of the background in a row of fine pixels.
    pub(super) fn background_at(&self, y: usize) -> [f32; 3] {
        background(y as f32 / self.height as f32)
    }

    /// Returns whether something at this nearness is visible at a fine pixel.
    pub(super) fn is_visible(&self, x: usize, y: usize, nearness: f32) -> bool {
        nearness >= self.nearness[y * self.width + x]
    }

    /// Paints a fine pixel unless a nearer surface is there, and hides farther surfaces from then on.
    pub(super) fn cover(&mut self, x: usize, y: usize, dab: Dab) {
        let index = y * self.width + x;
        if dab.nearness >= self.nearness[index] {
            self.nearness[index] = dab.nearness;
            self.mix(index, dab);
        }
    }

    /// Paints a fine pixel unless a nearer surface is there, and hides nothing.
    pub(super) fn glaze(&mut self, x: usize, y: usize, dab: Dab) {
        let index = y * self.width + x;
        if dab.nearness >= self.nearness[index] {
            self.mix(index, dab);
        }
    }

    fn mix(&mut self, index: usize, dab: Dab) {
        for (old, new) in self.light[index].iter_mut().zip(dab.light) {
            *old += (new - *old) * dab.opacity;
        }
    }

    /// The finished picture.
    pub(super) fn into_image(self) -> Image {
        let fineness = self.fineness;
        let scale = 1.0 / (fineness * fineness) as f32;
        let mut pixels = Vec::with_capacity(self.light.len() * 3 / (fineness * fineness));
        for y in (0..self.height).step_by(fineness) {
            for x in (0..self.width).step_by(fineness) {
                let mut sum = [0.0; 3];
                for row in y..y + fineness {
                    for light in &self.light[row * self.width + x..][..fineness] {
                        sum.iter_mut().zip(light).for_each(|(sum, light)| *sum += light);
                    }
                }
                // Half a grey level of noise that repeats every 4 pixels keeps dark gradients from banding.
                let noise =
                    if fineness > 1 { DITHER[y / fineness % 4][x / fineness % 4] } else { 0.0 };
                pixels.extend(sum.map(|sum| encode(sum * scale + noise * DITHER_LIGHT)));
            }
        }
        Image { width: self.width / fineness, height: self.height / fineness, pixels }
    }
}

/// Bayer's 4 by 4 matrix about zero, from -½ to ½.
const DITHER: [[f32; 4]; 4] = [
    [-0.5, 0.0, -0.375, 0.125],
    [0.25, -0.25, 0.375, -0.125],
    [-0.3125, 0.1875, -0.4375, 0.0625],
    [0.4375, -0.0625, 0.3125, -0.1875],
];
/// Amplitude of the dither: about one grey level in dark parts of the picture.
const DITHER_LIGHT: f32 = 0.0006;

/// The light of the background at a height of the picture: 0 at the top, 1 at the bottom.
fn background(y: f32) -> [f32; 3] {
    let [top, bottom] = BACKGROUND;
    std::array::from_fn(|c| top[c] + (bottom[c] - top[c]) * y)
}
