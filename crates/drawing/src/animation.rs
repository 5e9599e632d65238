//! Moving pictures: PNG files with frames (APNG), which browsers and code hosts play.
//!
//! One palette of 255 colours serves all frames, and a frame stores only the pixels that differ from the
//! frame before. The palette's first entry is transparent. Both together make files about ten times smaller
//! than whole frames in full colour.

use crate::Image;
use crate::image::naming;
use png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, Encoder};
use std::io;
use std::path::Path;

/// Colours of the palette, besides the transparent one.
const COLORS: usize = 255;
/// Bits of each channel that the choice of a palette considers.
const BITS: u32 = 6;
/// Differences per channel up to this many levels do not count as a change: they are noise of dithering.
const NOISE: u8 = 2;

/// Frames of one size, in their order.
#[derive(Clone, Debug, Default)]
pub struct Animation {
    frames: Vec<Image>,
}

impl Animation {
    /// Adds a frame. A frame of another size than the first one is ignored.
    pub fn push(&mut self, frame: Image) {
        let fits = |first: &Image| (first.width, first.height) == (frame.width, frame.height);
        if self.frames.first().is_none_or(fits) {
            self.frames.push(frame);
        }
    }

    /// Number of frames.
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    /// Returns whether there is no frame.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// Writes the frames as an animated PNG that repeats for ever, with so many frames a second.
    ///
    /// # Errors
    /// There is no frame, or the file cannot be written; the message names it.
    pub fn save(&self, path: &Path, frames_per_second: u16) -> io::Result<()> {
        // Without a frame there is no file.
        let file = self.first().and_then(|_| std::fs::File::create(path));
        let written =
            file.and_then(|file| self.encode(io::BufWriter::new(file), frames_per_second));
        written.map_err(|error| naming(path, error))
    }

    fn first(&self) -> io::Result<&Image> {
        let error = || io::Error::new(io::ErrorKind::InvalidInput, "there is no frame");
        self.frames.first().ok_or_else(error)
    }

    /// Writes the bytes of an animated PNG that repeats for ever, with so many frames a second.
    ///
    /// # Errors
    /// There is no frame, or those of the writer.
    pub fn encode(&self, writer: impl io::Write, frames_per_second: u16) -> io::Result<()> {
        let first = self.first()?;
        let palette = Palette::of(&self.frames);
        let mut encoder = Encoder::new(writer, first.width as u32, first.height as u32);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_compression(Compression::High);
        encoder.set_filter(png::Filter::NoFilter);
        encoder.set_palette(palette.bytes());
        encoder.set_trns(vec![0]);
        encoder.set_animated(self.frames.len() as u32, 0)?;
        encoder.set_frame_delay(1, frames_per_second.max(1))?;
        encoder.set_dispose_op(DisposeOp::None)?;
        encoder.set_blend_op(BlendOp::Over)?;
        let mut writer = encoder.write_header()?;
        let mut shown = first.pixels.clone();
        for (number, frame) in self.frames.iter().enumerate() {
            let indices = if number == 0 {
                frame.pixels.chunks_exact(3).map(|pixel| palette.nearest(pixel)).collect()
            } else {
                changes(&palette, &mut shown, frame)
            };
            let area = Area::around(&indices, first.width);
            let area = if number == 0 { Area::whole(first) } else { area };
            writer.reset_frame_position()?;
            writer.set_frame_dimension(area.size[0] as u32, area.size[1] as u32)?;
            writer.set_frame_position(area.corner[0] as u32, area.corner[1] as u32)?;
            writer.write_image_data(&area.cut(&indices, first.width))?;
        }
        writer.finish()?;
        Ok(())
    }
}

/// The palette index of each pixel that differs from the one shown, and 0 for all others.
fn changes(palette: &Palette, shown: &mut [u8], frame: &Image) -> Vec<u8> {
    let pairs = shown.chunks_exact_mut(3).zip(frame.pixels.chunks_exact(3));
    let changed = pairs.map(|(old, new)| {
        if old.iter().zip(new).all(|(a, b)| a.abs_diff(*b) <= NOISE) {
            return 0;
        }
        old.copy_from_slice(new);
        palette.nearest(new)
    });
    changed.collect()
}

/// A rectangle of pixels.
struct Area {
    corner: [usize; 2],
    size: [usize; 2],
}

impl Area {
    fn whole(image: &Image) -> Self {
        Self { corner: [0; 2], size: [image.width, image.height] }
    }

    /// The smallest rectangle with all pixels that are not transparent; a single pixel if there are none.
    fn around(indices: &[u8], width: usize) -> Self {
        let (mut low, mut high) = ([usize::MAX; 2], [0; 2]);
        for (at, _) in indices.iter().enumerate().filter(|(_, index)| **index != 0) {
            let place = [at % width, at / width];
            for axis in 0..2 {
                low[axis] = low[axis].min(place[axis]);
                high[axis] = high[axis].max(place[axis] + 1);
            }
        }
        if low[0] == usize::MAX {
            return Self { corner: [0; 2], size: [1; 2] };
        }
        Self { corner: low, size: [high[0] - low[0], high[1] - low[1]] }
    }

    fn cut(&self, indices: &[u8], width: usize) -> Vec<u8> {
        let rows = indices.chunks_exact(width).skip(self.corner[1]).take(self.size[1]);
        rows.flat_map(|row| &row[self.corner[0]..][..self.size[0]]).copied().collect()
    }
}

/// The colours of an animation.
struct Palette {
    colors: Vec<[u8; 3]>,
    /// The index for each shortened colour that occurs, by its number.
    index: Vec<u8>,
}

/// Number of the shortened colours: those with the considered bits only.
const SHORTENED: usize = 1 << (3 * BITS);

/// The number of a shortened colour, in the order of red, green, blue.
fn number(pixel: &[u8]) -> usize {
    pixel.iter().fold(0, |number, c| number << BITS | usize::from(c >> (8 - BITS)))
}

/// The channels of the shortened colour with a number.
fn channels(number: usize) -> [u8; 3] {
    [2, 1, 0].map(|place| (number >> (place * BITS) & ((1 << BITS) - 1)) as u8)
}

impl Palette {
    /// Colours that fit the frames: the median cut of all that occur.
    fn of(frames: &[Image]) -> Self {
        let mut counts = vec![0; SHORTENED];
        for frame in frames {
            frame.pixels.chunks_exact(3).for_each(|pixel| counts[number(pixel)] += 1);
        }
        let occurring = counts.iter().enumerate().filter(|&(_, &count)| count > 0);
        let all: Part = occurring.map(|(number, &count)| (channels(number), count)).collect();
        let mut boxes = vec![all];
        while boxes.len() < COLORS {
            let Some(largest) = largest(&boxes) else { break };
            let (left, right) = split(boxes.swap_remove(largest));
            boxes.extend([left, right]);
        }
        let colors: Vec<[u8; 3]> = boxes.iter().map(|part| mean(part)).collect();
        let nearest = |(number, &count): (usize, &u64)| match count {
            0 => 1,
            _ => closest(&colors, channels(number)),
        };
        let index = counts.iter().enumerate().map(nearest).collect();
        Self { colors, index }
    }

    fn nearest(&self, pixel: &[u8]) -> u8 {
        self.index[number(pixel)]
    }

    /// The transparent entry, then the colours.
    fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![0; 3];
        bytes.extend(self.colors.as_flattened());
        bytes
    }
}

type Part = Vec<([u8; 3], u64)>;

/// The channel with the widest range in a part, and that range.
fn widest(part: &[([u8; 3], u64)]) -> (usize, u8) {
    let range = |channel: usize| {
        let values = part.iter().map(|(color, _)| color[channel]);
        values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
    };
    (0..3)
        .map(|channel| (channel, range(channel)))
        .max_by_key(|&(_, range)| range)
        .unwrap_or((0, 0))
}

/// The part that gains most from a split.
fn largest(parts: &[Part]) -> Option<usize> {
    let gain = |part: &Part| {
        let pixels: u64 = part.iter().map(|(_, count)| count).sum();
        (pixels as f64).sqrt() * f64::from(widest(part).1)
    };
    let best = parts.iter().enumerate().map(|(i, part)| (i, gain(part)));
    best.filter(|&(_, gain)| gain > 0.0).max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
}

/// Two halves of a part, with about as many pixels each.
fn split(mut part: Part) -> (Part, Part) {
    let (channel, _) = widest(&part);
    part.sort_unstable_by_key(|&(color, _)| (color[channel], color));
    let total: u64 = part.iter().map(|(_, count)| count).sum();
    let mut sum = 0;
    let middle = part.iter().position(|(_, count)| {
        sum += count;
        2 * sum >= total
    });
    let right = part.split_off((middle.unwrap_or(0) + 1).clamp(1, part.len() - 1));
    (part, right)
}

/// The mean colour of a part, in bytes.
fn mean(part: &[([u8; 3], u64)]) -> [u8; 3] {
    let total: u64 = part.iter().map(|(_, count)| count).sum::<u64>().max(1);
    std::array::from_fn(|channel| {
        let half_step = 1 << (7 - BITS);
        let sum: u64 = part
            .iter()
            .map(|(color, count)| count * ((u64::from(color[channel]) << (8 - BITS)) + half_step))
            .sum();
        (sum / total) as u8
    })
}

/// The palette index of the colour that is closest to a shortened one.
fn closest(colors: &[[u8; 3]], color: [u8; 3]) -> u8 {
    let full = color.map(|c| (i32::from(c) << (8 - BITS)) + (1 << (7 - BITS)));
    let distance = |other: &[u8; 3]| -> i32 {
        (0..3).map(|c| (full[c] - i32::from(other[c])).pow(2) * [3, 4, 2][c]).sum()
    };
    let best = colors.iter().enumerate().min_by_key(|(_, other)| distance(other));
    best.map_or(1, |(i, _)| i as u8 + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(at: usize) -> Image {
        let mut pixels = vec![40; 3 * 32 * 16];
        pixels[3 * at..3 * at + 3].copy_from_slice(&[250, 10, 10]);
        Image { width: 32, height: 16, pixels }
    }

    #[test]
    fn frames_hold_their_changes_only() {
        let frames = vec![frame(5), frame(70)];
        let palette = Palette::of(&frames);
        let mut shown = frames[0].pixels.clone();
        let indices = changes(&palette, &mut shown, &frames[1]);
        assert_eq!(indices.iter().filter(|&&index| index != 0).count(), 2);
        assert_eq!(shown, frames[1].pixels);
        let area = Area::around(&indices, 32);
        assert_eq!((area.corner, area.size), ([5, 0], [2, 3]));
    }

    #[test]
    fn files_have_their_frames() {
        let mut animation = Animation::default();
        (0..7).for_each(|i| animation.push(frame(3 * i)));
        animation.push(Image { width: 2, height: 2, pixels: vec![0; 12] });
        assert_eq!(animation.len(), 7);
        let path = std::env::temp_dir().join(format!("frames-{}.png", std::process::id()));
        animation.save(&path, 30).unwrap();
        let file = io::BufReader::new(std::fs::File::open(&path).unwrap());
        let reader = png::Decoder::new(file).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_frames, 7);
        std::fs::remove_file(&path).unwrap();
        assert!(Animation::default().save(&path, 30).is_err());
    }
}
