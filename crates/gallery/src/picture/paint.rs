//! Turns what the camera sees into pixels.

use super::camera::{Camera, Seen};
use super::canvas::{Canvas, Dab, FINENESS};
use super::vector::{cross, dot, normalize, smoothstep, sub};
use super::{Line, Point, Triangle, clip};

/// Width of a line in pixels of the finished picture.
const LINE_WIDTH: f32 = 1.15;
/// How much thicker lines are that show through everything.
const ON_TOP: f32 = 1.5;
/// Lines shorter than this many pixels get fainter, or else a far crowd would be a white blot.
const SHORT_LINE: f32 = 9.0;
/// The faintest that shortness makes a line. In a flat scene nothing shades the insides, so lines have
/// more to tell.
const FAINTEST: f32 = 0.12;
const FAINTEST_FLAT: f32 = 0.4;
/// How much nearer a line counts than it is, so that the faces it borders do not hide it.
const LINE_LIFT: f32 = 1.0025;
/// How much of a colour a surface in full light shows.
const SURFACE: f32 = 0.34;
/// Opacity of surfaces in a flat scene.
const FLAT_OPACITY: f32 = 0.20;
/// How much of the farthest thing the haze takes away.
const HAZE: f32 = 0.62;
/// Where the light comes from.
const SUN: Point = [0.42, 0.78, 0.46];

/// Paints the surfaces, then the lines.
pub(crate) fn scene(canvas: &mut Canvas, camera: &Camera, triangles: &[Triangle], lines: &[Line]) {
    for triangle in triangles {
        surface(canvas, camera, triangle);
    }
    for line in lines {
        edge(canvas, camera, line);
    }
}

/// How much of a thing is left at a distance.
fn clarity(camera: &Camera, w: f32) -> f32 {
    if camera.flat { 1.0 } else { 1.0 - HAZE * smoothstep(camera.depth[0], camera.depth[1], w) }
}

fn edge(canvas: &mut Canvas, camera: &Camera, line: &Line) {
    let ends = clip::line(camera.see(line.from), camera.see(line.to), camera.nearest());
    let Some(ends) = ends else { return };
    let [a, b] = ends.map(|end| canvas.place(end.x / end.w, end.y / end.w));
    let length = ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt() / FINENESS as f32;
    let faintest = if camera.flat { FAINTEST_FLAT } else { FAINTEST };
    let strength = (length / SHORT_LINE).clamp(faintest, 1.0);
    let stroke = Stroke {
        ends: [a, b],
        nearness: ends.map(|end| if line.on_top { f32::MAX } else { LINE_LIFT / end.w }),
        light: line.color.to_light(),
        opacity: ends.map(|end| line.color.opacity * strength * clarity(camera, end.w)),
        width: LINE_WIDTH * FINENESS as f32 * if line.on_top { ON_TOP } else { 1.0 },
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
    /// Visits the fine pixels along the longer axis and, at each, those across. The opacity falls off
    /// over one fine pixel about the stroke's border: the share of the pixel that the stroke covers.
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

/// The pixels whose middle may lie in a range, of those that there are.
fn whole([low, high]: [f32; 2], limit: usize) -> std::ops::Range<usize> {
    let first = low.floor().max(0.0) as usize;
    let end = (high.ceil().max(0.0) as usize).min(limit);
    first..end
}

fn surface(canvas: &mut Canvas, camera: &Camera, triangle: &Triangle) {
    if triangle.floor && !camera.flat && !faces_eye(camera, triangle) {
        return;
    }
    let polygon = clip::triangle(triangle.corners.map(|p| camera.see(p)), camera.nearest());
    let [first, rest @ ..] = polygon.as_slice() else { return };
    let shade = Shade::new(camera, triangle);
    for pair in rest.windows(2) {
        fill(canvas, [*first, pair[0], pair[1]], |canvas, x, y, nearness| {
            let dab = shade.dab(canvas, x, y, nearness);
            if camera.flat { canvas.glaze(x, y, dab) } else { canvas.cover(x, y, dab) }
        });
    }
}

/// Visits the fine pixels whose middle lies in the triangle, with the nearness there.
fn fill(
    canvas: &mut Canvas,
    corners: [Seen; 3],
    mut visit: impl FnMut(&mut Canvas, usize, usize, f32),
) {
    let p = corners.map(|c| canvas.place(c.x / c.w, c.y / c.w));
    let nearness = corners.map(|c| 1.0 / c.w);
    let area = twice_area(p[0], p[1], p[2]);
    if area.abs() < 1.0e-6 {
        return;
    }
    // Share of corner `i`: the area of the triangle between the opposite side and the pixel, over the
    // whole area.
    let share = |i: usize, at: [f32; 2]| twice_area(p[(i + 1) % 3], p[(i + 2) % 3], at) / area;
    let range = |axis: usize| {
        let values = p.map(|p| p[axis]);
        [values.into_iter().fold(f32::MAX, f32::min), values.into_iter().fold(f32::MIN, f32::max)]
    };
    let (columns, rows) = (whole(range(0), canvas.width), whole(range(1), canvas.height));
    for y in rows {
        for x in columns.clone() {
            let at = [x as f32 + 0.5, y as f32 + 0.5];
            let shares = [share(0, at), share(1, at), share(2, at)];
            if shares.iter().all(|&share| share > 0.0) {
                visit(canvas, x, y, (0..3).map(|i| shares[i] * nearness[i]).sum());
            }
        }
    }
}

/// Twice the area of a triangle, positive if it turns clockwise in the picture.
///
/// The side from `a` to `b` is always measured from the same end, so two triangles that share it see
/// every point on exactly one side of it: no pixel along it is painted twice, or not at all. A point
/// right on it belongs to the triangle that has the side in rising order.
fn twice_area(a: [f32; 2], b: [f32; 2], point: [f32; 2]) -> f32 {
    let rising = |a: [f32; 2], b: [f32; 2]| {
        let area = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
        if area == 0.0 { f32::EPSILON } else { area }
    };
    if (a[0], a[1]) < (b[0], b[1]) { rising(a, b) } else { -rising(b, a) }
}

/// Do the triangle's corners turn counter-clockwise as seen from the eye?
fn faces_eye(camera: &Camera, triangle: &Triangle) -> bool {
    let [a, b, c] = triangle.corners;
    dot(cross(sub(b, a), sub(c, a)), camera.toward_eye(a)) > 0.0
}

/// How a triangle's pixels look.
struct Shade<'a> {
    camera: &'a Camera,
    light: [f32; 3],
    opacity: f32,
    floor: bool,
}

impl<'a> Shade<'a> {
    fn new(camera: &'a Camera, triangle: &Triangle) -> Self {
        let [a, b, c] = triangle.corners;
        let mut normal = normalize(cross(sub(b, a), sub(c, a)));
        if dot(normal, camera.toward_eye(a)) < 0.0 {
            normal = normal.map(|c| -c);
        }
        // Sides that face away from the sun still get some light from the sky.
        let lit = if camera.flat { 1.0 } else { 0.55 + 0.45 * dot(normal, normalize(SUN)) };
        let strength = if camera.flat { 1.0 } else { SURFACE * lit * lit };
        Self {
            camera,
            light: triangle.color.to_light().map(|light| light * strength),
            opacity: triangle.color.opacity * if camera.flat { FLAT_OPACITY } else { 1.0 },
            floor: triangle.floor && !camera.flat,
        }
    }

    fn dab(&self, canvas: &Canvas, x: usize, y: usize, nearness: f32) -> Dab {
        let w = 1.0 / nearness;
        if !self.floor {
            // Haze is the background's light, not transparency: what is behind must not shine through.
            let (haze, clear) = (canvas.background_at(x, y), clarity(self.camera, w));
            let light = std::array::from_fn(|c| haze[c] + (self.light[c] - haze[c]) * clear);
            return Dab { light, opacity: self.opacity, nearness };
        }
        let [px, py] = canvas.place_of(x, y);
        let point = self.camera.point_at(px, py, w);
        let offset = sub(point, self.camera.center);
        let distance = (offset[0] * offset[0] + offset[2] * offset[2]).sqrt();
        let fade = 1.0 - smoothstep(self.camera.radius, 4.5 * self.camera.radius, distance);
        let grid = self.grid(point, w, canvas.height);
        let light = self.light.map(|light| light * (0.35 + 1.1 * grid));
        Dab { light, opacity: 0.8 * fade, nearness }
    }

    /// How much of a grid line there is at a point: 0 to 1. Every fifth line is stronger. Lines keep
    /// the same width in the picture, and vanish where they would come too close together.
    fn grid(&self, point: Point, w: f32, height: usize) -> f32 {
        let pixel = 2.0 * w / (height as f32 * self.camera.scale_up());
        let cell = cell_size(self.camera.radius);
        let line = |position: f32, cell: f32| {
            let distance = (position / cell - (position / cell).round()).abs() * cell;
            let crowded = smoothstep(3.0, 14.0, cell / pixel);
            (1.0 - distance / (1.4 * pixel)).clamp(0.0, 1.0) * crowded
        };
        let fine = line(point[0], cell).max(line(point[2], cell));
        let coarse = line(point[0], 5.0 * cell).max(line(point[2], 5.0 * cell));
        (0.4 * fine).max(coarse)
    }
}

/// A round number that is about a tenth of the scene's radius: 1, 2 or 5 times a power of ten.
fn cell_size(radius: f32) -> f32 {
    let wanted = (0.16 * radius).max(1.0e-3);
    let power = 10.0_f32.powf(wanted.log10().floor());
    match wanted / power {
        m if m < 1.5 => power,
        m if m < 3.5 => 2.0 * power,
        _ => 5.0 * power,
    }
}
