//! # Pictures, drawn without a graphics card
//!
//! A [`Picture`] collects lines and triangles, then [`save`](Picture::save) fits a camera to them and
//! paints: triangles fill a depth buffer with dim shades, so that a pile reads as a pile and not as a
//! tangle of wires; lines go on top as glowing edges. Everything is painted at twice the size in
//! linear light and then averaged down, which is what makes the edges smooth.

mod camera;
mod canvas;
mod clip;
mod color;
mod letters;
mod paint;
mod vector;

pub use camera::View;
pub use color::Color;

use crate::album::naming;
use camera::Camera;
use canvas::Canvas;
use std::io;
use std::path::Path;

/// A position in the scene. Flat scenes lie at z = 0; y is up.
pub type Point = [f32; 3];

/// A straight line in the scene.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Line {
    /// Where it begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// Its colour.
    pub color: Color,
    /// Is it part of the surroundings? The camera makes no effort to show those.
    pub scenery: bool,
    /// Does it show through what stands before it? Such lines are drawn thicker.
    pub on_top: bool,
}

/// A filled triangle in the scene. It hides what is behind it.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Triangle {
    /// Its corners; either side can be seen.
    pub corners: [Point; 3],
    /// Its colour in full light. It is painted dimmer than a line of the same colour.
    pub color: Color,
    /// Is it part of the surroundings? The camera makes no effort to show those.
    pub scenery: bool,
    /// Is it part of a large plane? Such triangles get a faint grid, fade out with distance, and are seen
    /// from their front only: from where their corners turn counter-clockwise.
    pub floor: bool,
}

/// What a scene draws with.
pub trait Pen {
    /// Draws a line.
    fn line(&mut self, line: Line);

    /// Draws a filled triangle.
    fn triangle(&mut self, triangle: Triangle);

    /// Writes a word or two, with their middle at a place. Whoever has no letters leaves them out.
    fn label(&mut self, at: Point, text: &str) {
        let _ = (at, text);
    }
}

/// Size of a picture in pixels.
pub(crate) const SIZE: [usize; 2] = [1280, 720];

/// A picture in the making.
pub(crate) struct Picture {
    view: View,
    lines: Vec<Line>,
    triangles: Vec<Triangle>,
    labels: Vec<(Point, String)>,
    caption: [String; 2],
}

impl Pen for Picture {
    fn line(&mut self, line: Line) {
        if [line.from, line.to].as_flattened().iter().all(|c| c.is_finite()) {
            self.lines.push(line);
        }
    }

    fn triangle(&mut self, triangle: Triangle) {
        if triangle.corners.as_flattened().iter().all(|c| c.is_finite()) {
            self.triangles.push(triangle);
        }
    }

    fn label(&mut self, at: Point, text: &str) {
        if at.iter().all(|c| c.is_finite()) {
            self.labels.push((at, text.to_owned()));
        }
    }
}

impl Picture {
    /// An empty picture.
    pub(crate) fn new(view: View) -> Self {
        Self {
            view,
            lines: Vec::new(),
            triangles: Vec::new(),
            labels: Vec::new(),
            caption: Default::default(),
        }
    }

    /// Sets what stands in the upper left corner: a large line and a small one.
    pub(crate) fn caption(&mut self, title: &str, details: &str) {
        self.caption = [title.to_owned(), details.to_owned()];
    }

    /// Paints the picture and writes it as a PNG file.
    pub(crate) fn save(&self, path: &Path) -> io::Result<()> {
        let pixels = self.render();
        write_png(path, &pixels).map_err(|error| naming(path, error))
    }

    /// Paints the picture: rows of red, green and blue bytes.
    fn render(&self) -> Vec<u8> {
        let camera = Camera::fit(&self.view, &self.points_to_show(), aspect());
        let mut canvas = Canvas::new(SIZE);
        paint::scene(&mut canvas, &camera, &self.triangles, &self.lines);
        for (at, text) in &self.labels {
            letters::label(&mut canvas, &camera, *at, text);
        }
        letters::caption(&mut canvas, &self.caption);
        canvas.into_bytes()
    }

    /// What the camera should get into the picture: all that moves, or else all there is.
    fn points_to_show(&self) -> Vec<Point> {
        let gather = |scenery_too: bool| -> Vec<Point> {
            let lines = self.lines.iter().filter(|line| scenery_too || !line.scenery);
            let triangles = self.triangles.iter().filter(|t| scenery_too || !t.scenery);
            lines
                .flat_map(|line| [line.from, line.to])
                .chain(triangles.flat_map(|t| t.corners))
                .chain(self.labels.iter().map(|(at, _)| *at))
                .collect()
        };
        let moving = gather(false);
        if moving.is_empty() { gather(true) } else { moving }
    }
}

/// Width over height.
fn aspect() -> f32 {
    SIZE[0] as f32 / SIZE[1] as f32
}

fn write_png(path: &Path, pixels: &[u8]) -> io::Result<()> {
    let file = io::BufWriter::new(std::fs::File::create(path)?);
    let mut encoder = png::Encoder::new(file, SIZE[0] as u32, SIZE[1] as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(())
}

#[cfg(test)]
mod tests;
