//! Runs all scenes and compares their hashes with the expected ones: see `--help`.

use golden::{EXPECTED, PILES, Scene, Settings, line, scenes, time};
use std::process::ExitCode;
use std::time::Instant;

const HELP: &str = "Runs the golden scenes and compares their hashes with the expected ones.

Usage: golden [OPTIONS]

  --threads N,...   numbers of threads, each for all scenes (default: 1; needs the feature `parallel`)
  --print           print the lines of hashes in the format of src/hashes.txt, and compare nothing
  --time            print the median time of a step in a pile of 1,000 boxes that falls and settles, and compare nothing
  -h, --help        print this

All scenes run with the widest registers of the machine and with its baseline.";

/// One row of the matrix.
struct Row {
    name: String,
    settings: Settings,
}

fn rows(threads: &[usize]) -> Vec<Row> {
    let row = |threads, wide| Row {
        name: format!("{threads} thread(s), {} registers", if wide { "wide" } else { "baseline" }),
        settings: Settings { threads, wide },
    };
    threads.iter().flat_map(|&threads| [row(threads, true), row(threads, false)]).collect()
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        [] => compare(&[1]),
        ["--threads", list] => match list.split(',').map(str::parse).collect::<Result<Vec<_>, _>>()
        {
            Ok(threads) => compare(&threads),
            Err(error) => usage(&format!("`--threads {list}`: {error}")),
        },
        ["--print"] => print(),
        ["--time"] => print_times(),
        ["-h" | "--help"] => {
            println!("{HELP}");
            ExitCode::SUCCESS
        }
        _ => usage(&format!("unknown arguments {arguments:?}; `--help` lists them")),
    }
}

fn usage(message: &str) -> ExitCode {
    eprintln!("golden: {message}");
    ExitCode::from(2)
}

fn print() -> ExitCode {
    for scene in scenes() {
        println!("{}", line(&scene, scene.run(Settings { threads: 1, wide: true })));
    }
    ExitCode::SUCCESS
}

fn print_times() -> ExitCode {
    let start = Instant::now();
    for (engine, pile) in PILES {
        println!("{}", time(engine, pile, || 1000.0 * start.elapsed().as_secs_f64()));
    }
    ExitCode::SUCCESS
}

/// Prints one line for each row of the matrix and each scene that differs.
fn compare(threads: &[usize]) -> ExitCode {
    let (scenes, mut all_equal) = (scenes(), true);
    println!("{} {}: {} scenes", std::env::consts::ARCH, std::env::consts::OS, scenes.len());
    for Row { name, settings } in rows(threads) {
        let wrong: Vec<String> =
            scenes.iter().filter_map(|scene| difference(scene, settings)).collect();
        all_equal &= wrong.is_empty();
        println!("{name}: {} of {} as expected", scenes.len() - wrong.len(), scenes.len());
        wrong.iter().for_each(|line| println!("  {line}"));
    }
    if all_equal { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The line of a scene if it is not among the expected ones.
fn difference(scene: &Scene, settings: Settings) -> Option<String> {
    let found = line(scene, scene.run(settings));
    (!EXPECTED.lines().any(|expected| expected == found)).then_some(found)
}
