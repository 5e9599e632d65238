//! Every joint, each with what it leaves free.

use crate::common::{Scene, SceneInfo};
use crate::kit::{add, add_post, hinge};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// The scene's entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "joints",
    description: "Every joint, with its free axes as far as their limits reach; all are pushed every two seconds.",
    category: Category::Capability,
    steps: 150,
    build,
};

/// Joins something to a post, and returns it.
type Stand = fn(&mut PhysicsWorld, RigidBodyHandle) -> RigidBodyHandle;

const STANDS: [(&str, Stand); 8] = [
    ("fixed", fixed),
    ("soft", soft),
    ("revolute", revolute),
    ("prismatic", prismatic),
    ("pin slot", pin_slot),
    ("rope", rope),
    ("spring", spring),
    ("table", table),
];
/// Posts in a row, and from one to the next.
const IN_ROW: usize = 4;
const ACROSS: Real = 4.0;
const UP: Real = 4.0;
/// Half extents of what hangs.
const HALF: Vector = Vector::new(0.25, 0.6);
/// From the post to its middle.
const DOWN: Vector = Vector::new(0.0, -1.1);
/// Steps from one push to the next, and the velocity that it gives.
const REST: usize = 120;
const PUSH: Vector = Vector::new(3.0, 0.0);

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let (mut hung, mut labels) = (Vec::new(), Vec::new());
    for (i, (name, stand)) in STANDS.into_iter().enumerate() {
        let (column, row) = ((i % IN_ROW) as Real, (i / IN_ROW) as Real);
        let place = Vector::new(ACROSS * column, -UP * row);
        let post = add_post(&mut world, place);
        hung.push(stand(&mut world, post));
        labels.push((place + Vector::Y * 0.9, name));
    }
    let scene = Scene::new(world, View::flat())
        .showing_joints(0.6)
        .focusing(Vector::new(-1.5, -UP - 2.2), Vector::new(3.0 * ACROSS + 1.5, 1.6));
    let scene = labels.into_iter().fold(scene, |scene, (at, name)| scene.label(at, name));
    scene.script(move |world, step| {
        if step.is_multiple_of(REST) {
            for &body in &hung {
                let body = &mut world.bodies[body];
                // Off its middle, so that it turns, too.
                let (push, at) = (PUSH * body.mass(), body.translation() + HALF * 0.3);
                body.apply_impulse_at_point(push, at, true);
            }
        }
    })
}

/// Adds a body at a distance from a post, and joins it.
fn hang(
    world: &mut PhysicsWorld,
    post: RigidBodyHandle,
    offset: Vector,
    joint: impl Into<GenericJoint>,
) -> RigidBodyHandle {
    let place = world.bodies[post].translation() + offset;
    let body = add(world, place, ColliderBuilder::cuboid(HALF.x, HALF.y));
    world.impulse_joints.insert(post, body, joint, true);
    body
}

fn fixed(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let beside = Vector::new(1.0, 0.0);
    hang(world, post, beside, FixedJointBuilder::new().local_anchor2(-beside))
}

/// A fixed joint that gives way like a spring.
fn soft(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let beside = Vector::new(1.0, 0.0);
    let spring = SpringCoefficients::new(1.5, 0.1);
    let joint = FixedJointBuilder::new().local_anchor2(-beside).softness(Some(spring));
    hang(world, post, beside, joint)
}

fn revolute(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    hang(world, post, DOWN, hinge().local_anchor2(-DOWN).limits([-0.8, 0.8]))
}

fn prismatic(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let slope = Vector::new(1.0, -0.15);
    let joint = PrismaticJointBuilder::new(slope).local_anchor2(-DOWN).limits([-1.2, 1.2]);
    hang(world, post, DOWN, joint)
}

/// Slides along a slot, and turns in it.
fn pin_slot(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let slot = Vector::new(1.0, 0.15);
    let joint = PinSlotJointBuilder::new(slot).local_anchor2(-DOWN).limits([-1.2, 1.2]);
    hang(world, post, DOWN, joint)
}

fn rope(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = RopeJointBuilder::new(1.2).local_anchor2(Vector::Y * HALF.y);
    hang(world, post, Vector::new(0.5, -1.5), joint)
}

fn spring(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = SpringJointBuilder::new(Vector::ZERO, Vector::Y * HALF.y, 0.8, 15.0).damping(0.2);
    hang(world, post, DOWN * 1.3, joint)
}

/// Slides along both axes within limits, on springs, and does not turn.
fn table(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = GenericJointBuilder::new(JointAxesMask::ANG_X)
        .limits(JointAxis::LinX, [-1.0, 1.0])
        .limits(JointAxis::LinY, [-1.5, 0.5])
        .motor_position(JointAxis::LinX, 0.0, 20.0, 0.5)
        .motor_position(JointAxis::LinY, 0.0, 20.0, 0.5);
    hang(world, post, DOWN, joint)
}
