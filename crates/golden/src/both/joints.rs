//! Joints of all kinds between bodies, and multibodies.

use super::super::dim::{cuboid, joints, link_joints, vec};
use super::super::rapier::prelude::*;
use super::{Act, undisturbed};

/// Chains of impulse joints of all kinds that hang, swing, and break, and a loop of them.
pub fn impulse_joints(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(30.0, 0.5, 10.0), None);
    let kinds = joints(vec(0.3, 0.0, 0.0), vec(-0.3, 0.05, 0.0));
    for (k, joint) in kinds.iter().enumerate() {
        let hook = vec(3.0 * k as Real - 9.0, 5.0, 0.0);
        let mut last = world.insert_body(RigidBodyBuilder::fixed().translation(hook));
        for link in 0..6_u8 {
            let at = hook + vec(0.6 * Real::from(link + 1), 0.05, 0.02 * Real::from(link));
            let body = RigidBodyBuilder::dynamic().translation(at).linvel(vec(0.0, 0.0, 1.0));
            let (next, _) = world.insert(body, cuboid(0.2, 0.1, 0.1));
            let mut joint = *joint;
            if k % 2 == 1 {
                joint.set_break_thresholds(25.0 + 5.0 * k as Real, Real::INFINITY);
            }
            world.insert_impulse_joint(last, next, joint);
            last = next;
        }
        if k == 0 {
            let end = world
                .insert_body(RigidBodyBuilder::fixed().translation(hook + vec(2.0, -1.0, 0.0)));
            world.insert_impulse_joint(last, end, *joint);
        }
    }
    undisturbed()
}

/// Multibodies of joints of all kinds that fall onto a floor, and onto each other.
pub fn trees(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(30.0, 0.5, 10.0).friction(0.7), None);
    let kinds = link_joints(vec(0.3, 0.0, 0.0), vec(-0.3, 0.0, 0.0));
    for tree in 0..6_usize {
        let root = vec(1.5 * tree as Real - 4.0, 2.0 + 0.5 * tree as Real, 0.1 * tree as Real);
        let body = RigidBodyBuilder::dynamic().translation(root);
        let (root_body, _) = world.insert(body, ColliderBuilder::ball(0.2));
        let mut bodies = vec![(root_body, root)];
        for link in 0..7_usize {
            let (parent, place) = bodies[link / 2];
            let at = place + vec(0.6, 0.0, 0.0);
            let body = RigidBodyBuilder::dynamic().translation(at).linvel(vec(0.0, -1.0, 0.5));
            let (child, _) =
                world.insert(body, ColliderBuilder::capsule_x(0.15, 0.1).restitution(0.3));
            world.insert_multibody_joint(parent, child, kinds[(tree + link) % kinds.len()]);
            bodies.push((child, at));
        }
    }
    undisturbed()
}
