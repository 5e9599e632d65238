//! Lines: strokes with smooth borders.

use super::canvas::{Canvas, Dab};
use super::{clarity, clip, whole};
use crate::{Camera, Line};

/// Width of a line in pixels of the finished picture.
const LINE_WIDTH: f32 = 1.2;
/// Factor on the width of lines that are visible through surfaces.
const ON_TOP: f32 = 1.5;
/// Length in pixels below which lines get fainter, so that distant crowds do not become white areas.
const SHORT_LINE_PIXELS: f32 = 9.0;
/// Smallest factor on the opacity of short lines.
const OPACITY_FACTOR_MIN: f32 = 0.3;
/// Factor on the nearness of a line, so that adjacent faces do not hide it.
const LINE_LIFT: f32 = 1.0025;
/// Nearness of a line in a flat scene: below the shapes, whose nearness is 1.
const FLAT_LINE_NEARNESS: f32 = 0.9;

/// Paints a line of the scene.
pub(super) fn line(canvas: &mut Canvas, camera: &Camera, line: &Line) {
    let ends = clip::line(camera.see(line.from), camera.see(line.to), camera.nearest());
    let Some(ends) = ends else { return };
    let [a, b] = ends.map(|end| canvas.place(end.x / end.w, end.y / end.w));
    let length = ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt() / canvas.fineness as f32;
    let strength = (length / SHORT_LINE_PIXELS).clamp(OPACITY_FACTOR_MIN, 1.0);
    let stroke = Stroke {
        ends: [a, b],
        nearness: ends.map(|end| match (line.on_top, camera.flat) {
            (true, _) => f32::MAX,
            (false, true) => FLAT_LINE_NEARNESS,
            (false, false) => LINE_LIFT / end.w,
        }),
        light: line.color.to_light(),
        opacity: ends.map(|end| line.color.opacity * strength * clarity(camera, end.w)),
        width: LINE_WIDTH * canvas.fineness as f32 * if line.on_top { ON_TOP } else { 1.0 },
    };
    stroke.paint(canvas);
}

/// A straight stroke with round ends, in fine pixels.
pub(crate) struct Stroke {
    pub ends: [[f32; 2]; 2],
    pub nearness: [f32; 2],
    pub light: [f32; 3],
    pub opacity: [f32; 2],
    pub width: f32,
}

impl Stroke {
    /// Visits the fine pixels along the longer axis, and at each the pixels across. The opacity falls off
    /// over one fine pixel about the stroke's border, in proportion to the covered fraction of the pixel.
    pub(crate) fn paint(&self, canvas: &mut Canvas) {
        let [a, b] = self.ends;
        let delta = [b[0] - a[0], b[1] - a[1]];
        let (long, short) = if delta[0].abs() >= delta[1].abs() { (0, 1) } else { (1, 0) };
        let reach = 0.5 * self.width + 0.5;
        let limits = [canvas.width, canvas.height];
        let slope = if delta[long] != 0.0 { delta[short] / delta[long] } else { 0.0 };
        // The stroke is wider across the short axis the more it leans.
        let across = reach * (1.0 + slope * slope).sqrt();
        let span = [a[long].min(b[long]) - reach, a[long].max(b[long]) + reach];
        for major in whole(span, limits[long]) {
            let middle = a[short] + slope * (major as f32 + 0.5 - a[long]);
            let low = middle.max(a[short].min(b[short])) - across;
            let high = middle.min(a[short].max(b[short])) + across;
            for minor in whole([low, high], limits[short]) {
                let (x, y) = if long == 0 { (major, minor) } else { (minor, major) };
                self.dab(canvas, x, y);
            }
        }
    }

    fn dab(&self, canvas: &mut Canvas, x: usize, y: usize) {
        let [a, b] = self.ends;
        let delta = [b[0] - a[0], b[1] - a[1]];
        let p = [x as f32 + 0.5 - a[0], y as f32 + 0.5 - a[1]];
        let squared = delta[0] * delta[0] + delta[1] * delta[1];
        let along = if squared > 0.0 { (p[0] * delta[0] + p[1] * delta[1]) / squared } else { 0.0 };
        let t = along.clamp(0.0, 1.0);
        let distance = ((p[0] - t * delta[0]).powi(2) + (p[1] - t * delta[1]).powi(2)).sqrt();
        let cover = (0.5 * self.width + 0.5 - distance).clamp(0.0, 1.0);
        if cover > 0.0 {
            let mixed = |ends: [f32; 2]| ends[0] + (ends[1] - ends[0]) * t;
            canvas.glaze(
                x,
                y,
                Dab {
                    light: self.light,
                    opacity: mixed(self.opacity) * cover,
                    nearness: mixed(self.nearness),
                },
            );
        }
    }
}
