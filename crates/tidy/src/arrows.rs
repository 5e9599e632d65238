//! Dependencies among rooms: docs/architecture.md's table, as code.
//!
//! Every path that begins with `crate::` or `super::` is resolved to its room. Globs are forbidden, because
//! they hide dependencies.

use crate::Complaint;
use crate::source::Source;

/// A part of `src/` in the table.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Room<'a> {
    Base,
    /// Vocabulary of a dimension.
    Dim,
    /// Contact constraints and joint frames of a dimension: vocabulary of the solver, which may use
    /// parameters.
    DimContact,
    /// Inherent methods of the model's types with dimension-specific signatures.
    DimSurface,
    Model,
    /// Dynamics of articulated bodies, independent of world and contacts.
    Multibody,
    /// Contact manifolds of two shapes, independent of bodies and time.
    Collide,
    /// Names in `step/` for all stages.
    Notes,
    /// All sets of a step, for the stages of [`WHOLE_WORLD`] only.
    StepWorld,
    Stage(&'a str),
    /// A room of the solver: see [`SOLVER`].
    Solver(&'a str),
    Step,
    /// Queries of the world: reads it, writes nothing.
    Query,
    /// Characters, vehicles, feedback: users of queries and of the model's public side.
    Controllers,
    DebugRender,
    Api,
    /// `lib2d.rs` and `lib3d.rs`.
    Door,
}

/// Files of `step/` that are no stages but data between stages.
const NOTES: [&str; 1] = ["notes"];
/// Files of `step/` for its driver only.
const DRIVER: [&str; 3] = ["scratch", "stages", "trace"];
/// Stages that get the whole world of a step instead of the sets that their signatures list, with the reason.
const WHOLE_WORLD: [(&str, &str); 2] = [
    ("user_changes", "compares the stamps of all sets"),
    ("quarantine", "searches all sets for causes"),
];

/// The rooms of the solver, each with the rooms that it may use, which stand before it. The solver's `mod.rs`
/// and its tests use all of them.
const SOLVER: [(&str, &[&str]); 18] = [
    ("axis_law", &[]),
    ("blocks", &[]),
    ("context", &[]),
    ("impact_time", &[]),
    ("island_sums", &[]),
    ("joint_rules", &[]),
    ("links", &[]),
    ("restitution", &[]),
    ("stacks", &[]),
    ("states", &[]),
    ("transmission_end", &[]),
    ("groups", &["context", "stacks"]),
    ("bodies", &["context", "groups", "impact_time", "links", "states"]),
    ("ledger", &["bodies", "context", "island_sums", "states"]),
    ("contacts", &["blocks", "bodies", "context", "ledger", "links", "states"]),
    (
        "joints",
        &[
            "axis_law",
            "blocks",
            "bodies",
            "context",
            "impact_time",
            "joint_rules",
            "ledger",
            "links",
            "states",
            "transmission_end",
        ],
    ),
    (
        "multibodies",
        &[
            "axis_law",
            "bodies",
            "context",
            "impact_time",
            "joint_rules",
            "links",
            "restitution",
            "transmission_end",
        ],
    ),
    (
        "impacts",
        &[
            "blocks",
            "bodies",
            "contacts",
            "context",
            "impact_time",
            "island_sums",
            "joints",
            "multibodies",
            "restitution",
            "states",
        ],
    ),
];

/// Files that may use globs, with the reason.
const GLOBS: [(&str, &str); 4] = [
    ("src/api/prelude.rs", "gathers all public names"),
    ("src/api/control.rs", "gathers the names of vehicles, which are in 3D only"),
    ("src/api/dynamics.rs", "gathers the joints that one dimension alone has"),
    ("src/api/geometry.rs", "gathers the shapes' names, which differ by dimension"),
];

impl<'a> Room<'a> {
    /// The room that a module path leads to; `None` if it names no room.
    fn of(path: &[&'a str]) -> Option<Self> {
        Some(match path {
            [] | ["lib2d" | "lib3d", ..] => Self::Door,
            ["base", ..] => Self::Base,
            ["dim" | "dim2" | "dim3", "contact" | "joint", ..] => Self::DimContact,
            ["dim" | "dim2" | "dim3", "surface", ..] => Self::DimSurface,
            // Declared by the dimension that has vehicles; the files are in `controllers/`.
            ["dim" | "dim2" | "dim3", "vehicle", ..] => Self::Controllers,
            ["dim" | "dim2" | "dim3", ..] => Self::Dim,
            ["model", ..] => Self::Model,
            ["multibody", ..] => Self::Multibody,
            ["collide", ..] => Self::Collide,
            ["step", notes, ..] if NOTES.contains(notes) => Self::Notes,
            ["step", "world", ..] => Self::StepWorld,
            ["step", driver, ..] if DRIVER.contains(driver) => Self::Step,
            ["step", "solver", room, ..] if SOLVER.iter().any(|(name, _)| name == room) => {
                Self::Solver(room)
            }
            ["step", stage, ..] if stage.starts_with(char::is_lowercase) && *stage != "mod" => {
                Self::Stage(stage)
            }
            ["step", ..] => Self::Step,
            ["query", ..] => Self::Query,
            ["controllers", ..] => Self::Controllers,
            ["debug_render", ..] => Self::DebugRender,
            [
                "api" | "control" | "data" | "dynamics" | "geometry" | "math" | "pipeline"
                | "prelude",
                ..,
            ] => Self::Api,
            _ => return None,
        })
    }

    /// Returns whether this room may use the other.
    fn may_use(self, other: Self) -> bool {
        use Room::{
            Api, Base, Collide, Controllers, DebugRender, Dim, DimContact, DimSurface, Door, Model,
            Multibody, Notes, Query, Solver, Stage, Step, StepWorld,
        };
        match self {
            _ if self == other => true,
            Door | Api => true,
            Base => false,
            Dim => other == Base,
            DimContact | DimSurface | Multibody | Collide | Notes | StepWorld | DebugRender => {
                matches!(other, Base | Dim | Model)
            }
            Query => matches!(other, Base | Dim | Model | Collide),
            Controllers => matches!(other, Base | Dim | Model | Collide | Query),
            Model => matches!(other, Base | Dim),
            Stage(stage) if other == StepWorld => {
                WHOLE_WORLD.iter().any(|(whole, _)| *whole == stage)
            }
            Stage("solver") if matches!(other, Solver(_)) => true,
            Stage(_) => {
                matches!(other, Base | Dim | DimContact | Model | Multibody | Collide | Notes)
            }
            Solver(room) => match other {
                Solver(used) => {
                    SOLVER.iter().any(|(name, may_use)| *name == room && may_use.contains(&used))
                }
                _ => other != Stage("solver") && Stage("solver").may_use(other),
            },
            Step => matches!(other, Base | Dim | Model | Notes | StepWorld | Stage(_)),
        }
    }
}

/// Complains of arrows that point up, of stages that use each other, and of globs.
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for source in sources {
        if let Some(path) = source.in_engine() {
            check_file(source, &module_path(path), &mut complaints);
        }
    }
    complaints
}

/// `step/solver/mod.rs` → `step`, `solver`.
fn module_path(path: &str) -> Vec<&str> {
    let path = path.strip_suffix(".rs").unwrap_or(path);
    path.strip_suffix("/mod").unwrap_or(path).split('/').collect()
}

fn check_file(source: &Source, module: &[&str], complaints: &mut Vec<Complaint>) {
    let Some(here) = Room::of(module) else {
        complaints.push(Complaint::new(&source.path, 1, "is in no room of docs/architecture.md"));
        return;
    };
    let mut inline = InlineModules::default();
    for at in 0..source.tokens.len() {
        inline.pass(source, at);
        let line = source.tokens[at].line;
        if source.token(at) == "*" && is_foreign_glob(source, at) {
            complaints.push(Complaint::new(&source.path, line, "a glob hides what is used"));
        }
        let Some(target) = path_at(source, at, module, &inline) else { continue };
        let what = match Room::of(&target) {
            None if target[0] == "{" && here != Room::Api => {
                "braces after `crate::`: write one `use` per room".to_owned()
            }
            // Macros are at the crate root.
            None => continue,
            Some(there) if here.may_use(there) => continue,
            Some(_) => format!("{} may not use {}", module.join("::"), target.join("::")),
        };
        complaints.push(Complaint::new(&source.path, line, what));
    }
}

/// Returns whether this sign is the glob of a `use`, except `use super::*`, which opens a module of tests.
fn is_foreign_glob(source: &Source, at: usize) -> bool {
    let glob =
        at >= 2 && source.token(at - 1) == "::" && matches!(source.token(at + 1), ";" | "," | "}");
    let of_tests = source.token(at.wrapping_sub(2)) == "super";
    glob && !of_tests && !GLOBS.iter().any(|(file, _)| *file == source.path)
}

/// The absolute module path of an expression at a token: `crate::…`, or `super::…`.
fn path_at<'a>(
    source: &'a Source,
    at: usize,
    module: &[&'a str],
    inline: &InlineModules<'a>,
) -> Option<Vec<&'a str>> {
    let follows = |back: usize, token| at >= back && source.token(at - back) == token;
    let is_visibility = follows(1, "in") && follows(2, "(") && follows(3, "pub");
    if follows(1, "::") || is_visibility {
        return None;
    }
    let (mut path, mut next) = match source.token(at) {
        "crate" => (Vec::new(), at + 1),
        "super" => {
            let mut path = module.to_vec();
            path.extend(inline.names());
            path.pop();
            (path, at + 1)
        }
        _ => return None,
    };
    // `pub(crate)` and `pub(super)` contain no path either.
    if source.token(next) != "::" {
        return None;
    }
    while source.token(next) == "::" {
        match source.token(next + 1) {
            "super" => drop(path.pop()),
            word => path.push(word),
        }
        next += 2;
    }
    Some(path)
}

/// The enclosing `mod name { … }` of a token.
#[derive(Default)]
struct InlineModules<'a> {
    depth: usize,
    open: Vec<(usize, &'a str)>,
}

impl<'a> InlineModules<'a> {
    fn names(&self) -> impl Iterator<Item = &'a str> {
        self.open.iter().map(|(_, name)| *name)
    }

    fn pass(&mut self, source: &'a Source, at: usize) {
        match source.token(at) {
            "mod" if source.token(at + 2) == "{" => {
                self.open.push((self.depth, source.token(at + 1)));
            }
            "{" => self.depth += 1,
            "}" => {
                self.depth = self.depth.saturating_sub(1);
                if self.open.last().is_some_and(|(depth, _)| *depth == self.depth) {
                    self.open.pop();
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{SOLVER, check};
    use crate::source::Source;

    fn complaints(path: &str, text: &str) -> usize {
        check(&[Source::new(path, text)]).len()
    }

    #[test]
    fn arrows_point_down() {
        assert_eq!(complaints("src/model/a.rs", "use crate::base::arena::Arena;"), 0);
        assert_eq!(complaints("src/base/a.rs", "use crate::model::body::RigidBody;"), 1);
        assert_eq!(complaints("src/model/a.rs", "use crate::dim::contact::ContactBlock;"), 1);
        assert_eq!(complaints("src/model/a.rs", "fn f() { crate::dynamics::g() }"), 1);
        assert_eq!(complaints("src/dim3/contact/a.rs", "use crate::model::params::Softness;"), 0);
        assert_eq!(complaints("src/dim3/math.rs", "use crate::model::params::Softness;"), 1);
        assert_eq!(complaints("src/controllers/vehicle/a.rs", "use crate::query::QueryView;"), 0);
        assert_eq!(complaints("src/controllers/vehicle/a.rs", "use crate::step::step;"), 1);
    }

    #[test]
    fn stages_do_not_import_each_other() {
        let other = "use crate::step::islands::update;";
        assert_eq!(complaints("src/step/solver/a.rs", other), 1);
        assert_eq!(complaints("src/step/islands/a.rs", other), 0);
        assert_eq!(complaints("src/step/mod.rs", other), 0);
        assert_eq!(complaints("src/step/solver/a.rs", "use super::super::islands::update;"), 1);
        assert_eq!(complaints("src/step/solver/a.rs", "use crate::step::StepScratch;"), 1);
        assert_eq!(complaints("src/step/solver/a.rs", "use crate::step::world::World;"), 1);
        assert_eq!(complaints("src/step/quarantine/a.rs", "use crate::step::world::World;"), 0);
        assert_eq!(complaints("src/step/solver/a.rs", "use crate::step::notes::StepNotes;"), 0);
    }

    #[test]
    fn rooms_of_the_solver_form_no_circle() {
        for (position, (room, may_use)) in SOLVER.iter().enumerate() {
            let before = |used: &&&str| SOLVER[..position].iter().all(|(name, _)| name != *used);
            assert_eq!(may_use.iter().find(before), None, "{room} stands before a room it uses");
        }
        let contacts = "use crate::step::solver::contacts::Blocks;";
        assert_eq!(complaints("src/step/solver/impacts/a.rs", contacts), 0);
        assert_eq!(complaints("src/step/solver/joints/a.rs", contacts), 1);
        assert_eq!(complaints("src/step/solver/mod.rs", contacts), 0);
        assert_eq!(complaints("src/step/solver/tests/a.rs", contacts), 0);
        assert_eq!(complaints("src/step/solver/blocks/a.rs", "use super::super::bodies::B;"), 1);
        assert_eq!(complaints("src/step/solver/bodies/a.rs", "use crate::step::solver::S;"), 1);
        assert_eq!(complaints("src/step/islands/a.rs", contacts), 1);
    }

    #[test]
    fn inline_modules_count_when_climbing() {
        let inside = "mod tests { use super::super::math; } fn f() {}";
        assert_eq!(complaints("src/dim3/wide.rs", inside), 0);
        let behind = "mod tests { fn g() { {} } } use super::super::model::body;";
        assert_eq!(complaints("src/dim3/wide.rs", behind), 1);
    }

    #[test]
    fn globs_and_braces_hide_arrows() {
        assert_eq!(complaints("src/model/a.rs", "use crate::base::arena::*;"), 1);
        assert_eq!(complaints("src/model/a.rs", "mod tests { use super::*; }"), 0);
        assert_eq!(complaints("src/model/a.rs", "use crate::{base, dim};"), 1);
        assert_eq!(complaints("src/model/a.rs", "let a = b * crate::base::c;"), 0);
    }

    #[test]
    fn comments_and_visibilities_are_no_arrows() {
        assert_eq!(
            complaints("src/base/a.rs", "//! Not [`crate::model`].\npub(crate) fn f() {}"),
            0
        );
        let visible = "pub(in crate::step::solver) fn f() {}";
        assert_eq!(complaints("src/step/solver/blocks/a.rs", visible), 0);
    }
}
