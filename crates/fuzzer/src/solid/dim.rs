//! Parts of the fuzzer that depend on the dimension, in 3D.

use super::both::values::{some_real, some_vector, within};
use super::rapier::parry::utils::Array2;
use super::rapier::prelude::*;
use crate::choices::Choices;

/// All axes of a joint.
pub const AXES: [JointAxis; 6] = JointAxis::ALL;
/// Number of shape kinds.
pub const SHAPES: usize = 22;

/// Locked axes of the joints of a tree: ball joints, universal joints, hinges, sliders, and fixed joints.
pub const TREE_LOCKS: [JointAxesMask; 6] = [
    JointAxesMask::LIN_AXES,
    JointAxesMask::LIN_AXES.union(JointAxesMask::ANG_X),
    JointAxesMask::LIN_AXES.union(JointAxesMask::ANG_X).union(JointAxesMask::ANG_Y),
    JointAxesMask::LIN_AXES.union(JointAxesMask::ANG_X).union(JointAxesMask::ANG_Z),
    JointAxesMask::LOCKED_PRISMATIC_AXES,
    JointAxesMask::all(),
];

/// Returns a rotation vector or angular velocity about Z.
pub fn about_z(angle: Real) -> AngVector {
    AngVector::new(0.0, 0.0, angle)
}

/// Returns an invalid rotation.
pub fn broken_rotation(value: Real) -> Rotation {
    Rotation::from_xyzw(value, 0.0, 1.0, 1.0)
}

/// Returns a box.
pub fn cuboid(half: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half, half, half)
}

/// Returns the rotational energy of a body: `ω I ω / 2`.
pub fn spin_energy(body: &RigidBody) -> f64 {
    let local = body.mass_properties().local_mprops();
    let to_world = *body.rotation() * local.principal_inertia_local_frame;
    let spin = to_world.inverse() * body.angvel();
    0.5 * f64::from(spin.dot(local.principal_inertia() * spin))
}

/// Returns a shape of this kind, of about size `s`.
pub fn shape(kind: usize, s: Real, choices: &mut Choices<'_>) -> Option<ColliderBuilder> {
    let corners = [point![-s, -s, -s], point![s, -s, -s], point![0.0, s, -s], point![0.0, 0.0, s]];
    let [a, b, c, _] = corners;
    Some(match kind {
        0 => ColliderBuilder::cuboid(s, s * 0.5, s),
        1 => ColliderBuilder::ball(s),
        2 => ColliderBuilder::round_cuboid(s, s * 0.5, s, s * 0.1),
        3 => ColliderBuilder::capsule_x(s, s * 0.3),
        4 => ColliderBuilder::capsule_z(s, s * 0.3),
        5 => ColliderBuilder::cylinder(s, s * 0.5),
        6 => ColliderBuilder::round_cylinder(s, s * 0.5, s * 0.1),
        7 => ColliderBuilder::cone(s, s * 0.5),
        8 => ColliderBuilder::round_cone(s, s * 0.5, s * 0.1),
        9 => ColliderBuilder::segment(a, b),
        10 => ColliderBuilder::triangle(a, b, c),
        11 => ColliderBuilder::round_triangle(a, b, c, s * 0.1),
        12 => compound(s, choices),
        13 => ColliderBuilder::polyline(points(s, choices), None),
        14 => voxels(s, choices),
        15 => heights(s, choices),
        16 => mesh(points(s, choices), choices)?,
        17 => ColliderBuilder::convex_hull(&points(s, choices))?,
        18 => ColliderBuilder::round_convex_hull(&points(s, choices), s * 0.1)?,
        19 => ColliderBuilder::convex_mesh(corners.to_vec(), &TETRAHEDRON)?,
        20 => ColliderBuilder::round_convex_mesh(corners.to_vec(), &TETRAHEDRON, s * 0.1)?,
        _ => ColliderBuilder::halfspace(vector![some_real(choices), 1.0, 0.0]),
    })
}

const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

fn points(s: Real, choices: &mut Choices<'_>) -> Vec<Vector> {
    let size = 2.0 * f64::from(s);
    let count = 4 + choices.below(5);
    let mut number = || within(choices, -size, size);
    (0..count).map(|_| point![number(), number(), number()]).collect()
}

fn mesh(points: Vec<Vector>, choices: &mut Choices<'_>) -> Option<ColliderBuilder> {
    let flags = TriMeshFlags::from_bits_truncate(choices.below(256) as u16);
    ColliderBuilder::trimesh_with_flags(points, TETRAHEDRON.to_vec(), flags).ok()
}

fn heights(s: Real, choices: &mut Choices<'_>) -> ColliderBuilder {
    let (rows, columns) = (choices.below(3) + 2, choices.below(3) + 2);
    let heights = (0..rows * columns).map(|_| within(choices, -0.5, 0.5)).collect();
    ColliderBuilder::heightfield(Array2::new(rows, columns, heights), Vector::splat(6.0 * s))
}

fn compound(s: Real, choices: &mut Choices<'_>) -> ColliderBuilder {
    let count = choices.below(3) + 1;
    let parts = (0..count).map(|k| {
        let at = Pose::translation(s * k as Real, within(choices, -1.0, 1.0), 0.0);
        let part = choices.pick(&[SharedShape::cuboid(s, s * 0.5, s), SharedShape::ball(s)]);
        (at, part)
    });
    ColliderBuilder::compound(parts.collect())
}

fn voxels(s: Real, choices: &mut Choices<'_>) -> ColliderBuilder {
    let count = choices.below(9) + 1;
    let mut number = || choices.below(3) as Int;
    let cells = (0..count).map(|_| [number(), number(), number()].into());
    ColliderBuilder::voxels(Vector::splat(s), &cells.collect::<Vec<_>>())
}

/// Returns a joint of some kind, without limits and motors.
pub fn joint(choices: &mut Choices<'_>) -> GenericJoint {
    let axis = choices.pick(&[Vector::X, Vector::Y, Vector::Z, vector![0.6, 0.0, 0.8]]);
    let reach = some_real(choices);
    match choices.below(8) {
        0 => RevoluteJointBuilder::new(axis).build().into(),
        1 => FixedJointBuilder::new().build().into(),
        2 => PrismaticJointBuilder::new(axis).build().into(),
        3 => SphericalJointBuilder::new().build().into(),
        4 => SphericalJointBuilder::new().swing_limit(reach).build().into(),
        5 => RopeJointBuilder::new(reach).build().into(),
        6 => SpringJointBuilder::new(Vector::ZERO, axis, reach, some_real(choices)).build().into(),
        _ => {
            let mask = JointAxesMask::from_bits_truncate(choices.below(64) as u8);
            let coupled = JointAxesMask::from_bits_truncate(choices.below(64) as u8);
            GenericJointBuilder::new(mask).coupled_axes(coupled).build()
        }
    }
}

/// Returns the angular velocity of a cast shape.
pub fn spin(choices: &mut Choices<'_>) -> AngVector {
    some_vector(choices, 2.0)
}

/// Vehicle of the world, after its creation.
pub type Vehicle = Option<DynamicRayCastVehicleController>;
