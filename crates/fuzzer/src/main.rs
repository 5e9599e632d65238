//! Random operations without limit, with a progress bar: see `--help`.

mod watch;

use fuzzer::findings::{Finding, minimised, search};
use fuzzer::{CRATES, FAMILIES, Run, Tally, random_bytes, set_family};
use std::collections::BTreeMap;
use std::io::{IsTerminal, Write};
use std::process::ExitCode;
use std::time::{Duration, Instant};
use watch::Watch;

const HELP: &str = "Runs random operations on worlds and checks their invariants.

Usage: fuzzer [OPTIONS]

  --crate NAME        rapier2d, rapier3d, rapier2d-f64 or rapier3d-f64 (default: all by turns)
  --operations N      stop after so many operations (default: 1000000)
  --seed N            first seed (default: 0)
  --bytes N           length of a string of random bytes (default: 2000)
  --family NAME       closed, thin, driven, trees or crowds: worlds of one kind, each with a law (default: some
                      of each, and mostly worlds with arbitrary operations)
  --replay FILE       runs the operations of a file only
  -h, --help          print this

Each finding is minimised and written to a file in the current folder. A sequence that takes longer than a
minute is also a finding, and ends the search. The profile `fuzz` enables the engine's own checks:
cargo run --profile fuzz -p fuzzer";

/// Interval of the progress bar's updates.
const TICK: Duration = Duration::from_millis(500);
const BAR: usize = 30;

struct Options {
    crates: Vec<(&'static str, Run)>,
    operations: usize,
    seed: u64,
    bytes: usize,
    family: Option<usize>,
    replay: Option<String>,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "-h" || argument == "--help") {
        println!("{HELP}");
        return ExitCode::SUCCESS;
    }
    match parse(&arguments).and_then(|options| run(&options)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("fuzzer: {error}");
            ExitCode::from(2)
        }
    }
}

fn parse(arguments: &[String]) -> Result<Options, String> {
    let mut options = Options {
        crates: CRATES.to_vec(),
        operations: 1_000_000,
        seed: 0,
        bytes: 2000,
        family: None,
        replay: None,
    };
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        let value = rest.next().ok_or_else(|| format!("`{argument}` needs a value after it"))?;
        let number =
            || value.parse().map_err(|_| format!("`{argument}` needs a number, not `{value}`"));
        match argument.as_str() {
            "--crate" => options.crates.retain(|(name, _)| name == value),
            "--operations" => options.operations = number()?,
            "--seed" => options.seed = number()? as u64,
            "--bytes" => options.bytes = number()?,
            "--family" => {
                let family = FAMILIES.iter().position(|name| name == value);
                let unknown = || format!("`{value}` is no family; `--help` lists them");
                options.family = Some(family.ok_or_else(unknown)?);
            }
            "--replay" => options.replay = Some(value.clone()),
            _ => return Err(format!("unknown option `{argument}`; `--help` lists the options")),
        }
    }
    if options.crates.is_empty() {
        return Err("there is no such crate; `--help` lists them".into());
    }
    Ok(options)
}

/// Returns whether the run has no finding.
fn run(options: &Options) -> Result<bool, String> {
    if !cfg!(debug_assertions) {
        eprintln!(
            "without the checks inside of the engine: use `cargo run --profile fuzz -p fuzzer`"
        );
    }
    if let Some(file) = &options.replay {
        return replay(options, file);
    }
    let (watch, mut progress) = (Watch::new(), Progress::new(options.operations));
    let mut findings: BTreeMap<String, usize> = BTreeMap::new();
    let turns =
        (options.seed..).flat_map(|seed| options.crates.iter().map(move |&which| (seed, which)));
    for (seed, (name, run)) in turns {
        let mut bytes = random_bytes(seed, options.bytes);
        options.family.into_iter().for_each(|family| set_family(&mut bytes, family));
        let start = Instant::now();
        let outcome = watch.during(format!("{name}-{seed}"), &bytes, || search(run, &bytes));
        progress.note_time(start.elapsed(), || format!("{name}, seed {seed}"));
        match outcome {
            Ok(tally) => progress.add(tally),
            Err(finding) => {
                let times = findings.entry(finding.place.clone()).or_default();
                *times += 1;
                if *times == 1 {
                    report(name, seed, &minimised(run, &bytes, &finding), &finding)?;
                }
            }
        }
        progress.show(findings.len());
        if progress.tally.operations >= options.operations {
            break;
        }
    }
    progress.finish(findings.len());
    findings.iter().for_each(|(place, times)| println!("{times:>6} times {place}"));
    Ok(findings.is_empty())
}

/// Runs the operations of a file in each crate. Returns whether all invariants hold.
fn replay(options: &Options, file: &str) -> Result<bool, String> {
    let bytes = std::fs::read(file).map_err(|error| format!("{file}: {error}"))?;
    let outcomes = options.crates.iter().map(|&(name, run)| (name, search(run, &bytes)));
    let outcomes: Vec<_> = outcomes.collect();
    for (name, outcome) in &outcomes {
        match outcome {
            Ok(tally) => println!("{name}: all invariants hold after {} steps", tally.steps),
            Err(finding) => println!("{name}: {finding}"),
        }
    }
    Ok(outcomes.iter().all(|(_, outcome)| outcome.is_ok()))
}

fn report(name: &str, seed: u64, bytes: &[u8], finding: &Finding) -> Result<(), String> {
    let file = format!("finding-{name}-{seed}.bin");
    std::fs::write(&file, bytes).map_err(|error| format!("{file}: {error}"))?;
    println!("{}{name}, seed {seed}, {} bytes in {file}:\n    {finding}", wipe(), bytes.len());
    Ok(())
}

/// Returns the control sequence that clears the progress bar, if there is one.
fn wipe() -> &'static str {
    if std::io::stdout().is_terminal() { "\r\x1b[K" } else { "" }
}

/// Progress bar with the rate of operations. Output without a terminal has no bar.
struct Progress {
    start: Instant,
    shown: Instant,
    goal: usize,
    tally: Tally,
    /// Longest time of a sequence, and its name.
    slowest: (Duration, String),
}

impl Progress {
    fn new(goal: usize) -> Self {
        let now = Instant::now();
        Self {
            start: now,
            shown: now,
            goal: goal.max(1),
            tally: Tally::default(),
            slowest: Default::default(),
        }
    }

    fn note_time(&mut self, time: Duration, name: impl FnOnce() -> String) {
        if time > self.slowest.0 {
            self.slowest = (time, name());
        }
    }

    fn add(&mut self, tally: Tally) {
        self.tally.add(tally);
    }

    fn show(&mut self, findings: usize) {
        if self.shown.elapsed() < TICK || !std::io::stdout().is_terminal() {
            return;
        }
        self.shown = Instant::now();
        let full = (BAR * self.tally.operations / self.goal).min(BAR);
        let bar = "#".repeat(full) + &".".repeat(BAR - full);
        print!("\r[{bar}] {}", self.line(findings));
        let _ = std::io::stdout().flush();
    }

    fn finish(&self, findings: usize) {
        println!("{}{}", wipe(), self.line(findings));
        println!("slowest: {} with {:.2} s", self.slowest.1, self.slowest.0.as_secs_f64());
    }

    fn line(&self, findings: usize) -> String {
        let Tally { operations, steps } = self.tally;
        let rate = operations as f64 / self.start.elapsed().as_secs_f64();
        format!(
            "{operations} operations, {steps} steps, {rate:.0} operations/s, {findings} findings"
        )
    }
}
