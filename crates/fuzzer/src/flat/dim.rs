//! Parts of the fuzzer that depend on the dimension, in 2D.

use super::both::values::{some_real, within};
use super::rapier::prelude::*;
use crate::choices::Choices;

/// All axes of a joint.
pub const AXES: [JointAxis; 3] = JointAxis::ALL;
/// Number of shape kinds.
pub const SHAPES: usize = 18;

/// Locked axes of the joints of a tree: hinges, sliders, and fixed joints.
pub const TREE_LOCKS: [JointAxesMask; 3] =
    [JointAxesMask::LIN_AXES, JointAxesMask::LOCKED_PRISMATIC_AXES, JointAxesMask::all()];

/// Returns a rotation vector or angular velocity about the axis out of the plane.
pub fn about_z(angle: Real) -> AngVector {
    angle
}

/// Returns an invalid rotation.
pub fn broken_rotation(value: Real) -> Rotation {
    Rotation { re: value, im: 1.0 }
}

/// Returns a box.
pub fn cuboid(half: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half, half)
}

/// Returns the rotational energy of a body about its centre of mass: `ω I ω / 2`.
pub fn spin_energy(body: &RigidBody) -> f64 {
    let inertia = body.mass_properties().local_mprops().principal_inertia();
    0.5 * f64::from(inertia) * f64::from(body.angvel()).powi(2)
}

/// Returns a shape of this kind, of about size `s`.
pub fn shape(kind: usize, s: Real, choices: &mut Choices<'_>) -> Option<ColliderBuilder> {
    let corners = vec![point![-s, -s], point![s, -s], point![s, s], point![-s, s]];
    Some(match kind {
        0 => ColliderBuilder::cuboid(s, s * 0.5),
        1 => ColliderBuilder::ball(s),
        2 => ColliderBuilder::round_cuboid(s, s * 0.5, s * 0.1),
        3 => ColliderBuilder::capsule_x(s, s * 0.3),
        4 => ColliderBuilder::capsule_y(s, s * 0.3),
        5 => ColliderBuilder::segment(corners[0], corners[1]),
        6 => ColliderBuilder::triangle(corners[0], corners[1], corners[2]),
        7 => ColliderBuilder::round_triangle(corners[0], corners[1], corners[2], s * 0.1),
        8 => compound(s, choices),
        9 => ColliderBuilder::polyline(corners, Some(vec![[0, 1], [1, 2], [2, 3], [3, 0]])),
        10 => ColliderBuilder::oriented_polyline(points(s, choices), None),
        11 => voxels(s, choices),
        12 => ColliderBuilder::heightfield(
            points(s, choices).iter().map(|p| p.y).collect(),
            Vector::splat(4.0 * s),
        ),
        13 => ColliderBuilder::trimesh(points(s, choices), vec![[0, 1, 2], [0, 2, 3]]).ok()?,
        14 => ColliderBuilder::convex_hull(&points(s, choices))?,
        15 => ColliderBuilder::round_convex_hull(&points(s, choices), s * 0.1)?,
        16 => ColliderBuilder::convex_polyline(corners)?,
        _ => ColliderBuilder::halfspace(vector![some_real(choices), 1.0]),
    })
}

fn points(s: Real, choices: &mut Choices<'_>) -> Vec<Vector> {
    let size = 2.0 * f64::from(s);
    let count = 4 + choices.below(4);
    (0..count).map(|_| point![within(choices, -size, size), within(choices, -size, size)]).collect()
}

fn compound(s: Real, choices: &mut Choices<'_>) -> ColliderBuilder {
    let count = choices.below(3) + 1;
    let parts = (0..count).map(|k| {
        let at = Pose::translation(s * k as Real, within(choices, -1.0, 1.0));
        let part = choices.pick(&[SharedShape::cuboid(s, s * 0.5), SharedShape::ball(s)]);
        (at, part)
    });
    ColliderBuilder::compound(parts.collect())
}

fn voxels(s: Real, choices: &mut Choices<'_>) -> ColliderBuilder {
    let count = choices.below(9) + 1;
    let cells = (0..count).map(|_| [choices.below(3) as Int, choices.below(3) as Int].into());
    ColliderBuilder::voxels(Vector::splat(s), &cells.collect::<Vec<_>>())
}

/// Returns a joint of some kind, without limits and motors.
pub fn joint(choices: &mut Choices<'_>) -> GenericJoint {
    let axis = choices.pick(&[Vector::X, Vector::Y, vector![0.6, 0.8]]);
    let reach = some_real(choices);
    match choices.below(7) {
        0 => RevoluteJointBuilder::new().build().into(),
        1 => FixedJointBuilder::new().build().into(),
        2 => PrismaticJointBuilder::new(axis).build().into(),
        3 => PinSlotJointBuilder::new(axis).build().into(),
        4 => RopeJointBuilder::new(reach).build().into(),
        5 => SpringJointBuilder::new(Vector::ZERO, axis, reach, some_real(choices)).build().into(),
        _ => {
            let mask = JointAxesMask::from_bits_truncate(choices.below(8) as u8);
            let coupled = JointAxesMask::from_bits_truncate(choices.below(8) as u8);
            GenericJointBuilder::new(mask).coupled_axes(coupled).build()
        }
    }
}

/// Returns the angular velocity of a cast shape.
pub fn spin(choices: &mut Choices<'_>) -> AngVector {
    some_real(choices)
}

/// Placeholder: there are no vehicles in 2D.
#[derive(Copy, Clone, Default)]
pub struct Vehicle {}
