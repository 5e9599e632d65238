//! Numbers of queries per second: rays, and balls that are cast along them.
//!
//! A scene advances by one step, so that every engine has its trees, and then stays as it is. All engines run
//! the same queries by turns. The table has the number of hits beside the time: fewer hits mean less work.

use crate::args::Options;
use crate::catalog::Scene;
use crate::clock::Clock;
use crate::engine::{Engine, Kind, Probes, Template};
use gallery::{Progress, Table, grouped};
use std::io::{self, Write};

/// Number of queries of each kind.
const COUNT: usize = 50_000;

const HEADINGS: [&str; 8] =
    ["scene", "engine", "rays/s", "ratio", "hits", "ball casts/s", "ratio", "hits"];

/// Meaning of the columns.
const LEGEND: &str = "\
Rays and ball casts start at random points in random directions. They are as long as the scene is wide, and the balls have a hundredth of
its height. rays/s, ball casts/s: median over the rounds of the number per second of time on the processor, one thread. ratio: this
engine's number divided by the engine's, so above 1 this engine is faster. hits: number of queries with a result.";

/// Results of one engine in one round: seconds and hits, for rays and for balls; `None` for missing queries.
type Answers = [Option<(f64, usize)>; 2];

/// Engine that runs the queries.
struct Contestant<'t> {
    kind: Kind,
    engine: Box<dyn Engine + 't>,
    /// Results of each round.
    answers: Vec<Answers>,
}

/// Runs the chosen scenes and prints the table.
pub fn run(scenes: &[Scene], options: &Options) -> io::Result<()> {
    let mut table = Table::new(&HEADINGS);
    for &index in &options.scenes {
        let scene = &scenes[index];
        let template = (scene.build)();
        let label = format!("{}, {COUNT} rays and balls", scene.title());
        let mut contestants = start(&*template, &options.engines);
        let count = contestants.len();
        let mut progress = Progress::new(&label, label.len(), options.rounds * count);
        for round in 0..options.rounds {
            for (position, contestant) in contestants.iter_mut().enumerate() {
                contestant.answers.push(run_queries(&*contestant.engine, &*template, round));
                progress.advance(round * count + position + 1);
            }
        }
        progress.clear();
        add_rows(scene, &contestants, &mut table);
    }
    let mut out = io::stdout().lock();
    table.print(&mut out)?;
    writeln!(out, "\n{LEGEND}")
}

/// Returns the engines that can take part, after their first step.
fn start<'t>(template: &'t dyn Template, kinds: &[Kind]) -> Vec<Contestant<'t>> {
    let start = |&kind| {
        let mut engine = template.start(kind, 1).ok()?;
        engine.step();
        Some(Contestant { kind, engine, answers: Vec::new() })
    };
    kinds.iter().filter_map(start).collect()
}

/// Runs one round of one engine.
fn run_queries(engine: &dyn Engine, template: &dyn Template, round: usize) -> Answers {
    let probes = Probes::random(COUNT, template.region(), round as u64);
    [None, Some(probes.radius)].map(|radius| {
        let clock = Clock::start(1);
        let hits = engine.cast(&probes, radius)?;
        Some((clock.milliseconds() * 1e-3, hits))
    })
}

fn add_rows(scene: &Scene, contestants: &[Contestant<'_>], table: &mut Table) {
    let ours = contestants.iter().find(|contestant| contestant.kind == Kind::This);
    for contestant in contestants {
        let mut row = vec![scene.title(), scene.engine_name(contestant.kind).to_owned()];
        let ours = ours.filter(|_| contestant.kind != Kind::This);
        for kind_of_query in 0..2 {
            let Some((seconds, hits)) = contestant.median(kind_of_query) else {
                row.extend(["–"; 3].map(str::to_owned));
                continue;
            };
            let ratio = ours.and_then(|ours| Some(seconds / ours.median(kind_of_query)?.0));
            row.push(grouped((COUNT as f64 / seconds) as usize));
            row.push(ratio.map_or(String::new(), |ratio| format!("{ratio:.2}")));
            row.push(grouped(hits));
        }
        table.push(row);
    }
}

impl Contestant<'_> {
    /// Returns the median of the times and the hits of the first round; `None` if the engine has no such
    /// query.
    fn median(&self, kind_of_query: usize) -> Option<(f64, usize)> {
        let answered: Vec<_> =
            self.answers.iter().filter_map(|round| round[kind_of_query]).collect();
        let mut seconds: Vec<f64> = answered.iter().map(|&(seconds, _)| seconds).collect();
        seconds.sort_by(f64::total_cmp);
        Some((*seconds.get(seconds.len() / 2)?, answered.first()?.1))
    }
}
