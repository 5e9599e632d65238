//! The selection of drawn items, and their quality.

use crate::rapier::prelude::*;
use crate::scene::Overlays;
use crate::viewport::Viewport;
use eframe::egui::{Key, Slider, Ui};

/// Parts of the debug-renderer, with their names and the keys that switch them.
const LINES: [(DebugRenderMode, &str, Option<Key>); 9] = [
    (DebugRenderMode::CONTACTS, "contacts and normals", Some(Key::Num1)),
    (DebugRenderMode::SOLVER_CONTACTS, "contacts of the solver", None),
    (DebugRenderMode::COLLIDER_AABBS, "boxes (AABB)", Some(Key::Num2)),
    (DebugRenderMode::RIGID_BODY_AXES, "axes of bodies", Some(Key::Num3)),
    (DebugRenderMode::IMPULSE_JOINTS, "impulse joints", Some(Key::Num5)),
    (DebugRenderMode::MULTIBODY_JOINTS, "multibody joints", None),
    (DebugRenderMode::JOINT_AXES, "joint axes and limits", None),
    (DebugRenderMode::COLLIDER_SHAPES, "outlines of shapes", None),
    (DebugRenderMode::PSEUDO_NORMALS, "pseudo-normals of meshes", None),
];

/// Shows the choice.
pub(crate) fn show(ui: &mut Ui, overlays: &mut Overlays) {
    for (mode, name, _) in LINES {
        let mut on = overlays.lines.contains(mode);
        if ui.checkbox(&mut on, name).changed() {
            overlays.lines.set(mode, on);
        }
    }
    ui.checkbox(&mut overlays.impulses, "impulses of contacts");
    ui.checkbox(&mut overlays.solver_colors, "solver colours of contacts");
    ui.checkbox(&mut overlays.centers_of_mass, "centres of mass");
    ui.checkbox(&mut overlays.velocities, "velocities");
    ui.checkbox(&mut overlays.sleep, "dim sleeping bodies");
    ui.checkbox(&mut overlays.islands, "colour islands");
    ui.checkbox(&mut overlays.surfaces, "surfaces");
    ui.add(Slider::new(&mut overlays.length, 0.05..=5.0).logarithmic(true).text("length of lines"));
}

/// Switches parts by their keys.
pub(crate) fn keys(ui: &Ui, overlays: &mut Overlays) {
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    for (mode, _, key) in LINES {
        if key.is_some_and(pressed) {
            overlays.lines.toggle(mode);
        }
    }
    overlays.centers_of_mass ^= pressed(Key::Num4);
    overlays.surfaces ^= pressed(Key::Num6);
}

/// Shows the choice of the quality of pictures.
pub(crate) fn quality(ui: &mut Ui, viewport: &mut Viewport) {
    let mut quality = viewport.quality();
    let mut smooth = quality.samples > 1;
    ui.checkbox(&mut smooth, "smooth borders (4 samples)");
    quality.samples = if smooth { 4 } else { 1 };
    ui.horizontal(|ui| {
        ui.label("shadows");
        for (texels, name) in [(0, "off"), (1024, "1024"), (2048, "2048"), (4096, "4096")] {
            ui.selectable_value(&mut quality.shadow_texels, texels, name);
        }
    });
    ui.checkbox(&mut viewport.adapts, "resolution follows the frame rate");
    ui.add_enabled(
        !viewport.adapts,
        Slider::new(&mut viewport.scale, 0.25..=1.0).text("resolution"),
    );
    viewport.set_quality(quality);
}
