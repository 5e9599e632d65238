//! Tables of the curves, for the terminal and for the documentation, and their charts.

use super::Growth;
use super::curve::Setting;
use crate::args::Options;
use crate::catalog::engine_name;
use crate::contest::Score;
use crate::engine::Kind;
use crate::report::{machine, markdown, publish, written_by};
use crate::units::counted;
use gallery::{Table, grouped};
use std::io::{self, Write};

/// Name of the page.
const PAGE: &str = "growth.md";

const HEADINGS: [&str; 8] =
    ["engine", "bodies", "threads", "awake", "pairs", "points", "ms/step", "bytes/body"];

/// Meaning of the columns.
const LEGEND: &str = "\
bodies: number of bodies that the curve varies. awake: dynamic bodies that are awake at the end. pairs, points: touching pairs and their
contact points at the end, as each engine counts them. ms/step: mean of the step's median over the rounds, without the first step and
steps in which bodies fall asleep. With one thread it is time on the processor, with more it is time on the wall. bytes/body: memory of
the world at the end, with its contacts, divided by the number of all its bodies, floors included.";

/// Prints a curve as a table.
pub fn print(out: &mut dyn Write, growth: &Growth) -> io::Result<()> {
    writeln!(out, "{}\n{}\n", title(growth), growth.curve.description())?;
    let mut table = Table::new(&HEADINGS);
    rows(growth).into_iter().for_each(|row| table.push(row));
    table.print(out)?;
    for remark in growth.remarks() {
        writeln!(out, "{remark}")?;
    }
    writeln!(out)
}

/// Formats the title: `Fixed bodies, 3D`.
fn title(growth: &Growth) -> String {
    format!("{}, {}", growth.curve.heading(), growth.dimension.to_uppercase())
}

fn rows(growth: &Growth) -> Vec<Vec<String>> {
    let row = |(setting, kind, score): (&Setting, Kind, &Score)| {
        let counts = &score.stats.counts;
        vec![
            engine_name(kind, growth.dimension).to_owned(),
            grouped(setting.world.bodies()),
            setting.threads.to_string(),
            grouped(counts.awake),
            grouped(counts.pairs),
            grouped(counts.points),
            format!("{:.3}", score.median()),
            grouped(bytes_per_body(score) as usize),
        ]
    };
    growth.scores().map(row).collect()
}

/// Writes the page and its charts.
pub fn write(growths: &[Growth], options: &Options) -> io::Result<()> {
    let mut page = format!(
        "# How costs grow\n\n\
         {}, {}.\n\
         Machine: {}. Steps of 1/60 s, 4 substeps, no continuous collision detection, no sleeping unless stated.\n\n\
         ```text\n{LEGEND}\n```\n",
        written_by(),
        rounds(options),
        machine()
    );
    let mut last = None;
    for growth in growths {
        if last.replace(growth.curve) != Some(growth.curve) {
            page += &format!("\n## {}\n\n{}\n", growth.curve.heading(), growth.curve.description());
        }
        let picture = format!("growth-{}-{}.svg", growth.curve.name(), growth.dimension);
        page += &format!("\n![{}]({picture})\n\n", title(growth));
        page += &markdown(&HEADINGS, &["engine"], &rows(growth));
        let remarks = growth.remarks();
        page.extend(remarks.iter().map(|remark| format!("\n* {remark}\n")));
    }
    publish(PAGE, &page)
}

/// Formats the number of rounds: `3 rounds (1 with a million bodies)`.
fn rounds(options: &Options) -> String {
    let rounds = counted(options.rounds, "round");
    if options.rounds > 1 { rounds + " (1 with a million bodies)" } else { rounds }
}

/// Returns the bytes per body of any type.
fn bytes_per_body(score: &Score) -> f64 {
    score.bytes as f64 / score.stats.counts.bodies.max(1) as f64
}
