//! Every parameter of the step, and gravity.

use crate::player::Player;
use crate::rapier::dynamics::FrictionModel;
use crate::rapier::prelude::*;
use crate::session::Session;
use eframe::egui::{DragValue, Grid, Label, RichText, Slider, Ui, Vec2};

/// Width of the column of names, in points.
const NAME_WIDTH: f32 = 128.0;

/// Shows the parameters of the scene, or of one of the two compared ones.
pub(crate) fn show(ui: &mut Ui, session: &mut Session) {
    let mut comparing = session.other.is_some();
    ui.horizontal(|ui| {
        if ui.checkbox(&mut comparing, "Side by side").on_hover_text("Two settings (C)").changed() {
            session.set_comparison(comparing);
        }
        if comparing {
            ui.selectable_value(&mut session.edits_other, false, "A");
            ui.selectable_value(&mut session.edits_other, true, "B");
        }
    });
    let player = match &mut session.other {
        Some(other) if session.edits_other => other,
        _ => &mut session.player,
    };
    edit(ui, player);
}

fn edit(ui: &mut Ui, player: &mut Player) {
    let mut parameters = player.scene.world.integration_parameters;
    let mut gravity = player.scene.world.gravity;
    let before = (parameters, gravity);
    Grid::new("parameters").num_columns(2).spacing([8.0, 4.0]).show(ui, |ui| {
        time_and_passes(ui, &mut parameters);
        softness(ui, &mut parameters);
        lengths(ui, &mut parameters);
        continuous(ui, &mut parameters);
        row(ui, "gravity", "Along each axis (length/s²)", |ui| {
            // The sum with zero shows -0 as 0.
            let mut values: Vec<Real> =
                Vector::AXES.iter().map(|axis| gravity.dot(*axis) + 0.0).collect();
            for value in &mut values {
                ui.add(DragValue::new(value).speed(0.1).max_decimals(2));
            }
            let axes = Vector::AXES.into_iter().zip(values);
            gravity = axes.fold(Vector::ZERO, |sum, (axis, value)| sum + axis * value);
        });
    });
    if ui.button("Defaults").clicked() {
        parameters = IntegrationParameters::default();
        gravity = Vector::Y * -9.81;
    }
    if before == (parameters, gravity) {
        return;
    }
    let world = player.world_mut();
    match parameters.validate() {
        Ok(()) => world.integration_parameters = parameters,
        Err(error) => {
            ui.label(RichText::new(error.to_string()).color(eframe::egui::Color32::LIGHT_RED));
        }
    }
    if world.gravity != gravity {
        world.gravity = gravity;
        world.wake_up_all(true);
    }
}

/// A row of the table: a name with an explanation, and something to change it with.
fn row(ui: &mut Ui, name: &str, hint: &str, change: impl FnOnce(&mut Ui)) {
    // The prefix and long names leave no room for sliders.
    let short = name.trim_start_matches("normalized_");
    let label = Label::new(RichText::new(short).small()).truncate();
    let size = Vec2::new(NAME_WIDTH, ui.spacing().interact_size.y);
    ui.add_sized(size, label).on_hover_text(format!("{name}: {hint}"));
    ui.horizontal(change);
    ui.end_row();
}

fn count(
    ui: &mut Ui,
    name: &str,
    hint: &str,
    value: &mut usize,
    range: std::ops::RangeInclusive<usize>,
) {
    row(ui, name, hint, |ui| {
        ui.add(Slider::new(value, range));
    });
}

fn number(
    ui: &mut Ui,
    name: &str,
    hint: &str,
    value: &mut Real,
    range: std::ops::RangeInclusive<Real>,
) {
    row(ui, name, hint, |ui| {
        ui.add(
            Slider::new(value, range).clamping(eframe::egui::SliderClamping::Never).max_decimals(4),
        );
    });
}

fn time_and_passes(ui: &mut Ui, p: &mut IntegrationParameters) {
    let mut rate = 1.0 / p.dt.max(1.0e-6);
    row(ui, "dt", "Steps for a second (1 / dt)", |ui| {
        if ui.add(Slider::new(&mut rate, 10.0..=480.0).suffix(" Hz").max_decimals(0)).changed() {
            p.dt = 1.0 / rate;
        }
    });
    count(ui, "num_solver_iterations", "Substeps of a step", &mut p.num_solver_iterations, 1..=32);
    let extra = &mut p.num_additional_friction_iterations;
    count(
        ui,
        "num_additional_friction_iterations",
        "More iterations, with friction",
        extra,
        0..=16,
    );
    let pgs = &mut p.num_internal_pgs_iterations;
    count(ui, "num_internal_pgs_iterations", "Iterations of a substep", pgs, 1..=8);
    let warm = &mut p.warmstart_coefficient;
    number(
        ui,
        "warmstart_coefficient",
        "Fraction of the last impulses to start from",
        warm,
        0.0..=1.0,
    );
    row(ui, "friction_model", "Friction for a manifold, or for each point", |ui| {
        ui.selectable_value(&mut p.friction_model, FrictionModel::Standard, "Standard");
        ui.selectable_value(&mut p.friction_model, FrictionModel::Coulomb, "Coulomb");
    });
}

fn softness(ui: &mut Ui, p: &mut IntegrationParameters) {
    number(
        ui,
        "erp",
        "Fraction of a contact's error that a substep removes",
        &mut p.erp,
        0.0..=1.0,
    );
    number(ui, "damping_ratio", "Softness of contacts", &mut p.damping_ratio, 0.0..=20.0);
    number(
        ui,
        "joint_erp",
        "Fraction of a joint's error that a substep removes",
        &mut p.joint_erp,
        0.0..=1.0,
    );
    number(ui, "joint_damping_ratio", "Softness of joints", &mut p.joint_damping_ratio, 0.0..=20.0);
}

fn lengths(ui: &mut Ui, p: &mut IntegrationParameters) {
    number(ui, "length_unit", "Size of a typical body", &mut p.length_unit, 0.01..=100.0);
    let allowed = &mut p.allowed_linear_error;
    number(ui, "allowed_linear_error", "Overlap that remains", allowed, 0.0..=0.1);
    let prediction = &mut p.normalized_prediction_distance;
    number(ui, "normalized_prediction_distance", "Gap with contacts", prediction, 0.0..=0.5);
    let recycle = &mut p.normalized_contact_recycle_distance;
    number(
        ui,
        "normalized_contact_recycle_distance",
        "Motion that keeps contact points",
        recycle,
        0.0..=0.2,
    );
    let corrective = &mut p.normalized_max_corrective_velocity;
    number(
        ui,
        "normalized_max_corrective_velocity",
        "Speed that undoes overlap",
        corrective,
        0.0..=50.0,
    );
    let joint = &mut p.normalized_max_joint_corrective_velocity;
    number(
        ui,
        "normalized_max_joint_corrective_velocity",
        "Speed that joins anchors",
        joint,
        0.0..=500.0,
    );
    let threshold = &mut p.normalized_restitution_velocity_threshold;
    number(
        ui,
        "normalized_restitution_velocity_threshold",
        "Slower impacts do not bounce",
        threshold,
        0.0..=5.0,
    );
    row(ui, "normalized_max_linear_velocity", "Fastest motion of a body", |ui| {
        let shown = |value: f64, _| {
            if value > 1.0e9 { "no limit".to_owned() } else { format!("{value:.1}") }
        };
        let value = DragValue::new(&mut p.normalized_max_linear_velocity).range(0.0..=Real::MAX);
        ui.add(value.custom_formatter(shown));
    });
}

fn continuous(ui: &mut Ui, p: &mut IntegrationParameters) {
    row(ui, "max_ccd_substeps", "Continuous collision detection", |ui| {
        let mut on = p.max_ccd_substeps != 0;
        ui.checkbox(&mut on, "on");
        p.max_ccd_substeps = usize::from(on);
    });
    row(ui, "ccd_on_penetration", "Stops bodies that touch something already", |ui| {
        ui.checkbox(&mut p.ccd_on_penetration, "on");
    });
    row(ui, "min_ccd_dt", "Accepted for compatibility; no effect", |ui| {
        ui.add(DragValue::new(&mut p.min_ccd_dt).speed(1.0e-5).max_decimals(6));
    });
    row(ui, "max_neighbors_per_collider", "Pairs of a collider with its size", |ui| {
        ui.add(DragValue::new(&mut p.max_neighbors_per_collider));
    });
    row(ui, "max_sensor_neighbors_per_collider", "Pairs of a sensor", |ui| {
        ui.add(DragValue::new(&mut p.max_sensor_neighbors_per_collider));
    });
}
