//! Filters of pairs, and modification of contacts.

use super::version::{
    COMPUTE_IMPULSES, contacts, manifolds, point, set_friction, stored_contacts, user_data,
};
use super::world::{GRAVITY, World, assert_near, cuboid, rounding};
use rapier::prelude::*;

/// Answers each contact pair with the same flags.
struct Answer(Option<SolverFlags>);

impl PhysicsHooks for Answer {
    fn filter_contact_pair(&self, context: &PairFilterContext) -> Option<SolverFlags> {
        assert!(context.colliders.contains(context.collider1));
        assert!(context.bodies.iter().count() == 1);
        self.0
    }
}

/// The world after half a second, with a filter that has this answer.
fn filtered(answer: Option<SolverFlags>) -> (Real, usize) {
    let (mut world, body, [_, collider]) = World::box_on_ground();
    world.colliders[collider].set_active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS);
    world.step_with(&Answer(answer), &());
    let pairs = world.narrow_phase.contact_pairs().filter(|pair| pair.has_any_active_contact());
    let count = pairs.count();
    for _ in 0..29 {
        world.step_with(&Answer(answer), &());
    }
    (world.bodies[body].translation().y, count)
}

/// Without a contact force, a body falls by `g t²/2` (and by `g t h/2` more, with substeps `h`).
#[test]
fn filters_refuse_pairs_or_forces() {
    let (time, h) = (0.5, 1.0 / 240.0);
    let fallen = 0.5 - GRAVITY * time * (time + h) / 2.0;
    let (height, touching) = filtered(None);
    assert_near(height, fallen, rounding(5_000));
    assert_eq!(touching, 0);
    let (height, touching) = filtered(Some(SolverFlags::empty()));
    assert_near(height, fallen, rounding(5_000));
    assert_eq!(touching, 1);
    let (height, touching) = filtered(Some(COMPUTE_IMPULSES));
    assert_near(height, 0.5, 0.01);
    assert_eq!(touching, 1);
}

/// A belt with a coefficient of friction.
struct Belt {
    friction: Real,
    velocity: Real,
}

impl PhysicsHooks for Belt {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext) {
        // The velocity is that of the second collider relative to the first.
        assert_eq!(stored_contacts(context), 0, "the context has the contacts");
        let sign = if context.rigid_body1.is_none() { 1.0 } else { -1.0 };
        set_friction(context, self.friction);
        for contact in contacts(context) {
            contact.tangent_velocity = Vector::X * (self.velocity * sign);
        }
        *user_data(context) += 1;
    }
}

/// A body on a fast belt accelerates with `μ g`; later it has the velocity of the belt.
#[test]
fn belts_drag_bodies() {
    let (mut world, body, [ground, collider]) = World::box_on_ground();
    world.colliders[collider].set_active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
    let belt = Belt { friction: 0.3, velocity: 2.0 };
    for _ in 0..30 {
        world.step_with(&belt, &());
    }
    let expected = belt.friction * GRAVITY * 0.5;
    assert_near(world.bodies[body].linvel().x, expected, 0.05 * expected);
    for _ in 0..60 {
        world.step_with(&belt, &());
    }
    assert_near(world.bodies[body].linvel().x, belt.velocity, 0.02);
    let pair = world.narrow_phase.contact_pair(ground, collider).unwrap();
    assert_eq!(manifolds(pair)[0].data.user_data, 90, "user data persists");
}

/// Removes all contacts.
struct Ghost;

impl PhysicsHooks for Ghost {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext) {
        contacts(context).clear();
    }
}

#[test]
fn cleared_contacts_exert_no_force() {
    let (mut world, body, [_, collider]) = World::box_on_ground();
    world.colliders[collider].set_active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
    for _ in 0..60 {
        world.step_with(&Ghost, &());
    }
    assert_near(world.bodies[body].linvel().y, -GRAVITY, rounding(5_000));
}

/// Keeps the contacts on one side.
struct HalfContact;

impl PhysicsHooks for HalfContact {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext) {
        contacts(context).retain(|contact| point(contact).x < 0.0);
    }
}

/// A box without support on its right side turns clockwise.
#[test]
fn contacts_can_be_removed_one_by_one() {
    let (mut world, body, [_, collider]) = World::box_on_ground();
    world.colliders[collider].set_active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
    for _ in 0..20 {
        world.step_with(&HalfContact, &());
    }
    #[cfg(feature = "dim2")]
    let turn = world.bodies[body].angvel();
    #[cfg(feature = "dim3")]
    let turn = world.bodies[body].angvel().z;
    assert!(turn < -0.1, "turns with {turn} rad/s");
}

/// A platform that is solid from above.
struct Platform;

impl PhysicsHooks for Platform {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext) {
        let up = if context.rigid_body1.is_none() { Vector::Y } else { -Vector::Y };
        context.update_as_oneway_platform(up, 0.1);
    }
}

/// A body that jumps through a platform lands on it.
#[test]
fn platforms_are_solid_from_one_side() {
    let mut world = World::default();
    world.colliders.insert(cuboid(5.0, 0.1).active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS));
    let body = RigidBodyBuilder::dynamic().translation(Vector::Y * -2.0).linvel(Vector::Y * 9.0);
    let (body, _) = world.insert(body.can_sleep(false), ColliderBuilder::ball(0.25));
    let mut highest = Real::MIN;
    for _ in 0..180 {
        world.step_with(&Platform, &());
        highest = highest.max(world.bodies[body].translation().y);
    }
    // Without resistance the body rises by v²/(2g).
    assert_near(highest, -2.0 + 81.0 / (2.0 * GRAVITY), 0.05);
    assert_near(world.bodies[body].translation().y, 0.35, 0.02);
}
