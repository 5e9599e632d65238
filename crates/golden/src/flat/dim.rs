//! Names of 2D for the shared scenes.

use super::rapier::prelude::*;

/// Boxes of the timed pile along each axis.
pub const PILE: [usize; 3] = [40, 25, 1];

/// A vector.
pub fn vec(x: Real, y: Real, _z: Real) -> Vector {
    Vector::new(x, y)
}

/// An angle or angular velocity.
pub fn about(_x: Real, _y: Real, z: Real) -> AngVector {
    z
}

/// A rectangle.
pub fn cuboid(hx: Real, hy: Real, _hz: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(hx, hy)
}

/// Does nothing: bodies cannot leave the plane.
pub fn enclose(_world: &mut PhysicsWorld, _half: Real) {}

/// One shape of each kind, of about half a unit.
pub fn shapes() -> Vec<ColliderBuilder> {
    let (a, b, c) = (Vector::new(-0.3, -0.2), Vector::new(0.4, -0.2), Vector::new(0.0, 0.4));
    let cloud: Vec<Vector> = (0..9).map(|k| corner(k, 0.4)).collect();
    let pieces = [-0.3, 0.3]
        .map(|x| (Pose::from_translation(Vector::new(x, 0.1)), SharedShape::cuboid(0.25, 0.2)));
    let mut shapes = vec![
        ColliderBuilder::ball(0.3),
        ColliderBuilder::cuboid(0.4, 0.25),
        ColliderBuilder::capsule_y(0.25, 0.2),
        ColliderBuilder::round_cuboid(0.25, 0.2, 0.05),
        ColliderBuilder::triangle(a, b, c),
        ColliderBuilder::round_triangle(a, b, c, 0.05),
        ColliderBuilder::compound(pieces.to_vec()),
    ];
    shapes.extend(ColliderBuilder::convex_hull(&cloud));
    shapes.extend(ColliderBuilder::round_convex_hull(&cloud, 0.05));
    shapes.push(ColliderBuilder::convex_decomposition(&STAR, &STAR_EDGES));
    shapes
}

/// A corner of an irregular figure around the origin.
fn corner(k: usize, size: Real) -> Vector {
    let angle = 0.7 * k as Real;
    Rotation::new(angle) * Vector::new(size * (1.0 - 0.05 * (k % 4) as Real), 0.0)
}

const STAR: [Vector; 6] = [
    Vector::new(-0.4, -0.3),
    Vector::new(0.0, -0.1),
    Vector::new(0.4, -0.3),
    Vector::new(0.15, 0.0),
    Vector::new(0.0, 0.45),
    Vector::new(-0.15, 0.0),
];
const STAR_EDGES: [[u32; 2]; 6] = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]];

/// Grounds of several kinds, side by side.
pub fn grounds() -> Vec<ColliderBuilder> {
    let heights: Vec<Real> = (0..17).map(|k| 0.3 * (k * k % 5) as Real).collect();
    let bumps: Vec<Vector> =
        (0..17).map(|k| Vector::new(k as Real - 8.0, 0.2 * (k * 3 % 4) as Real)).collect();
    let cells: Vec<IVector> = (0..32).map(|k| IVector::new(k - 16, k % 3)).collect();
    vec![
        ColliderBuilder::heightfield(heights, Vector::new(16.0, 1.0)),
        ColliderBuilder::polyline(bumps, None),
        ColliderBuilder::voxels(Vector::new(0.5, 0.4), &cells),
        ColliderBuilder::cuboid(8.0, 0.5),
    ]
}

/// Joints of all kinds, with limits, motors and springs.
pub fn joints(anchor1: Vector, anchor2: Vector) -> Vec<GenericJoint> {
    let slide = Rotation::new(0.4) * Vector::X;
    vec![
        RevoluteJointBuilder::new().local_anchor1(anchor1).local_anchor2(anchor2).build().into(),
        RevoluteJointBuilder::new()
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .limits([-0.5, 0.7])
            .motor_velocity(2.0, 0.5)
            .build()
            .into(),
        PrismaticJointBuilder::new(slide)
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .limits([-0.2, 0.3])
            .motor_position(0.2, 30.0, 2.0)
            .build()
            .into(),
        FixedJointBuilder::new().local_anchor1(anchor1).local_anchor2(anchor2).build().into(),
        SpringJointBuilder::new(anchor1, anchor2, 0.6, 40.0).damping(1.0).build().into(),
        RopeJointBuilder::new(0.8).local_anchor1(anchor1).local_anchor2(anchor2).build().into(),
    ]
}

/// Joints for the links of a multibody.
pub fn link_joints(anchor1: Vector, anchor2: Vector) -> Vec<GenericJoint> {
    joints(anchor1, anchor2).into_iter().take(3).collect()
}

/// There are no vehicles in 2D.
pub fn drive(_world: &mut PhysicsWorld) -> impl FnMut(&mut PhysicsWorld, usize) + use<> {
    |_, _| ()
}
