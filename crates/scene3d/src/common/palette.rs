//! Colours of bodies.

use crate::rapier::prelude::*;
use drawing::Color;

/// Colours of dynamic bodies (hue in degrees, saturation, lightness).
const DYNAMIC: [[f32; 3]; 6] = [
    [208.0, 0.70, 0.55],
    [28.0, 0.86, 0.60],
    [172.0, 0.48, 0.48],
    [44.0, 0.85, 0.70],
    [354.0, 0.66, 0.60],
    [216.0, 0.40, 0.76],
];
/// Colours of the other kinds.
const KINEMATIC: [f32; 3] = [266.0, 0.55, 0.66];
const FIXED: [f32; 3] = [218.0, 0.13, 0.46];
const SCENERY: [f32; 3] = [218.0, 0.16, 0.40];
/// Factors on saturation and lightness of sleeping bodies.
const ASLEEP: [f32; 2] = [0.55, 0.72];

/// A place from 0 to 1 for a number. Multiples of the golden section spread evenly, and neighbouring numbers are far
/// apart.
pub(super) fn spread(number: u32) -> f32 {
    (number as f32 * 0.618_034).fract()
}

/// The colour of a collider. Neighbouring handles have different colours.
pub(super) fn color(
    handle: ColliderHandle,
    body: Option<&RigidBody>,
    scenery: bool,
    sleep: bool,
) -> Color {
    let [hue, mut saturation, mut lightness] = match body {
        Some(body) if body.is_dynamic() => {
            let place = spread(handle.into_raw_parts().0) * DYNAMIC.len() as f32;
            DYNAMIC[place as usize % DYNAMIC.len()]
        }
        Some(body) if body.is_kinematic() => KINEMATIC,
        _ if scenery => SCENERY,
        _ => FIXED,
    };
    if sleep && body.is_some_and(RigidBody::is_sleeping) {
        saturation *= ASLEEP[0];
        lightness *= ASLEEP[1];
    }
    Color::from_hsl(hue, saturation, lightness, 1.0)
}
