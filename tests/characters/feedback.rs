//! Feedback controllers that move a body to a pose.

use crate::dim::{about_z, cuboid, turned_about_z, vec, z_of};
use rapier::control::*;
use rapier::prelude::*;

const DT: Real = 1.0 / 60.0;

fn weightless() -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let (body, _) = world.insert(RigidBodyBuilder::dynamic(), cuboid(0.5, 0.3));
    (world, body)
}

fn target() -> Pose {
    Pose::from_parts(
        vec(2.0, -1.0),
        RigidBodyBuilder::dynamic().rotation(about_z(0.2)).build().rotation().to_owned(),
    )
}

/// Returns the errors of position and angle after each step.
fn errors(controller: &PdController, steps: usize) -> Vec<(Real, Real)> {
    let (mut world, handle) = weightless();
    let mut errors = Vec::new();
    for _ in 0..steps {
        let body = &mut world.bodies[handle];
        let change = controller.rigid_body_correction(body, target(), RigidBodyVelocity::zero());
        let vels = body.vels();
        body.set_vels(vels + change, true);
        world.step();
        let body = &world.bodies[handle];
        let off = target().translation - body.translation();
        errors.push((off.x, 0.2 - turned_about_z(body.rotation())));
    }
    errors
}

#[test]
fn the_body_reaches_the_target() {
    let (off, turn) = errors(&PdController::default(), 60)[59];
    assert!(off.abs() < 1.0e-4 && turn.abs() < 1.0e-4, "{off}, {turn}");
}

/// Critical gains do not oscillate, slightly stiffer gains do, and deadbeat gains arrive in one step.
#[test]
fn critical_damping_agrees_with_the_formula() {
    let kd: Real = 0.5;
    let critical = (1.0 - (1.0 - kd).sqrt()).powi(2) / DT;
    let overshoot = |kp: Real| {
        let all = errors(&PdController::new(kp, kd, AxesMask::all()), 200);
        let least = all.iter().map(|(off, turn)| off.min(10.0 * turn)).fold(0.0, Real::min);
        assert!(all[199].0.abs() < 1.0e-3, "arrives");
        -least
    };
    assert!(overshoot(0.99 * critical) < 1.0e-4);
    assert!(overshoot(3.0 * critical) > 1.0e-2);
    let (off, turn) = errors(&PdController::new(1.0 / DT, 1.0, AxesMask::all()), 1)[0];
    assert!(off.abs() < 1.0e-4 && turn.abs() < 1.0e-3, "{off}, {turn}");
}

#[test]
fn only_the_chosen_axes_are_controlled() {
    let (world, handle) = weightless();
    let body = &world.bodies[handle];
    let corrects = |axes| {
        let change = PdController::new(60.0, 0.8, axes).rigid_body_correction(
            body,
            target(),
            RigidBodyVelocity::zero(),
        );
        (change.linvel.x != 0.0, change.linvel.y != 0.0, z_of(change.angvel) != 0.0)
    };
    assert_eq!(corrects(AxesMask::LIN_X), (true, false, false));
    assert_eq!(corrects(AxesMask::LIN_Y), (false, true, false));
    assert_eq!(corrects(AxesMask::ANG_Z), (false, false, true));
    assert_eq!(corrects(AxesMask::empty()), (false, false, false));
    assert_eq!(corrects(AxesMask::all()), (true, true, true));
    let pd = PdController::default();
    let linear = pd.linear_rigid_body_correction(body, vec(2.0, -1.0), Vector::ZERO);
    assert_eq!(linear, vec(2.0, -1.0) * 60.0);
    let angular = pd.angular_rigid_body_correction(body, target().rotation, about_z(0.0));
    assert!((z_of(angular) - 12.0).abs() < 1.0e-3);
}

/// Under gravity, the PD controller has a constant error, and the integral removes it. With n substeps, a
/// body that begins a step at the velocity u ends it at u - g dt. It moves by (u - g dt (n + 1)/2n) dt, which
/// is zero at equilibrium. So u = 5/8 g dt for four substeps. The controller computes it from the last end
/// velocity, -3/8 g dt: kp e = (5/8 + (1 - kd) 3/8) g dt.
#[test]
fn the_integral_compensates_gravity() {
    let sag = |ki: Real| {
        let (mut world, handle) = weightless();
        world.gravity = vec(0.0, -9.81);
        let mut controller = PidController::new(15.0, ki, 0.8, AxesMask::all());
        for _ in 0..1200 {
            let body = &mut world.bodies[handle];
            let still = RigidBodyVelocity::zero();
            let change = controller.rigid_body_correction(DT, body, Pose::IDENTITY, still);
            let vels = body.vels();
            body.set_vels(vels + change, true);
            world.step();
        }
        -world.bodies[handle].translation().y
    };
    let without = sag(0.0);
    assert!((without - 0.7 * 9.81 * DT / 15.0).abs() < 1.0e-4, "hangs {without} low");
    assert!(sag(20.0).abs() < 1.0e-4);
}

#[test]
fn integrals_can_be_reset_and_stay_finite() {
    let mut controller = PidController::default();
    let off = PdErrors { linear: vec(1.0, 2.0), angular: about_z(3.0) };
    controller.correction(DT, &off, &PdErrors::default());
    assert!((controller.lin_integral - vec(1.0, 2.0) * DT).length() < 1.0e-6);
    assert!((z_of(controller.ang_integral) - 3.0 * DT).abs() < 1.0e-6);
    let before = controller;
    let bad = PdErrors { linear: vec(Real::NAN, 0.0), angular: about_z(Real::INFINITY) };
    let change = controller.correction(DT, &bad, &PdErrors::default());
    assert!(change.is_finite());
    for dt in [0.0, -DT, Real::NAN] {
        assert!(controller.correction(dt, &off, &PdErrors::default()).is_finite());
    }
    assert_eq!(controller, before);
    controller.set_axes(AxesMask::LIN_X | AxesMask::ANG_Z);
    assert_eq!(
        (controller.lin_integral.y, controller.axes()),
        (0.0, AxesMask::LIN_X | AxesMask::ANG_Z)
    );
    assert!(controller.lin_integral.x > 0.0);
    controller.reset_integrals();
    assert_eq!((controller.lin_integral, z_of(controller.ang_integral)), (Vector::ZERO, 0.0));
}
