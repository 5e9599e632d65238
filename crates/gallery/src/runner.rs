//! Runs scenes without a window: steps, then a picture and a row of the table for each.

use crate::album::{self, Page};
use crate::args::Options;
use crate::catalog::{Entry, SceneRun, StageTimes, Stats};
use crate::painter::Painter;
use crate::progress::{Progress, seconds};
use crate::recording::Recording;
use crate::table::{Table, grouped};
use drawing::{Image, raster};
use std::io::{self, Write};
use std::time::Instant;

/// Size of a picture in pixels.
const SIZE: [usize; 2] = [1280, 720];
/// Frames per second of animations: one per two steps of the usual length.
const FRAMES_PER_SECOND: u16 = 30;

/// Result of a run.
pub(crate) struct Outcome {
    pub steps: usize,
    pub times: StageTimes,
    /// Counts at the end, with the largest penetration of the whole run.
    pub stats: Stats,
}

/// Runs the chosen scenes, one after the other.
pub(crate) fn run(
    out: &mut dyn Write,
    title: &str,
    entries: &[Entry],
    options: &Options,
    painter: &mut dyn Painter,
) -> io::Result<()> {
    // A folder without write access fails before hours of stepping.
    album::create_folder(&options.folder)?;

    let started = Instant::now();
    let label_width = options.chosen.iter().map(|&i| entries[i].name.len()).max().unwrap_or(0);
    let mut table = Table::new(&HEADINGS);
    let mut pages = Vec::new();
    for (position, &index) in options.chosen.iter().enumerate() {
        let entry = &entries[index];
        let steps = options.steps.unwrap_or(entry.steps);
        let mut progress = Progress::new(entry.name, label_width, steps);
        let mut scene = (entry.start)();
        let mut recording = options.record.map(|frames| Recording::new(frames, steps));
        let outcome = take_steps(scene.as_mut(), steps, &mut progress, recording.as_mut());
        progress.clear();

        let mut page =
            Page { entry, file: format!("{}.png", entry.name), recording: None, outcome };
        draw(scene.as_mut(), &page, painter).save(&options.folder.join(&page.file))?;
        if let Some(recording) = recording {
            let file = format!("{}-moving.png", entry.name);
            recording
                .paint(painter, &scene.view())
                .save(&options.folder.join(&file), FRAMES_PER_SECOND)?;
            page.recording = Some(file);
        }
        writeln!(out, "{}", report_line(&page, position, options.chosen.len(), label_width))?;
        out.flush()?;
        table.push(cells(&page));
        pages.push(page);
    }
    album::write(&options.folder, title, &pages)?;

    writeln!(out)?;
    table.print(out)?;
    writeln!(
        out,
        "\n{} {} in {}. Pictures: {}",
        pages.len(),
        if pages.len() == 1 { "scene" } else { "scenes" },
        seconds(started.elapsed()),
        options.folder.join(album::PAGE).display()
    )
}

/// Runs the steps and returns the sum of their times.
fn take_steps(
    scene: &mut dyn SceneRun,
    steps: usize,
    progress: &mut Progress,
    mut recording: Option<&mut Recording>,
) -> Outcome {
    let mut times = StageTimes::default();
    let mut stats = scene.stats();
    let mut penetration = 0.0;
    for done in 1..=steps {
        times += scene.step();
        stats = scene.stats();
        penetration = stats.penetration.max(penetration);
        if let Some(recording) = &mut recording {
            recording.after_step(scene, done);
        }
        progress.advance(done);
    }
    Outcome { steps, times, stats: Stats { penetration, ..stats } }
}

fn draw(scene: &mut dyn SceneRun, page: &Page, painter: &mut dyn Painter) -> Image {
    let drawing = scene.draw();
    let camera = drawing.camera(&scene.view(), SIZE);
    let picture = painter.paint(&drawing, &camera, SIZE);
    let stats = &page.outcome.stats;
    let caption = [
        page.entry.name.replace('_', " "),
        format!(
            "{} steps   {} bodies   {} contacts",
            page.outcome.steps, stats.bodies, stats.contacts
        ),
    ];
    raster::write(&picture, &camera, &drawing.labels, &caption)
}

/// Returns the log line of a finished scene.
fn report_line(page: &Page, position: usize, count: usize, label_width: usize) -> String {
    let digits = count.to_string().len();
    format!(
        "[{:>digits$}/{count}] {:label_width$}  {:>5} steps in {:>7}",
        position + 1,
        page.entry.name,
        page.outcome.steps,
        seconds(page.outcome.times.total),
    )
}

const HEADINGS: [&str; 9] = [
    "scene",
    "bodies",
    "contacts",
    "steps/s",
    "broad %",
    "narrow %",
    "solver %",
    "rest %",
    "max overlap",
];

/// Returns the scene's row of the table.
fn cells(page: &Page) -> Vec<String> {
    let Outcome { stats, times, .. } = &page.outcome;
    let mut cells = vec![
        page.entry.name.to_owned(),
        grouped(stats.bodies),
        grouped(stats.contacts),
        page.outcome.rate(),
    ];
    cells.extend(times.percentages().iter().map(|percentage| format!("{percentage:.0}")));
    cells.push(format!("{:.4}", stats.penetration));
    cells
}

impl Outcome {
    /// Returns the steps per second, to three digits.
    pub(crate) fn rate(&self) -> String {
        let total = self.times.total.as_secs_f64();
        if total <= 0.0 {
            return "-".to_owned();
        }
        match self.steps as f64 / total {
            rate if rate < 10.0 => format!("{rate:.2}"),
            rate if rate < 100.0 => format!("{rate:.1}"),
            rate => grouped(rate as usize),
        }
    }
}
