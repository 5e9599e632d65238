//! The window: a list of demos, the running session, panels around the picture.

use crate::panels::gallery::{GalleryPanel, title_of};
use crate::panels::{help, inspect, parameters, shown, transport};
use crate::rapier::math::Real;
use crate::recorder::Recorder;
use crate::scene::SceneInfo;
use crate::session::{Demo, Session};
use crate::stages::Part;
use crate::testbed::Testbed;
use crate::thumbnails::Thumbnails;
use crate::viewport::Viewport;
use eframe::egui::{self, Key, Ui};
use gallery::{Category, DEFAULT_FOLDER, WindowRequest};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Size of the window in points.
const SIZE: [f32; 2] = [1360.0, 840.0];
/// Weight of the last frame in the shown frame rate.
const SMOOTHING: f64 = 0.08;
/// Time between two frames of a paused scene without input.
const IDLE_FRAME: Duration = Duration::from_millis(50);

/// A list of demos, and a window for them.
pub struct TestbedApp {
    demos: Vec<Demo>,
    folder: PathBuf,
}

impl TestbedApp {
    /// Demos from functions that build a world in a [`Testbed`].
    pub fn from_builders<F>(builders: Vec<(&str, F)>) -> Self
    where
        F: Fn(&mut Testbed) + Send + Sync + 'static,
    {
        let demos = builders.into_iter().map(|(name, init)| {
            let build = move || {
                let mut testbed = Testbed::new();
                init(&mut testbed);
                testbed.into_scene()
            };
            Demo {
                name: name.to_owned(),
                description: String::new(),
                source: "",
                category: Category::Basics,
                build: Arc::new(build),
            }
        });
        Self { demos: demos.collect(), folder: PathBuf::from(DEFAULT_FOLDER) }
    }

    /// The chosen ones of a gallery's scenes.
    pub fn from_scenes(scenes: &[SceneInfo], request: &WindowRequest) -> Self {
        let demos = request.chosen.iter().filter_map(|&index| scenes.get(index)).map(|info| {
            let build = info.build;
            Demo {
                name: info.name.to_owned(),
                description: info.description.to_owned(),
                source: info.source,
                category: info.category,
                build: Arc::new(move || (build(), None)),
            }
        });
        Self { demos: demos.collect(), folder: request.folder.to_owned() }
    }

    /// Opens the window and returns when it is closed.
    ///
    /// # Errors
    /// There is no scene, no display, or no graphics adapter.
    pub fn run(self) -> Result<(), String> {
        if self.demos.is_empty() {
            return Err("there is no scene".to_owned());
        }
        let options = eframe::NativeOptions {
            renderer: eframe::Renderer::Wgpu,
            // Noise for every pixel of the window costs an adapter in software more than it gains.
            dithering: false,
            viewport: egui::ViewportBuilder::default().with_inner_size(SIZE).with_title("Testbed"),
            ..Default::default()
        };
        let create: eframe::AppCreator = Box::new(move |context| {
            let state = context.wgpu_render_state.as_ref().ok_or("no graphics adapter")?;
            context.egui_ctx.set_theme(egui::Theme::Dark);
            Ok(Box::new(Window::new(self.demos, &self.folder, Viewport::new(state))))
        });
        eframe::run_native("rapier testbed", options, create).map_err(|error| error.to_string())
    }
}

/// The open window.
struct Window {
    demos: Vec<Demo>,
    current: usize,
    session: Session,
    viewport: Viewport,
    gallery: GalleryPanel,
    thumbnails: Thumbnails,
    recorder: Recorder,
    help: bool,
    /// Whether this frame follows the last one without a rest.
    hurries: bool,
    last_frame: Instant,
    /// End of the window's own work in the last frame.
    last_end: Instant,
    frame_time: f64,
}

impl Window {
    fn new(demos: Vec<Demo>, folder: &Path, viewport: Viewport) -> Self {
        let session = Session::new(&demos[0]);
        Self {
            demos,
            current: 0,
            session,
            viewport,
            gallery: GalleryPanel::default(),
            thumbnails: Thumbnails::new(folder),
            recorder: Recorder::new(folder),
            help: false,
            hurries: false,
            last_frame: Instant::now(),
            last_end: Instant::now(),
            frame_time: 1.0 / 60.0,
        }
    }

    /// Loads a demo; the selection of drawn items and the pace stay.
    fn load(&mut self, index: usize) {
        self.current = index;
        let mut session = Session::new(&self.demos[index]);
        session.artist.overlays = self.session.artist.overlays;
        session.pace = self.session.pace;
        self.session = session;
    }

    fn name(&self) -> &str {
        &self.demos[self.current].name
    }

    fn keys(&mut self, ui: &Ui) {
        if ui.ctx().egui_wants_keyboard_input() {
            return;
        }
        let pressed = |key| ui.input(|input| input.key_pressed(key));
        let session = &mut self.session;
        if pressed(Key::Space) {
            session.pace.running = !session.pace.running;
        }
        if let Some(controls) = &session.player.scene.controls {
            controls.set(arrows(ui));
        }
        if pressed(Key::S) {
            session.pace.running = false;
            session.pace.single_steps += 1;
        }
        if pressed(Key::R) {
            session.restart();
        }
        if pressed(Key::Home) {
            session.go_home();
        }
        if pressed(Key::C) {
            let comparing = session.other.is_some();
            session.set_comparison(!comparing);
        }
        session.follow ^= pressed(Key::F) && session.artist.selected.is_some();
        if pressed(Key::Delete) {
            session.remove_selected();
        }
        shown::keys(ui, &mut session.artist.overlays);
        self.help ^= pressed(Key::H) || pressed(Key::F1);
        if pressed(Key::P) {
            self.screenshot();
        }
        if pressed(Key::V) {
            self.toggle_recording();
        }
        let count = self.demos.len();
        if pressed(Key::PageDown) {
            self.load((self.current + 1) % count);
        }
        if pressed(Key::PageUp) {
            self.load((self.current + count - 1) % count);
        }
    }

    fn screenshot(&mut self) {
        if let Some(picture) = self.viewport.picture() {
            let step = self.session.player.shown().steps_taken;
            let name = self.demos[self.current].name.clone();
            self.recorder.screenshot(picture, &name, step);
        }
    }

    fn toggle_recording(&mut self) {
        let name = self.name().to_owned();
        if self.recorder.is_recording() {
            self.recorder.stop(&name);
        } else {
            self.recorder.start();
        }
    }

    fn side_panel(&mut self, ui: &mut Ui) {
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            if ui.button("Screenshot").clicked() {
                self.screenshot();
            }
            let recording = self.recorder.is_recording();
            if ui.button(if recording { "Stop" } else { "Record" }).clicked() {
                self.toggle_recording();
            }
            if ui.button("Keys").clicked() {
                self.help = !self.help;
            }
        });
        egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let session = &mut self.session;
            let section =
                |title: &str, open: bool| egui::CollapsingHeader::new(title).default_open(open);
            section("Drawing", true).show(ui, |ui| {
                shown::show(ui, &mut session.artist.overlays);
                ui.collapsing("Quality", |ui| shown::quality(ui, &mut self.viewport));
            });
            section("Selection", true).show(ui, |ui| inspect::show(ui, session));
            section("Parameters", true).show(ui, |ui| parameters::show(ui, session));
            section("Time of a frame", true).show(ui, |ui| session.plot.show(ui));
        });
    }

    fn panels(&mut self, ui: &mut Ui) {
        // The window is cleared in the colour of the panels: pixels that panels fill cost adapters in
        // software much more.
        let frame = egui::Frame::side_top_panel(ui.style()).fill(egui::Color32::TRANSPARENT);
        let left = egui::Panel::left("gallery").default_size(230.0).frame(frame);
        let clicked = left
            .show(ui, |ui| self.gallery.show(ui, &self.demos, self.current, &mut self.thumbnails));
        if let Some(index) = clicked.inner {
            self.load(index);
        }
        let right = egui::Panel::right("panels").default_size(310.0).frame(frame);
        right.show(ui, |ui| self.side_panel(ui));
        egui::Panel::bottom("transport")
            .frame(frame)
            .show(ui, |ui| transport::show(ui, &mut self.session, self.frame_time));
        egui::CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| {
            self.viewport.show(ui, &mut self.session);
            let demo = &self.demos[self.current];
            let controls = self.session.player.scene.controls.as_ref();
            let hint =
                controls.map_or(String::new(), |controls| format!("\n{}", controls.sentence));
            caption(ui, &title_of(&demo.name), &(demo.description.clone() + &hint), demo.source);
            if let Some(message) = self.recorder.message() {
                toast(ui, message);
            }
        });
        help::show(ui.ctx(), &mut self.help);
    }
}

/// Returns the direction of the arrow keys that are down: right and up.
fn arrows(ui: &Ui) -> [Real; 2] {
    let down = |key| ui.input(|input| Real::from(u8::from(input.key_down(key))));
    let between = |low, high| down(high) - down(low);
    [between(Key::ArrowLeft, Key::ArrowRight), between(Key::ArrowDown, Key::ArrowUp)]
}

/// Writes a title, a sentence and the path of the source into the lower left corner of the picture.
fn caption(ui: &Ui, title: &str, sentence: &str, source: &str) {
    let area = ui.max_rect().shrink2(egui::vec2(12.0, 10.0));
    let mut bottom = area.bottom();
    let lines = [
        (source, egui::FontId::monospace(11.5), 130),
        (sentence, egui::FontId::proportional(13.0), 170),
        (title, egui::FontId::proportional(17.0), 220),
    ];
    for (text, font, alpha) in lines.into_iter().filter(|(text, ..)| !text.is_empty()) {
        let color = egui::Color32::from_white_alpha(alpha);
        let text = ui.painter().layout(text.to_owned(), font, color, area.width());
        bottom -= text.size().y;
        ui.painter().galley(egui::pos2(area.left(), bottom), text, egui::Color32::WHITE);
        bottom -= 2.0;
    }
}

/// Shows a message over the upper right corner of the picture.
fn toast(ui: &Ui, message: &str) {
    let font = egui::FontId::proportional(14.0);
    let text = ui.painter().layout_no_wrap(message.to_owned(), font, egui::Color32::WHITE);
    let corner = ui.max_rect().right_top() + egui::vec2(-24.0 - text.size().x, 18.0);
    let area = egui::Rect::from_min_size(corner, text.size());
    let back = egui::Color32::from_black_alpha(190);
    ui.painter().rect_filled(area.expand2(egui::vec2(12.0, 6.0)), 6.0, back);
    ui.painter().galley(area.min, text, egui::Color32::WHITE);
}

impl eframe::App for Window {
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.panel_fill.to_normalized_gamma_f32()
    }

    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        let start = Instant::now();
        let elapsed = (start - self.last_frame).as_secs_f64();
        self.last_frame = start;
        if self.hurries {
            self.frame_time += SMOOTHING * (elapsed - self.frame_time);
            self.viewport.adapt(self.frame_time);
            self.session.plot.add(Part::Display, self.last_end);
        }
        self.session.plot.end_frame();
        self.keys(ui);
        self.session.advance(start, elapsed);
        self.panels(ui);
        if self.recorder.is_due(elapsed)
            && let Some(picture) = self.viewport.picture()
        {
            let name = self.name().to_owned();
            self.recorder.push(&picture, &name);
        }
        self.session.plot.add_rest(Part::Panels, start);
        self.last_end = Instant::now();
        self.hurries = self.session.pace.is_due();
        // Input repaints at once, too; thumbnails and recordings need no more than the slow rate.
        let rest = if self.hurries { Duration::ZERO } else { IDLE_FRAME };
        ui.ctx().request_repaint_after(rest);
    }
}
