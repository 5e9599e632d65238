//! Edits between steps: joints are inserted and removed, bodies are pushed, moved and removed.

use super::stage::{chain, hang, momentum, slab};
use crate::dim::{about_z, hinge, vec, z_of};
use crate::suite::joints::stage::bob;
use crate::suite::physics::stage::{run, weightless, world};
use rapier::prelude::*;

fn links(world: &PhysicsWorld, joint: MultibodyJointHandle) -> Option<usize> {
    world.multibody_joints.get(joint).map(|(multibody, _)| multibody.num_links())
}

/// A detached part keeps its velocity, and the parts are separate multibodies.
#[test]
fn a_removed_joint_splits() {
    let mut world = weightless(60);
    let chain = chain(&mut world, None, 6);
    for &body in &chain.bodies {
        world.bodies[body].set_linvel(vec(0.3, 0.1), true);
    }
    run(&mut world, 0.5);
    let velocity = world.bodies[chain.bodies[4]].linvel();
    assert!(world.multibody_joints.remove(chain.joints[2], true).is_some());
    assert!(world.multibody_joints.remove(chain.joints[2], true).is_none(), "it is gone");
    assert_eq!(links(&world, chain.joints[0]), Some(3));
    assert_eq!(links(&world, chain.joints[4]), Some(3));
    assert_eq!(world.multibody_joints.multibodies().count(), 2);
    world.step();
    let after = world.bodies[chain.bodies[4]].linvel();
    assert!((velocity - after).length() < 1.0e-5);
    let (multibody, _) = world.multibody_joints.get(chain.joints[4]).expect("it is there");
    assert_eq!(multibody.root().expect("a root").rigid_body_handle(), chain.bodies[3]);
    assert_eq!(
        multibody.root().expect("a root").ndofs(),
        multibody.root().expect("a root").ndofs()
    );
    world.bodies[chain.bodies[0]].set_linvel(vec(-3.0, 0.0), true);
    run(&mut world, 0.5);
    let apart =
        world.bodies[chain.bodies[3]].translation() - world.bodies[chain.bodies[2]].translation();
    assert!(apart.length() > 1.2, "the parts go their ways");
}

/// The removal of a body removes its joints; the other links continue.
#[test]
fn a_removed_body_takes_its_joints_with_it() {
    let mut world = weightless(60);
    let chain = chain(&mut world, None, 5);
    run(&mut world, 0.1);
    world.remove_body(chain.bodies[2]);
    run(&mut world, 0.1);
    assert_eq!(world.multibody_joints.len(), 2);
    assert!(!world.multibody_joints.contains(chain.joints[1]));
    assert!(!world.multibody_joints.contains(chain.joints[2]));
    assert_eq!(links(&world, chain.joints[0]), Some(2));
    assert_eq!(links(&world, chain.joints[3]), Some(2));

    // The same happens before a step: a detection applies the removal, and the next step continues with the
    // remaining links.
    world.remove_body(chain.bodies[1]);
    world.detect_collisions(&(), &());
    run(&mut world, 0.1);
    assert_eq!(world.multibody_joints.len(), 1);
}

/// All joints of a multibody are removed at once.
#[test]
fn articulations_are_removed_together() {
    let mut world = weightless(60);
    let chain = chain(&mut world, None, 5);
    run(&mut world, 0.1);
    world.multibody_joints.remove_multibody_articulations(chain.joints[1], true);
    assert!(world.multibody_joints.is_empty());
    assert_eq!(world.multibody_joints.multibodies().count(), 0);
    world.bodies[chain.bodies[0]].set_linvel(vec(0.0, 1.0), true);
    run(&mut world, 0.5);
    assert!((world.bodies[chain.bodies[0]].translation().y - 0.5).abs() < 1.0e-4);
    assert!(world.bodies[chain.bodies[1]].translation().y.abs() < 1.0e-4);
}

/// Two chains are joined in flight: they become one multibody, and the momentum is constant.
#[test]
fn multibodies_merge() {
    let mut world = weightless(60);
    let first = chain(&mut world, None, 2);
    let second = [vec(2.5, 0.0), vec(3.5, 0.0)].map(|at| world.insert_body(slab(at)));
    let joint = || hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
    let inner = world.multibody_joints.insert(second[0], second[1], joint(), true).expect("fits");
    world.bodies[second[1]].set_linvel(vec(0.0, 2.0), true);
    run(&mut world, 1.0 / 60.0);
    let bodies = [first.bodies[0], first.bodies[1], second[0], second[1]];
    let before = momentum(&world, &bodies);
    let bridge = world.multibody_joints.insert(first.bodies[1], second[0], joint(), true);
    let bridge = bridge.expect("the second chain's root has no parent");
    assert_eq!((links(&world, inner), links(&world, bridge)), (Some(4), Some(4)));
    assert_eq!(world.multibody_joints.multibodies().count(), 1);
    run(&mut world, 1.0);
    let after = momentum(&world, &bodies);
    assert!((after - before).length() < 1.0e-3 * before.length(), "{after} instead of {before}");
    for pair in bodies.windows(2) {
        let [one, two] = [0, 1].map(|k| *world.bodies[pair[k]].position());
        let gap = one * vec(0.5, 0.0) - two * vec(-0.5, 0.0);
        assert!(gap.length() < 1.0e-4, "joints never come apart: {gap}");
    }
}

/// A body that the user rotates gives its joint a new coordinate, and its child links follow.
#[test]
fn a_body_that_was_moved_moves_its_joint() {
    let mut world = weightless(60);
    let (body, joint) = hang(&mut world, 1.0, 0.1, 0.0);
    let tip = world.insert_body(bob(1.0, 0.1).translation(vec(0.0, -2.0)));
    let next = hinge().local_anchor2(vec(0.0, 1.0));
    let next = world.multibody_joints.insert(body, tip, next, true).expect("it fits");
    run(&mut world, 0.1);
    let pose = Pose::from_parts(vec(1.0, 0.0), Rotation::from(RotationOf(0.5)));
    world.bodies[body].set_position(pose, true);
    world.step();
    let coordinate = |joint| {
        let link = world.multibody_joints.get_link(joint).expect("a link");
        link.joint().coords()[JointAxis::AngX as usize]
    };
    assert!((coordinate(joint) - 0.5).abs() < 1.0e-4, "{}", coordinate(joint));
    assert!(coordinate(next).abs() < 1.0e-4);
    let expected = vec((0.5 as Real).sin(), -(0.5 as Real).cos());
    assert!((world.bodies[body].translation() - expected).length() < 1.0e-4, "its anchor holds");
    assert!(
        (world.bodies[tip].translation() - expected * 2.0).length() < 1.0e-4,
        "the tip follows"
    );
}

/// Conversion of an angle to a rotation, which depends on the dimension.
struct RotationOf(Real);

impl From<RotationOf> for Rotation {
    fn from(RotationOf(angle): RotationOf) -> Self {
        *RigidBodyBuilder::dynamic().rotation(about_z(angle)).build().rotation()
    }
}

/// The user's forces and torques act on the whole: a torque on the second of two links in free flight rotates
/// both.
#[test]
fn forces_on_links_act_on_the_multibody() {
    let mut world = weightless(60);
    let chain = chain(&mut world, None, 3);
    world.bodies[chain.bodies[2]].add_force(vec(0.0, 0.4), true);
    run(&mut world, 0.5);
    let gained = momentum(&world, &chain.bodies);
    assert!((gained - vec(0.0, 0.2)).length() < 2.0e-4, "force times time, not {gained}");
    assert!(
        z_of(world.bodies[chain.bodies[0]].angvel()).abs() > 1.0e-3,
        "the first link moves, too"
    );
}

/// A root that becomes fixed stops the chain, and releases it again.
#[test]
fn roots_may_change_their_type() {
    let mut world = world(60);
    let chain = chain(&mut world, None, 3);
    let root = chain.bodies[0];
    world.bodies[root].set_body_type(RigidBodyType::Fixed, true);
    run(&mut world, 0.5);
    let at = world.bodies[root].translation();
    assert!((at - vec(0.5, 0.0)).length() < 1.0e-6, "it is fixed");
    assert!(world.bodies[chain.bodies[2]].translation().y < -0.3, "the others swing");
    world.bodies[root].set_body_type(RigidBodyType::Dynamic, true);
    run(&mut world, 0.5);
    assert!(world.bodies[root].translation().y < -0.5, "it falls");
}

/// A kinematic root moves the other links, and keeps them awake.
#[test]
fn kinematic_roots_carry() {
    let mut world = weightless(60);
    let cart = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(0.2, 0.0));
    let cart = world.insert_body(cart);
    let weld = FixedJointBuilder::new().local_anchor1(vec(0.0, 1.0));
    let rider = world.insert_body(bob(1.0, 0.1).translation(vec(0.0, 1.0)).can_sleep(true));
    world.multibody_joints.insert(cart, rider, weld, true).expect("it fits");
    run(&mut world, 3.0);
    assert!((world.bodies[rider].translation() - vec(0.6, 1.0)).length() < 1.0e-4);
    assert!((world.bodies[rider].linvel() - vec(0.2, 0.0)).length() < 1.0e-5);
}

/// Queries return the joints and the links of a body.
#[test]
fn joints_are_found_by_their_bodies() {
    let mut world = weightless(60);
    let chain = chain(&mut world, None, 4);
    let set = &world.multibody_joints;
    let link = set.rigid_body_link(chain.bodies[2]).expect("a link");
    assert_eq!(link.id, 2);
    let attached: Vec<_> = set.attached_joints(chain.bodies[1]).collect();
    let expected = [
        (chain.bodies[0], chain.bodies[1], chain.joints[0]),
        (chain.bodies[1], chain.bodies[2], chain.joints[1]),
    ];
    assert_eq!(attached, expected);
    let bodies: Vec<_> = set.attached_bodies(chain.bodies[1]).collect();
    assert_eq!(bodies, [chain.bodies[0], chain.bodies[2]]);
    let (handle, ..) = set.joint_between(chain.bodies[3], chain.bodies[2]).expect("a joint");
    assert_eq!(handle, chain.joints[2]);
    assert!(set.joint_between(chain.bodies[3], chain.bodies[0]).is_none());
    assert_eq!(set.iter().count(), 3);
    let (multibody, id) = set.get(chain.joints[2]).expect("it is there");
    assert_eq!(multibody.kinematic_branch(id), [0, 1, 2, 3]);
}
