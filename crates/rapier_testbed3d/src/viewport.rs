//! The part of the window that shows the scene, and the mouse in it.

use crate::panels::parameters::changes;
use crate::rapier::math::DIM;
use crate::session::Session;
use crate::stages::Part;
use drawing::{Camera, Color, Label};
use eframe::egui::{self, Color32, PointerButton, Rect, Sense, Ui, Vec2, pos2};
use eframe::egui_wgpu::{Callback, CallbackResources, CallbackTrait, RenderState};
use render::wgpu::{FilterMode, RenderPass};
use render::{Blit, Copyable, Quality, Renderer, Target};
use std::time::Instant;

/// Gap between two pictures in points.
const GAP: f32 = 4.0;

/// Frame times (s) above which the resolution falls, and below which it rises.
const FRAME_TIME_MAX: f64 = 1.0 / 29.0;
const FRAME_TIME_MIN: f64 = 1.0 / 45.0;
/// Lowest resolution, and frames between two changes of it.
const SCALE_MIN: f32 = 0.45;
const PATIENCE: u32 = 12;

/// A picture in the window.
struct Screen {
    target: Target,
    picture: Copyable,
}

/// Copies a picture into the window's pass.
struct Paint(Copyable);

impl CallbackTrait for Paint {
    fn paint(
        &self,
        _: egui::PaintCallbackInfo,
        pass: &mut RenderPass<'static>,
        _: &CallbackResources,
    ) {
        self.0.copy_into(pass);
    }
}

/// The renderer and its pictures: one, or two side by side.
pub(crate) struct Viewport {
    state: RenderState,
    renderer: Renderer,
    blit: Blit,
    screens: Vec<Screen>,
    /// Pixels of the picture for a pixel of the window.
    pub scale: f32,
    /// Whether the scale follows the frame rate.
    pub adapts: bool,
    frames_at_scale: u32,
}

impl Viewport {
    pub(crate) fn new(state: &RenderState) -> Self {
        let renderer =
            Renderer::new(&state.device, &state.queue, Quality::for_adapter(&state.adapter));
        let adapts = renderer.quality() != Quality::default();
        // An adapter in software filters each pixel on the processor.
        let filter = if adapts { FilterMode::Nearest } else { FilterMode::Linear };
        Self {
            state: state.clone(),
            renderer,
            blit: Blit::new(&state.device, state.target_format, filter),
            screens: Vec::new(),
            scale: 1.0,
            adapts,
            frames_at_scale: 0,
        }
    }

    /// Sets the cost of pictures.
    pub(crate) fn set_quality(&mut self, quality: Quality) {
        if quality != self.renderer.quality() {
            self.renderer = Renderer::new(&self.state.device, &self.state.queue, quality);
            self.screens.clear();
        }
    }

    /// Lowers the resolution while frames take too long, and raises it when they do not.
    pub(crate) fn adapt(&mut self, frame_time: f64) {
        self.frames_at_scale += 1;
        if !self.adapts || self.frames_at_scale < PATIENCE {
            return;
        }
        let factor = match frame_time {
            time if time > FRAME_TIME_MAX => 0.8,
            time if time < FRAME_TIME_MIN => 1.1,
            _ => return,
        };
        self.scale = (self.scale * factor).clamp(SCALE_MIN, 1.0);
        self.frames_at_scale = 0;
    }

    pub(crate) fn quality(&self) -> Quality {
        self.renderer.quality()
    }

    /// The finished first picture.
    pub(crate) fn picture(&self) -> Option<drawing::Image> {
        let screen = self.screens.first()?;
        Some(render::read(&self.state.device, &self.state.queue, &screen.target))
    }

    /// Shows a session: one picture, or two for a comparison.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &mut Session) {
        let begin = Instant::now();
        let area = ui.available_rect_before_wrap();
        let count = if session.other.is_some() { 2 } else { 1 };
        let width = (area.width() - GAP * (count - 1) as f32) / count as f32;
        for index in 0..count {
            let left = area.left() + index as f32 * (width + GAP);
            let rect = Rect::from_min_size(pos2(left, area.top()), Vec2::new(width, area.height()));
            self.show_picture(ui, session, rect, index);
        }
        ui.allocate_rect(area, Sense::hover());
        session.plot.add(Part::Drawing, begin);
    }

    fn show_picture(&mut self, ui: &mut Ui, session: &mut Session, rect: Rect, index: usize) {
        let response =
            ui.interact(rect, ui.scope_id().with(("picture", index)), Sense::click_and_drag());
        let aspect = (rect.width() / rect.height().max(1.0)).max(0.01);
        session.fit(aspect);
        let camera = session.camera.camera(aspect);
        if index == 0 {
            mouse(ui, &response, session, &camera, rect);
        }
        let mut drawing = session.draw(index == 1);
        let camera = framed(session, aspect, &drawing);
        drawing.outline_highlighted(&camera, Color::from_hsl(48.0, 1.0, 0.65, 1.0));
        if session.other.is_some() {
            self.renderer.renew_shadows();
        }
        let screen = self.screen(ui, rect, index);
        let Screen { target, picture } = &self.screens[screen];
        self.renderer.draw(target, &drawing, &camera);
        ui.painter().add(Callback::new_paint_callback(rect, Paint(picture.clone())));
        for label in &drawing.labels {
            write(ui, rect, &camera, label);
        }
        if let Some(other) = &session.other {
            let [a, b] = [&session.player, other].map(|p| p.scene.world.integration_parameters);
            let (name, changes) =
                if index == 0 { ("A", changes(&b, &a)) } else { ("B", changes(&a, &b)) };
            let values = changes.iter().map(|(name, value)| format!("\n{name} {value}"));
            let corner = rect.left_top() + Vec2::splat(12.0);
            let font = egui::FontId::proportional(16.0);
            let text = values.fold(name.to_owned(), |all, value| all + &value);
            ui.painter().text(corner, egui::Align2::LEFT_TOP, text, font, Color32::WHITE);
        }
    }

    /// The screen for a place of the window: an existing one if it has the size.
    fn screen(&mut self, ui: &Ui, rect: Rect, index: usize) -> usize {
        let pixels = ui.pixels_per_point() * self.scale;
        let size =
            [rect.width(), rect.height()].map(|side| (side * pixels).round().max(1.0) as u32);
        if self.screens.get(index).is_none_or(|screen| screen.target.size != size) {
            let target = self.renderer.target(size);
            let picture = self.blit.picture(&self.state.device, &target);
            let screen = Screen { target, picture };
            match self.screens.get_mut(index) {
                Some(place) => *place = screen,
                None => self.screens.push(screen),
            }
        }
        index
    }
}

/// The camera with the region of shadows that suits the drawing.
fn framed(session: &Session, aspect: f32, drawing: &drawing::Drawing) -> Camera {
    let mut camera = session.camera.camera(aspect);
    if camera.flat {
        return camera;
    }
    if let Some((middle, radius)) = drawing.moving_extent() {
        // A near camera shows a part of the scene only.
        let near = 1.6 * session.camera.distance;
        if radius < near {
            (camera.center, camera.radius) = (middle, radius.max(1.0));
        } else {
            camera.radius = near;
        }
        camera.depth = [0.5 * session.camera.distance, session.camera.distance + 4.0 * radius];
    }
    camera
}

/// Writes a label at its place.
fn write(ui: &Ui, rect: Rect, camera: &Camera, label: &Label) {
    let Some([x, y]) = camera.in_picture(label.at) else { return };
    let at = rect.center() + Vec2::new(x * 0.5 * rect.width(), -y * 0.5 * rect.height());
    let font = egui::FontId::proportional(14.0);
    ui.painter().text(at, egui::Align2::CENTER_CENTER, &label.text, font, Color32::LIGHT_GRAY);
}

/// Left: pull a body, or turn where there is none. Right: turn (3D) or pan. Middle, or shift: pan. Wheel:
/// zoom.
fn mouse(ui: &Ui, response: &egui::Response, session: &mut Session, camera: &Camera, rect: Rect) {
    let place = |at: egui::Pos2| {
        let offset = (at - rect.center()) / (0.5 * rect.size());
        [offset.x, -offset.y]
    };
    let shift = ui.input(|input| input.modifiers.shift);
    let pointer = response.interact_pointer_pos().map(place);
    let pressed = ui.input(|input| input.pointer.button_pressed(PointerButton::Primary));
    if let (Some(at), true, false) = (pointer, pressed && response.hovered(), shift) {
        session.grab(camera, at);
    }
    if !ui.input(|input| input.pointer.primary_down()) {
        session.grip = None;
    }
    let motion = response.drag_delta();
    let primary = response.dragged_by(PointerButton::Primary);
    let pans = response.dragged_by(PointerButton::Middle)
        || (primary && shift)
        || (DIM == 2 && response.dragged_by(PointerButton::Secondary))
        || (DIM == 2 && primary && session.grip.is_none());
    if let (Some(at), true) = (pointer, session.grip.is_some()) {
        session.drag(camera, at);
    } else if pans {
        session.follow = false;
        session.camera.pan([motion.x, motion.y].map(|c| c / rect.height()), rect.aspect_ratio());
    } else if primary || response.dragged_by(PointerButton::Secondary) {
        session.camera.turn([motion.x, motion.y]);
    }
    if let Some(at) = ui.input(|input| input.pointer.hover_pos()).filter(|_| response.hovered()) {
        session.camera.zoom(ui.input(|input| input.smooth_scroll_delta().y));
        if ui.input(|input| input.key_pressed(egui::Key::B)) {
            session.throw(camera, place(at));
        }
    }
}
