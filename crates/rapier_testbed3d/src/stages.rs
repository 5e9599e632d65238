//! Times of the parts of the last frames, as a stacked plot: the stages of the step, the picture, the panels.

use crate::rapier::prelude::*;
use eframe::egui::{Color32, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, pos2};
use std::collections::VecDeque;
use std::time::Instant;

/// Frames in the plot.
const FRAMES: usize = 240;
/// Height of the plot in points.
const HEIGHT: f32 = 130.0;
/// Thickness in points below which a part of a frame is not drawn.
const THICKNESS_MIN: f32 = 0.2;
/// Number of parts.
const PARTS: usize = 11;
/// Names and colours of the parts, from the bottom.
const LEGEND: [(&str, Color32); PARTS] = [
    ("user changes", Color32::from_rgb(120, 132, 158)),
    ("broad phase", Color32::from_rgb(70, 130, 200)),
    ("narrow phase", Color32::from_rgb(86, 180, 160)),
    ("islands", Color32::from_rgb(160, 190, 90)),
    ("solver", Color32::from_rgb(232, 170, 70)),
    ("continuous", Color32::from_rgb(220, 110, 90)),
    ("rest of the step", Color32::from_rgb(170, 120, 190)),
    ("scripts, history", Color32::from_rgb(110, 84, 140)),
    ("drawing", Color32::from_rgb(90, 96, 110)),
    ("panels", Color32::from_rgb(130, 118, 96)),
    ("adapter, display", Color32::from_rgb(60, 66, 80)),
];

/// The parts of a frame beside the stages of the step, by their positions in the legend.
#[derive(Copy, Clone)]
pub(crate) enum Part {
    /// Scripts, copies for the history, the compared world.
    BesideSteps = 7,
    /// The drawing of the scene, and its commands for the adapter.
    Drawing,
    /// All other work of the window's thread.
    Panels,
    /// The time from the end of this work to the next frame: the adapter paints, and the display shows the
    /// result.
    Display,
}

/// Milliseconds of each part, by frame.
#[derive(Default)]
pub(crate) struct StagePlot {
    frames: VecDeque<[f64; PARTS]>,
    current: [f64; PARTS],
}

impl StagePlot {
    /// Adds the times of a step to the current frame.
    pub(crate) fn after_step(&mut self, world: &PhysicsWorld) {
        let counters = &world.physics_pipeline.counters;
        let parts = [
            counters.user_changes_time_ms(),
            counters.broad_phase_time_ms(),
            counters.narrow_phase_time_ms(),
            counters.island_construction_time_ms(),
            counters.solver_time_ms(),
            counters.ccd_time_ms(),
        ];
        let rest = counters.step_time_ms() - parts.iter().sum::<f64>();
        for (sum, part) in self.current.iter_mut().zip(parts.into_iter().chain([rest.max(0.0)])) {
            *sum += part;
        }
    }

    /// Adds the time since the begin of the frame that belongs to no other part so far.
    pub(crate) fn add_rest(&mut self, part: Part, begin: Instant) {
        let known: f64 = self.current.iter().sum();
        self.current[part as usize] += (milliseconds(begin) - known).max(0.0);
    }

    /// Adds the time since a moment.
    pub(crate) fn add(&mut self, part: Part, since: Instant) {
        self.current[part as usize] += milliseconds(since);
    }

    /// Ends the frame.
    pub(crate) fn end_frame(&mut self) {
        self.frames.push_back(std::mem::take(&mut self.current));
        while self.frames.len() > FRAMES {
            self.frames.pop_front();
        }
    }

    /// Mean milliseconds of each part over the last frames.
    fn means(&self) -> [f64; PARTS] {
        let last = self.frames.iter().rev().take(60);
        let count = last.len().max(1) as f64;
        let sums =
            last.fold([0.0; PARTS], |sums, frame| std::array::from_fn(|i| sums[i] + frame[i]));
        sums.map(|sum| sum / count)
    }

    /// Returns the time that one frame of fifty exceeds: a single slow frame does not flatten the plot.
    fn usual_peak(&self) -> f64 {
        let mut totals: Vec<f64> = self.frames.iter().map(|frame| frame.iter().sum()).collect();
        totals.sort_by(f64::total_cmp);
        let place = totals.len().saturating_sub(1 + totals.len() / 50);
        totals.get(place).map_or(1.0, |&total| total.max(1.0))
    }

    /// Draws the plot and its legend.
    pub(crate) fn show(&self, ui: &mut Ui) {
        let size = Vec2::new(ui.available_width(), HEIGHT);
        let (response, painter) = ui.allocate_painter(size, Sense::hover());
        let rect = response.rect;
        painter.rect_filled(rect, 4.0, Color32::from_rgb(16, 19, 25));
        let top = round_up(self.usual_peak());
        let mut below = vec![0.0; self.frames.len()];
        for part in 0..PARTS {
            let above: Vec<f64> =
                below.iter().zip(&self.frames).map(|(sum, frame)| sum + frame[part]).collect();
            band(&painter, rect, top, (&below, &above), LEGEND[part].1);
            below = above;
        }
        let line = |ms: f64| pos2(rect.left(), height_of(rect, ms / top));
        for ms in [1.0, 4.0, 16.7, 33.3, 100.0].into_iter().filter(|&ms| ms < top && 5.0 * ms > top)
        {
            let from = line(ms);
            let stroke = Stroke::new(1.0, Color32::from_white_alpha(60));
            painter.line_segment([from, pos2(rect.right(), from.y)], stroke);
            let text = format!("{ms:.0} ms");
            let corner = eframe::egui::Align2::LEFT_BOTTOM;
            let font = eframe::egui::FontId::proportional(10.0);
            painter.text(from, corner, text, font, Color32::from_white_alpha(120));
        }
        self.legend(ui);
    }

    fn legend(&self, ui: &mut Ui) {
        let means = self.means();
        eframe::egui::Grid::new("legend").num_columns(4).spacing([10.0, 2.0]).show(ui, |ui| {
            for (row, pair) in LEGEND.chunks(2).enumerate() {
                for (column, (name, color)) in pair.iter().enumerate() {
                    ui.horizontal(|ui| {
                        let (rect, _) = ui.allocate_exact_size(Vec2::splat(9.0), Sense::hover());
                        ui.painter().rect_filled(rect, 2.0, *color);
                        ui.small(*name);
                    });
                    ui.small(format!("{:.2} ms", means[2 * row + column]));
                }
                ui.end_row();
            }
        });
    }
}

fn milliseconds(since: Instant) -> f64 {
    1.0e3 * since.elapsed().as_secs_f64()
}

/// The next round number of milliseconds.
fn round_up(ms: f64) -> f64 {
    [2.0, 5.0, 10.0, 20.0, 40.0, 80.0, 160.0, 320.0]
        .into_iter()
        .find(|&top| ms <= top)
        .unwrap_or(ms)
}

fn height_of(rect: Rect, fraction: f64) -> f32 {
    rect.bottom() - rect.height() * fraction.min(1.0) as f32
}

/// Fills the band between two curves, frame by frame.
fn band(
    painter: &eframe::egui::Painter,
    rect: Rect,
    top: f64,
    (below, above): (&[f64], &[f64]),
    color: Color32,
) {
    let width = rect.width() / FRAMES as f32;
    let first = FRAMES - below.len();
    let x = |i: usize| rect.left() + (first + i) as f32 * width;
    let mut mesh = eframe::egui::Mesh::default();
    for (i, (low, high)) in below.iter().zip(above).enumerate() {
        let [bottom, peak] = [low, high].map(|ms| height_of(rect, ms / top));
        // Most stages are too short to be seen, and each triangle costs an adapter in software.
        if bottom - peak < THICKNESS_MIN {
            continue;
        }
        let (left, right) = (x(i), x(i) + width);
        let corners: [Pos2; 4] =
            [pos2(left, bottom), pos2(left, peak), pos2(right, peak), pos2(right, bottom)];
        let start = mesh.vertices.len() as u32;
        corners.into_iter().for_each(|corner| mesh.colored_vertex(corner, color));
        mesh.add_triangle(start, start + 1, start + 2);
        mesh.add_triangle(start, start + 2, start + 3);
    }
    painter.add(Shape::mesh(mesh));
}
