//! The command line.

use crate::catalog::{Category, Entry};
use std::fmt;
use std::io::{self, Write};
use std::path::PathBuf;

/// Default folder of pictures and recordings.
pub const DEFAULT_FOLDER: &str = "target/gallery";

/// Parsed command line.
#[derive(Debug, PartialEq)]
pub(crate) enum Request {
    Help,
    List,
    Run(Options),
}

/// Options of a run.
#[derive(Debug, PartialEq)]
pub(crate) struct Options {
    /// Whether no window is opened even with a display.
    pub headless: bool,
    /// Positions of the chosen scenes in the list, in the order of the command line.
    pub chosen: Vec<usize>,
    /// Number of steps for every scene. `None` selects each scene's own number.
    pub steps: Option<usize>,
    /// Folder of the pictures.
    pub folder: PathBuf,
    /// Number of frames of an animation of every scene, or `None` without animations.
    pub record: Option<usize>,
    /// The renderer of pictures.
    pub renderer: Renderer,
}

/// A way to paint pictures.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Renderer {
    /// The graphics adapter if there is one, otherwise the processor.
    Auto,
    /// The processor.
    Cpu,
    /// The graphics adapter.
    Gpu,
}

/// Reason why the command line is invalid.
#[derive(Debug, PartialEq)]
pub(crate) enum UsageError {
    UnknownOption(String),
    MissingValue(&'static str),
    BadNumber { option: &'static str, value: String },
    BadRenderer(String),
    UnknownScene { name: String, known: Vec<&'static str> },
}

impl fmt::Display for UsageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            UsageError::UnknownOption(option) => {
                write!(f, "unknown option `{option}`; `--help` lists the options")
            }
            UsageError::MissingValue(option) => write!(f, "`{option}` needs a value after it"),
            UsageError::BadNumber { option, value } => {
                write!(f, "`{option}` needs a whole number of at least 1, not `{value}`")
            }
            UsageError::BadRenderer(value) => {
                write!(f, "`--renderer` is `auto`, `gpu` or `cpu`, not `{value}`")
            }
            UsageError::UnknownScene { name, known } => {
                write!(f, "no scene is called `{name}`; the scenes are:")?;
                known.iter().try_for_each(|scene| write!(f, "\n  {scene}"))
            }
        }
    }
}

/// Parses the arguments (without the program's name).
pub(crate) fn parse(arguments: &[String], entries: &[Entry]) -> Result<Request, UsageError> {
    let mut options = Options {
        headless: false,
        chosen: Vec::new(),
        steps: None,
        folder: PathBuf::from(DEFAULT_FOLDER),
        record: None,
        renderer: Renderer::Auto,
    };
    let mut list = false;
    let mut rest = arguments.iter().map(String::as_str);
    while let Some(argument) = rest.next() {
        // `--steps=5` and `--steps 5` mean the same.
        let (name, mut inline) = match argument.split_once('=') {
            Some((name, value)) if name.starts_with("--") => (name, Some(value)),
            _ => (argument, None),
        };
        let mut value =
            |name| inline.take().or_else(|| rest.next()).ok_or(UsageError::MissingValue(name));
        match name {
            "-h" | "--help" => return Ok(Request::Help),
            "--list" => list = true,
            "--headless" => options.headless = true,
            "--steps" => options.steps = Some(parse_number("--steps", value("--steps")?)?),
            "--record" => options.record = Some(parse_number("--record", value("--record")?)?),
            "--renderer" => options.renderer = parse_renderer(value("--renderer")?)?,
            "--out" => options.folder = PathBuf::from(value("--out")?),
            _ if name.starts_with('-') => return Err(UsageError::UnknownOption(name.to_owned())),
            scene => options.chosen.push(find(scene, entries)?),
        }
        if inline.is_some() {
            return Err(UsageError::UnknownOption(argument.to_owned()));
        }
    }
    if list {
        return Ok(Request::List);
    }
    if options.chosen.is_empty() {
        options.chosen.extend(0..entries.len());
    }
    Ok(Request::Run(options))
}

fn parse_number(option: &'static str, value: &str) -> Result<usize, UsageError> {
    match value.parse() {
        Ok(number) if number > 0 => Ok(number),
        _ => Err(UsageError::BadNumber { option, value: value.to_owned() }),
    }
}

fn parse_renderer(value: &str) -> Result<Renderer, UsageError> {
    match value {
        "auto" => Ok(Renderer::Auto),
        "gpu" => Ok(Renderer::Gpu),
        "cpu" => Ok(Renderer::Cpu),
        _ => Err(UsageError::BadRenderer(value.to_owned())),
    }
}

/// Returns the position of the scene with this name.
fn find(name: &str, entries: &[Entry]) -> Result<usize, UsageError> {
    entries.iter().position(|entry| entry.name == name).ok_or_else(|| UsageError::UnknownScene {
        name: name.to_owned(),
        known: entries.iter().map(|entry| entry.name).collect(),
    })
}

/// Prints the usage text.
pub(crate) fn print_help(out: &mut dyn Write, program: &str) -> io::Result<()> {
    writeln!(
        out,
        "Shows the scenes in a window. Without a display, runs them and writes a picture of each.

Usage: {program} [OPTIONS] [SCENE]...

  SCENE         show or run only the scenes with these names, in this order (default: all)

  --list        print the names of the scenes, and what there is to see
  --headless    open no window
  --steps N     take N steps in every scene, not the scene's own number
  --out DIR     folder of the pictures and their page (default: {DEFAULT_FOLDER})
  --record N    also write an animation of the last N frames (30 a second) of every scene
  --renderer R  paint with `gpu`, `cpu`, or the first of them that works (`auto`, the default)
  -h, --help    print this

Through cargo the options come after two dashes:
  cargo run --release --bin {program} -- --headless --steps 100 SCENE"
    )
}

/// Prints the names and descriptions of the scenes, by category.
pub(crate) fn print_list(out: &mut dyn Write, entries: &[Entry]) -> io::Result<()> {
    let width = entries.iter().map(|entry| entry.name.len()).max().unwrap_or(0);
    for category in Category::ALL {
        writeln!(out, "{}", category.heading())?;
        for entry in entries.iter().filter(|entry| entry.category == category) {
            writeln!(out, "  {:width$}  {}", entry.name, entry.description)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries() -> Vec<Entry> {
        ["tower", "rain"]
            .into_iter()
            .map(|name| Entry {
                name,
                description: "a scene",
                category: Category::Basics,
                steps: 10,
                start: Box::new(|| unreachable!("parsing starts no scene")),
            })
            .collect()
    }

    fn parse_words(words: &str) -> Result<Request, UsageError> {
        let arguments: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
        parse(&arguments, &entries())
    }

    fn options(words: &str) -> Options {
        match parse_words(words) {
            Ok(Request::Run(options)) => options,
            other => panic!("`{words}` should run scenes, but gave {other:?}"),
        }
    }

    #[test]
    fn no_arguments_run_all_scenes() {
        let options = options("");
        assert_eq!(options.chosen, [0, 1]);
        assert_eq!(options.steps, None);
        assert_eq!(options.folder, PathBuf::from("target/gallery"));
        assert!(!options.headless);
        assert_eq!((options.record, options.renderer), (None, Renderer::Auto));
    }

    #[test]
    fn scenes_run_in_the_order_given() {
        let options =
            options("--headless rain --steps 7 tower --out=here --record=20 --renderer cpu");
        assert_eq!(options.chosen, [1, 0]);
        assert_eq!(options.steps, Some(7));
        assert_eq!(options.folder, PathBuf::from("here"));
        assert!(options.headless);
        assert_eq!((options.record, options.renderer), (Some(20), Renderer::Cpu));
    }

    #[test]
    fn unknown_scene_lists_the_known_ones() {
        let error = parse_words("tover").unwrap_err().to_string();
        for word in ["`tover`", "tower", "rain"] {
            assert!(error.contains(word), "{error} should name {word}");
        }
    }

    #[test]
    fn invalid_arguments_are_errors() {
        let bad =
            |value: &str| UsageError::BadNumber { option: "--steps", value: value.to_owned() };
        assert_eq!(parse_words("--steps"), Err(UsageError::MissingValue("--steps")));
        assert_eq!(parse_words("--steps 0"), Err(bad("0")));
        assert_eq!(parse_words("--steps=-3"), Err(bad("-3")));
        assert_eq!(parse_words("--quick"), Err(UsageError::UnknownOption("--quick".into())));
        assert_eq!(parse_words("--renderer x"), Err(UsageError::BadRenderer("x".into())));
        assert_eq!(parse_words("--list=no"), Err(UsageError::UnknownOption("--list=no".into())));
    }

    #[test]
    fn help_and_list_take_precedence() {
        assert_eq!(parse_words("tower --help"), Ok(Request::Help));
        assert_eq!(parse_words("--list rain"), Ok(Request::List));
    }
}
