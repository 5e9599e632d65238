//! The selected body, its collider, its joints and its contacts.

use crate::rapier::prelude::*;
use crate::session::Session;
use eframe::egui::{DragValue, Grid, Slider, Ui};

/// Contacts and joints that are listed at most.
const ROWS_MAX: usize = 12;

/// Shows the selection, and changes it.
pub(crate) fn show(ui: &mut Ui, session: &mut Session) {
    let Some(handle) = session.selected else {
        ui.weak("Click a body.");
        return;
    };
    ui.checkbox(&mut session.follow, "follow (F)");
    let world = session.player.world_mut();
    let Some(collider) = world.colliders.get(handle) else {
        session.selected = None;
        return;
    };
    let parent = collider.parent();
    if let Some(body) = parent {
        show_body(ui, world, body);
    }
    show_collider(ui, world, handle);
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

fn vector(v: Vector) -> String {
    let parts: Vec<String> =
        Vector::AXES.iter().map(|axis| format!("{:.3}", v.dot(*axis))).collect();
    parts.join("  ")
}

fn show_body(ui: &mut Ui, world: &mut PhysicsWorld, handle: RigidBodyHandle) {
    let Some(body) = world.bodies.get_mut(handle) else { return };
    heading(ui, format!("Body {}, {:?}", handle.into_raw_parts().0, body.body_type()));
    Grid::new("body").num_columns(2).show(ui, |ui| {
        fact(ui, "position", vector(body.translation()));
        fact(ui, "velocity", vector(body.linvel()));
        fact(ui, "angular", format!("{:.3?}", body.angvel()));
        fact(ui, "mass", format!("{:.4}", body.mass()));
        fact(ui, "kinetic energy", format!("{:.3}", body.kinetic_energy()));
        let sleep = if body.is_sleeping() { "asleep" } else { "awake" };
        fact(ui, "state", sleep.to_owned());
        let mut damping = [body.linear_damping(), body.angular_damping()];
        for (name, value) in ["linear damping", "angular damping"].into_iter().zip(&mut damping) {
            ui.small(name);
            ui.add(DragValue::new(value).range(0.0..=100.0).speed(0.02));
            ui.end_row();
        }
        if damping != [body.linear_damping(), body.angular_damping()] {
            body.set_linear_damping(damping[0]);
            body.set_angular_damping(damping[1]);
        }
        let mut scale = body.gravity_scale();
        ui.small("gravity scale");
        if ui.add(DragValue::new(&mut scale).speed(0.02)).changed() {
            body.set_gravity_scale(scale, true);
        }
        ui.end_row();
        let mut ccd = body.is_ccd_enabled();
        ui.small("continuous");
        if ui.checkbox(&mut ccd, "").changed() {
            body.enable_ccd(ccd);
        }
        ui.end_row();
    });
}

fn show_collider(ui: &mut Ui, world: &mut PhysicsWorld, handle: ColliderHandle) {
    let Some(collider) = world.colliders.get_mut(handle) else { return };
    let shape = format!("{:?}", collider.shape().shape_type());
    heading(ui, format!("Collider {}, {shape}", handle.into_raw_parts().0));
    Grid::new("collider").num_columns(2).show(ui, |ui| {
        ui.small("friction");
        let mut friction = collider.friction();
        if ui.add(Slider::new(&mut friction, 0.0..=2.0)).changed() {
            collider.set_friction(friction);
        }
        ui.end_row();
        ui.small("restitution");
        let mut restitution = collider.restitution();
        if ui.add(Slider::new(&mut restitution, 0.0..=1.0)).changed() {
            collider.set_restitution(restitution);
        }
        ui.end_row();
        fact(ui, "density", format!("{:.3}", collider.density()));
        let groups = collider.collision_groups();
        fact(
            ui,
            "groups",
            format!("{:08x} / {:08x}", groups.memberships.bits(), groups.filter.bits()),
        );
    });
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
        for contact in pair.manifolds.iter().flat_map(|manifold| &manifold.data) {
            let other = other.into_raw_parts().0;
            let (distance, impulse) = (contact.dist, contact.impulse);
            texts.push(format!("{other}: distance {distance:.4}, impulse {impulse:.3}"));
        }
    }
    if !texts.is_empty() {
        heading(ui, format!("Contacts ({})", texts.len()));
        texts.into_iter().take(ROWS_MAX).for_each(|text| {
            ui.small(text);
        });
    }
}
