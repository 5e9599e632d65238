//! Names that ported programs use.
//!
//! Programs for upstream's engine name the types of one dimension, read fields of joints and contacts, and
//! write `rapier3d::parry` and `rapier3d::glamx`. This file compiles if these names exist and mean the same.

use super::stage::{add_box, steps, world_with_ground};
use crate::dim::vec;
use rapier::prelude::*;
use std::cell::RefCell;
use std::sync::mpsc::channel;

/// The mathematics of both dimensions, in the precision of the crate.
#[test]
fn the_prelude_names_vectors_and_poses_of_both_dimensions() {
    let flat = Pose2::from_parts(Vec2::new(1.0, 2.0), Rot2::from_angle(0.5));
    let solid = Pose3::from_parts(Vec3::new(1.0, 2.0, 3.0), Rot3::from_rotation_z(0.5));
    let length: Real = flat.translation.length() + solid.translation.length();
    assert!(length > 5.0);
    assert_eq!(IVector::ONE.to_lattice().len(), DIM);
    let same: rapier::glamx::Vec2 = rapier::parry::glamx::Vec2::ONE;
    assert_eq!(same, glamx::Vec2::ONE);
    let turned: Rotation = rotation_from_angle(crate::dim::about_z(0.5));
    assert!((crate::dim::turned_about_z(&turned) - 0.5).abs() < 1.0e-6);
    assert_eq!(Mat2::IDENTITY * Vec2::X, Vec2::X);
    assert_eq!(Mat3::IDENTITY * Vec3::X, Vec3::X);
}

/// The number of components of an integer vector, of either dimension.
trait Components {
    fn to_lattice(self) -> Vec<i64>;
}

impl Components for IVector {
    #[allow(
        clippy::unnecessary_cast,
        reason = "the integers are 32 or 64 bits wide, as the precision is"
    )]
    fn to_lattice(self) -> Vec<i64> {
        self.to_array().iter().map(|component| *component as i64).collect()
    }
}

#[test]
fn contacts_and_masses_are_read_as_fields_and_by_methods() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), |c| c);
    steps(&mut world, 30);
    let pair = world.contact_pair(ground, collider).expect("they touch");
    assert!(pair.has_any_active_contact && pair.has_any_active_contact());
    let manifold = &pair.manifolds[0];
    assert!(!manifold.points.is_empty());
    assert_eq!(manifold.points.len(), manifold.data.solver_contacts().len());
    assert_eq!(manifold.normal, manifold.data.normal);
    for contact in manifold.data.solver_contacts() {
        assert!(contact.dist.abs() < 0.02 && contact.impulse >= 0.0);
    }
    let properties = world.bodies[body].mass_properties();
    assert_eq!(properties.local_mprops.mass(), properties.local_mprops().mass());
    let _: DefaultBroadPhase = BroadPhaseBvh::default();
}

#[test]
fn joints_name_their_bodies_and_links_their_joint() {
    let mut world = PhysicsWorld::new();
    let root = world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::ball(0.1)).0;
    let builder = || RigidBodyBuilder::dynamic().translation(vec(1.0, 0.0));
    let held = world.insert(builder(), ColliderBuilder::ball(0.1)).0;
    let linked = world.insert(builder(), ColliderBuilder::ball(0.1)).0;
    let hinge = || crate::dim::hinge().local_anchor2(vec(-1.0, 0.0));
    let joint = world.impulse_joints.insert(root, held, hinge(), true);
    let joint = &world.impulse_joints[joint];
    let pair: BodyPair = joint.bodies();
    assert_eq!((joint.body1, joint.body2), (joint.body1(), joint.body2()));
    assert_eq!((pair.body1, pair.body2), (root, held));
    let link = world.multibody_joints.insert(root, linked, hinge(), true).expect("a hinge");
    world.step();
    let (multibody, id) = world.multibody_joints.get(link).expect("it is there");
    let link = multibody.link(id).expect("a link");
    assert_eq!(link.joint.coords(), link.joint().coords());
    let jacobian: Jacobian = multibody.body_jacobian(id);
    assert_eq!(jacobian.len(), multibody.ndofs());
}

/// `started` is true in the step in which the force passes the threshold, and again after a step below it.
#[test]
fn a_contact_force_starts_once() {
    let (mut world, _) = world_with_ground();
    let (body, _) = add_box(&mut world, vec(0.0, 0.5), |c| {
        c.active_events(ActiveEvents::CONTACT_FORCE_EVENTS).contact_force_event_threshold(1.0)
    });
    world.bodies[body].activation_mut().normalized_linear_threshold = -1.0;
    let (send_collision, _collisions) = channel();
    let (send_force, forces) = channel();
    let events = ChannelEventCollector::new(send_collision, send_force);
    let seen = RefCell::new(Vec::new());
    let run = |world: &mut PhysicsWorld, count: usize| {
        seen.borrow_mut().clear();
        for _ in 0..count {
            world.step_with_events(&(), &events);
            seen.borrow_mut().extend(forces.try_iter().map(|event| event.started));
        }
        seen.borrow().clone()
    };
    let first = run(&mut world, 10);
    assert!(first.len() > 5 && first[0] && first[1..].iter().all(|started| !started), "{first:?}");
    // In the air there is no force; the landing starts again, once.
    world.bodies[body].set_linvel(vec(0.0, 3.0), true);
    let again = run(&mut world, 60);
    assert_eq!(again.iter().filter(|started| **started).count(), 1, "{again:?}");
    assert!(again.len() > 5, "{again:?}");
}
