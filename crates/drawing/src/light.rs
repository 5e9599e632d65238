//! The light of every picture: one sun, a sky above, a ground below. Both renderers use these numbers.

use crate::Point;
use crate::vector::{cross, normalize};

/// Direction towards the sun, not normalised.
pub const SUN: Point = [0.42, 0.84, 0.46];
/// Light of the sun on a surface that faces it.
pub const SUN_LIGHT: Point = [1.02, 0.96, 0.86];
/// Light from above, and light that the ground reflects from below.
pub const SKY_LIGHT: Point = [0.40, 0.46, 0.56];
/// Light from below.
pub const GROUND_LIGHT: Point = [0.17, 0.16, 0.16];
/// Background at the top of the picture and at its bottom (linear light).
pub const BACKGROUND: [Point; 2] = [[0.020, 0.028, 0.044], [0.052, 0.068, 0.094]];
/// Strength of highlights. The exponent that narrows them is 32: five squarings.
pub const GLOSS: f32 = 0.10;
/// Fraction of the background mixed into the farthest surfaces.
pub const HAZE: f32 = 0.35;
/// Width of the rim of a flat shape, in pixels of a picture 720 pixels high.
pub const RIM_PIXELS: f32 = 1.7;
/// Factor on the light of the rim of a flat shape.
pub const RIM_LIGHT: f32 = 2.1;
/// Factor on the light of the inside of a flat shape.
pub const FLAT_LIGHT: f32 = 0.55;
/// Light added to a highlighted surface.
pub const HIGHLIGHT: f32 = 0.22;
/// Side of the shadow map, in texels.
pub const SHADOW_TEXELS: usize = 2048;
/// Radius of the shadowed region, in radii of the framed content.
pub const SHADOW_REACH: f32 = 1.25;

/// The axes of the picture that the sun sees: to the right, up, and towards the sun.
pub fn sun_axes() -> [Point; 3] {
    let sun = normalize(SUN);
    let right = normalize(cross([0.0, 1.0, 0.0], sun));
    [right, cross(sun, right), sun]
}

/// Side of a cell of the ground's grid: 1, 2 or 5 times a power of ten, about a sixth of the radius of the
/// content.
pub fn cell_size(radius: f32) -> f32 {
    let wanted = (0.16 * radius).max(1.0e-3);
    let power = 10.0_f32.powf(wanted.log10().floor());
    match wanted / power {
        m if m < 1.5 => power,
        m if m < 3.5 => 2.0 * power,
        _ => 5.0 * power,
    }
}
