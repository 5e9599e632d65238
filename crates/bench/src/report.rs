//! Table of results, for the terminal and for the documentation.

use crate::args::Options;
use crate::contest::{Contest, Score};
use crate::engine::Kind;
use crate::units::counted;
use crate::{chart, equal, means};
use gallery::{Table, grouped};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

const HEADINGS: [&str; 15] = [
    "scene",
    "threads",
    "engine",
    "ms/step",
    "ratio",
    "best ms",
    "ratio",
    "setup ms",
    "pairs",
    "points",
    "overlap",
    "99 %",
    "apart",
    "kinetic J",
    "bytes/body",
];

/// Folder of the pages and charts of `--write`, relative to the root of the repository.
const FOLDER: &str = "docs/benchmarks";
/// Whether the compiler may use the instructions of this processor (`-C target-cpu=native`). These figures
/// have a separate page.
const IS_NATIVE: bool = cfg!(target_feature = "avx2");
/// Name of the page.
const PAGE: &str = if IS_NATIVE { "native.md" } else { "latest.md" };
/// Name of its chart.
const CHART: &str = if IS_NATIVE { "native.svg" } else { "latest.svg" };

/// Build flags of the engines and their reasons, for each of the two pages.
const BUILDS: &str = if IS_NATIVE {
    "All engines are built for this processor (`-C target-cpu=native`, `-march=native`), Rapier with its features `parallel` and `simd8`. \
     The other page is [latest.md](latest.md)."
} else {
    "All engines are built as their users get them: default flags of the compiler, the feature `parallel` of Rapier. At default flags its \
     feature `simd8` makes it slower, so it is off here ([how much](../performance.md#fair-builds)); [native.md](native.md) has figures with `simd8` and \
     `-C target-cpu=native` for all."
};

/// Meaning of the columns, and the rules.
const LEGEND: &str = "\
ms/step: mean over all steps but the first of the step's median over the rounds. best ms: the same with
the step's fastest round. setup ms: to make the world and take the first step, in the fastest round;
some engines insert new bodies at once, and others insert them in the next step. With one thread it is
time on the processor, with more it is time on the wall.
ratio: the engine's time divided by this engine's, so above 1 this engine is faster.
pairs, points: touching pairs and their contact points at the end, by each engine's own account.
overlap: deepest overlap of any pair at the end, measured from shapes and poses in the same way for all.
99 %: the 99th percentile of the overlap of all overlapping pairs.
apart: largest distance between the two anchors of any joint at the end, measured likewise.
kinetic: energy of all dynamic bodies at the end.
bytes/body: memory of the world at the end per dynamic body, contacts and all.";

/// Prints the table and its summary.
pub fn print(out: &mut dyn Write, contests: &[Contest]) -> io::Result<()> {
    let mut table = Table::new(&HEADINGS);
    rows(contests).into_iter().for_each(|row| table.push(row));
    table.print(out)?;
    for line in absences(contests) {
        writeln!(out, "{line}")?;
    }
    writeln!(out, "\n{LEGEND}\n")?;
    for line in means::lines(contests).into_iter().chain(equal::notes(contests)) {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// Writes the table as a page of the documentation, with a chart.
pub fn write(contests: &[Contest], options: &Options) -> io::Result<()> {
    publish(PAGE, &page(contests, options))
}

/// Writes a page of the documentation, and draws its charts.
pub fn publish(name: &str, page: &str) -> io::Result<()> {
    let folder = folder()?;
    chart::draw(&folder, page)?;
    std::fs::write(folder.join(name), page)
}

/// Draws the charts of all pages from their tables.
pub fn redraw() -> io::Result<()> {
    let folder = folder()?;
    for page in ["latest.md", "native.md", "growth.md"] {
        chart::draw(&folder, &std::fs::read_to_string(folder.join(page))?)?;
    }
    Ok(())
}

/// Creates the folder of pages and charts if necessary, and returns its path.
fn folder() -> io::Result<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(FOLDER);
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// Formats the page in Markdown.
fn page(contests: &[Contest], options: &Options) -> String {
    let mut page = format!(
        "# Beside its peers\n\n\
         {}, {}.\n\
         Machine: {}.\n\
         All: steps of 1/60 s, 4 substeps, no sleeping, no continuous collision detection.\n\n\
         {BUILDS}\n\n",
        written_by(),
        counted(options.rounds, "round"),
        machine()
    );
    let points = |lines: Vec<String>| lines.into_iter().map(|line| format!("* {line}.\n"));
    page.extend(points(means::lines(contests)));
    // Without a peer there is no bar.
    if contests.iter().any(|contest| means::ratio_to_fastest(contest).is_some()) {
        page += &format!(
            "\n![How many times as fast as the fastest peer this engine is, for each scene]({CHART})\n"
        );
    }
    page += "\n## Figures\n\n";
    page += &markdown(&HEADINGS, &["scene", "engine"], &rows(contests));
    page.push('\n');
    page.extend(points(absences(contests)));
    page.push_str("\n```text\n");
    page.push_str(LEGEND);
    page.push_str("\n```\n\n## Equal work\n\n");
    page.extend(equal::notes(contests).into_iter().map(|note| format!("* {note}\n")));
    page
}

/// Returns the command that writes a page.
pub fn written_by() -> String {
    let flags =
        if IS_NATIVE { "RUSTFLAGS='-C target-cpu=native' CFLAGS=-march=native " } else { "" };
    let features = [
        ("box3d", cfg!(feature = "box3d")),
        ("box2d", cfg!(feature = "box2d")),
        ("simd8", cfg!(feature = "simd8")),
    ];
    let features: Vec<&str> =
        features.iter().filter(|(_, on)| *on).map(|(name, _)| *name).collect();
    let features = match features.as_slice() {
        [] => String::new(),
        names => format!(" --features {}", names.join(",")),
    };
    let words: Vec<String> = std::env::args().skip(1).collect();
    let command = format!("{flags}cargo run --release -p bench{features} -- {}", words.join(" "));
    format!("Written by\n\n    {command}\n\nEngines by turns in one process")
}

/// Formats a table in Markdown. Columns hold figures, except those in `texts`.
pub fn markdown(headings: &[&str], texts: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let mut table = line(&headings.iter().map(|&heading| heading.to_owned()).collect::<Vec<_>>());
    let rule = |heading: &&str| if texts.contains(heading) { "---" } else { "--:" }.to_owned();
    table += &line(&headings.iter().map(rule).collect::<Vec<_>>());
    table.extend(rows.iter().map(|row| line(row)));
    table
}

fn rows(contests: &[Contest]) -> Vec<Vec<String>> {
    let rows_of = |contest: &Contest| {
        contest.scores().map(|(kind, score)| row(contest, kind, score)).collect::<Vec<_>>()
    };
    contests.iter().flat_map(rows_of).collect()
}

fn row(contest: &Contest, kind: Kind, score: &Score) -> Vec<String> {
    let ratio = |time: fn(&Score) -> f64| match contest.ours() {
        Some(ours) if kind != Kind::This => format!("{:.2}", time(score) / time(ours)),
        _ => String::new(),
    };
    let stats = &score.stats;
    vec![
        contest.scene.clone(),
        contest.threads.to_string(),
        contest.engine_name(kind).to_owned(),
        format!("{:.3}", score.median()),
        ratio(Score::median),
        format!("{:.3}", score.best()),
        ratio(Score::best),
        format!("{:.1}", score.setup()),
        grouped(stats.counts.pairs),
        grouped(stats.counts.points),
        format!("{:.4}", stats.overlap.deepest),
        format!("{:.4}", stats.overlap.percentile99),
        stats.separation.map_or_else(String::new, |gap| format!("{gap:.4}")),
        format!("{:.3}", stats.kinetic_energy),
        grouped(score.bytes / contest.dynamic_bodies.max(1)),
    ]
}

/// Returns the absent engines with their reasons.
fn absences(contests: &[Contest]) -> Vec<String> {
    let mut lines = Vec::new();
    for contest in contests {
        for (kind, outcome) in &contest.outcomes {
            if let Err(reason) = outcome {
                let line = format!(
                    "{}: without {}: {}",
                    contest.scene,
                    contest.engine_name(*kind),
                    reason.0
                );
                if !lines.contains(&line) {
                    lines.push(line);
                }
            }
        }
    }
    lines
}

/// Returns the name of the processor, if the system has it.
pub fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let model = model.map_or("unknown processor", |(_, model)| model);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{model}, {cores} hardware threads, {}", std::env::consts::OS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{Stats, Unsupported};

    fn contest() -> Contest {
        let score = |ms| Score {
            rounds: vec![vec![ms]],
            setups: vec![7.0],
            stats: Stats::default(),
            bytes: 3000,
        };
        Contest {
            scene: "3d/tower".into(),
            dynamic_bodies: 30,
            threads: 1,
            outcomes: vec![
                (Kind::This, Ok(score(2.0))),
                (Kind::Rapier, Ok(score(4.0))),
                (Kind::Box, Err(Unsupported("not built in".into()))),
            ],
        }
    }

    #[test]
    fn the_ratio_is_above_one_when_this_engine_is_faster() {
        let rows = rows(&[contest()]);
        assert_eq!(rows.len(), 2);
        assert_eq!((rows[0][4].as_str(), rows[0][6].as_str()), ("", ""));
        assert_eq!((rows[1][4].as_str(), rows[1][6].as_str()), ("2.00", "2.00"));
        assert_eq!((rows[1][7].as_str(), rows[1][14].as_str()), ("7.0", "100"));
    }

    #[test]
    fn an_absent_engine_is_listed_once() {
        let lines = absences(&[contest(), contest()]);
        assert_eq!(lines, ["3d/tower: without Box3D: not built in"]);
    }
}
