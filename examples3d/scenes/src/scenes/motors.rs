//! Joint motors: they reach velocities and positions within their force limits.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, add_post, cube, hinge};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "motors",
    description: "Motors: a fan, servos stiff and soft, one that is too weak for its load, a lift, a ball joint that nods.",
    category: Category::Joints,
    steps: 200,
    law: Law { overlap_max: 0.01, height_min: -6.0, reach_max: 10.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Distance of neighbouring motors.
const ACROSS: Real = 4.2;
/// Number of steps per target.
const HOLD: usize = 100;
/// Half extents of an arm, and the distance from its hinge to its middle.
const HALF: Vector = Vector::new(0.7, 0.15, 0.15);
const ARM: Vector = Vector::new(0.8, 0.0, 0.0);

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let place =
        |column: usize, row: usize| Vector::new(ACROSS * column as Real, -4.0 * row as Real, 0.0);
    let (fan, _) = arm(&mut world, place(0, 0), hinge());
    let [stiff, soft, weak] = [(1, 0), (2, 0), (0, 1)].map(|(column, row)| {
        let (joint, tip) = arm(&mut world, place(column, row), hinge());
        (joint, tip)
    });
    let tip = world.bodies[weak.1].translation() + ARM;
    hang_weight(&mut world, weak.1, tip);
    let lift = add_lift(&mut world, place(1, 1));
    let ball = add_nodder(&mut world, place(2, 1));

    drive(&mut world, fan, |joint| {
        joint.set_motor_velocity(JointAxis::AngX, 6.0, 5.0);
    });
    let labels = ["velocity", "stiff servo", "soft servo", "too weak", "lift", "ball"];
    let places = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)];
    let scene = Scene::new(world, View::orbit(-14.0, 9.0))
        .showing_joints(0.5)
        .focusing(Vector::new(-1.5, -6.0, 0.0), Vector::new(2.0 * ACROSS + 1.5, 2.0, 0.0));
    let scene = labels.into_iter().zip(places).fold(scene, |scene, (text, (column, row))| {
        scene.label(place(column, row) + Vector::Y * 1.4, text)
    });
    scene.script(move |world, step| {
        let side = if (step / HOLD).is_multiple_of(2) { 1.0 } else { -1.0 };
        // Frequency √stiffness, critical damping 2 √stiffness.
        drive(world, stiff.0, |joint| {
            joint.set_motor_position(JointAxis::AngX, side, 900.0, 60.0);
        });
        drive(world, soft.0, |joint| {
            joint.set_motor_position(JointAxis::AngX, side, 60.0, 3.0);
        });
        drive(world, weak.0, |joint| {
            joint.set_motor_position(JointAxis::AngX, 1.0, 900.0, 60.0);
            joint.set_motor_max_force(JointAxis::AngX, 9.0);
        });
        drive(world, lift, |joint| {
            joint.set_motor_position(JointAxis::LinX, 0.8 * side, 200.0, 28.0);
        });
        for (axis, target) in [(JointAxis::AngX, 0.0), (JointAxis::AngY, 0.6 * side)] {
            drive(world, ball, |joint| {
                joint.set_motor_position(axis, target, 400.0, 40.0);
            });
        }
        drive(world, ball, |joint| {
            joint.set_motor_position(JointAxis::AngZ, -0.4 * side, 400.0, 40.0);
        });
    })
}

/// Changes the motor of a joint.
fn drive(world: &mut PhysicsWorld, joint: ImpulseJointHandle, change: impl Fn(&mut GenericJoint)) {
    if let Some(joint) = world.impulse_joints.get_mut(joint) {
        change(&mut joint.data);
    }
}

/// Adds an arm on a post.
fn arm(
    world: &mut PhysicsWorld,
    place: Vector,
    joint: RevoluteJointBuilder,
) -> (ImpulseJointHandle, RigidBodyHandle) {
    let post = add_post(world, place);
    let body = add(world, place + ARM, ColliderBuilder::cuboid(HALF.x, HALF.y, HALF.z));
    let joint = world.impulse_joints.insert(post, body, joint.local_anchor2(-ARM), true);
    (joint, body)
}

/// Hangs a weight on a rope from a body.
fn hang_weight(world: &mut PhysicsWorld, body: RigidBodyHandle, from: Vector) {
    let anchor = from - world.bodies[body].translation();
    let weight = add(world, from - Vector::Y * 0.8, cube(0.3).density(5.0));
    let rope = RopeJointBuilder::new(0.5).local_anchor1(anchor).local_anchor2(Vector::Y * 0.3);
    world.insert_impulse_joint(body, weight, rope);
}

/// Adds a platform that a motor moves up and down, with a box on it.
fn add_lift(world: &mut PhysicsWorld, place: Vector) -> ImpulseJointHandle {
    let shaft = ColliderBuilder::cuboid(0.1, 1.2, 0.1);
    let back = Vector::new(0.0, 0.0, -0.8);
    let post = add_fixed(world, place + back, shaft);
    let platform = add(world, place, ColliderBuilder::cuboid(0.9, 0.1, 0.6));
    add(world, place + Vector::Y * 0.5, cube(0.4));
    let joint = PrismaticJointBuilder::new(Vector::Y).local_anchor1(-back).limits([-1.0, 1.0]);
    world.insert_impulse_joint(post, platform, joint)
}

/// Adds a head on a ball joint.
fn add_nodder(world: &mut PhysicsWorld, place: Vector) -> ImpulseJointHandle {
    let post = add_post(world, place);
    let up = Vector::Y * 0.8;
    let head = add(world, place + up, cube(0.35));
    let nose = ColliderBuilder::ball(0.12).translation(Vector::Z * 0.4);
    world.insert_collider(nose, Some(head));
    world.insert_impulse_joint(post, head, SphericalJointBuilder::new().local_anchor2(-up))
}
