//! The camera, and the fit of a camera to the content of a scene.

use crate::sheet::box_corners;
use crate::vector::{add_scaled, cross, dot, normalize, sub};
use crate::{Drawing, Point};

/// Viewing direction of a scene.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct View {
    kind: Kind,
    focus: Option<[Point; 2]>,
}

#[derive(Copy, Clone, Debug, PartialEq)]
enum Kind {
    Flat,
    Orbit { yaw: f32, pitch: f32 },
}

impl View {
    /// Views a flat scene from the front.
    pub fn flat() -> Self {
        Self { kind: Kind::Flat, focus: None }
    }

    /// Views a scene in space, in perspective. Angles are in degrees: `yaw` 0 looks along -z and 90 along -x,
    /// `pitch` is the angle below the horizontal.
    pub fn orbit(yaw: f32, pitch: f32) -> Self {
        Self { kind: Kind::Orbit { yaw, pitch }, focus: None }
    }

    /// Yaw and pitch (degrees); zero for a flat view.
    pub fn angles(&self) -> [f32; 2] {
        match self.kind {
            Kind::Flat => [0.0; 2],
            Kind::Orbit { yaw, pitch } => [yaw, pitch],
        }
    }

    /// Frames the box with these two opposite corners instead of the moving instances.
    pub fn focus(mut self, min: Point, max: Point) -> Self {
        self.focus = Some([min, max]);
        self
    }
}

/// Half the picture's height over the distance to it, for a lens of 38 degrees.
const LENS: f32 = 0.344;
/// Fraction of the picture that the scene may fill; the rest is margin.
const FILL: f32 = 0.86;
/// Vertical shift of the scene, in half heights of the picture. Negative, as the caption is above.
const LIFT: f32 = -0.04;
/// Fraction of the points on each side that may be outliers. Without it, one distant body would shrink all
/// others to dots.
const OUTLIER_FRACTION: f32 = 0.004;
/// Smallest gain in scale for which outliers are left out.
const CROPPING_GAIN_MIN: f32 = 1.6;

/// Point in camera coordinates: in the picture while `|x| <= w` and `|y| <= w`.
#[derive(Copy, Clone, Debug)]
pub struct Seen {
    /// To the right.
    pub x: f32,
    /// Up.
    pub y: f32,
    /// Distance along the line of sight; 1 for everything in a flat view.
    pub w: f32,
}

/// Returns the unit vector from the target to the eye of an orbit, by its angles in degrees as in
/// [`View::orbit`].
pub fn back(yaw: f32, pitch: f32) -> Point {
    let (yaw, pitch) = (yaw.to_radians(), pitch.to_radians());
    [yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos()]
}

impl Drawing {
    /// Returns the camera that frames the drawing in a picture of a size in pixels.
    pub fn camera(&self, view: &View, size: [usize; 2]) -> Camera {
        Camera::fit(view, &self.points_to_frame(), size[0] as f32 / size[1] as f32)
    }
}

/// Camera at a position.
#[derive(Clone, Debug)]
pub struct Camera {
    /// Position of the eye.
    pub eye: Point,
    /// Direction to the right of the picture.
    pub right: Point,
    /// Direction to its top.
    pub up: Point,
    /// Direction of sight.
    pub forward: Point,
    /// Scales of the two axes of the picture.
    pub scale: [f32; 2],
    /// Vertical shift of the content, in half heights of the picture.
    pub lift: f32,
    /// Whether the projection is parallel, along -z.
    pub flat: bool,
    /// Nearest and farthest distance of the content.
    pub depth: [f32; 2],
    /// Middle of the content.
    pub center: Point,
    /// Radius of the content.
    pub radius: f32,
}

impl Camera {
    /// Returns the camera that shows all of `points` (except a few outliers) in the direction of `view`.
    pub fn fit(view: &View, points: &[Point], aspect: f32) -> Self {
        let corners = view.focus.map(box_corners);
        let points = corners.as_ref().map_or(points, |corners| corners.as_slice());
        let points = if points.is_empty() { &[[0.0; 3]] } else { points };
        let mut camera = match view.kind {
            Kind::Flat => Self::fit_flat(points, aspect),
            Kind::Orbit { yaw, pitch } => Self::fit_orbit(yaw, pitch, points, aspect),
        };
        let span = |axis: Point| {
            let [low, high] = extent(points.iter().map(|&p| dot(p, axis)));
            (0.5 * (low + high), 0.5 * (high - low))
        };
        let spans = [span([1.0, 0.0, 0.0]), span([0.0, 1.0, 0.0]), span([0.0, 0.0, 1.0])];
        camera.center = spans.map(|(middle, _)| middle);
        camera.radius = spans.iter().map(|(_, half)| half * half).sum::<f32>().sqrt().max(0.5);
        camera
    }

    fn fit_flat(points: &[Point], aspect: f32) -> Self {
        let [left, right] = extent(points.iter().map(|p| p[0]));
        let [bottom, top] = extent(points.iter().map(|p| p[1]));
        let half_height = (0.5 * (top - bottom)).max(0.5 * (right - left) / aspect).max(0.5) / FILL;
        let middle = [0.5 * (left + right), 0.5 * (bottom + top)];
        Self { lift: LIFT, ..Self::level(middle, half_height, aspect) }
    }

    /// The eye is as near as possible. With the axes of the picture fixed, a point (x, y, z) is to the left
    /// of the right edge if `x - eye.x <= t (z - eye.z)`. Here t is the slope of that edge; the other edges
    /// likewise. Each edge needs the maximum of one linear function over all points. Two opposite edges
    /// together give one coordinate of the eye and a bound on its z.
    fn fit_orbit(yaw: f32, pitch: f32, points: &[Point], aspect: f32) -> Self {
        let forward = back(yaw, pitch).map(|c| -c);
        let right = normalize(cross(forward, [0.0, 1.0, 0.0]));
        let up = cross(right, forward);

        let along = |axis: Point, slope: f32| {
            let most = |sign: f32| {
                extent(points.iter().map(|&p| sign * dot(p, axis) - slope * dot(p, forward)))[1]
            };
            let (a, b) = (most(1.0), most(-1.0));
            (0.5 * (a - b), -(a + b) / (2.0 * slope))
        };
        let (x, z_for_width) = along(right, LENS * aspect * FILL);
        let (y, z_for_height) = along(up, LENS * FILL);
        let [near, far] = extent(points.iter().map(|&p| dot(p, forward)));
        let z = z_for_width.min(z_for_height).min(near - 0.1 * (far - near) - 0.5);

        let eye = add_scaled(add_scaled(right.map(|c| c * x), up, y), forward, z);
        Self {
            eye,
            right,
            up,
            forward,
            scale: [1.0 / (LENS * aspect), 1.0 / LENS],
            lift: LIFT,
            flat: false,
            depth: [near - z, (far - z).max(near - z + 1.0e-3)],
            center: [0.0; 3],
            radius: 1.0,
        }
    }

    /// Returns the point in camera coordinates.
    pub fn see(&self, point: Point) -> Seen {
        let p = sub(point, self.eye);
        let w = if self.flat { 1.0 } else { dot(p, self.forward) };
        Seen {
            x: dot(p, self.right) * self.scale[0],
            y: dot(p, self.up) * self.scale[1] + self.lift * w,
            w,
        }
    }

    /// Returns the position in the picture (both coordinates from -1 to 1), or `None` for a point outside.
    pub fn in_picture(&self, point: Point) -> Option<[f32; 2]> {
        let Seen { x, y, w } = self.see(point);
        let inside = w >= self.nearest() && x.abs() <= w && y.abs() <= w;
        inside.then(|| [x / w, y / w])
    }

    /// Returns the distance of the near plane.
    pub fn nearest(&self) -> f32 {
        if self.flat { 0.5 } else { 0.02 * self.depth[0] }
    }

    /// Returns the point at a distance on the line of sight through a position in the picture (both
    /// coordinates from -1 to 1).
    pub fn point_at(&self, x: f32, y: f32, w: f32) -> Point {
        let p = add_scaled(self.eye, self.right, x / self.scale[0] * w);
        let p = add_scaled(p, self.up, (y - self.lift) / self.scale[1] * w);
        if self.flat { p } else { add_scaled(p, self.forward, w) }
    }

    /// Returns the direction from a point to the eye.
    pub(crate) fn toward_eye(&self, point: Point) -> Point {
        if self.flat { self.forward.map(|c| -c) } else { sub(self.eye, point) }
    }
}

/// Returns the range of the values, without outliers at either end if there are any.
fn extent(values: impl Iterator<Item = f32>) -> [f32; 2] {
    let mut values: Vec<f32> = values.collect();
    let strays = (values.len() as f32 * OUTLIER_FRACTION) as usize;
    let last = values.len() - 1;
    let mut range = |skipped: usize| -> [f32; 2] {
        [skipped, last - skipped].map(|i| *values.select_nth_unstable_by(i, f32::total_cmp).1)
    };
    let (all, most) = (range(0), range(strays));
    if all[1] - all[0] > CROPPING_GAIN_MIN * (most[1] - most[0]) { most } else { all }
}

impl Camera {
    /// Returns a camera in perspective that looks from one point to another.
    pub fn looking(eye: Point, target: Point, aspect: f32) -> Self {
        let to_target = sub(target, eye);
        let distance = dot(to_target, to_target).sqrt().max(1.0e-3);
        let forward = if distance > 1.0e-3 { normalize(to_target) } else { [0.0, 0.0, -1.0] };
        let right = match normalize(cross(forward, [0.0, 1.0, 0.0])) {
            right if dot(right, right) > 0.0 => right,
            _ => [1.0, 0.0, 0.0],
        };
        Self {
            eye,
            right,
            up: cross(right, forward),
            forward,
            scale: [1.0 / (LENS * aspect), 1.0 / LENS],
            lift: 0.0,
            flat: false,
            depth: [0.3 * distance, 4.0 * distance],
            center: target,
            radius: 0.5 * distance,
        }
    }

    /// Returns a camera on a flat scene, from the scene's middle and half its visible height.
    pub fn level(middle: [f32; 2], half_height: f32, aspect: f32) -> Self {
        let half_height = half_height.max(1.0e-3);
        Self {
            eye: [middle[0], middle[1], 0.0],
            right: [1.0, 0.0, 0.0],
            up: [0.0, 1.0, 0.0],
            forward: [0.0, 0.0, -1.0],
            scale: [1.0 / (half_height * aspect), 1.0 / half_height],
            lift: 0.0,
            flat: true,
            depth: [0.0, 1.0],
            center: [middle[0], middle[1], 0.0],
            radius: half_height,
        }
    }

    /// Returns the length of a pixel at a distance along the line of sight, for this height of the picture in
    /// pixels.
    pub fn pixel_at(&self, w: f32, height: f32) -> f32 {
        2.0 * w / (height * self.scale[1])
    }

    /// Returns origin and unit direction of the line of sight through a position in the picture (both
    /// coordinates from -1 to 1).
    pub fn ray(&self, x: f32, y: f32) -> [Point; 2] {
        let through = self.point_at(x, y, 1.0);
        if self.flat {
            [through, self.forward]
        } else {
            [self.eye, normalize(sub(through, self.eye))]
        }
    }

    /// Returns the matrix, by columns, from the world to clip space with depth from 1 (near) to 0 (far).
    pub fn matrix(&self) -> [[f32; 4]; 4] {
        let [sx, sy] = self.scale;
        let shift = |axis: Point| -dot(axis, self.eye);
        let row_x =
            [self.right[0] * sx, self.right[1] * sx, self.right[2] * sx, shift(self.right) * sx];
        let along = [self.forward[0], self.forward[1], self.forward[2], shift(self.forward)];
        let row_w = if self.flat { [0.0, 0.0, 0.0, 1.0] } else { along };
        let row_y: [f32; 4] = std::array::from_fn(|i| {
            let up = [self.up[0], self.up[1], self.up[2], shift(self.up)];
            up[i] * sy + self.lift * row_w[i]
        });
        // Reversed depth, `near / w`, keeps its digits at large distances.
        let row_z = if self.flat { [0.0, 0.0, 0.0, 0.5] } else { [0.0, 0.0, 0.0, self.nearest()] };
        std::array::from_fn(|column| [row_x[column], row_y[column], row_z[column], row_w[column]])
    }
}
