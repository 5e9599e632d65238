//! Ragdolls: limbs on ball joints and hinges with the limits of human joints.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, add_fixed};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "ragdoll_stairs",
    description: "Ragdolls tumble down stairs: shoulders, hips and necks swing and twist as far as those of people, elbows and knees bend one way.",
    category: Category::Stress,
    steps: 110,
    law: Law { overlap_max: 0.02, height_min: 0.0, reach_max: 10.0, gap_max: 0.02, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of stairs, and their length and height.
const STEPS: usize = 12;
const TREAD: Real = 0.55;
const RISE: Real = 0.4;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let height = STEPS as Real * RISE;
    for i in 0..STEPS {
        let top = height - i as Real * RISE;
        let half = Vector::new(0.5 * TREAD, 0.5 * top, 2.5);
        let place = Vector::new((i as Real + 0.5) * TREAD, 0.5 * top, 0.0);
        add_fixed(&mut world, place, ColliderBuilder::cuboid(half.x, half.y, half.z));
    }
    let landing = ColliderBuilder::cuboid(1.5, 0.5 * height, 2.5);
    add_fixed(&mut world, Vector::new(-1.5, 0.5 * height, 0.0), landing);
    let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0);
    add_fixed(&mut world, -Vector::Y, floor);
    for (i, z) in [-1.5, 0.0, 1.5].into_iter().enumerate() {
        let place = Vector::new(1.2 * i as Real, height + 1.2 - 0.5 * i as Real, z);
        let doll = add_ragdoll(&mut world, place);
        for body in doll {
            let push = Vector::new(3.2, 0.5, 0.2 * (i as Real - 1.0));
            world.bodies[body].set_linvel(push, true);
        }
    }
    Scene::new(world, View::orbit(55.0, 16.0))
        .focusing(Vector::new(-1.0, 0.0, -2.0), Vector::new(9.0, 5.0, 2.0))
}

/// Limb: a capsule along y, with half its length.
struct Limb {
    body: RigidBodyHandle,
    reach: Real,
}

impl Limb {
    fn new(world: &mut PhysicsWorld, middle: Vector, reach: Real, radius: Real) -> Self {
        let body = add(world, middle, ColliderBuilder::capsule_y(reach - radius, radius));
        Self { body, reach }
    }

    fn top(&self) -> Vector {
        Vector::Y * self.reach
    }
}

/// Returns a frame with its X axis, the twist axis, along a limb's direction.
fn along(place: Vector, direction: Vector) -> Pose {
    Pose::from_parts(place, Rotation::from_rotation_arc(Vector::X, direction))
}

/// Adds an upright ragdoll that faces along x, with the hips at a place.
fn add_ragdoll(world: &mut PhysicsWorld, hips: Vector) -> Vec<RigidBodyHandle> {
    let shape = ColliderBuilder::cuboid(0.14, 0.28, 0.2);
    let chest = add(world, hips + Vector::Y * 0.3, shape);
    let head = add(world, hips + Vector::Y * 0.78, ColliderBuilder::ball(0.14));
    let neck = [Vector::Y * 0.3, Vector::Y * -0.18];
    socket(world, [chest, head], neck, Vector::Y, [0.6, 0.8]);
    let mut bodies = vec![chest, head];
    for side in [-1.0, 1.0] {
        let shoulder = Vector::new(0.0, 0.22, side * 0.28);
        let hip = Vector::new(0.0, -0.3, side * 0.11);
        let upper = (0.17, 0.06, 1.4, 0.0);
        let thigh = (0.24, 0.08, 0.9, 0.35);
        for (root, (reach, radius, swing, lean), bend) in
            [(shoulder, upper, [0.0, 2.4]), (hip, thigh, [-2.4, 0.0])]
        {
            let from = hips + Vector::Y * 0.3 + root;
            let near = Limb::new(world, from - Vector::Y * reach, reach, radius);
            let middle = from - Vector::Y * (3.0 * reach);
            let far = Limb::new(world, middle, reach, 0.85 * radius);
            // The middle of the swing leans forwards, because hips bend more in that direction.
            let direction = Vector::new(lean, -1.0, 0.0).normalize();
            socket_leaning(world, (chest, root), &near, direction, swing);
            let hinge = RevoluteJointBuilder::new(Vector::Z)
                .local_anchor1(-near.top())
                .local_anchor2(far.top())
                .limits(bend)
                .motor_velocity(0.0, 3.0)
                .contacts_enabled(false);
            world.insert_impulse_joint(near.body, far.body, hinge);
            bodies.extend([near.body, far.body]);
        }
    }
    bodies
}

/// Returns a ball joint with a cone for the swing and a range for the twist.
fn socket(
    world: &mut PhysicsWorld,
    [body1, body2]: [RigidBodyHandle; 2],
    [anchor1, anchor2]: [Vector; 2],
    direction: Vector,
    [swing, twist]: [Real; 2],
) {
    let joint = SphericalJointBuilder::new()
        .local_frame1(along(anchor1, direction))
        .local_frame2(along(anchor2, direction))
        .swing_limit(swing)
        .limits(JointAxis::AngX, [-twist, twist])
        .contacts_enabled(false);
    world.insert_impulse_joint(body1, body2, damped(joint));
}

/// Returns the same for a limb that hangs down, with its cone about a direction.
fn socket_leaning(
    world: &mut PhysicsWorld,
    (body, anchor): (RigidBodyHandle, Vector),
    limb: &Limb,
    direction: Vector,
    swing: Real,
) {
    let joint = SphericalJointBuilder::new()
        .local_frame1(along(anchor, direction))
        .local_frame2(along(limb.top(), -Vector::Y))
        .swing_limit(swing)
        .limits(JointAxis::AngX, [-0.25 * HALF_TURN, 0.25 * HALF_TURN])
        .contacts_enabled(false);
    world.insert_impulse_joint(body, limb.body, damped(joint));
}

/// Returns the joint with damping.
fn damped(joint: SphericalJointBuilder) -> SphericalJointBuilder {
    [JointAxis::AngX, JointAxis::AngY, JointAxis::AngZ]
        .into_iter()
        .fold(joint, |joint, axis| joint.motor_velocity(axis, 0.0, 3.0))
}
