//! Ragdolls: limbs on hinges with the limits of human joints.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, hinge, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "ragdoll_stairs",
    description: "Ragdolls tumble down stairs: hinges with the limits of necks, shoulders, elbows, hips and knees.",
    category: Category::Stress,
    steps: 110,
    law: Law { overlap_max: 0.1, height_min: 0.0, gap_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of stairs, and their length and height.
const STEPS: usize = 12;
const TREAD: Real = 0.55;
const RISE: Real = 0.4;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(40.0);
    let height = STEPS as Real * RISE;
    for i in 0..STEPS {
        let top = height - i as Real * RISE;
        let place = Vector::new((i as Real + 0.5) * TREAD, 0.5 * top);
        add_fixed(&mut world, place, ColliderBuilder::cuboid(0.5 * TREAD, 0.5 * top));
    }
    let landing = ColliderBuilder::cuboid(3.0, 0.5 * height);
    add_fixed(&mut world, Vector::new(-3.0, 0.5 * height), landing);
    for i in 0..3 {
        let place = Vector::new(2.2 * i as Real, height + 1.2 - 0.6 * i as Real);
        for body in add_ragdoll(&mut world, place, Some(3.0)) {
            world.bodies[body].set_linvel(Vector::new(3.0, 1.0), true);
        }
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-4.0, -0.3), Vector::new(10.0, 6.2))
}

/// Adds an upright ragdoll that faces along x, with the hips at a place. Optional damping slows its joints
/// down.
pub(super) fn add_ragdoll(
    world: &mut PhysicsWorld,
    hips: Vector,
    muscles: Option<Real>,
) -> Vec<RigidBodyHandle> {
    let middle = hips + Vector::Y * 0.3;
    let chest = add(world, middle, ColliderBuilder::cuboid(0.14, 0.28));
    let head = add(world, hips + Vector::Y * 0.78, ColliderBuilder::ball(0.14));
    let neck = (Vector::Y * 0.3, Vector::Y * -0.18);
    join(world, (chest, neck.0), (head, neck.1), [-0.7, 0.5], muscles);
    let mut bodies = vec![chest, head];
    // By limb: its origin, half its length and its radius, the limits of its swing and of its bend.
    let arm = (Vector::Y * 0.22, 0.17, 0.06, [-1.2, 2.8], [0.0, 2.4]);
    let leg = (Vector::Y * -0.3, 0.24, 0.08, [-0.4, 1.8], [-2.4, 0.0]);
    for (root, reach, radius, swing, bend) in [arm, arm, leg, leg] {
        let shape = ColliderBuilder::capsule_y(reach - radius, radius);
        let near = add(world, middle + root - Vector::Y * reach, shape.clone());
        let far = add(world, middle + root - Vector::Y * (3.0 * reach), shape);
        let end = Vector::Y * reach;
        join(world, (chest, root), (near, end), swing, muscles);
        join(world, (near, -end), (far, end), bend, muscles);
        bodies.extend([near, far]);
    }
    // The limbs of one ragdoll do not collide, because they all overlap in the plane.
    for (k, &body) in bodies.iter().enumerate() {
        let doll = InteractionGroups::new(Group::GROUP_2, !Group::GROUP_2);
        let colliders = world.bodies[body].colliders().to_vec();
        for collider in colliders.into_iter().filter(|_| k > 1) {
            world.colliders[collider].set_collision_groups(doll);
        }
    }
    bodies
}

/// Joins two limbs by a hinge with limits and optional damping.
fn join(
    world: &mut PhysicsWorld,
    (body1, anchor1): (RigidBodyHandle, Vector),
    (body2, anchor2): (RigidBodyHandle, Vector),
    limits: [Real; 2],
    muscles: Option<Real>,
) {
    let joint = hinge().local_anchor1(anchor1).local_anchor2(anchor2).limits(limits);
    let joint = joint.contacts_enabled(false);
    let joint = match muscles {
        Some(damping) => joint.motor_velocity(0.0, damping),
        None => joint,
    };
    world.insert_impulse_joint(body1, body2, joint);
}
