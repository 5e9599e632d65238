//! Every joint, each with what it leaves free.

use crate::common::{Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, add_post, hinge};
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
    ("revolute", revolute),
    ("prismatic", prismatic),
    ("spherical", spherical),
    ("rope", rope),
    ("spring", spring),
    ("piston", piston),
    ("universal", universal),
];
/// Posts in a row, and from one to the next.
const IN_ROW: usize = 4;
const ACROSS: Real = 4.0;
const UP: Real = 4.2;
/// Half extents of what hangs.
const HALF: Vector = Vector::new(0.2, 0.6, 0.3);
/// From the post to its middle.
const DOWN: Vector = Vector::new(0.0, -1.1, 0.0);
/// Steps from one push to the next, and the velocity that it gives.
const REST: usize = 120;
const PUSH: Vector = Vector::new(2.0, 0.0, 2.4);

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let (mut hung, mut labels) = (Vec::new(), Vec::new());
    for (i, (name, stand)) in STANDS.into_iter().enumerate() {
        let (column, row) = ((i % IN_ROW) as Real, (i / IN_ROW) as Real);
        let place = Vector::new(ACROSS * column, -UP * row, 0.0);
        let post = add_post(&mut world, place);
        hung.push(stand(&mut world, post));
        labels.push((place + Vector::Y * 0.75, name));
    }
    let view = View::orbit(-14.0, 9.0);
    let scene = Scene::new(world, view)
        .showing_joints(0.6)
        .focusing(Vector::new(-1.0, -UP - 2.2, 0.0), Vector::new(3.0 * ACROSS + 1.0, 1.6, 0.0));
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
    let body = add(world, place, ColliderBuilder::cuboid(HALF.x, HALF.y, HALF.z));
    world.impulse_joints.insert(post, body, joint, true);
    body
}

fn fixed(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let beside = Vector::new(1.0, 0.0, 0.0);
    hang(world, post, beside, FixedJointBuilder::new().local_anchor2(-beside))
}

fn revolute(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    hang(world, post, DOWN, hinge().local_anchor2(-DOWN).limits([-0.8, 0.8]))
}

fn prismatic(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let slope = Vector::new(1.0, -0.15, 0.0);
    let joint = PrismaticJointBuilder::new(slope).local_anchor2(-DOWN).limits([-1.2, 1.2]);
    hang(world, post, DOWN, joint)
}

/// A frame whose X axis, the axis of the twist, points down.
fn downwards(place: Vector) -> Pose {
    Pose::from_parts(place, Rotation::from_rotation_z(-0.5 * HALF_TURN))
}

fn spherical(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = SphericalJointBuilder::new()
        .local_frame1(downwards(Vector::ZERO))
        .local_frame2(downwards(-DOWN))
        .swing_limit(0.7)
        .limits(JointAxis::AngX, [-0.4, 0.4]);
    hang(world, post, DOWN, joint)
}

fn rope(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = RopeJointBuilder::new(1.4).local_anchor2(Vector::Y * HALF.y);
    hang(world, post, Vector::new(0.5, -1.5, 0.0), joint)
}

fn spring(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = SpringJointBuilder::new(Vector::ZERO, Vector::Y * HALF.y, 0.8, 25.0).damping(0.3);
    hang(world, post, DOWN * 1.5, joint)
}

/// Slides along an axis, carried by a spring, and turns about it.
fn piston(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let (slide, spin) = (JointAxesMask::LIN_X, JointAxesMask::ANG_X);
    let joint = GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES - slide - spin)
        .local_frame1(downwards(Vector::ZERO))
        .local_frame2(downwards(Vector::ZERO))
        .limits(JointAxis::LinX, [0.8, 1.8])
        .motor_position(JointAxis::LinX, 1.0, 60.0, 1.0);
    hang(world, post, DOWN, joint)
}

/// Swings to all sides, but has no twist.
fn universal(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let swing = JointAxesMask::ANG_Y | JointAxesMask::ANG_Z;
    let joint = GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES - swing)
        .local_frame1(downwards(Vector::ZERO))
        .local_frame2(downwards(-DOWN))
        .limits(JointAxis::AngY, [-0.5, 0.5])
        .limits(JointAxis::AngZ, [-1.0, 1.0]);
    hang(world, post, DOWN, joint)
}
