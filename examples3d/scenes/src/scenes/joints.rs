//! Every joint with its free axes.

use crate::common::{Law, Scene, SceneInfo, stands};
use crate::kit::HALF_TURN;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "joints",
    description: "Every joint, with its free axes as far as their limits reach; all are pushed every two seconds.",
    category: Category::Joints,
    steps: 150,
    law: Law { overlap_max: 0.01, height_min: -6.0, reach_max: 15.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Exhibits of the scene.
const STANDS: [(&str, stands::Stand); 8] = [
    ("fixed", stands::fixed),
    ("revolute", stands::revolute),
    ("prismatic", stands::prismatic),
    ("spherical", spherical),
    ("rope", stands::rope),
    ("spring", stands::spring),
    ("piston", piston),
    ("universal", universal),
];

/// Builds the scene.
pub fn build() -> Scene {
    stands::show(&STANDS, View::orbit(-14.0, 9.0))
}

/// Returns a frame with its X axis, the twist axis, downwards.
fn downwards(place: Vector) -> Pose {
    Pose::from_parts(place, Rotation::from_rotation_z(-0.5 * HALF_TURN))
}

/// Joins a body by a ball joint with a cone for the swing and a small range of twist.
fn spherical(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = SphericalJointBuilder::new()
        .local_frame1(downwards(Vector::ZERO))
        .local_frame2(downwards(-stands::down()))
        .swing_limit(0.7)
        .limits(JointAxis::AngX, [-0.4, 0.4]);
    stands::hang(world, post, stands::down(), joint)
}

/// Joins a body that slides along an axis on a spring, and rotates about it.
fn piston(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let (slide, spin) = (JointAxesMask::LIN_X, JointAxesMask::ANG_X);
    let joint = GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES - slide - spin)
        .local_frame1(downwards(Vector::ZERO))
        .local_frame2(downwards(Vector::ZERO))
        .limits(JointAxis::LinX, [0.8, 1.8])
        .motor_position(JointAxis::LinX, 1.0, 60.0, 1.0);
    stands::hang(world, post, stands::down(), joint)
}

/// Joins a body by a joint with free swing and locked twist.
fn universal(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let swing = JointAxesMask::ANG_Y | JointAxesMask::ANG_Z;
    let joint = GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES - swing)
        .local_frame1(downwards(Vector::ZERO))
        .local_frame2(downwards(-stands::down()))
        .limits(JointAxis::AngY, [-0.5, 0.5])
        .limits(JointAxis::AngZ, [-1.0, 1.0]);
    stands::hang(world, post, stands::down(), joint)
}
