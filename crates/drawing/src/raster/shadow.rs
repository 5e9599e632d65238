//! Shadow map: the depth of the scene as seen from the sun.

use super::fill;
use crate::light::{SHADOW_REACH, SHADOW_TEXELS, sun_axes};
use crate::vector::{add_scaled, dot, sub};
use crate::{Camera, Drawing, Point, Role};

/// Offset along the normal, and towards the sun, in texels: keeps surfaces from shadowing themselves.
const BIAS: f32 = 1.6;

/// Distances from the sun.
pub(super) struct ShadowMap {
    light: Light,
    /// Heights towards the sun; the lowest float without a surface.
    heights: Vec<f32>,
}

impl ShadowMap {
    /// Creates the map of the region in the camera's view.
    pub(super) fn new(drawing: &Drawing, camera: &Camera) -> Self {
        let [right, up, sun] = sun_axes();
        let radius = camera.radius * SHADOW_REACH;
        let light = Light { right, up, sun, center: camera.center, radius };
        let mut map = Self { light, heights: vec![f32::MIN; SHADOW_TEXELS * SHADOW_TEXELS] };
        map.paint(drawing);
        map
    }

    fn paint(&mut self, drawing: &Drawing) {
        let Self { light, heights } = self;
        for (mesh, instance) in drawing.instances() {
            let mesh = mesh.coarsest();
            if instance.role == Role::Ground {
                continue;
            }
            let places: Vec<[f32; 3]> =
                mesh.vertices.iter().map(|v| light.place(instance.place(v.position))).collect();
            for triangle in &mesh.triangles {
                let corners = triangle.map(|i| places[i as usize]);
                let Some(plane) = Plane::through(corners) else { continue };
                let flat = corners.map(|[x, y, _]| [x, y]);
                fill::cover([SHADOW_TEXELS; 2], flat, |x, y, _| {
                    let texel = &mut heights[y * SHADOW_TEXELS + x];
                    *texel = texel.max(plane.height_at(x, y));
                });
            }
        }
    }

    /// Fraction of the sun's light that reaches a point of a surface with this unit normal.
    pub(super) fn light_at(&self, point: Point, normal: Point) -> f32 {
        let bias = BIAS * (2.0 * self.light.radius / SHADOW_TEXELS as f32);
        let raised = add_scaled(add_scaled(point, normal, bias), self.light.sun, bias);
        let [x, y, height] = self.light.place(raised);
        let (x, y) = (x - 0.5, y - 0.5);
        let last = (SHADOW_TEXELS - 2) as f32;
        if x < 1.0 || y < 1.0 || x > last || y > last {
            return 1.0;
        }
        // Three by three texels, weighted so that the result is continuous.
        let (left, top) = (x.floor(), y.floor());
        let weights = |fraction: f32| [1.0 - fraction, 1.0, fraction].map(|w| w * 0.5);
        let (across, down) = (weights(x - left), weights(y - top));
        let mut lit = 0.0;
        for (j, wy) in down.into_iter().enumerate() {
            for (i, wx) in across.into_iter().enumerate() {
                let index = (top as usize + j) * SHADOW_TEXELS + left as usize + i;
                if self.heights.get(index).is_none_or(|&blocker| blocker <= height) {
                    lit += wx * wy;
                }
            }
        }
        lit
    }
}

/// The sun as a parallel camera.
struct Light {
    right: Point,
    up: Point,
    sun: Point,
    center: Point,
    radius: f32,
}

impl Light {
    /// Texel coordinates of a point, and its height towards the sun.
    fn place(&self, point: Point) -> [f32; 3] {
        let offset = sub(point, self.center);
        let texels = |axis: Point, sign: f32| {
            (sign * dot(offset, axis) / self.radius * 0.5 + 0.5) * SHADOW_TEXELS as f32
        };
        [texels(self.right, 1.0), texels(self.up, -1.0), dot(offset, self.sun)]
    }
}

/// Height as a linear function of the place in the map.
struct Plane {
    origin: [f32; 3],
    slope: [f32; 2],
}

impl Plane {
    /// Returns the plane of a triangle, or `None` for a triangle parallel to the sun's light.
    fn through([a, b, c]: [[f32; 3]; 3]) -> Option<Self> {
        let (u, v) = (sub(b, a), sub(c, a));
        let area = u[0] * v[1] - u[1] * v[0];
        if area.abs() < 1.0e-4 {
            return None;
        }
        let slope = [(u[2] * v[1] - u[1] * v[2]) / area, (u[0] * v[2] - u[2] * v[0]) / area];
        Some(Self { origin: a, slope })
    }

    fn height_at(&self, x: usize, y: usize) -> f32 {
        let offset = [x as f32 + 0.5 - self.origin[0], y as f32 + 0.5 - self.origin[1]];
        self.origin[2] + self.slope[0] * offset[0] + self.slope[1] * offset[1]
    }
}
