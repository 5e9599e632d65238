//! Where the time of this engine's step goes.

use crate::args::Options;
use crate::catalog::Scene;
use gallery::{Progress, Table};
use std::io;

/// Runs the chosen scenes in this engine alone and prints the time of each stage.
pub fn run(scenes: &[Scene], options: &Options) -> io::Result<()> {
    for &threads in &options.threads {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(io::Error::other)?;
        for &index in &options.scenes {
            pool.install(|| print(&scenes[index], threads, options))?;
        }
    }
    Ok(())
}

fn print(scene: &Scene, threads: usize, options: &Options) -> io::Result<()> {
    let steps = options.steps.unwrap_or(scene.steps);
    let label = format!("{}, {threads} thread(s)", scene.title());
    let mut progress = Progress::new(&label, label.len(), steps);
    let template = (scene.build)();
    let stages = template.profile(steps, &mut |done| progress.advance(done));
    progress.clear();

    let total = stages.iter().find(|(name, _)| *name == "step").map_or(0.0, |(_, time)| *time);
    let mut table = Table::new(&[&label, "ms/step", "share"]);
    for (name, milliseconds) in stages {
        table.push(vec![
            name.to_owned(),
            format!("{milliseconds:.3}"),
            format!("{:.1} %", milliseconds / total * 100.0),
        ]);
    }
    let mut out = io::stdout().lock();
    table.print(&mut out)?;
    io::Write::write_all(&mut out, b"\n")
}
