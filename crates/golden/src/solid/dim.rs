//! Names of 3D for the shared scenes.

use super::rapier::control::*;
use super::rapier::parry::utils::Array2;
use super::rapier::prelude::*;

/// Boxes of the timed pile along each axis.
pub const PILE: [usize; 3] = [10, 10, 10];

/// A vector.
pub fn vec(x: Real, y: Real, z: Real) -> Vector {
    Vector::new(x, y, z)
}

/// A rotation vector or angular velocity.
pub fn about(x: Real, y: Real, z: Real) -> AngVector {
    AngVector::new(x, y, z)
}

/// A box.
pub fn cuboid(hx: Real, hy: Real, hz: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(hx, hy, hz)
}

/// Walls in front and behind, at this distance from the origin.
pub fn enclose(world: &mut PhysicsWorld, half: Real) {
    for side in [-1.0, 1.0] {
        let wall = ColliderBuilder::cuboid(half, 4.0, 0.3);
        world.insert_collider(wall.translation(Vector::new(0.0, 4.0, half * side)), None);
    }
}

/// One shape of each kind, of about half a unit.
pub fn shapes() -> Vec<ColliderBuilder> {
    let cloud: Vec<Vector> = (0..20).map(|k| corner(k, 0.4)).collect();
    let piece =
        |x| (Pose::from_translation(Vector::new(x, 0.1, 0.0)), SharedShape::cuboid(0.25, 0.2, 0.2));
    let mut shapes = vec![
        ColliderBuilder::ball(0.3),
        ColliderBuilder::cuboid(0.4, 0.25, 0.3),
        ColliderBuilder::capsule_z(0.25, 0.2),
        ColliderBuilder::cylinder(0.3, 0.25),
        ColliderBuilder::cone(0.35, 0.3),
        ColliderBuilder::round_cuboid(0.25, 0.2, 0.2, 0.05),
        ColliderBuilder::round_cylinder(0.25, 0.25, 0.05),
        ColliderBuilder::round_cone(0.3, 0.25, 0.05),
        ColliderBuilder::compound(vec![piece(-0.3), piece(0.3)]),
    ];
    shapes.extend(ColliderBuilder::convex_hull(&cloud));
    shapes.extend(ColliderBuilder::round_convex_hull(&cloud, 0.05));
    shapes.push(ColliderBuilder::convex_decomposition(&NOTCHED, &NOTCHED_FACES));
    shapes
}

/// A corner of an irregular body around the origin.
fn corner(k: usize, size: Real) -> Vector {
    let k = k as Real;
    let turn = Rotation::from_scaled_axis(Vector::new(0.9 * k, 0.4 * k, 1.7));
    turn * Vector::new(size * (1.0 - 0.1 * (k % 3.0)), 0.0, 0.0)
}

/// A prism whose cross-section has a notch.
const NOTCHED: [Vector; 10] = {
    let outline = [(-0.4, -0.3), (0.4, -0.3), (0.4, 0.3), (0.0, 0.0), (-0.4, 0.3)];
    let mut corners = [Vector::ZERO; 10];
    let mut k = 0;
    while k < 10 {
        let (x, y) = outline[k % 5];
        corners[k] = Vector::new(x, y, if k < 5 { -0.2 } else { 0.2 });
        k += 1;
    }
    corners
};
const NOTCHED_FACES: [[u32; 3]; 16] = [
    [0, 3, 1],
    [1, 3, 2],
    [0, 4, 3],
    [5, 6, 8],
    [6, 7, 8],
    [5, 8, 9],
    [0, 1, 6],
    [0, 6, 5],
    [1, 2, 7],
    [1, 7, 6],
    [2, 3, 8],
    [2, 8, 7],
    [3, 4, 9],
    [3, 9, 8],
    [4, 0, 5],
    [4, 5, 9],
];

/// Grounds of several kinds, side by side.
pub fn grounds() -> Vec<ColliderBuilder> {
    let height = |k: usize| 0.3 * (k * k % 5) as Real;
    let heights = Array2::new(17, 17, (0..17 * 17).map(height).collect());
    let vertex = |k: usize| {
        vec((k % 9) as Real * 2.0 - 8.0, 0.2 * (k * 3 % 4) as Real, (k / 9) as Real * 2.0 - 8.0)
    };
    let vertices: Vec<Vector> = (0..81).map(vertex).collect();
    let cell = |k: u32| {
        let at = k / 8 * 9 + k % 8;
        [[at, at + 9, at + 1], [at + 1, at + 9, at + 10]]
    };
    let triangles: Vec<[u32; 3]> = (0..64).flat_map(cell).collect();
    let cells: Vec<IVector> =
        (0..1024).map(|k| IVector::new(k % 32 - 16, k % 3, k / 32 - 16)).collect();
    let mut grounds = vec![
        ColliderBuilder::heightfield(heights, vec(16.0, 1.0, 16.0)),
        ColliderBuilder::voxels(vec(0.5, 0.4, 0.5), &cells),
        ColliderBuilder::cuboid(8.0, 0.5, 8.0),
    ];
    grounds.extend(ColliderBuilder::trimesh(vertices, triangles));
    grounds
}

/// Joints of all kinds, with limits, motors and springs.
pub fn joints(anchor1: Vector, anchor2: Vector) -> Vec<GenericJoint> {
    let axis = vec(0.3, 0.2, 1.0).normalize();
    vec![
        RevoluteJointBuilder::new(Vector::Z)
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .build()
            .into(),
        RevoluteJointBuilder::new(axis)
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .limits([-0.5, 0.7])
            .motor_velocity(2.0, 0.5)
            .build()
            .into(),
        PrismaticJointBuilder::new(axis)
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .limits([-0.2, 0.3])
            .motor_position(0.2, 30.0, 2.0)
            .build()
            .into(),
        SphericalJointBuilder::new()
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .limits(JointAxis::AngX, [-0.4, 0.4])
            .motor_position(JointAxis::AngY, 0.3, 5.0, 0.5)
            .build()
            .into(),
        FixedJointBuilder::new().local_anchor1(anchor1).local_anchor2(anchor2).build().into(),
        SpringJointBuilder::new(anchor1, anchor2, 0.6, 40.0).damping(1.0).build().into(),
        RopeJointBuilder::new(0.8).local_anchor1(anchor1).local_anchor2(anchor2).build().into(),
    ]
}

/// Joints for the links of a multibody.
pub fn link_joints(anchor1: Vector, anchor2: Vector) -> Vec<GenericJoint> {
    joints(anchor1, anchor2).into_iter().take(4).collect()
}

/// Adds a vehicle, and returns the function that drives it.
pub fn drive(world: &mut PhysicsWorld) -> impl FnMut(&mut PhysicsWorld, usize) + use<> {
    let body = RigidBodyBuilder::dynamic().translation(vec(-6.0, 2.2, 0.0));
    let (chassis, _) = world.insert(body, ColliderBuilder::cuboid(1.0, 0.2, 0.5).mass(300.0));
    let mut vehicle = DynamicRayCastVehicleController::new(chassis);
    for (x, z) in [(0.7, -0.5), (0.7, 0.5), (-0.7, -0.5), (-0.7, 0.5)] {
        vehicle.add_wheel(
            vec(x, -0.1, z),
            -Vector::Y,
            Vector::Z,
            0.3,
            0.25,
            &WheelTuning::default(),
        );
    }
    move |world, step| {
        for (index, wheel) in vehicle.wheels_mut().iter_mut().enumerate() {
            wheel.engine_force = 200.0;
            wheel.steering = if index < 2 { 0.3 * ((step / 40 % 3) as Real - 1.0) } else { 0.0 };
        }
        let dt = world.integration_parameters.dt;
        let filter = QueryFilter::default().exclude_rigid_body(chassis);
        vehicle.update_vehicle(dt, world.query_pipeline_mut(filter));
    }
}
