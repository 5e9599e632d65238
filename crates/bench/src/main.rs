//! # Benchmark — speed of this engine and its peers
//!
//! Builds each scene with this engine and transcribes it into every other engine. The engines run the same
//! steps by turns: one round of each, then the next round. On a busy machine a disturbance is likely to
//! affect all engines alike, so ratios are more reliable than times. With one thread only processor time
//! counts.
//!
//! This engine in double precision takes part as a further engine; it is not a peer. The growth measurement
//! (`--growth`) builds worlds from many copies of one arrangement.
//!
//! All engines follow the same rules: steps of 1/60 s with 4 substeps, and the same compiler profile. No body
//! sleeps, except in curves over sleeping bodies. Continuous collision detection is off, except in small
//! worlds. Contact stiffness and recycling have each engine's own defaults. The first step counts as building
//! the world.
//!
//! One program links all engines. This engine and Rapier share the geometry crate, which cargo builds with
//! the sum of their requested features. This engine requests no feature that changes the code of a step, so
//! Rapier gets the same geometry as alone. (Saving adds code that no step calls.) With the feature `simd8`
//! both get the geometry crate's eight lanes.

#![expect(
    clippy::duplicate_mod,
    reason = "the files of `both` are compiled once against the 2D and once against the 3D engines"
)]

mod args;
mod catalog;
mod chart;
mod clock;
mod contest;
mod engine;
mod equal;
mod flat;
mod growth;
mod means;
mod memory;
mod pool;
mod profile;
mod queries;
mod report;
mod saving;
mod scenes;
mod small;
mod solid;
mod units;

use args::{Options, Request};
use std::io::Write;
use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: memory::Counting = memory::Counting;

/// Exit code for an invalid command line.
const EXIT_USAGE: u8 = 2;

fn main() -> ExitCode {
    let scenes = scenes::all();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match args::parse(&arguments, &scenes) {
        Ok(Request::Help) => args::print_help(&scenes),
        Ok(Request::Redraw) => report::redraw(),
        Ok(Request::Run(options)) if options.profile => profile::run(&scenes, &options),
        Ok(Request::Run(options)) if options.queries => queries::run(&scenes, &options),
        Ok(Request::Run(options)) if options.saving => saving::run(&scenes, &options),
        Ok(Request::Run(options)) if options.small => small::run(&scenes, &options),
        Ok(Request::Run(options)) if options.growth => growth::run(&scenes, &options),
        Ok(Request::Run(options)) => run(&scenes, &options),
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "bench: {error}");
            return ExitCode::from(EXIT_USAGE);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of a pipe may close it before the end, as `head` does. That is not a failure.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "bench: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Runs the contests and reports them.
fn run(scenes: &[catalog::Scene], options: &Options) -> std::io::Result<()> {
    let mut contests = Vec::new();
    for &threads in &options.threads {
        let pool = pool::of(threads)?;
        for &index in &options.scenes {
            contests.push(pool.install(|| contest::run(&scenes[index], threads, options)));
        }
    }
    report::print(&mut std::io::stdout().lock(), &contests)?;
    if options.write {
        report::write(&contests, options)?;
    }
    Ok(())
}
