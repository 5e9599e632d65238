//! The list of keys and of actions of the mouse.

use crate::rapier::math::DIM;
use eframe::egui::{Align2, Context, Grid, Key, RichText, Window};

/// Keys and their effects.
const KEYS: [(&str, &str); 14] = [
    ("Space", "run, pause"),
    ("S", "one step"),
    ("arrows", "drive, where the scene says so"),
    ("R", "restart"),
    ("Page Down, Page Up", "next scene, previous scene"),
    ("B", "throw a ball at the pointer"),
    ("F", "follow the selected body"),
    ("Home", "the first view"),
    ("C", "two settings side by side"),
    ("P", "screenshot"),
    ("V", "start or stop a recording"),
    ("1 – 6", "contacts, boxes, axes, centres of mass, joints, surfaces"),
    ("Delete", "remove the selected body"),
    ("H  or  F1", "this list"),
];
/// The mouse in 3D and in 2D.
const MOUSE: [(&str, &str); 4] = [
    ("Left on a body", "select it and pull it"),
    ("Left beside, right", "turn"),
    ("Middle, Shift + left", "move the view"),
    ("Wheel", "zoom"),
];
const FLAT_MOUSE: [(&str, &str); 3] = [
    ("Left on a body", "select it and pull it"),
    ("Left beside, right, middle", "move the view"),
    ("Wheel", "zoom"),
];

/// Shows the list while it is open.
pub(crate) fn show(ctx: &Context, open: &mut bool) {
    if ctx.input(|input| input.key_pressed(Key::Escape)) {
        *open = false;
    }
    let mouse: &[_] = if DIM == 3 { &MOUSE } else { &FLAT_MOUSE };
    Window::new("Keys")
        .open(open)
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0; 2])
        .show(ctx, |ui| {
            Grid::new("keys").num_columns(2).spacing([24.0, 4.0]).striped(true).show(ui, |ui| {
                for (key, effect) in KEYS.iter().chain(mouse) {
                    ui.label(RichText::new(*key).strong());
                    ui.label(*effect);
                    ui.end_row();
                }
            });
        });
}
