//! Every joint with its free axes.

use crate::common::{Law, Scene, SceneInfo, stands};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "joints",
    description: "Every joint, with its free axes as far as their limits reach; all are pushed every two seconds.",
    category: Category::Joints,
    steps: 150,
    law: Law { overlap_max: 0.01, height_min: -7.0, reach_max: 15.0, gap_max: 2.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Exhibits of the scene.
const STANDS: [(&str, stands::Stand); 8] = [
    ("fixed", stands::fixed),
    ("soft", soft),
    ("revolute", stands::revolute),
    ("prismatic", stands::prismatic),
    ("pin slot", pin_slot),
    ("rope", stands::rope),
    ("spring", stands::spring),
    ("table", table),
];

/// Builds the scene.
pub fn build() -> Scene {
    stands::show(&STANDS, View::flat())
}

/// Joins a body by a soft fixed joint.
fn soft(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let beside = Vector::X;
    let spring = SpringCoefficients::new(1.5, 0.1);
    let joint = FixedJointBuilder::new().local_anchor2(-beside).softness(Some(spring));
    stands::hang(world, post, beside, joint)
}

/// Joins a body that slides along a slot and rotates in it.
fn pin_slot(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let slot = Vector::new(1.0, 0.15);
    let joint = PinSlotJointBuilder::new(slot).local_anchor2(-stands::down()).limits([-1.2, 1.2]);
    stands::hang(world, post, stands::down(), joint)
}

/// Joins a body that slides along both axes within limits, on springs, with locked rotation.
fn table(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = GenericJointBuilder::new(JointAxesMask::ANG_X)
        .limits(JointAxis::LinX, [-1.0, 1.0])
        .limits(JointAxis::LinY, [-1.5, 0.5])
        .motor_position(JointAxis::LinX, 0.0, 20.0, 0.5)
        .motor_position(JointAxis::LinY, 0.0, 20.0, 0.5);
    stands::hang(world, post, stands::down(), joint)
}
