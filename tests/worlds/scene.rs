//! A small world with one object of every kind, and the compared state of worlds.

use crate::rapier::parry::shape::Cuboid;
use crate::rapier::prelude::*;

/// Returns a cube (3D) or square (2D).
pub fn cube(half_extent: Real) -> ColliderBuilder {
    ColliderBuilder::new(SharedShape::new(Cuboid::new(Vector::splat(half_extent))))
}

/// Returns a point in the plane of x and y.
pub fn at(x: Real, y: Real) -> Vector {
    Vector::X * x + Vector::Y * y
}

/// Returns a world with ground, a pile, sleeping bodies, a platform, a sensor, a pendulum, a chain of links,
/// a gear and composite shapes.
pub fn world() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    pile(&mut world);
    moved_and_sensed(&mut world);
    joined(&mut world);
    shapes(&mut world);
    world
}

fn pile(world: &mut PhysicsWorld) {
    for k in 0..4_u8 {
        let body = RigidBodyBuilder::dynamic().translation(at(0.0, 0.5 + 1.01 * Real::from(k)));
        world.insert(body, cube(0.5).active_events(ActiveEvents::all()));
        let body = RigidBodyBuilder::dynamic()
            .translation(at(1.05 + 0.1 * Real::from(k), 0.5 + 1.02 * Real::from(k)));
        world.insert(body, ColliderBuilder::ball(0.5).restitution(0.3));
    }
    let sleeper = RigidBodyBuilder::dynamic().translation(at(-20.0, 0.5)).sleeping(true);
    world.insert(sleeper, cube(0.5));
    let sleeper = RigidBodyBuilder::dynamic().translation(at(-20.0, 1.5)).sleeping(true);
    world.insert(sleeper, cube(0.5));
}

fn moved_and_sensed(world: &mut PhysicsWorld) {
    let platform = RigidBodyBuilder::kinematic_velocity_based().translation(at(6.0, 1.0));
    world.insert(platform.linvel(Vector::X * 0.5), cube(0.5));
    let rider = RigidBodyBuilder::dynamic().translation(at(6.0, 1.9));
    world.insert(rider, ColliderBuilder::capsule_x(0.3, 0.3));
    world.insert_collider(cube(2.0).sensor(true).active_events(ActiveEvents::all()), None);
    let off = RigidBodyBuilder::dynamic().translation(at(0.0, 9.0)).enabled(false);
    world.insert(off, ColliderBuilder::ball(0.3));
}

fn joined(world: &mut PhysicsWorld) {
    let hook = world.insert_body(RigidBodyBuilder::fixed().translation(at(12.0, 4.0)));
    let bob = RigidBodyBuilder::dynamic().translation(at(13.0, 4.0));
    let (bob, _) = world.insert(bob, ColliderBuilder::ball(0.3));
    let rod = RopeJointBuilder::new(1.0).build();
    world.insert_impulse_joint(hook, bob, rod);
    let (other, _) = world
        .insert(RigidBodyBuilder::dynamic().translation(at(14.0, 4.0)), ColliderBuilder::ball(0.3));
    world.insert_impulse_joint(bob, other, FixedJointBuilder::new().local_anchor2(-Vector::X));
    let mut last = world.insert_body(RigidBodyBuilder::fixed().translation(at(18.0, 5.0)));
    for k in 1..4_u8 {
        let link = RigidBodyBuilder::dynamic().translation(at(18.0 + Real::from(k), 5.0));
        let (link, _) = world.insert(link, ColliderBuilder::ball(0.2));
        let joint = GenericJointBuilder::new(JointAxesMask::LIN_AXES).local_anchor2(-Vector::X);
        world.insert_multibody_joint(last, link, joint);
        last = link;
    }
    geared(world);
}

/// Adds two sliders on a frame; the second one moves half as far as the first one.
fn geared(world: &mut PhysicsWorld) {
    let frame = world.insert_body(RigidBodyBuilder::fixed().translation(at(18.0, 8.0)));
    let [first, second] = [0.0, 2.0].map(|y| {
        let body = RigidBodyBuilder::dynamic().translation(at(18.0, 8.0 + y)).linvel(Vector::X);
        let (body, _) = world.insert(body, ColliderBuilder::ball(0.2));
        let joint = GenericJointBuilder::new(JointAxesMask::LOCKED_PRISMATIC_AXES);
        let joint = joint.local_anchor1(Vector::Y * y);
        world.insert_multibody_joint(frame, body, joint).expect("it joins two bodies")
    });
    let link = |world: &PhysicsWorld, joint| world.multibody_joints.get(joint).expect("it is").1;
    let (link1, link2) = (link(world, first), link(world, second));
    let (multibody, _) = world.multibody_joints.get_mut(first).expect("it is there");
    let axis = JointAxis::LinX;
    multibody.add_dof_coupling(link1, axis, link2, axis, 0.5, 0.0).expect("both can slide");
}

fn shapes(world: &mut PhysicsWorld) {
    let corners = [at(-1.0, 0.0), at(1.0, 0.0), at(0.0, 0.3)];
    let tip = Vector::splat(0.4);
    let vertices = [corners[0], corners[1], corners[2], tip].to_vec();
    let mesh = ColliderBuilder::trimesh(vertices.clone(), vec![[0, 1, 2], [1, 3, 2]]);
    let mesh = mesh.expect("it has triangles").translation(at(26.0, 0.2));
    world.insert_collider(mesh, None);
    let line = ColliderBuilder::polyline(vertices.clone(), None).translation(at(30.0, 0.2));
    world.insert_collider(line, None);
    let hull = ColliderBuilder::convex_hull(&[at(-0.4, 0.0), at(0.4, 0.0), at(0.0, 0.5), tip]);
    let parts = [-0.3, 0.3].map(|x| {
        let part = SharedShape::new(Cuboid::new(Vector::splat(0.2)));
        (Pose::from_translation(at(x, 0.0)), part)
    });
    let compound = ColliderBuilder::compound(parts.to_vec());
    for (x, shape) in [(26.0, hull), (30.0, Some(compound))] {
        let body = RigidBodyBuilder::dynamic().translation(at(x, 1.2));
        if let Some(shape) = shape {
            world.insert(body, shape);
        }
    }
}

/// Returns all numbers of all bodies.
pub fn bits(world: &PhysicsWorld) -> Vec<String> {
    let of = |(handle, body): (RigidBodyHandle, &RigidBody)| {
        let (pose, velocity) = (body.position(), body.vels());
        format!("{handle:?} {pose:?} {velocity:?} {:?}", body.activation())
    };
    world.bodies.iter().map(of).collect()
}

/// Returns a copy of the complete state.
pub fn copy(world: &PhysicsWorld) -> PhysicsWorld {
    world.clone()
}

/// Steps a world and checks that all numbers are finite, and that each awake body is listed once.
pub fn step(world: &mut PhysicsWorld) {
    world.step();
    for (handle, body) in world.bodies.iter() {
        let is_finite = body.position().is_finite() && body.vels().is_finite();
        assert!(is_finite, "{handle:?} is at {:?} and moves at {:?}", body.position(), body.vels());
    }
    let mut awake = world.active_bodies().to_vec();
    let count = awake.len();
    awake.sort_unstable();
    awake.dedup();
    assert_eq!(awake.len(), count, "each awake body is listed once");
}
