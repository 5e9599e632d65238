//! The command line.

use crate::catalog::Scene;
use crate::engine::Kind;
use crate::growth::curve::Curve;
use std::fmt;
use std::io::Write;
use std::str::FromStr;

/// Parsed command line.
pub enum Request {
    /// The command line requests the usage text.
    Help,
    /// Draw the charts again from the tables of the pages.
    Redraw,
    /// Run the benchmark.
    Run(Options),
}

/// Options of a run.
#[derive(Debug, PartialEq)]
pub struct Options {
    /// Positions of the chosen scenes in the catalogue.
    pub scenes: Vec<usize>,
    /// Engines, in the order of their turns.
    pub engines: Vec<Kind>,
    /// Numbers of threads. Each scene runs once with each number.
    pub threads: Vec<usize>,
    /// Number of steps for every scene. `None` selects each scene's own number.
    pub steps: Option<usize>,
    /// Number of rounds.
    pub rounds: usize,
    /// Whether the table is written as a page of the documentation.
    pub write: bool,
    /// Whether the run prints the stages of this engine's step, without peers.
    pub profile: bool,
    /// Whether the run times queries instead of steps.
    pub queries: bool,
    /// Whether the run saves and restores worlds instead of stepping them.
    pub saving: bool,
    /// Whether the run measures worlds of few bodies instead of scenes.
    pub small: bool,
    /// Whether the run measures growing worlds instead of scenes.
    pub growth: bool,
    /// Curves of the growth measurement.
    pub curves: Vec<Curve>,
    /// Largest number of bodies in a growing world.
    pub bodies_max: usize,
}

/// Default for the largest number of bodies in a growing world.
const BODIES_MAX: usize = 1_000_000;

/// Reason why the command line is invalid.
#[derive(Debug, PartialEq)]
pub enum UsageError {
    /// The option does not exist.
    UnknownOption(String),
    /// The option needs a value, and none follows.
    MissingValue(String),
    /// The value is not a whole number of at least 1.
    BadNumber(String, String),
    /// The scene does not exist.
    UnknownScene(String),
    /// The engine does not exist.
    UnknownEngine(String),
    /// The curve does not exist.
    UnknownCurve(String),
}

impl fmt::Display for UsageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownOption(option) => {
                write!(f, "unknown option `{option}`; `--help` lists the options")
            }
            Self::MissingValue(option) => write!(f, "`{option}` needs a value after it"),
            Self::BadNumber(option, value) => {
                write!(f, "`{option}` needs whole numbers of at least 1, not `{value}`")
            }
            Self::UnknownScene(name) => {
                write!(f, "no scene is called `{name}`; `--help` lists the scenes")
            }
            Self::UnknownEngine(name) => {
                write!(
                    f,
                    "no engine is called `{name}`; there are {}",
                    listed(Kind::ALL.map(Kind::name))
                )
            }
            Self::UnknownCurve(name) => {
                write!(
                    f,
                    "no curve is called `{name}`; there are {}",
                    listed(Curve::ALL.map(Curve::name))
                )
            }
        }
    }
}

/// Formats names as `a`, `b`, `c`.
fn listed<const N: usize>(names: [&str; N]) -> String {
    names.map(|name| format!("`{name}`")).join(", ")
}

/// Parses the arguments (without the program's name).
pub fn parse(arguments: &[String], scenes: &[Scene]) -> Result<Request, UsageError> {
    let mut options = Options {
        scenes: Vec::new(),
        engines: Vec::new(),
        threads: vec![1],
        steps: None,
        rounds: 3,
        write: false,
        profile: false,
        queries: false,
        saving: false,
        small: false,
        growth: false,
        curves: Vec::new(),
        bodies_max: BODIES_MAX,
    };
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        let mut value = || rest.next().ok_or_else(|| UsageError::MissingValue(argument.clone()));
        match argument.as_str() {
            "-h" | "--help" => return Ok(Request::Help),
            "--redraw" => return Ok(Request::Redraw),
            "--write" => options.write = true,
            "--profile" => options.profile = true,
            "--queries" => options.queries = true,
            "--saving" => options.saving = true,
            "--small" => options.small = true,
            "--growth" => options.growth = true,
            "--curve" => options.curves.push(find_curve(value()?)?),
            "--bodies-max" => options.bodies_max = number(argument, value()?)?,
            "--scene" => options.scenes.extend(find_scenes(value()?, scenes)?),
            "--engine" => options.engines.push(find_engine(value()?)?),
            "--steps" => options.steps = Some(number(argument, value()?)?),
            "--rounds" => options.rounds = number(argument, value()?)?,
            "--threads" => {
                options.threads = value()?
                    .split(',')
                    .map(|part| number(argument, part))
                    .collect::<Result<_, _>>()?;
            }
            _ => return Err(UsageError::UnknownOption(argument.clone())),
        }
    }
    if options.scenes.is_empty() {
        options.scenes = (0..scenes.len()).filter(|&index| scenes[index].by_default).collect();
    }
    if options.engines.is_empty() {
        options.engines = Kind::ALL.to_vec();
    }
    if options.curves.is_empty() {
        options.curves = Curve::ALL.to_vec();
    }
    Ok(Request::Run(options))
}

fn number(option: &str, text: &str) -> Result<usize, UsageError> {
    match usize::from_str(text) {
        Ok(number) if number > 0 => Ok(number),
        _ => Err(UsageError::BadNumber(option.to_owned(), text.to_owned())),
    }
}

/// Finds scenes by name: `large_pyramid` in both dimensions, `3d/large_pyramid` in 3D, `2d` for all in 2D.
fn find_scenes(name: &str, scenes: &[Scene]) -> Result<Vec<usize>, UsageError> {
    let fits =
        |scene: &Scene| [scene.name, scene.dimension].contains(&name) || scene.title() == name;
    let found: Vec<usize> = (0..scenes.len()).filter(|&index| fits(&scenes[index])).collect();
    if found.is_empty() { Err(UsageError::UnknownScene(name.to_owned())) } else { Ok(found) }
}

fn find_engine(name: &str) -> Result<Kind, UsageError> {
    let found = Kind::ALL.into_iter().find(|kind| kind.name() == name);
    found.ok_or_else(|| UsageError::UnknownEngine(name.to_owned()))
}

fn find_curve(name: &str) -> Result<Curve, UsageError> {
    let found = Curve::ALL.into_iter().find(|curve| curve.name() == name);
    found.ok_or_else(|| UsageError::UnknownCurve(name.to_owned()))
}

/// Prints the usage text.
pub fn print_help(scenes: &[Scene]) -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "Measures this engine and its peers on the same scenes.

Usage: bench [OPTIONS]

  --scene NAME      a scene: large_pyramid, 3d/large_pyramid, or 3d for all in 3D; may be repeated
  --engine NAME     this, rapier, box (Box3D and Box2D), or double (this engine, f64); may be repeated (default: all)
  --threads N,...   numbers of threads (default: 1)
  --steps N         take N steps in every scene, not the scene's own number
  --rounds N        turns of each engine, each in a fresh world; the median counts (default: 3)
  --profile         the stages of this engine's step instead
  --queries         rays and shape casts per second instead of steps
  --saving          times of saving and restoring worlds instead of steps
  --small           worlds of few bodies, with continuous collision detection, instead of scenes
  --growth          growing worlds instead of scenes; --scene 3d or 2d selects a dimension. All curves except
                    `threads` run with the first number of threads. `threads` runs with all given numbers; if only
                    one is given, with 1 to all threads of the machine
  --curve NAME      awake, static, sleeping, contacts, or threads; may be repeated (default: all)
  --bodies-max N    let worlds grow to N bodies at most (default: 1000000)
  --write           also write the table and its chart to docs/benchmarks/latest.md (native.md if built
                    with -C target-cpu=native), or to growth.md or small.md
  --redraw          only draw the charts again, from the tables of these pages
  -h, --help        print this

Box3D and Box2D take part when they are built in (they need cmake, libclang and a C compiler):
  cargo run --release -p bench --features box3d,box2d
All engines with the instructions of this processor, Rapier with eight lanes:
  RUSTFLAGS='-C target-cpu=native' CFLAGS=-march=native cargo run --release -p bench --features box3d,box2d,simd8

Scenes (* runs by default):"
    )?;
    for scene in scenes {
        let mark = if scene.by_default { '*' } else { ' ' };
        writeln!(out, "  {mark} {:24}  {} steps", scene.title(), scene.steps)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn options(words: &str) -> Result<Options, UsageError> {
        let arguments: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
        match parse(&arguments, &crate::scenes::all())? {
            Request::Run(options) => Ok(options),
            _ => panic!("`{words}` should run"),
        }
    }

    #[test]
    fn every_option_has_a_default() {
        let options = options("").unwrap();
        assert_eq!(options.engines, Kind::ALL);
        assert_eq!((options.threads, options.rounds, options.steps), (vec![1], 3, None));
        assert!(!options.scenes.is_empty() && !options.growth);
        assert_eq!((options.curves, options.bodies_max), (Curve::ALL.to_vec(), BODIES_MAX));
    }

    #[test]
    fn options_are_parsed() {
        let options =
            options("--threads 1,2 --engine rapier --steps 7 --scene 3d/large_pyramid").unwrap();
        assert_eq!(options.threads, [1, 2]);
        assert_eq!(options.engines, [Kind::Rapier]);
        assert_eq!(options.steps, Some(7));
        assert_eq!(options.scenes.len(), 1);
    }

    #[test]
    fn growth_options_are_parsed() {
        let options = options("--growth --curve static --engine double --bodies-max 300").unwrap();
        assert!(options.growth);
        assert_eq!(options.curves, [Curve::Static]);
        assert_eq!(options.engines, [Kind::Double]);
        assert_eq!(options.bodies_max, 300);
    }

    #[test]
    fn a_name_selects_both_dimensions() {
        assert_eq!(options("--scene large_pyramid").unwrap().scenes.len(), 2);
    }

    #[test]
    fn errors_name_the_argument() {
        let error = |words| options(words).unwrap_err();
        assert_eq!(error("--threads 0"), UsageError::BadNumber("--threads".into(), "0".into()));
        assert_eq!(error("--steps"), UsageError::MissingValue("--steps".into()));
        assert_eq!(error("--scene x"), UsageError::UnknownScene("x".into()));
        assert_eq!(error("--engine x"), UsageError::UnknownEngine("x".into()));
        assert_eq!(error("--curve x"), UsageError::UnknownCurve("x".into()));
        assert_eq!(error("-x"), UsageError::UnknownOption("-x".into()));
    }
}
