//! Worlds of few bodies: what a step costs besides its contacts.
//!
//! Here all engines detect collisions continuously, as their defaults do. A round is a fresh world. After
//! some steps to settle, blocks of steps are timed, and the shortest block of all rounds counts: other
//! programs can only lengthen a block.

use crate::args::Options;
use crate::catalog::{Scene, engine_name};
use crate::clock::Clock;
use crate::engine::{Kind, Template};
use crate::report::{machine, markdown, publish, written_by};
use crate::scenes;
use crate::units::counted;
use gallery::{Progress, Table};
use std::io::{self, Write};

/// Steps before the measurement.
const SETTLE: usize = 60;
/// Blocks of a round.
const BLOCKS: usize = 20;
/// Steps of a block.
const STEPS: usize = 20;

/// Page of `--write`.
const PAGE: &str = "small.md";

const LEGEND: &str = "\
Microseconds of a step on the processor, one thread, steps of 1/60 s, 4 substeps. No body sleeps. Continuous collision detection has each engine's own default: this engine searches the paths of all fast bodies, \
Rapier those of bodies that request it, Box3D and Box2D those of fast bodies against fixed ones. The shortest of 20 blocks of 20 steps in each round counts. \
Ratio: the time of the fastest peer divided by this engine's, so above 1 this engine is faster.";

/// World of few bodies.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Small {
    /// Nothing.
    Empty,
    /// A ball in free fall.
    FreeBall,
    /// A ball at rest on a box.
    BallOnGround,
    /// A box at rest on a box.
    BoxOnGround,
    /// A hinge with a motor and limits.
    Door,
    /// Five boxes that hang on each other.
    Chain,
    /// Ten such chains.
    Chains,
    /// 500 balls in free fall.
    FreeFall,
    /// 500 balls that are thrown upwards at 60 m/s.
    Fast,
    /// 20 boxes on 10,000 fixed blocks.
    AmongFixed,
}

impl Small {
    const ALL: [Self; 10] = [
        Self::Empty,
        Self::FreeBall,
        Self::BallOnGround,
        Self::BoxOnGround,
        Self::Door,
        Self::Chain,
        Self::Chains,
        Self::FreeFall,
        Self::Fast,
        Self::AmongFixed,
    ];

    fn title(self) -> &'static str {
        match self {
            Self::Empty => "empty world",
            Self::FreeBall => "one free ball",
            Self::BallOnGround => "ball on the ground",
            Self::BoxOnGround => "box on the ground",
            Self::Door => "door with a motor",
            Self::Chain => "chain of 5",
            Self::Chains => "ten chains of 5",
            Self::FreeFall => "500 balls in free fall",
            Self::Fast => "500 fast balls, nothing near",
            Self::AmongFixed => "20 boxes on 10,000 fixed blocks",
        }
    }
}

/// Times of all worlds in a dimension.
struct Outcome {
    dimension: &'static str,
    headings: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

/// Runs all worlds in the chosen dimensions, and prints a table for each.
pub fn run(scenes: &[Scene], options: &Options) -> io::Result<()> {
    let chosen =
        |dimension: &str| options.scenes.iter().any(|&index| scenes[index].dimension == dimension);
    let mut outcomes = Vec::new();
    let mut out = io::stdout().lock();
    for dimension in ["3d", "2d"].into_iter().filter(|dimension| chosen(dimension)) {
        let outcome = measure(dimension, options);
        let mut table = Table::new(&outcome.headings);
        outcome.rows.iter().for_each(|row| table.push(row.clone()));
        table.print(&mut out)?;
        writeln!(out)?;
        outcomes.push(outcome);
    }
    writeln!(out, "{LEGEND}")?;
    if options.write { write(&outcomes, options.rounds) } else { Ok(()) }
}

/// Times all engines in all worlds of a dimension, by turns.
fn measure(dimension: &'static str, options: &Options) -> Outcome {
    let engines = &options.engines;
    let mut headings = vec![if dimension == "3d" { "3D" } else { "2D" }];
    headings.extend(engines.iter().map(|&kind| engine_name(kind, dimension)));
    headings.push("ratio");
    let label = format!("{dimension}, few bodies");
    let turns = options.rounds * engines.len();
    let mut progress = Progress::new(&label, label.len(), Small::ALL.len() * turns);
    let mut rows = Vec::new();
    for (index, world) in Small::ALL.into_iter().enumerate() {
        let template = scenes::small(dimension, world);
        let mut best = vec![None; engines.len()];
        for turn in 0..turns {
            let position = turn % engines.len();
            if let Some(time) = time(&*template, engines[position]) {
                best[position] = Some(best[position].map_or(time, |known: f64| known.min(time)));
            }
            progress.advance(index * turns + turn + 1);
        }
        rows.push(row(world, engines, &best));
    }
    progress.clear();
    Outcome { dimension, headings, rows }
}

/// Writes the page.
fn write(outcomes: &[Outcome], rounds: usize) -> io::Result<()> {
    let mut page = format!(
        "# Few bodies\n\n{}, {}. Machine: {}.\n\n{LEGEND}\n",
        written_by(),
        counted(rounds, "round"),
        machine()
    );
    for Outcome { dimension, headings, rows } in outcomes {
        page += &format!("\n## {}\n\n", dimension.to_uppercase());
        page += &markdown(headings, &headings[..1], rows);
    }
    publish(PAGE, &page)
}

/// The shortest time of a step in a fresh world (µs); `None` if the engine cannot build the world.
fn time(template: &dyn Template, kind: Kind) -> Option<f64> {
    let mut engine = template.start(kind, 1).ok()?;
    (0..SETTLE).for_each(|_| engine.step());
    let blocks = (0..BLOCKS).map(|_| {
        let clock = Clock::start(1);
        (0..STEPS).for_each(|_| engine.step());
        clock.milliseconds() * 1e3 / STEPS as f64
    });
    blocks.min_by(f64::total_cmp)
}

fn row(world: Small, engines: &[Kind], best: &[Option<f64>]) -> Vec<String> {
    let digits = |time: f64| if time < 10.0 { format!("{time:.2}") } else { format!("{time:.1}") };
    let mut row = vec![world.title().to_owned()];
    row.extend(best.iter().map(|time| time.map_or("–".to_owned(), digits)));
    let times = || engines.iter().zip(best).filter_map(|(&kind, &time)| Some((kind, time?)));
    let own = times().find(|(kind, _)| *kind == Kind::This).map(|(_, time)| time);
    let peer =
        times().filter(|(kind, _)| kind.is_peer()).map(|(_, time)| time).min_by(f64::total_cmp);
    let ratio = peer.zip(own).map(|(peer, own)| format!("{:.2}", peer / own));
    row.push(ratio.unwrap_or_default());
    row
}
