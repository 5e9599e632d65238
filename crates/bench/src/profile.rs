//! Times of the stages of this engine's step.
//!
//! Stage times are wall times. The last column is the processor time of all threads. Idle workers spin for a
//! while before they sleep, so with two threads it is nearly twice the step. A value near the step's wall
//! time means that the other threads were idle, as in small scenes, or had no processor. The stages are then
//! those of one thread.

use crate::args::Options;
use crate::catalog::Scene;
use crate::pool;
use crate::units::counted;
use gallery::{Progress, Table};
use std::io::{self, Write};

/// Runs the chosen scenes in this engine alone and prints the time of each stage.
pub fn run(scenes: &[Scene], options: &Options) -> io::Result<()> {
    for &threads in &options.threads {
        let pool = pool::of(threads)?;
        for &index in &options.scenes {
            pool.install(|| print(&scenes[index], threads, options))?;
        }
    }
    Ok(())
}

fn print(scene: &Scene, threads: usize, options: &Options) -> io::Result<()> {
    let steps = options.steps.unwrap_or(scene.steps);
    let label = format!("{}, {}", scene.title(), counted(threads, "thread"));
    let mut progress = Progress::new(&label, label.len(), steps);
    let template = (scene.build)();
    let stages = template.profile(steps, &mut |done| progress.advance(done));
    progress.clear();

    let total = stages.iter().find(|(name, _)| *name == "step").map_or(0.0, |(_, time)| *time);
    let mut table = Table::new(&[&label, "ms/step", "fraction"]);
    for (name, milliseconds) in stages {
        table.push(vec![
            name.to_owned(),
            format!("{milliseconds:.3}"),
            format!("{:.1} %", milliseconds / total * 100.0),
        ]);
    }
    let mut out = io::stdout().lock();
    table.print(&mut out)?;
    writeln!(out)
}
