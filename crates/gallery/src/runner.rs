//! Runs scenes without a window: steps, then a picture and a row of the table for each.

use crate::album::{self, Page};
use crate::args::Options;
use crate::catalog::{Entry, SceneRun, StageTimes, Stats};
use crate::picture::Picture;
use crate::progress::{Progress, seconds};
use crate::table::{Table, grouped};
use std::io::{self, Write};
use std::time::Instant;

/// What a run has come to.
pub(crate) struct Outcome {
    pub steps: usize,
    pub times: StageTimes,
    /// What there is at the end, with the largest penetration of the whole run.
    pub stats: Stats,
}

/// Runs the chosen scenes, one after the other.
pub(crate) fn run(
    out: &mut dyn Write,
    title: &str,
    entries: &[Entry],
    options: &Options,
) -> io::Result<()> {
    // Before hours of stepping: can the pictures be written at all?
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
        let outcome = take_steps(scene.as_mut(), steps, &mut progress);
        progress.clear();

        let page = Page { entry, file: format!("{}.png", entry.name), outcome };
        draw(scene.as_ref(), &page).save(&options.folder.join(&page.file))?;
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

/// Takes the steps and adds up what they cost.
fn take_steps(scene: &mut dyn SceneRun, steps: usize, progress: &mut Progress) -> Outcome {
    let mut times = StageTimes::default();
    let mut stats = scene.stats();
    let mut penetration = 0.0;
    for done in 1..=steps {
        times += scene.step();
        stats = scene.stats();
        penetration = stats.penetration.max(penetration);
        progress.advance(done);
    }
    Outcome { steps, times, stats: Stats { penetration, ..stats } }
}

fn draw(scene: &dyn SceneRun, page: &Page) -> Picture {
    let mut picture = Picture::new(scene.view());
    scene.draw(&mut picture);
    let stats = &page.outcome.stats;
    picture.caption(
        &page.entry.name.replace('_', " "),
        &format!(
            "{} steps   {} bodies   {} contacts",
            page.outcome.steps, stats.bodies, stats.contacts
        ),
    );
    picture
}

/// What the log says when a scene is done.
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

/// The scene's row of the table.
fn cells(page: &Page) -> Vec<String> {
    let Outcome { stats, times, .. } = &page.outcome;
    let mut cells = vec![
        page.entry.name.to_owned(),
        grouped(stats.bodies),
        grouped(stats.contacts),
        page.outcome.rate(),
    ];
    cells.extend(times.shares().iter().map(|share| format!("{share:.0}")));
    cells.push(format!("{:.4}", stats.penetration));
    cells
}

impl Outcome {
    /// Steps per second, to three digits.
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
