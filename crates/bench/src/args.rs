//! The command line.

use crate::catalog::Scene;
use crate::engine::Kind;
use crate::growth::Curve;
use std::fmt;
use std::io::Write;
use std::str::FromStr;

/// What the user asks for.
pub enum Request {
    /// How to call the program.
    Help,
    /// Run the benchmark.
    Run(Options),
}

/// How to run.
#[derive(Debug, PartialEq)]
pub struct Options {
    /// Positions of the chosen scenes in the catalogue.
    pub scenes: Vec<usize>,
    /// The engines, in the order in which they take turns.
    pub engines: Vec<Kind>,
    /// Numbers of threads; everything runs once with each.
    pub threads: Vec<usize>,
    /// Number of steps for every scene, if not the scene's own.
    pub steps: Option<usize>,
    /// Number of rounds.
    pub rounds: usize,
    /// Leave the table as a page in the documentation.
    pub write: bool,
    /// Show the stages of this engine's step, with no peers.
    pub profile: bool,
    /// Ask questions instead of taking steps.
    pub queries: bool,
    /// Save and restore worlds instead of taking steps.
    pub saving: bool,
    /// Let worlds grow instead of running scenes.
    pub growth: bool,
    /// What grows.
    pub curves: Vec<Curve>,
    /// The most bodies that worlds grow to.
    pub bodies_max: usize,
}

/// So far worlds grow if the user does not say.
const BODIES_MAX: usize = 1_000_000;

/// Why the command line cannot be followed.
#[derive(Debug, PartialEq)]
pub enum UsageError {
    /// There is no such option.
    UnknownOption(String),
    /// The option stands last but needs a value.
    MissingValue(String),
    /// The value is no number above zero.
    BadNumber(String, String),
    /// There is no such scene.
    UnknownScene(String),
    /// There is no such engine.
    UnknownEngine(String),
    /// There is no such curve.
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

/// `a`, `b`, `c`
fn listed<const N: usize>(names: [&str; N]) -> String {
    names.map(|name| format!("`{name}`")).join(", ")
}

/// Understands the arguments (without the program's name).
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
        growth: false,
        curves: Vec::new(),
        bodies_max: BODIES_MAX,
    };
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        let mut value = || rest.next().ok_or_else(|| UsageError::MissingValue(argument.clone()));
        match argument.as_str() {
            "-h" | "--help" => return Ok(Request::Help),
            "--write" => options.write = true,
            "--profile" => options.profile = true,
            "--queries" => options.queries = true,
            "--saving" => options.saving = true,
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

/// `large_pyramid` means the scene in both dimensions, `3d/large_pyramid` the one in 3D, `2d` all in 2D.
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

/// Says how to call the program.
pub fn print_help(scenes: &[Scene]) -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "Times this engine beside its peers on the same scenes.

Usage: bench [OPTIONS]

  --scene NAME      a scene: large_pyramid, 3d/large_pyramid, or 3d for all in 3D; may be repeated
  --engine NAME     this, rapier, box (Box3D and Box2D), or double (this engine, f64); may be repeated (default: all)
  --threads N,...   numbers of threads (default: 1)
  --steps N         take N steps in every scene, not the scene's own number
  --rounds N        turns of each engine, each in a fresh world; the median counts (default: 3)
  --profile         the stages of this engine's step instead
  --queries         rays and shapes a second instead of steps
  --saving          worlds that are saved and restored instead of steps
  --growth          worlds that grow instead of scenes; --scene 3d or 2d chooses a dimension. All curves run with the
                    first number of threads, but that over threads with all, or with 1 to all there are if one is given
  --curve NAME      awake, static, sleeping, contacts, or threads; may be repeated (default: all)
  --bodies-max N    let worlds grow to N bodies at most (default: 1000000)
  --write           also write the table and its chart to docs/benchmarks/latest.md (native.md if built
                    with -C target-cpu=native), or to growth.md
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
        match parse(&arguments, &crate::catalog::scenes())? {
            Request::Run(options) => Ok(options),
            Request::Help => panic!("`{words}` should not ask for help"),
        }
    }

    #[test]
    fn everything_has_a_default() {
        let options = options("").unwrap();
        assert_eq!(options.engines, Kind::ALL);
        assert_eq!((options.threads, options.rounds, options.steps), (vec![1], 3, None));
        assert!(!options.scenes.is_empty() && !options.growth);
        assert_eq!((options.curves, options.bodies_max), (Curve::ALL.to_vec(), BODIES_MAX));
    }

    #[test]
    fn options_are_understood() {
        let options =
            options("--threads 1,2 --engine rapier --steps 7 --scene 3d/large_pyramid").unwrap();
        assert_eq!(options.threads, [1, 2]);
        assert_eq!(options.engines, [Kind::Rapier]);
        assert_eq!(options.steps, Some(7));
        assert_eq!(options.scenes.len(), 1);
    }

    #[test]
    fn growth_is_understood() {
        let options = options("--growth --curve static --engine double --bodies-max 300").unwrap();
        assert!(options.growth);
        assert_eq!(options.curves, [Curve::Static]);
        assert_eq!(options.engines, [Kind::Double]);
        assert_eq!(options.bodies_max, 300);
    }

    #[test]
    fn a_name_means_both_dimensions() {
        assert_eq!(options("--scene large_pyramid").unwrap().scenes.len(), 2);
    }

    #[test]
    fn mistakes_are_named() {
        let error = |words| options(words).unwrap_err();
        assert_eq!(error("--threads 0"), UsageError::BadNumber("--threads".into(), "0".into()));
        assert_eq!(error("--steps"), UsageError::MissingValue("--steps".into()));
        assert_eq!(error("--scene x"), UsageError::UnknownScene("x".into()));
        assert_eq!(error("--engine x"), UsageError::UnknownEngine("x".into()));
        assert_eq!(error("--curve x"), UsageError::UnknownCurve("x".into()));
        assert_eq!(error("-x"), UsageError::UnknownOption("-x".into()));
    }
}
