//! Contact-force events: magnitudes and thresholds of contact forces.

use super::stage::{Protocol, add_box, close, steps, with_events, world_with_ground};
use crate::dim::vec;
use rapier::prelude::*;

const G: Real = 9.81;

fn with_force_events(threshold: Real) -> impl FnOnce(ColliderBuilder) -> ColliderBuilder {
    move |collider| {
        let events = ActiveEvents::CONTACT_FORCE_EVENTS;
        collider.active_events(events).contact_force_event_threshold(threshold)
    }
}

#[test]
fn a_resting_box_presses_with_its_weight() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), with_events);
    *world.bodies[body].activation_mut() = RigidBodyActivation::cannot_sleep();
    steps(&mut world, 120);
    let weight = world.bodies[body].mass() * G;
    let protocol = Protocol::default();
    protocol.of_steps(&mut world, 1);
    let [force] = protocol.forces()[..] else { panic!("one pair, one event") };
    assert_eq!((force.collider1, force.collider2), (ground, collider));
    close(force.total_force_magnitude, weight, 1.0e-3 * weight);
    close(force.total_force.y, weight, 1.0e-3 * weight);
    assert!(force.max_force_magnitude <= force.total_force_magnitude);
    assert_eq!(force.max_force_direction, Vector::Y, "from the first collider onto the second");
}

#[test]
fn only_forces_above_the_threshold_send_events() {
    for (fraction, expected) in [(0.0, true), (0.9, true), (1.1, false), (Real::INFINITY, false)] {
        let (mut world, _) = world_with_ground();
        let (body, collider) = add_box(&mut world, vec(0.0, 0.5), with_force_events(0.0));
        steps(&mut world, 20);
        let weight = world.bodies[body].mass() * G;
        let threshold = if fraction == 0.0 { 0.0 } else { fraction * weight };
        world.colliders[collider].set_contact_force_event_threshold(threshold);
        let protocol = Protocol::default();
        assert!(protocol.of_steps(&mut world, 1).is_empty(), "collision events are disabled");
        assert_eq!(!protocol.forces().is_empty(), expected, "threshold {fraction} of the weight");
    }
}

/// Of two colliders with force events, the lower threshold decides.
#[test]
fn the_lower_threshold_counts() {
    let (mut world, ground) = world_with_ground();
    let (_, collider) = add_box(&mut world, vec(0.0, 0.5), with_force_events(1.0e9));
    steps(&mut world, 20);
    let protocol = Protocol::default();
    world.colliders[ground].set_contact_force_event_threshold(0.1);
    protocol.of_steps(&mut world, 1);
    assert!(protocol.forces().is_empty(), "the ground has no force events");
    world.colliders[ground].set_active_events(ActiveEvents::CONTACT_FORCE_EVENTS);
    protocol.of_steps(&mut world, 1);
    assert_eq!(protocol.forces().len(), 1);
    world.colliders[collider].set_active_events(ActiveEvents::empty());
    protocol.of_steps(&mut world, 1);
    assert_eq!(protocol.forces().len(), 1);
}

/// The forces of an impact, summed from its first step on, add up to the momentum of the body.
#[test]
fn the_forces_of_a_hit_add_up_to_its_momentum() {
    for restitution in [0.0, 0.5] {
        let (mut world, _) = world_with_ground();
        world.gravity = Vector::ZERO;
        let reporting = with_force_events(0.0);
        let rule = CoefficientCombineRule::Max;
        let (body, _) = add_box(&mut world, vec(0.0, 1.0), |c| {
            reporting(c).restitution(restitution).restitution_combine_rule(rule)
        });
        world.bodies[body].set_linvel(vec(0.0, -8.0), true);
        let (protocol, dt) = (Protocol::default(), world.integration_parameters.dt);
        let (mut impulse, mut first_report) = (0.0, None);
        for step in 0..60 {
            protocol.of_steps(&mut world, 1);
            for force in protocol.forces() {
                impulse += force.total_force.y * dt;
                first_report = first_report.or(Some((step, world.bodies[body].linvel().y)));
            }
        }
        let (_, velocity) = first_report.expect("the hit is reported");
        assert!(velocity > -8.0, "the first event is of the step that slowed it down");
        let gained = world.bodies[body].mass() * (world.bodies[body].linvel().y + 8.0);
        close(impulse, gained, 1.0e-3 * gained);
    }
}
