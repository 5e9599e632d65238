//! Light from a pixel of a surface to the eye.

use super::canvas::{Canvas, Dab};
use super::shadow::ShadowMap;
use super::{clarity, fill};
use crate::light::{
    FLAT_LIGHT, GLOSS, GROUND_LIGHT, HIGHLIGHT, RIM_LIGHT, SKY_LIGHT, SUN, SUN_LIGHT, cell_size,
};
use crate::vector::{add_scaled, dot, normalize, smoothstep, sub};
use crate::{Camera, Instance, Mesh, Point, Role};

/// Paints instances in the view of a camera.
pub(super) struct Shader<'a> {
    camera: &'a Camera,
    shadow: Option<&'a ShadowMap>,
    sun: Point,
    /// Height of the canvas in fine pixels.
    height: usize,
}

impl<'a> Shader<'a> {
    pub(super) fn new(camera: &'a Camera, shadow: Option<&'a ShadowMap>, height: usize) -> Self {
        Self { camera, shadow, sun: normalize(SUN), height }
    }

    /// Paints an instance.
    pub(super) fn paint(&self, canvas: &mut Canvas, mesh: &Mesh, instance: &Instance) {
        let albedo = instance.color.to_light();
        let size = [canvas.width, canvas.height];
        let detail = mesh.detail(self.camera, instance, canvas.height as f32);
        let mesh = detail.map_or(mesh, |detail| &mesh.coarse[detail].0);
        let mut row = (usize::MAX, [0.0; 3]);
        fill::instance(self.camera, size, mesh, instance, |pixel| {
            if !canvas.is_visible(pixel.x, pixel.y, pixel.nearness) {
                return;
            }
            if row.0 != pixel.y {
                row = (pixel.y, canvas.background_at(pixel.y));
            }
            let (mut opacity, mut light) = (instance.color.opacity, albedo);
            if self.camera.flat {
                let factor = RIM_LIGHT + (FLAT_LIGHT - RIM_LIGHT) * pixel.normal[2];
                light = light.map(|l| l * factor);
            } else {
                let [px, py] = canvas.place_of(pixel.x, pixel.y);
                let w = 1.0 / pixel.nearness;
                let point = self.camera.point_at(px, py, w);
                if instance.role == Role::Ground {
                    let [fade, grid] = self.ground(point, w);
                    opacity *= fade;
                    light = light.map(|l| l * (1.0 + 0.55 * grid));
                }
                light = self.lit(light, point, pixel.normal);
                let clear = clarity(self.camera, w);
                light = std::array::from_fn(|c| row.1[c] + (light[c] - row.1[c]) * clear);
            }
            if instance.highlighted {
                light = light.map(|l| l + HIGHLIGHT);
            }
            canvas.cover(pixel.x, pixel.y, Dab { light, opacity, nearness: pixel.nearness });
        });
    }

    /// The light of a surface at a point.
    fn lit(&self, albedo: Point, point: Point, normal: Point) -> Point {
        let to_eye = normalize(self.camera.toward_eye(point));
        let mut normal = normalize(normal);
        if dot(normal, to_eye) < 0.0 {
            normal = normal.map(|c| -c);
        }
        let facing = dot(normal, self.sun).max(0.0);
        let reach = match self.shadow {
            Some(shadow) if facing > 0.0 => shadow.light_at(point, normal),
            _ => 1.0,
        };
        let middle = normalize(add_scaled(self.sun, to_eye, 1.0));
        let gloss = GLOSS * dot(normal, middle).max(0.0).powi(32) * facing.min(1.0);
        let up = 0.5 + 0.5 * normal[1];
        std::array::from_fn(|c| {
            let around = GROUND_LIGHT[c] + (SKY_LIGHT[c] - GROUND_LIGHT[c]) * up;
            albedo[c] * (around + SUN_LIGHT[c] * facing * reach) + gloss * reach
        })
    }

    /// Returns the opacity of the ground at a point, and the strength of a grid line there. Every fifth line
    /// is stronger. Lines keep their width in the picture, and vanish where their density is too high.
    fn ground(&self, point: Point, w: f32) -> [f32; 2] {
        let offset = sub(point, self.camera.center);
        let distance = (offset[0] * offset[0] + offset[2] * offset[2]).sqrt();
        let radius = self.camera.radius;
        let fade = 1.0 - smoothstep(1.6 * radius, 6.0 * radius, distance);
        let pixel = self.camera.pixel_at(w, self.height as f32);
        let cell = cell_size(radius);
        let line = |position: f32, cell: f32| {
            let distance = (position / cell - (position / cell).round()).abs() * cell;
            let crowded = smoothstep(3.0, 14.0, cell / pixel);
            (1.0 - distance / (1.8 * pixel)).clamp(0.0, 1.0) * crowded
        };
        let fine = line(point[0], cell).max(line(point[2], cell));
        let coarse = line(point[0], 5.0 * cell).max(line(point[2], 5.0 * cell));
        [fade, (0.4 * fine).max(coarse)]
    }
}
