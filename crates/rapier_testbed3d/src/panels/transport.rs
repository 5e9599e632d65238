//! The bar below the picture: run, pause, step, speed, time, counts.

use crate::session::Session;
use eframe::egui::{Button, RichText, Slider, Ui, Vec2};

/// Shows the bar.
pub(crate) fn show(ui: &mut Ui, session: &mut Session, frame_time: f64) {
    ui.add_space(3.0);
    ui.horizontal(|ui| {
        buttons(ui, session);
        ui.separator();
        ui.label("Speed");
        let speed = Slider::new(&mut session.pace.speed, 0.02..=4.0).logarithmic(true).suffix(" ×");
        ui.add(speed.max_decimals(2));
        ui.separator();
        time(ui, session);
    });
    ui.horizontal(|ui| counts(ui, session, frame_time));
    ui.add_space(2.0);
}

fn buttons(ui: &mut Ui, session: &mut Session) {
    let running = session.pace.running;
    let word = if running { "Pause" } else { "Run" };
    let button = Button::new(RichText::new(word).strong()).min_size(Vec2::new(52.0, 22.0));
    if ui.add(button).on_hover_text("Space").clicked() {
        session.pace.running = !running;
    }
    if ui.button("Step").on_hover_text("S").clicked() {
        session.pace.running = false;
        session.pace.single_steps += 1;
    }
    if ui.button("Restart").on_hover_text("R").clicked() {
        session.restart();
    }
}

/// The slider of the history: its right end is the present.
fn time(ui: &mut Ui, session: &mut Session) {
    let player = &mut session.player;
    let last = player.history.len();
    ui.label("Time");
    let mut position = player.rewound.unwrap_or(last);
    ui.spacing_mut().slider_width = (ui.available_width() - 190.0).clamp(80.0, 420.0);
    let slider = Slider::new(&mut position, 0..=last).show_value(false);
    if ui.add(slider).on_hover_text("Drag to go back; Run continues from there").changed() {
        session.pace.running = false;
        player.rewound = (position < last).then_some(position);
    }
    let shown = player.shown();
    ui.monospace(format!("{:7.2} s  step {}", shown.time, shown.steps_taken));
}

fn counts(ui: &mut Ui, session: &Session, frame_time: f64) {
    let world = &session.player.shown().world;
    let counters = &world.physics_pipeline.counters;
    let mut part = |text: String| {
        ui.label(RichText::new(text).small());
        ui.separator();
    };
    part(format!("{:.0} frames/s", 1.0 / frame_time.max(1.0e-4)));
    part(format!("step {:.2} ms", counters.step_time_ms()));
    part(format!("{} bodies, {} awake", world.bodies.len(), world.active_bodies().len()));
    part(format!("{} pairs", counters.cd.ncontact_pairs));
    part(format!("{} joints", world.impulse_joints.len()));
    if session.pace.running {
        part("hash: while paused".to_owned());
    } else {
        part(format!("hash {:016x}", session.player.hash()));
    }
}
