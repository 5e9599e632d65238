//! Rules of impacts: kinematic bodies, locked axes, dominance, sensors, combined coefficients, hooks.

use super::impact_energy::{RADIUS, ball, surface};
use super::stage::{run, weightless};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// A wall at the speed `V` accelerates a free body to `(1 + e) V`.
#[test]
fn kinematic_hitters() {
    for e in [0.0, 0.5, 1.0] {
        for by_position in [false, true] {
            let mut world = weightless(60);
            let builder = if by_position {
                RigidBodyBuilder::kinematic_position_based()
            } else {
                RigidBodyBuilder::kinematic_velocity_based().linvel(vec(4.0, 0.0))
            };
            let (bat, _) = world
                .insert(builder.translation(vec(-2.0, 0.0)), surface(cuboid(0.5, 1.0), e, 0.0));
            let (hit, _) = world.insert(RigidBodyBuilder::dynamic(), ball(e, 0.0));
            for _ in 0..40 {
                if by_position {
                    let next = world.bodies[bat].translation() + vec(4.0 / 60.0, 0.0);
                    world.bodies[bat].set_next_kinematic_translation(next);
                }
                world.step();
            }
            let speed = world.bodies[hit].linvel().x;
            assert!((speed - 4.0 * (1.0 + e)).abs() < 0.01, "{speed}, e = {e}, {by_position}");
        }
    }
}

/// Locked axes do not move. A body that hits them is reflected as by a wall, or by a mass on a rail.
#[test]
fn locked_axes_and_dominance() {
    let rail = LockedAxes::TRANSLATION_LOCKED_Y | LockedAxes::ROTATION_LOCKED;
    let all = LockedAxes::TRANSLATION_LOCKED | LockedAxes::ROTATION_LOCKED;
    for (locked, dominance, speeds) in [
        (all, 0, [0.0, -3.0]),
        (rail, 0, [3.0, 0.0]),
        (LockedAxes::empty(), 1, [0.0, -3.0]),
        (LockedAxes::empty(), -1, [6.0, 3.0]),
    ] {
        let mut world = weightless(60);
        let stands = RigidBodyBuilder::dynamic().locked_axes(locked).dominance_group(dominance);
        let (stands, _) = world.insert(stands, ball(1.0, 0.0));
        let comes = RigidBodyBuilder::dynamic().translation(vec(-1.0, 0.0)).linvel(vec(3.0, 0.0));
        let (comes, _) = world.insert(comes, ball(1.0, 0.0));
        run(&mut world, 0.5);
        let found = [stands, comes].map(|body| world.bodies[body].linvel().x);
        for (found, speed) in found.into_iter().zip(speeds) {
            assert!(
                (found - speed).abs() < 1.0e-3,
                "{found} instead of {speed}: {locked:?} {dominance}"
            );
        }
    }
}

/// Sensors have no impacts, and bodies without mass are not moved by any.
#[test]
fn sensors_and_the_massless() {
    let mut world = weightless(60);
    world.insert_collider(cuboid(0.5, 0.5).sensor(true).restitution(1.0), None);
    let comes = RigidBodyBuilder::dynamic().translation(vec(-2.0, 0.0)).linvel(vec(6.0, 0.0));
    let (comes, _) = world.insert(comes, ball(1.0, 0.0));
    run(&mut world, 1.0);
    assert_eq!(world.bodies[comes].linvel(), vec(6.0, 0.0));

    let mut world = weightless(60);
    let (ghost, _) = world.insert(RigidBodyBuilder::dynamic(), ball(1.0, 0.0).mass(0.0));
    let comes = RigidBodyBuilder::dynamic().translation(vec(-2.0, 0.0)).linvel(vec(6.0, 0.0));
    let (comes, _) = world.insert(comes, ball(1.0, 0.0));
    run(&mut world, 1.0);
    let found = [ghost, comes].map(|body| world.bodies[body].linvel().x);
    for (found, speed) in found.into_iter().zip([0.0, -6.0]) {
        assert!((found - speed).abs() < 1.0e-3, "{found}: what has no mass stands as a wall does");
    }
}

/// Two coefficients of restitution combine by these rules.
#[test]
fn combined_restitution() {
    use CoefficientCombineRule::{Average, ClampedSum, Max, Min, Multiply};
    for (rule, e) in [(Average, 0.55), (Min, 0.3), (Multiply, 0.24), (Max, 0.8), (ClampedSum, 1.0)]
    {
        let mut world = weightless(60);
        let wall = ColliderBuilder::ball(1.0).restitution(0.8).restitution_combine_rule(rule);
        world.insert_collider(wall, None);
        let shape = ColliderBuilder::ball(RADIUS).restitution(0.3).restitution_combine_rule(rule);
        let comes = RigidBodyBuilder::dynamic().translation(vec(-3.0, 0.0)).linvel(vec(6.0, 0.0));
        let (comes, _) = world.insert(comes, shape);
        run(&mut world, 0.8);
        let speed = -world.bodies[comes].linvel().x;
        assert!((speed - 6.0 * e).abs() < 0.01, "{rule:?}: {speed} instead of {}", 6.0 * e);
    }
}

/// Hook that changes restitution and tangent velocity.
struct Change {
    restitution: Real,
    along: Vector,
}

impl PhysicsHooks for Change {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        context.set_restitution(self.restitution);
        context.set_tangent_velocity(self.along);
    }
}

/// The restitution of a hook applies, also above 1; an invalid one does not. The friction of a belt acts in
/// an impact as well.
#[test]
fn hooks_change_impacts() {
    for (given, e) in
        [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (Real::NAN, 0.5), (Real::INFINITY, 0.5), (-1.0, 0.5)]
    {
        let mut world = weightless(60);
        let wall = surface(cuboid(1.0, 3.0), 0.5, 2.0);
        world.insert_collider(wall.active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS), None);
        let comes = RigidBodyBuilder::dynamic().translation(vec(-3.0, 0.0)).linvel(vec(6.0, 0.0));
        let comes = comes.locked_axes(LockedAxes::ROTATION_LOCKED);
        let (comes, _) = world.insert(comes, ball(0.5, 2.0));
        for _ in 0..30 {
            world.step_with_events(&Change { restitution: given, along: vec(0.0, 3.0) }, &());
        }
        let v = world.bodies[comes].linvel();
        assert!((-v.x - 6.0 * e).abs() < 0.01, "{v} with {given}");
        // Friction 2 stops the slip on the belt: 2 · 6 (1 + e) > 3.
        assert!((v.y.abs() - 3.0).abs() < 0.02, "{v} with {given}");
    }
}
