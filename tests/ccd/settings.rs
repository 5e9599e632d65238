//! Effects of the parameters and of the settings of a body.

use super::{RADIUS, add_ball, wall};
use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::weightless;
use rapier::prelude::*;

/// Returns a wall of 2 cm, and a ball that moves towards it at 100 m/s from 3 m away.
fn scene() -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = weightless(60);
    world.insert_collider(wall(), None);
    let ball = add_ball(&mut world, vec(-3.0, 0.0), vec(100.0, 0.0));
    (world, ball)
}

fn passes(world: &mut PhysicsWorld, ball: RigidBodyHandle) -> bool {
    (0..10).any(|_| {
        world.step();
        world.bodies[ball].translation().x > 0.0
    })
}

#[test]
fn zero_substeps_disable_ccd() {
    for (substeps, wanted) in [(0, true), (1, false), (8, false)] {
        let (mut world, ball) = scene();
        world.integration_parameters.max_ccd_substeps = substeps;
        assert_eq!(passes(&mut world, ball), wanted, "max_ccd_substeps = {substeps}");
        let searches = world.physics_pipeline.counters.ccd.num_searches;
        assert!(substeps > 0 || searches == 0);
    }
}

/// A ball penetrates a wall with its front, its middle still outside, when a kinematic plate pushes it
/// further at 100 m/s. Without CCD only contacts act against it.
#[test]
fn overlapping_bodies_are_stopped_on_request() {
    let place = |wanted: bool| {
        let mut world = weightless(60);
        world.integration_parameters.ccd_on_penetration = wanted;
        world.insert_collider(wall(), None);
        let ball = add_ball(&mut world, vec(-0.8 * RADIUS - 0.01, 0.0), Vector::ZERO);
        let plate = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(100.0, 0.0));
        let plate = plate.translation(vec(-1.8 * RADIUS - 0.021, 0.0));
        world.insert(plate, cuboid(0.01, 1.0));
        world.step();
        (world.bodies[ball].translation().x, world.physics_pipeline.counters.ccd.num_substeps)
    };
    let (x, stopped) = place(true);
    assert!(x <= 0.0 && stopped == 1, "at {x}, {stopped} stopped");
    let (x, stopped) = place(false);
    assert!(x > 0.0 && stopped == 0, "without it: at {x}, {stopped} stopped");
}

#[test]
fn bodies_report_active_ccd() {
    let (mut world, ball) = scene();
    assert!(!world.bodies[ball].is_ccd_active() && !world.bodies[ball].is_ccd_enabled());
    world.step();
    assert!(world.bodies[ball].is_ccd_active(), "1.7 m in a step");
    assert_eq!(world.physics_pipeline.counters.ccd.num_fast_bodies, 1);
    assert_eq!(world.physics_pipeline.counters.ccd.num_searches, 0, "nothing is near");
    world.step();
    assert_eq!(world.physics_pipeline.counters.ccd.num_substeps, 1, "the wall");
    assert_eq!(world.physics_pipeline.counters.ccd.num_searches, 1);
    // Half the thickness of the ball per step is 1.5 m/s.
    world.bodies[ball].set_linvel(vec(0.0, 1.4), true);
    world.step();
    assert!(!world.bodies[ball].is_ccd_active(), "2.3 cm in a step");
    assert_eq!(world.physics_pipeline.counters.ccd.num_fast_bodies, 0);
    world.bodies[ball].enable_ccd(true);
    assert!(world.bodies[ball].is_ccd_enabled() && !world.bodies[ball].is_ccd_active());
    world.bodies[ball].set_linvel(vec(0.0, 1.6), true);
    world.step();
    assert!(world.bodies[ball].is_ccd_active(), "2.7 cm in a step");
    world.bodies[ball].set_body_type(RigidBodyType::KinematicVelocityBased, true);
    assert!(!world.bodies[ball].is_ccd_active(), "colliders do not stop kinematic bodies");
}

/// CCD uses the present thickness of a body, whatever its shape at insertion.
#[test]
fn ccd_uses_the_present_shape() {
    use RigidBodyType::{Dynamic, Fixed, KinematicPositionBased, KinematicVelocityBased};
    for (was, is) in [
        (Dynamic, KinematicPositionBased),
        (Dynamic, Fixed),
        (Fixed, KinematicVelocityBased),
        (Fixed, Dynamic),
        (KinematicPositionBased, Fixed),
        (KinematicVelocityBased, Dynamic),
    ] {
        let mut world = weightless(60);
        let (body, _) = world.insert(RigidBodyBuilder::new(was), wall());
        world.step();
        world.bodies[body].set_body_type(is, true);
        let ball = add_ball(&mut world, vec(-3.0, 0.0), vec(1000.0, 0.0));
        assert_eq!(passes(&mut world, ball), is == Dynamic, "{was:?} became {is:?}");
    }
}

/// Bodies that are not bullets pass each other. With a prediction distance as long as the motion of a step,
/// contacts stop them.
#[test]
fn soft_prediction_stops_bodies_straight_ahead() {
    for (prediction, wanted) in [(0.0, true), (2.0, false)] {
        let mut world = weightless(60);
        let target = add_ball(&mut world, Vector::ZERO, Vector::ZERO);
        let ball = add_ball(&mut world, vec(-3.0, 0.0), vec(100.0, 0.0));
        world.bodies[ball].set_soft_ccd_prediction(prediction);
        assert_eq!(world.bodies[ball].soft_ccd_prediction(), prediction);
        let passes = (0..10).any(|_| {
            world.step();
            world.bodies[ball].translation().x > world.bodies[target].translation().x
        });
        assert_eq!(passes, wanted, "soft_ccd_prediction = {prediction}");
    }
}

/// The parameter is the only speed limit, and limited bodies are counted.
#[test]
fn speeds_are_limited_by_the_parameter_only() {
    let mut world = weightless(60);
    let ball = add_ball(&mut world, Vector::ZERO, vec(1.0e6, 0.0));
    world.step();
    assert_eq!(world.bodies[ball].linvel().x, 1.0e6);
    assert_eq!(world.physics_pipeline.counters.solver.nlimited_bodies, 0);
    world.integration_parameters.normalized_max_linear_velocity = 500.0;
    world.step();
    assert!((world.bodies[ball].linvel().length() - 500.0).abs() < 0.01);
    assert_eq!(world.physics_pipeline.counters.solver.nlimited_bodies, 1);
    world.bodies[ball].set_linvel(vec(499.0, 0.0), true);
    world.step();
    assert_eq!(world.physics_pipeline.counters.solver.nlimited_bodies, 0);
}
