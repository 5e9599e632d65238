//! Sizes of saved worlds, and times of saving and restoring.
//!
//! Every engine runs the same steps, and is then saved and restored as its authors recommend. This engine
//! writes snapshots, Rapier serialises its sets with bincode.

use crate::args::Options;
use crate::catalog::Scene;
use crate::clock::Clock;
use crate::engine::{Engine, Kind, Template};
use gallery::{Progress, Table, grouped};
use std::io::{self, Write};

/// Default number of steps before a world is saved.
const STEPS: usize = 100;

/// Number of turns of saving and restoring per round. The shortest turn counts: other programs can only
/// lengthen one.
const TURNS: usize = 10;

const HEADINGS: [&str; 10] = [
    "scene",
    "engine",
    "bodies",
    "pairs",
    "step",
    "bytes/body",
    "save",
    "restore",
    "save/body",
    "rollback",
];

const LEGEND: &str = "\
step, save, restore, rollback: milliseconds of time on the processor, one thread; the shortest turn of all rounds. save: the world as bytes. restore: a world from these bytes.
save/body: microseconds to save and to restore, per body. rollback: to save into an earlier copy in memory and to return to it. pairs: pairs of colliders that touch.";

/// Shortest times so far (ms).
#[derive(Copy, Clone)]
struct Times {
    step: f64,
    save: f64,
    restore: f64,
    rollback: Option<f64>,
}

/// Engine that is saved.
struct Contestant<'t> {
    kind: Kind,
    engine: Box<dyn Engine + 't>,
    bytes: usize,
    times: Option<Times>,
}

/// Runs the chosen scenes and prints the table.
pub fn run(scenes: &[Scene], options: &Options) -> io::Result<()> {
    let mut table = Table::new(&HEADINGS);
    for &index in &options.scenes {
        let scene = &scenes[index];
        let template = (scene.build)();
        let label = format!("{}, saved and restored", scene.title());
        let mut contestants = start(&*template, options);
        let count = contestants.len();
        let mut progress = Progress::new(&label, label.len(), options.rounds * count);
        for round in 0..options.rounds {
            for (position, contestant) in contestants.iter_mut().enumerate() {
                contestant.take_round();
                progress.advance(round * count + position + 1);
            }
        }
        progress.clear();
        for contestant in &contestants {
            table.push(contestant.row(scene));
        }
    }
    let mut out = io::stdout().lock();
    table.print(&mut out)?;
    writeln!(out, "\n{LEGEND}")
}

/// Returns the engines that can be saved, after their first steps.
fn start<'t>(template: &'t dyn Template, options: &Options) -> Vec<Contestant<'t>> {
    let start = |&kind| {
        let mut engine = template.start(kind, 1).ok()?;
        (0..options.steps.unwrap_or(STEPS)).for_each(|_| engine.step());
        engine.save()?;
        Some(Contestant { kind, engine, bytes: 0, times: None })
    };
    options.engines.iter().filter_map(start).collect()
}

impl Contestant<'_> {
    fn take_round(&mut self) {
        for _ in 0..TURNS {
            let times = self.take_turn();
            let before = self.times.unwrap_or(times);
            let rollback = times.rollback.map(|time| time.min(before.rollback.unwrap_or(time)));
            self.times = Some(Times {
                step: times.step.min(before.step),
                save: times.save.min(before.save),
                restore: times.restore.min(before.restore),
                rollback,
            });
        }
    }

    fn take_turn(&mut self) -> Times {
        let clock = Clock::start(1);
        let bytes = self.engine.save().unwrap_or_default();
        let save = clock.milliseconds();
        self.bytes = bytes.len();
        let clock = Clock::start(1);
        let is_restored = self.engine.load(&bytes);
        let restore = clock.milliseconds();
        assert!(is_restored, "an engine restores its own saved world");
        let rollback = self.engine.save_and_return();
        let clock = Clock::start(1);
        self.engine.step();
        Times { step: clock.milliseconds(), save, restore, rollback }
    }

    fn row(&self, scene: &Scene) -> Vec<String> {
        let counts = self.engine.counts();
        let bodies = counts.bodies.max(1);
        let milliseconds = |time: f64| format!("{time:.2}");
        let mut row = vec![scene.title(), scene.engine_name(self.kind).to_owned()];
        row.extend([grouped(counts.bodies), grouped(counts.pairs)]);
        let Some(Times { step, save, restore, rollback }) = self.times else { return row };
        row.push(milliseconds(step));
        row.push(grouped(self.bytes / bodies));
        row.extend([milliseconds(save), milliseconds(restore)]);
        row.push(milliseconds(1e3 * (save + restore) / bodies as f64));
        row.push(rollback.map_or("–".to_owned(), milliseconds));
        row
    }
}
