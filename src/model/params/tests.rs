//! Defaults, limits of the softness, and the table of refused values.

use super::{CONTACT_COMPLIANCE, CONTACT_ERP_SCALE, IntegrationParameters, Softness};
use crate::dim::math::Real;

fn close(a: Real, b: Real) {
    assert!((a - b).abs() <= 1.0e-4 * a.abs().max(b.abs()).max(1.0), "{a} is not about {b}");
}

fn same(a: Softness, b: Softness) {
    close(a.bias_rate, b.bias_rate);
    close(a.mass_scale, b.mass_scale);
    close(a.impulse_scale, b.impulse_scale);
}

/// The relative velocity after one iteration, from rest without load.
fn correction(softness: Softness, error: Real) -> Real {
    -softness.mass_scale * softness.bias_rate * error
}

#[test]
fn hard_contact_removes_its_fraction() {
    let h = 1.0 / 240.0;
    let hard = Softness::new(0.25, 0.0, h);
    assert_eq!((hard.mass_scale, hard.impulse_scale), (1.0, 0.0));
    close(correction(hard, -0.04) * h, 0.01);
}

#[test]
fn softer_is_weaker_but_never_nothing() {
    let h = 1.0 / 240.0;
    let mut last = Real::INFINITY;
    for damping_ratio in [0.0, 0.1, 1.0, 100.0, 1.0e6] {
        let params = IntegrationParameters { damping_ratio, ..Default::default() };
        let softness = params.contact_softness(h);
        let velocity = correction(softness, -0.01);
        assert!(velocity > 0.0 && velocity < last, "{velocity} at {damping_ratio}");
        assert!(softness.impulse_scale < 1.0 || damping_ratio > 1.0e5);
        last = velocity;
    }
}

#[test]
fn nothing_moves_without_time() {
    let softness = IntegrationParameters::default().contact_softness(0.0);
    assert_eq!(softness.bias_rate, 0.0);
    assert!(softness.mass_scale.is_finite());
    assert_eq!(Softness::new(0.0, 0.0, 1.0), Softness::RIGID);
}

#[test]
fn frequency_and_damping_give_the_same_softness() {
    let h: Real = 1.0 / 240.0;
    for (fraction, compliance) in [(0.1, CONTACT_COMPLIANCE), (0.2, 0.5), (0.5, 0.01)] {
        let fraction: Real = fraction;
        let omega = (fraction / compliance).sqrt() / h;
        let damping = (1.0 - fraction) / (2.0 * (fraction * compliance).sqrt());
        same(Softness::new(fraction, compliance, h), Softness::spring(omega, damping, h));
    }
}

#[test]
fn spring_obeys_its_differential_equation() {
    // A mass on a spring, ω = 20, ζ = 0.5, let go at C = 1: compared with the exact solution.
    let (omega, zeta, h): (Real, Real, Real) = (20.0, 0.5, 1.0e-4);
    let softness = Softness::spring(omega, zeta, h);
    let (mut position, mut velocity): (Real, Real) = (1.0, 0.0);
    for _ in 0..1000 {
        let bias = softness.bias_rate * position;
        velocity -= softness.mass_scale * (velocity + bias);
        position += h * velocity;
    }
    let (time, damped) = (0.1, omega * (1.0 - zeta * zeta).sqrt());
    let phase = damped * time;
    let envelope = (-zeta * omega * time).exp();
    let exact = envelope * (phase.cos() + zeta * omega / damped * phase.sin());
    assert!((position - exact).abs() < 5.0e-3, "{position} instead of {exact}");
}

#[test]
fn resting_load_sinks_in_by_g_over_omega_squared() {
    // One substep after another, contact and gravity alone: bias pass, move, relax pass.
    let params = IntegrationParameters::default();
    let h = params.substep();
    let softness = params.contact_softness(h);
    let (g, mut position, mut velocity, mut impulse): (Real, Real, Real, Real) =
        (9.81, 0.0, 0.0, 0.0);
    for _ in 0..2000 {
        velocity += impulse - g * h;
        let bias = softness.bias_rate * position;
        let visit = -softness.mass_scale * (velocity + bias) - softness.impulse_scale * impulse;
        impulse += visit;
        velocity += visit;
        position += h * velocity;
        let relax = -velocity;
        impulse += relax;
        velocity += relax;
    }
    close(
        position * 1.0e3,
        -CONTACT_COMPLIANCE * g * h * h / (CONTACT_ERP_SCALE * params.erp) * 1.0e3,
    );
}

#[test]
fn scaled_world_scales_lengths() {
    let params = IntegrationParameters { length_unit: 100.0, ..Default::default() };
    close(params.allowed_linear_error(), 0.1);
    close(params.prediction_distance(), 2.0);
    close(params.max_corrective_velocity(), 400.0);
    close(params.contact_recycle_distance(), 1.0);
    close(params.restitution_velocity_threshold(), 100.0);
}

#[test]
fn time_step_setters_refuse_nonsense() {
    let mut params = IntegrationParameters::default();
    params.set_inv_dt(120.0).unwrap();
    close(params.inv_dt(), 120.0);
    for dt in [-1.0, Real::NAN, Real::INFINITY] {
        let error = params.set_dt(dt).unwrap_err();
        assert_eq!(error.field, "dt");
        close(params.inv_dt(), 120.0);
    }
    params.set_inv_dt(0.0).unwrap();
    assert_eq!((params.dt, params.inv_dt()), (0.0, 0.0));
}

#[test]
fn invalid_values_are_named() {
    type P = IntegrationParameters;
    type Row = (&'static str, fn(&mut P));
    let default = P::default();
    default.validate().unwrap();
    let table: [Row; 22] = [
        ("dt", |p| p.dt = Real::NAN),
        ("dt", |p| p.dt = -0.1),
        ("dt", |p| p.dt = 1.0e30),
        ("num_solver_iterations", |p| p.num_solver_iterations = 0),
        ("num_solver_iterations", |p| p.num_solver_iterations = usize::MAX),
        ("num_internal_pgs_iterations", |p| p.num_internal_pgs_iterations = 0),
        ("num_additional_friction_iterations", |p| p.num_additional_friction_iterations = 1001),
        ("max_ccd_substeps", |p| p.max_ccd_substeps = usize::MAX),
        ("erp", |p| p.erp = 1.5),
        ("joint_erp", |p| p.joint_erp = Real::NAN),
        ("damping_ratio", |p| p.damping_ratio = -0.1),
        ("joint_damping_ratio", |p| p.joint_damping_ratio = Real::INFINITY),
        ("allowed_linear_error", |p| p.allowed_linear_error = -1.0),
        ("warmstart_coefficient", |p| p.warmstart_coefficient = 2.0),
        ("min_ccd_dt", |p| p.min_ccd_dt = -1.0),
        ("length_unit", |p| p.length_unit = 0.0),
        ("allowed_linear_error", |p| (p.length_unit, p.allowed_linear_error) = (1.0e10, 1.0e10)),
        ("normalized_prediction_distance", |p| p.normalized_prediction_distance = Real::NAN),
        ("normalized_contact_recycle_distance", |p| p.normalized_contact_recycle_distance = -1.0),
        ("normalized_max_corrective_velocity", |p| p.normalized_max_corrective_velocity = -1.0),
        ("normalized_max_linear_velocity", |p| p.normalized_max_linear_velocity = Real::NAN),
        ("normalized_restitution_velocity_threshold", |p| {
            p.normalized_restitution_velocity_threshold = -1.0;
        }),
    ];
    for (field, spoil) in table {
        let mut params = default;
        spoil(&mut params);
        let error = params.validate().expect_err(field);
        assert_eq!(error.field, field);
        assert!(error.to_string().contains(&format!("IntegrationParameters::{field} is ")));
    }
}
