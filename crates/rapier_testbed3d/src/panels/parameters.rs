//! The parameters of the step, and gravity: five that change a scene visibly, then all others. The name of a
//! changed one is bright.

use crate::player::Player;
use crate::rapier::dynamics::FrictionModel;
use crate::rapier::prelude::*;
use crate::session::Session;
use eframe::egui::{Color32, DragValue, Grid, Label, RichText, Slider, SliderClamping, Ui, Vec2};

/// Width of the column of names, in points.
const NAME_WIDTH: f32 = 128.0;
/// Colour of the names of changed parameters.
const CHANGED: Color32 = Color32::from_rgb(255, 196, 92);

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
    let changes = changes(&IntegrationParameters::default(), &parameters);
    let changed: Vec<&str> = changes.iter().map(|(name, _)| name.as_str()).collect();
    table(ui, "parameters", &changed, |rows| everyday(rows, &mut parameters, &mut gravity));
    ui.collapsing("Advanced", |ui| {
        table(ui, "advanced", &changed, |rows| {
            iterations(rows, &mut parameters);
            softness(rows, &mut parameters);
            lengths(rows, &mut parameters);
            continuous(rows, &mut parameters);
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
            ui.label(RichText::new(error.to_string()).color(Color32::LIGHT_RED));
        }
    }
    if world.gravity != gravity {
        world.gravity = gravity;
        world.wake_up_all(true);
    }
}

/// Returns the names of the parameters that differ, with the second values.
pub(crate) fn changes(
    from: &IntegrationParameters,
    to: &IntegrationParameters,
) -> Vec<(String, String)> {
    // The derived text lists every field.
    let [from, to] = [from, to].map(|parameters| format!("{parameters:#?}"));
    let pairs = from.lines().zip(to.lines()).filter(|(from, to)| from != to);
    let field = |line: &str| {
        let (name, value) = line.trim().trim_end_matches(',').split_once(": ")?;
        Some((name.to_owned(), value.to_owned()))
    };
    pairs.filter_map(|(_, to)| field(to)).collect()
}

/// Shows a table with two columns.
fn table(ui: &mut Ui, name: &str, changed: &[&str], fill: impl FnOnce(&mut Rows<'_>)) {
    Grid::new(name)
        .num_columns(2)
        .spacing([8.0, 4.0])
        .show(ui, |ui| fill(&mut Rows { ui, changed }));
}

/// Rows of a table.
struct Rows<'u> {
    ui: &'u mut Ui,
    /// Names of the parameters that differ from the defaults.
    changed: &'u [&'u str],
}

impl Rows<'_> {
    /// Adds a row: a name with an explanation, and something to change it with.
    fn row(&mut self, name: &str, hint: &str, change: impl FnOnce(&mut Ui)) {
        // The prefix and long names leave no room for sliders.
        let short = name.trim_start_matches("normalized_");
        let text = RichText::new(short).small();
        let is_changed = self.changed.contains(&name);
        let text = if is_changed { text.strong().color(CHANGED) } else { text };
        let ui = &mut *self.ui;
        let size = Vec2::new(NAME_WIDTH, ui.spacing().interact_size.y);
        ui.add_sized(size, Label::new(text).truncate()).on_hover_text(format!("{name}: {hint}"));
        ui.horizontal(change);
        ui.end_row();
    }

    fn slider(&mut self, name: &str, hint: &str, slider: Slider<'_>) {
        self.row(name, hint, |ui| {
            ui.add(slider);
        });
    }

    fn number(
        &mut self,
        name: &str,
        hint: &str,
        value: &mut Real,
        range: std::ops::RangeInclusive<Real>,
    ) {
        let slider = Slider::new(value, range).clamping(SliderClamping::Never);
        self.slider(name, hint, slider.max_decimals(4));
    }
}

/// The parameters that change most scenes visibly.
fn everyday(rows: &mut Rows<'_>, p: &mut IntegrationParameters, gravity: &mut Vector) {
    let mut rate = 1.0 / p.dt.max(1.0e-6);
    rows.row("dt", "Steps for a second (1 / dt)", |ui| {
        if ui.add(Slider::new(&mut rate, 10.0..=480.0).suffix(" Hz").max_decimals(0)).changed() {
            p.dt = 1.0 / rate;
        }
    });
    rows.slider(
        "num_solver_iterations",
        "Substeps of a step",
        Slider::new(&mut p.num_solver_iterations, 1..=32),
    );
    rows.row("gravity", "Along each axis (length/s²)", |ui| {
        // The sum with zero shows -0 as 0.
        let mut values: Vec<Real> =
            Vector::AXES.iter().map(|axis| gravity.dot(*axis) + 0.0).collect();
        for value in &mut values {
            ui.add(DragValue::new(value).speed(0.1).max_decimals(2));
        }
        let axes = Vector::AXES.into_iter().zip(values);
        *gravity = axes.fold(Vector::ZERO, |sum, (axis, value)| sum + axis * value);
    });
    rows.number("length_unit", "Size of a typical body", &mut p.length_unit, 0.01..=100.0);
    rows.slider(
        "max_ccd_substeps",
        "Continuous collision detection: parts of a step, 0 is off",
        Slider::new(&mut p.max_ccd_substeps, 0..=8),
    );
}

fn iterations(rows: &mut Rows<'_>, p: &mut IntegrationParameters) {
    let extra = &mut p.num_additional_friction_iterations;
    rows.slider(
        "num_additional_friction_iterations",
        "More iterations, with friction",
        Slider::new(extra, 0..=16),
    );
    let pgs = &mut p.num_internal_pgs_iterations;
    rows.slider("num_internal_pgs_iterations", "Iterations of a substep", Slider::new(pgs, 1..=8));
    let warm = &mut p.warmstart_coefficient;
    rows.number(
        "warmstart_coefficient",
        "Fraction of the last impulses to start from",
        warm,
        0.0..=1.0,
    );
    rows.row("friction_model", "Friction for a manifold, or for each point", |ui| {
        ui.selectable_value(&mut p.friction_model, FrictionModel::Standard, "Standard");
        ui.selectable_value(&mut p.friction_model, FrictionModel::Coulomb, "Coulomb");
    });
}

fn softness(rows: &mut Rows<'_>, p: &mut IntegrationParameters) {
    rows.number(
        "erp",
        "Fraction of a contact's error that a substep removes",
        &mut p.erp,
        0.0..=1.0,
    );
    rows.number("damping_ratio", "Softness of contacts", &mut p.damping_ratio, 0.0..=20.0);
    rows.number(
        "joint_erp",
        "Fraction of a joint's error that a substep removes",
        &mut p.joint_erp,
        0.0..=1.0,
    );
    rows.number(
        "joint_damping_ratio",
        "Softness of joints",
        &mut p.joint_damping_ratio,
        0.0..=20.0,
    );
}

fn lengths(rows: &mut Rows<'_>, p: &mut IntegrationParameters) {
    let allowed = &mut p.allowed_linear_error;
    rows.number("allowed_linear_error", "Overlap that remains", allowed, 0.0..=0.1);
    let prediction = &mut p.normalized_prediction_distance;
    rows.number("normalized_prediction_distance", "Gap with contacts", prediction, 0.0..=0.5);
    let recycle = &mut p.normalized_contact_recycle_distance;
    rows.number(
        "normalized_contact_recycle_distance",
        "Motion that keeps contact points",
        recycle,
        0.0..=0.2,
    );
    let corrective = &mut p.normalized_max_corrective_velocity;
    rows.number(
        "normalized_max_corrective_velocity",
        "Speed that undoes overlap",
        corrective,
        0.0..=50.0,
    );
    let joint = &mut p.normalized_max_joint_corrective_velocity;
    rows.number(
        "normalized_max_joint_corrective_velocity",
        "Speed that joins anchors",
        joint,
        0.0..=500.0,
    );
    let threshold = &mut p.normalized_restitution_velocity_threshold;
    rows.number(
        "normalized_restitution_velocity_threshold",
        "Slower impacts do not bounce",
        threshold,
        0.0..=5.0,
    );
    rows.row("normalized_max_linear_velocity", "Fastest motion of a body", |ui| {
        let shown = |value: f64, _| {
            if value > 1.0e9 { "no limit".to_owned() } else { format!("{value:.1}") }
        };
        let value = DragValue::new(&mut p.normalized_max_linear_velocity).range(0.0..=Real::MAX);
        ui.add(value.custom_formatter(shown));
    });
}

fn continuous(rows: &mut Rows<'_>, p: &mut IntegrationParameters) {
    rows.row("ccd_on_penetration", "Stops bodies that touch something already", |ui| {
        ui.checkbox(&mut p.ccd_on_penetration, "on");
    });
    rows.row("min_ccd_dt", "Shortest part of a step that impacts divide (s)", |ui| {
        ui.add(DragValue::new(&mut p.min_ccd_dt).speed(1.0e-5).max_decimals(6));
    });
    rows.row("max_neighbors_per_collider", "Pairs of a collider with its size", |ui| {
        ui.add(DragValue::new(&mut p.max_neighbors_per_collider));
    });
    rows.row("max_sensor_neighbors_per_collider", "Pairs of a sensor", |ui| {
        ui.add(DragValue::new(&mut p.max_sensor_neighbors_per_collider));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_name_the_parameters() {
        let from = IntegrationParameters::default();
        let to = IntegrationParameters { num_solver_iterations: 9, length_unit: 2.0, ..from };
        let all = changes(&from, &to);
        let all: Vec<(&str, &str)> = all.iter().map(|(n, v)| (n.as_str(), v.as_str())).collect();
        assert!(all.contains(&("num_solver_iterations", "9")), "{all:?}");
        assert!(all.contains(&("length_unit", "2.0")), "{all:?}");
        assert_eq!((all.len(), changes(&from, &from).len()), (2, 0));
    }
}
