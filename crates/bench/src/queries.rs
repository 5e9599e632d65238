//! How many questions a second: rays, and balls that are sent along them.
//!
//! A scene takes one step, so that every engine has its trees, and then stands still. All engines are asked the same
//! questions by turns. How many found something stands beside the time: who finds less has less to do.

use crate::args::Options;
use crate::catalog::Scene;
use crate::clock::Clock;
use crate::engine::{Engine, Kind, Probes, Template};
use gallery::{Progress, Table, grouped};
use std::io::{self, Write};

/// Questions of each kind.
const COUNT: usize = 50_000;

const HEADINGS: [&str; 8] =
    ["scene", "engine", "rays/s", "ratio", "hits", "ball casts/s", "ratio", "hits"];

/// What the columns mean.
const LEGEND: &str = "\
Rays, and balls of a hundredth of the scene's height, from random places in random directions, as long as the scene is wide, one thread:
the median over the rounds of their number per second of time on the processor. ratio: this engine's number divided by the engine's, so
above 1 this engine is faster. hits: how many found something.";

/// What one engine has achieved in one round: seconds and hits, for rays and for balls.
/// None of what it cannot be asked.
type Turn = [Option<(f64, usize)>; 2];

/// Runs the chosen scenes and prints the table.
pub fn run(scenes: &[Scene], options: &Options) -> io::Result<()> {
    let mut table = Table::new(&HEADINGS);
    for &index in &options.scenes {
        let scene = &scenes[index];
        let template = (scene.build)();
        let mut turns: Vec<(Kind, Vec<Turn>)> =
            options.engines.iter().map(|&kind| (kind, Vec::new())).collect();
        let label = format!("{}, {COUNT} rays and balls", scene.title());
        let mut progress = Progress::new(&label, label.len(), options.rounds * turns.len());
        let engines = start(&*template, &options.engines);
        for round in 0..options.rounds {
            for (position, (_, turns)) in turns.iter_mut().enumerate() {
                if let Some(engine) = &engines[position] {
                    turns.push(ask(&**engine, &*template, round));
                }
                progress.advance(round * options.engines.len() + position + 1);
            }
        }
        progress.clear();
        rows(scene, &turns, &mut table);
    }
    let mut out = io::stdout().lock();
    table.print(&mut out)?;
    writeln!(out, "\n{LEGEND}")
}

/// The engines that can take part, after their first step.
fn start<'t>(template: &'t dyn Template, kinds: &[Kind]) -> Vec<Option<Box<dyn Engine + 't>>> {
    let start = |&kind| {
        let mut engine = template.start(kind, 1).ok()?;
        engine.step();
        Some(engine)
    };
    kinds.iter().map(start).collect()
}

/// One round of one engine.
fn ask(engine: &dyn Engine, template: &dyn Template, round: usize) -> Turn {
    let probes = Probes::random(COUNT, template.region(), round as u64);
    [None, Some(probes.radius)].map(|radius| {
        let clock = Clock::start(1);
        let hits = engine.cast(&probes, radius)?;
        Some((clock.milliseconds() * 1e-3, hits))
    })
}

fn rows(scene: &Scene, turns: &[(Kind, Vec<Turn>)], table: &mut Table) {
    let ours = turns.iter().find(|(kind, _)| *kind == Kind::This).map(|(_, turns)| turns);
    for (kind, turns) in turns.iter().filter(|(_, turns)| !turns.is_empty()) {
        let mut row = vec![scene.title(), scene.engine_name(*kind).to_owned()];
        for question in 0..2 {
            let Some((seconds, hits)) = middle(turns, question) else {
                row.extend(["–"; 3].map(str::to_owned));
                continue;
            };
            let ours = ours.filter(|_| *kind != Kind::This);
            let ratio = ours.and_then(|turns| Some(seconds / middle(turns, question)?.0));
            row.push(grouped((COUNT as f64 / seconds) as usize));
            row.push(ratio.map_or(String::new(), |ratio| format!("{ratio:.2}")));
            row.push(grouped(hits));
        }
        table.push(row);
    }
}

/// The median of the times, and the hits of the first round.
fn middle(turns: &[Turn], question: usize) -> Option<(f64, usize)> {
    let answered: Vec<_> = turns.iter().filter_map(|turn| turn[question]).collect();
    let mut seconds: Vec<f64> = answered.iter().map(|&(seconds, _)| seconds).collect();
    seconds.sort_by(f64::total_cmp);
    Some((*seconds.get(seconds.len() / 2)?, answered.first()?.1))
}
