//! Numbers, most of them valid.

use super::dim::about_z;
use super::rapier::prelude::*;
use crate::choices::Choices;

/// Extreme and invalid numbers.
const EDGES: [Real; 16] = [
    Real::NAN,
    Real::INFINITY,
    Real::NEG_INFINITY,
    Real::MAX,
    Real::MIN,
    -1.0,
    0.0,
    -0.0,
    Real::MIN_POSITIVE * Real::EPSILON,
    Real::MIN_POSITIVE,
    1.0e-20,
    1.0e-9,
    1.0e9,
    1.0e15,
    1.0e18,
    1.0e30,
];

/// Returns a number from `low` to `high`.
pub fn within(choices: &mut Choices<'_>, low: f64, high: f64) -> Real {
    choices.within(low, high) as Real
}

/// Returns a number near one, or an extreme one.
pub fn some_real(choices: &mut Choices<'_>) -> Real {
    if choices.once_in(12) { choices.pick(&EDGES) } else { within(choices, -2.0, 4.0) }
}

/// Returns a number for a coefficient, a mass or a size, rarely an extreme one.
pub fn some_positive(choices: &mut Choices<'_>) -> Real {
    if choices.once_in(40) { choices.pick(&EDGES) } else { within(choices, 0.0, 2.0) }
}

/// Returns a vector with components of up to `size`, or with an extreme one.
pub fn some_vector(choices: &mut Choices<'_>, size: f64) -> Vector {
    if choices.once_in(30) {
        let edge = choices.pick(&EDGES);
        return choices.pick(&[Vector::splat(edge), Vector::X * edge, Vector::Y * edge]);
    }
    let array = Vector::ZERO.to_array().map(|_| within(choices, -size, size));
    Vector::from_array(array)
}

/// Returns a pose near the origin, or an extreme one.
pub fn some_pose(choices: &mut Choices<'_>, size: f64) -> Pose {
    let angle = if choices.coin() { 0.0 } else { within(choices, -3.0, 3.0) };
    let mut pose = *RigidBodyBuilder::dynamic().rotation(about_z(angle)).build().position();
    pose.translation = some_vector(choices, size);
    if choices.once_in(60) {
        pose.rotation = super::dim::broken_rotation(some_real(choices));
    }
    pose
}

/// Returns a number from 0 to `count - 1`, and prints it if `FUZZ_VERBOSE` is set.
pub fn choose(choices: &mut Choices<'_>, count: usize) -> usize {
    let choice = choices.below(count);
    choices.print(|| format!("    variant {choice} of {count}"));
    choice
}
