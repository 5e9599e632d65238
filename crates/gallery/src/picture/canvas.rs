//! The sheet that is painted on: light and nearness for every fine pixel.

use super::color::encode;
use super::vector::smoothstep;

/// Fine pixels along each side of a pixel of the finished picture.
pub(crate) const FINENESS: usize = 2;

/// A canvas.
pub(crate) struct Canvas {
    pub width: usize,
    pub height: usize,
    /// Amounts of red, green and blue light.
    light: Vec<[f32; 3]>,
    /// One over the distance of what is painted, 0 where nothing is. It changes linearly across the
    /// picture of a plane, which distance itself does not.
    nearness: Vec<f32>,
}

/// What one fine pixel gets.
#[derive(Copy, Clone)]
pub(crate) struct Dab {
    pub light: [f32; 3],
    pub opacity: f32,
    pub nearness: f32,
}

impl Canvas {
    /// A canvas for a picture of this size, with the background painted.
    pub(crate) fn new(size: [usize; 2]) -> Self {
        let [width, height] = size.map(|s| s * FINENESS);
        let mut light = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                light.push(background(x as f32 / width as f32, y as f32 / height as f32));
            }
        }
        Self { width, height, light, nearness: vec![0.0; width * height] }
    }

    /// Fine pixel that a place of the picture (both coordinates from -1 to 1, y up) falls on.
    pub(crate) fn place(&self, x: f32, y: f32) -> [f32; 2] {
        [(x * 0.5 + 0.5) * self.width as f32, (0.5 - y * 0.5) * self.height as f32]
    }

    /// The place of the picture in the middle of a fine pixel: the way back of [`Canvas::place`].
    pub(crate) fn place_of(&self, x: usize, y: usize) -> [f32; 2] {
        [
            (x as f32 + 0.5) / self.width as f32 * 2.0 - 1.0,
            1.0 - (y as f32 + 0.5) / self.height as f32 * 2.0,
        ]
    }

    /// The light of the background at a fine pixel.
    pub(crate) fn background_at(&self, x: usize, y: usize) -> [f32; 3] {
        background(x as f32 / self.width as f32, y as f32 / self.height as f32)
    }

    /// Paints over a fine pixel if nothing nearer is there, and hides from then on what is farther.
    pub(crate) fn cover(&mut self, x: usize, y: usize, dab: Dab) {
        let index = y * self.width + x;
        if dab.nearness >= self.nearness[index] {
            self.nearness[index] = dab.nearness;
            self.mix(index, dab);
        }
    }

    /// Paints over a fine pixel if nothing nearer is there, and hides nothing.
    pub(crate) fn glaze(&mut self, x: usize, y: usize, dab: Dab) {
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

    /// The finished picture: rows of red, green and blue bytes.
    pub(crate) fn into_bytes(self) -> Vec<u8> {
        let share = 1.0 / (FINENESS * FINENESS) as f32;
        let mut bytes = Vec::with_capacity(self.light.len() * 3 / (FINENESS * FINENESS));
        for y in (0..self.height).step_by(FINENESS) {
            for x in (0..self.width).step_by(FINENESS) {
                let mut sum = [0.0; 3];
                for row in y..y + FINENESS {
                    for light in &self.light[row * self.width + x..][..FINENESS] {
                        sum.iter_mut().zip(light).for_each(|(sum, light)| *sum += light);
                    }
                }
                // Half a grey level of noise that repeats every 4 pixels keeps dark gradients from banding.
                let noise = DITHER[y / FINENESS % 4][x / FINENESS % 4] * DITHER_LIGHT;
                bytes.extend(sum.map(|sum| encode(sum * share + noise)));
            }
        }
        bytes
    }
}

/// Bayer's 4 by 4 matrix about zero, from -½ to ½.
const DITHER: [[f32; 4]; 4] = [
    [-0.5, 0.0, -0.375, 0.125],
    [0.25, -0.25, 0.375, -0.125],
    [-0.3125, 0.1875, -0.4375, 0.0625],
    [0.4375, -0.0625, 0.3125, -0.1875],
];
/// About one grey level of light where the picture is dark.
const DITHER_LIGHT: f32 = 0.0006;

/// A night sky: a little lighter towards the middle and the top.
fn background(x: f32, y: f32) -> [f32; 3] {
    let from_middle = ((x - 0.5).powi(2) * 1.6 + (y - 0.42).powi(2)).sqrt();
    let glow = 1.0 - smoothstep(0.0, 0.85, from_middle);
    let dark = [0.0030, 0.0042, 0.0075];
    let bright = [0.0125, 0.0170, 0.0290];
    std::array::from_fn(|c| dark[c] + (bright[c] - dark[c]) * glow)
}
