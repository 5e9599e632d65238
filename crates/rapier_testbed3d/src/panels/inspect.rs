//! The selected body, its collider, its joints and its contacts.

use crate::player::Player;
use crate::rapier::prelude::*;
use crate::session::Session;
use eframe::egui::{DragValue, Grid, Slider, Ui};

/// Contacts and joints that are listed at most.
const ROWS_MAX: usize = 12;

/// Shows the selection, and changes it.
pub(crate) fn show(ui: &mut Ui, session: &mut Session) {
    let Some(handle) = session.artist.selected else {
        ui.weak("Click a body.");
        return;
    };
    ui.checkbox(&mut session.follow, "follow (F)");
    let player = &mut session.player;
    let Some(collider) = player.shown().world.colliders.get(handle) else {
        session.artist.selected = None;
        return;
    };
    let parent = collider.parent();
    if let Some(body) = parent {
        show_body(ui, player, body);
    }
    show_collider(ui, player, handle);
    let world = &player.shown().world;
    if let Some(body) = parent {
        show_joints(ui, world, body);
    }
    show_contacts(ui, world, handle);
}

fn heading(ui: &mut Ui, text: String) {
    ui.add_space(4.0);
    ui.strong(text);
}

fn fact(ui: &mut Ui, name: &str, value: String) {
    ui.small(name);
    ui.monospace(value);
    ui.end_row();
}

/// Formats an angular velocity: a number in 2D.
fn angular(v: AngVector) -> String {
    let text = format!("{v:.3}");
    text.trim_matches(['[', ']']).replace(", ", "  ")
}

fn vector(v: Vector) -> String {
    let parts: Vec<String> =
        Vector::AXES.iter().map(|axis| format!("{:.3}", v.dot(*axis))).collect();
    parts.join("  ")
}

fn show_body(ui: &mut Ui, player: &mut Player, handle: RigidBodyHandle) {
    let Some(body) = player.shown().world.bodies.get(handle) else { return };
    heading(ui, format!("Body {}, {:?}", handle.into_raw_parts().0, body.body_type()));
    let shown = BodySettings::of(body);
    let (mut wanted, mut edited) = (shown, false);
    Grid::new("body").num_columns(2).show(ui, |ui| {
        fact(ui, "position", vector(body.translation()));
        fact(ui, "velocity", vector(body.linvel()));
        fact(ui, "angular", angular(body.angvel()));
        fact(ui, "mass", format!("{:.4}", body.mass()));
        fact(ui, "kinetic energy", format!("{:.3}", body.kinetic_energy()));
        let sleep = if body.is_sleeping() { "asleep" } else { "awake" };
        fact(ui, "state", sleep.to_owned());
        edited = wanted.edit(ui);
    });
    // Write access ends the rewound state, so an edit alone takes it.
    if edited && let Some(body) = player.world_mut().bodies.get_mut(handle) {
        wanted.apply(body, &shown);
    }
}

/// The properties of a body that the panel edits.
#[derive(Copy, Clone)]
struct BodySettings {
    /// Linear and angular.
    damping: [Real; 2],
    gravity_scale: Real,
    ccd: bool,
}

impl BodySettings {
    fn of(body: &RigidBody) -> Self {
        Self {
            damping: [body.linear_damping(), body.angular_damping()],
            gravity_scale: body.gravity_scale(),
            ccd: body.is_ccd_enabled(),
        }
    }

    /// Shows the fields; returns whether an input changed one.
    fn edit(&mut self, ui: &mut Ui) -> bool {
        let mut edited = false;
        for (name, value) in
            ["linear damping", "angular damping"].into_iter().zip(&mut self.damping)
        {
            ui.small(name);
            edited |= ui.add(DragValue::new(value).range(0.0..=100.0).speed(0.02)).changed();
            ui.end_row();
        }
        ui.small("gravity scale");
        edited |= ui.add(DragValue::new(&mut self.gravity_scale).speed(0.02)).changed();
        ui.end_row();
        ui.small("continuous");
        edited |= ui.checkbox(&mut self.ccd, "").changed();
        ui.end_row();
        edited
    }

    /// Sets the properties that differ from the previous ones: a new gravity scale alone wakes the body.
    fn apply(&self, body: &mut RigidBody, previous: &Self) {
        let [linear, angular] = self.damping;
        body.set_linear_damping(linear);
        body.set_angular_damping(angular);
        if self.gravity_scale != previous.gravity_scale {
            body.set_gravity_scale(self.gravity_scale, true);
        }
        body.enable_ccd(self.ccd);
    }
}

fn show_collider(ui: &mut Ui, player: &mut Player, handle: ColliderHandle) {
    let Some(collider) = player.shown().world.colliders.get(handle) else { return };
    let shape = format!("{:?}", collider.shape().shape_type());
    heading(ui, format!("Collider {}, {shape}", handle.into_raw_parts().0));
    let (mut edited, mut surface) = (false, [collider.friction(), collider.restitution()]);
    Grid::new("collider").num_columns(2).show(ui, |ui| {
        let rows = [("friction", 2.0), ("restitution", 1.0)];
        for ((name, most), value) in rows.into_iter().zip(&mut surface) {
            ui.small(name);
            edited |= ui.add(Slider::new(value, 0.0..=most)).changed();
            ui.end_row();
        }
        fact(ui, "density", format!("{:.3}", collider.density()));
        let groups = collider.collision_groups();
        fact(
            ui,
            "groups",
            format!("{:08x} / {:08x}", groups.memberships.bits(), groups.filter.bits()),
        );
    });
    if edited && let Some(collider) = player.world_mut().colliders.get_mut(handle) {
        let [friction, restitution] = surface;
        collider.set_friction(friction);
        collider.set_restitution(restitution);
    }
}

fn show_joints(ui: &mut Ui, world: &PhysicsWorld, body: RigidBodyHandle) {
    let joints = world.impulse_joints_with(body);
    let texts: Vec<String> = joints
        .take(ROWS_MAX)
        .map(|(_, joint)| {
            let other = if joint.body1() == body { joint.body2() } else { joint.body1() };
            let locked = joint.data.locked_axes.bits();
            let on = if joint.data.is_enabled() { "" } else { ", broken" };
            format!("with body {}, locked axes {locked:06b}{on}", other.into_raw_parts().0)
        })
        .collect();
    if !texts.is_empty() {
        heading(ui, format!("Joints ({})", texts.len()));
        texts.into_iter().for_each(|text| {
            ui.small(text);
        });
    }
}

fn show_contacts(ui: &mut Ui, world: &PhysicsWorld, handle: ColliderHandle) {
    let mut texts = Vec::new();
    for pair in world.contact_pairs_with(handle) {
        let other = if pair.collider1 == handle { pair.collider2 } else { pair.collider1 };
        let other = other.into_raw_parts().0;
        for manifold in &pair.manifolds {
            let color = manifold.solver_color().map_or("-".to_owned(), |color| color.to_string());
            for contact in &manifold.data {
                let (distance, impulse) = (contact.dist, contact.impulse);
                texts.push(format!(
                    "{other}: distance {distance:.4}, impulse {impulse:.3}, colour {color}"
                ));
            }
        }
    }
    if !texts.is_empty() {
        heading(ui, format!("Contacts ({})", texts.len()));
        texts.into_iter().take(ROWS_MAX).for_each(|text| {
            ui.small(text);
        });
    }
}
