//! Two hundred ragdolls fall into a pit.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add_walls, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "ragdolls",
    description: "200 ragdolls of 11 bodies each fall into a heap; cones and limits bound their joints.",
    category: Category::Joints,
    steps: 300,
    law: Law { overlap_max: 0.1, height_min: 0.0, reach_max: 8.0, gap_max: 0.05, ..Law::NONE },
    source: file!(),
    build,
};

/// Ragdolls along each side of a layer, and layers.
const SIDE: usize = 5;
const LAYERS: usize = 8;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(20.0);
    add_walls(&mut world, 5.0, 4.0);
    let mut dice = Dice::new(11);
    for k in 0..LAYERS * SIDE * SIDE {
        let (layer, x, z) = (k / (SIDE * SIDE), k / SIDE % SIDE, k % SIDE);
        let along = |n: usize| 1.8 * (n as Real - 0.5 * (SIDE - 1) as Real);
        let place = Vector::new(along(x), 2.0 + 2.0 * layer as Real, along(z));
        let axis = Vector::new(dice.between(-1.0, 1.0), 1.0, dice.between(-1.0, 1.0)).normalize();
        let turn = axis * dice.between(0.0, 2.0 * HALF_TURN);
        add_ragdoll(&mut world, Pose::new(place, turn), axis * 4.0);
    }
    // The view is steep enough to show all of the 10 m pit behind the 4 m wall.
    Scene::new(world, View::orbit(25.0, 62.0))
}

/// Adds a ragdoll with its pelvis at a pose and an angular velocity.
pub(super) fn add_ragdoll(world: &mut PhysicsWorld, at: Pose, spin: AngVector) {
    Ragdoll { world, at, spin }.build();
}

/// Ragdoll under construction, upright with its arms spread.
struct Ragdoll<'w> {
    world: &'w mut PhysicsWorld,
    /// Pose of its pelvis.
    at: Pose,
    spin: AngVector,
}

/// A limb, and its middle in the frame of the standing ragdoll.
#[derive(Copy, Clone)]
struct Limb {
    body: RigidBodyHandle,
    middle: Vector,
}

impl Ragdoll<'_> {
    fn build(&mut self) {
        let pelvis = self.limb(Vector::new(-0.06, 0.0, 0.0), Vector::new(0.06, 0.0, 0.0), 0.12);
        let chest = self.limb(Vector::new(-0.08, 0.34, 0.0), Vector::new(0.08, 0.34, 0.0), 0.15);
        let head = self.limb(Vector::new(0.0, 0.62, 0.0), Vector::new(0.0, 0.68, 0.0), 0.11);
        self.socket(pelvis, chest, Vector::new(0.0, 0.16, 0.0), Vector::Y, 0.5, 0.4);
        self.socket(chest, head, Vector::new(0.0, 0.50, 0.0), Vector::Y, 0.6, 0.7);
        for side in [-1.0, 1.0] {
            let out = Vector::X * side;
            let [shoulder, elbow, hand] =
                [0.24, 0.52, 0.78].map(|x| Vector::new(side * x, 0.42, 0.0));
            let upper = self.limb(shoulder + out * 0.05, elbow - out * 0.05, 0.05);
            let lower = self.limb(elbow + out * 0.04, hand, 0.04);
            self.socket(chest, upper, shoulder, out, 1.4, 0.7);
            self.hinge(upper, lower, elbow, -Vector::Y * side);

            let [hip, knee, foot] = [-0.10, -0.52, -0.94].map(|y| Vector::new(side * 0.10, y, 0.0));
            let thigh = self.limb(hip - Vector::Y * 0.08, knee + Vector::Y * 0.07, 0.075);
            let shin = self.limb(knee - Vector::Y * 0.06, foot, 0.055);
            self.socket(pelvis, thigh, hip, -Vector::Y, 1.0, 0.4);
            self.hinge(thigh, shin, knee, Vector::X);
        }
    }

    /// Adds a capsule between two points of the standing ragdoll, as a body with its origin in the middle.
    fn limb(&mut self, from: Vector, to: Vector, radius: Real) -> Limb {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let body = RigidBodyBuilder::dynamic()
            .pose(self.at * Pose::from_translation(middle))
            .angvel(self.spin);
        let capsule = ColliderBuilder::capsule_from_endpoints(-half, half, radius);
        let (body, _) = self.world.insert(body, capsule.density(1000.0).friction(0.6));
        Limb { body, middle }
    }

    /// Adds a ball joint with a cone about the direction of the second limb, and a range of twist to either
    /// side.
    fn socket(
        &mut self,
        first: Limb,
        second: Limb,
        at: Vector,
        way: Vector,
        cone: Real,
        twist: Real,
    ) {
        let turn = Rotation::from_rotation_arc(Vector::X, way);
        let joint = SphericalJointBuilder::new()
            .local_frame1(Pose::from_parts(at - first.middle, turn))
            .local_frame2(Pose::from_parts(at - second.middle, turn))
            .swing_limit(cone)
            .limits(JointAxis::AngX, [-twist, twist])
            .contacts_enabled(false);
        self.world.insert_impulse_joint(first.body, second.body, joint);
    }

    /// Adds a knee or an elbow, which bends in one direction only.
    fn hinge(&mut self, first: Limb, second: Limb, at: Vector, axis: Vector) {
        let joint = RevoluteJointBuilder::new(axis)
            .local_anchor1(at - first.middle)
            .local_anchor2(at - second.middle)
            .limits([0.0, 2.4])
            .contacts_enabled(false);
        self.world.insert_impulse_joint(first.body, second.body, joint);
    }
}
