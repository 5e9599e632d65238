//! # Benchmark — how fast is this engine beside its peers?
//!
//! Builds each scene once with this engine, transcribes it into every other engine, and lets them
//! take the same steps by turns: one round of each, then the next round. The machine may be busy
//! with other things; what disturbs one engine is then likely to disturb the next, so that the ratio
//! means more than the milliseconds. With one thread only time on the processor counts.
//!
//! This engine in double precision takes part as one more engine; it is no peer. Where nothing is asked but
//! how costs grow (`--growth`), worlds are made of one thing again and again.
//!
//! The same rules for all: steps of 1/60 s with 4 substeps, no body sleeps (but where sleeping bodies
//! are what grows), no continuous collision detection, contact stiffness and recycling as each engine's
//! own defaults have them, the same compiler profile. The first step counts as making the world.
//!
//! All engines are linked into one program. This engine and Rapier share the geometry crate, and
//! cargo gives both the sum of the features they ask for: this engine asks for none that changes what a step executes
//! (saving adds code that no step calls), so Rapier gets the geometry that it would get alone. With the feature `simd8` both get
//! the geometry crate's eight lanes.

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
mod solid;
mod units;

use args::{Options, Request};
use std::io::Write;
use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: memory::Counting = memory::Counting;

/// Exit code when the command line cannot be understood.
const EXIT_USAGE: u8 = 2;

fn main() -> ExitCode {
    let scenes = catalog::scenes();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match args::parse(&arguments, &scenes) {
        Ok(Request::Help) => args::print_help(&scenes),
        Ok(Request::Run(options)) if options.profile => profile::run(&scenes, &options),
        Ok(Request::Run(options)) if options.queries => queries::run(&scenes, &options),
        Ok(Request::Run(options)) if options.saving => saving::run(&scenes, &options),
        Ok(Request::Run(options)) if options.growth => growth::run(&scenes, &options),
        Ok(Request::Run(options)) => run(&scenes, &options),
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "bench: {error}");
            return ExitCode::from(EXIT_USAGE);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of a pipe may leave before the end, as `head` does: not a failure.
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
