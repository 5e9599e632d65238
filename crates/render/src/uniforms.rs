//! The numbers that the shader reads, in the order of its `View`.

use drawing::light::{
    BACKGROUND, FLAT_LIGHT, GLOSS, GROUND_LIGHT, HAZE, HIGHLIGHT, RIM_LIGHT, RIM_PIXELS,
    SHADOW_REACH, SKY_LIGHT, SUN, SUN_LIGHT, sun_axes,
};
use drawing::vector::{dot, normalize};
use drawing::{Camera, Point};

/// Rows of four numbers.
pub(crate) const ROWS: usize = 18;
/// Extent of the shadow map towards the sun, in radii of the region.
const SHADOW_DEPTH: f32 = 6.0;

/// The matrix to the shadow map, and the side of a texel of the map in the world.
pub(crate) type Sun = ([[f32; 4]; 4], f32);

/// The shadow map for a camera.
pub(crate) fn sun(camera: &Camera, texels: u32) -> Sun {
    let radius = camera.radius * SHADOW_REACH;
    (sun_matrix(camera.center, radius), 2.0 * radius / texels as f32)
}

/// The rows for a camera and a picture; without a sun there are no shadows.
pub(crate) fn rows(camera: &Camera, size: [u32; 2], sun: Option<&Sun>) -> [[f32; 4]; ROWS] {
    let [width, height] = size.map(|side| side as f32);
    let with = |[x, y, z]: Point, w: f32| [x, y, z, w];
    let mut rows = [[0.0; 4]; ROWS];
    rows[..4].copy_from_slice(&camera.matrix());
    let texel = sun.map_or(0.0, |(matrix, texel)| {
        rows[4..8].copy_from_slice(matrix);
        *texel
    });
    rows[8] = with(camera.eye, if camera.flat { 1.0 } else { 0.0 });
    rows[9] = with(camera.center, camera.radius);
    rows[10] = with(normalize(SUN), texel);
    rows[11] = with(SUN_LIGHT, HIGHLIGHT);
    rows[12] = with(SKY_LIGHT, GLOSS);
    rows[13] = with(GROUND_LIGHT, HAZE);
    rows[14] = with(BACKGROUND[0], 0.0);
    rows[15] = with(BACKGROUND[1], drawing::light::cell_size(camera.radius));
    let pixel = camera.pixel_at(1.0, height);
    let rim = camera.pixel_at(1.0, 720.0) * RIM_PIXELS;
    rows[16] = [camera.depth[0], camera.depth[1], pixel, rim];
    rows[17] = [width, height, RIM_LIGHT, FLAT_LIGHT];
    rows
}

/// The matrix, by columns, from the world to the shadow map.
fn sun_matrix(center: Point, radius: f32) -> [[f32; 4]; 4] {
    let [right, up, sun] = sun_axes();
    let across = |axis: Point, scale: f32| {
        [axis[0] * scale, axis[1] * scale, axis[2] * scale, -dot(axis, center) * scale]
    };
    let (x, y) = (across(right, 1.0 / radius), across(up, 1.0 / radius));
    let mut z = across(sun, -0.5 / (SHADOW_DEPTH * radius));
    z[3] += 0.5;
    std::array::from_fn(|column| {
        [x[column], y[column], z[column], if column == 3 { 1.0 } else { 0.0 }]
    })
}
