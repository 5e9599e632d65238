//! One tree without `cfg` on dimension or precision, and twins that stay twins.

use crate::Complaint;
use crate::source::Source;

/// The crate roots: the only files with dimension or precision.
const DOORS: [&str; 2] = ["src/lib2d.rs", "src/lib3d.rs"];
const VARIANTS: [&str; 4] = ["dim2", "dim3", "f32", "f64"];
/// The folder with threads.
const TASKS_FOLDER: &str = "src/base/tasks/";

/// Files that exist in one of `dim2/` and `dim3/` only, with the reason.
const SINGLES: [(&str, &str); 2] = [
    ("src/dim3/collide/cuboid_faces.rs", "faces are clipped by faces; in 2D faces are edges"),
    ("src/dim3/gyroscopic.rs", "gyroscopic motion needs three axes"),
];

/// Complains of misplaced `cfg`s and of twins that differ.
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for source in sources.iter().filter(|source| source.in_engine().is_some()) {
        check_features(source, &mut complaints);
    }
    check_doors(sources, &mut complaints);
    check_dimensions(sources, &mut complaints);
    complaints
}

fn check_features(source: &Source, complaints: &mut Vec<Complaint>) {
    for (number, line) in source.bare.lines().enumerate() {
        for feature in features(line) {
            let variant = VARIANTS
                .iter()
                .any(|variant| feature == *variant || feature.ends_with(&format!("-{variant}")));
            if variant && !DOORS.contains(&source.path.as_str()) {
                let what = format!("depends on the feature `{feature}`: only the front doors may");
                complaints.push(Complaint::new(&source.path, number + 1, what));
            }
            if feature == "parallel" && !source.path.starts_with(TASKS_FOLDER) {
                let what = format!("depends on the feature `parallel`: only {TASKS_FOLDER} may");
                complaints.push(Complaint::new(&source.path, number + 1, what));
            }
        }
    }
}

/// The quoted values of `feature =` in a line.
fn features(line: &str) -> impl Iterator<Item = &str> {
    line.split("feature").skip(1).filter_map(|rest| {
        let value = rest.trim_start().strip_prefix('=')?.trim_start().strip_prefix('"')?;
        value.split('"').next()
    })
}

/// The code of both front doors must be equal except for the dimension.
fn check_doors(sources: &[Source], complaints: &mut Vec<Complaint>) {
    let code = |path: &str| {
        let source = sources.iter().find(|source| source.path == path)?;
        let words = source.tokens.iter();
        Some(
            words
                .map(|t| {
                    (
                        t.line,
                        t.text
                            .replace("2d", "Nd")
                            .replace("3d", "Nd")
                            .replace("dim2", "dimN")
                            .replace("dim3", "dimN"),
                    )
                })
                .collect::<Vec<_>>(),
        )
    };
    let (Some(flat), Some(solid)) = (code(DOORS[0]), code(DOORS[1])) else { return };
    let differ = |(a, b): &(&(usize, String), &(usize, String))| a.1 != b.1;
    let line = match flat.iter().zip(&solid).find(differ) {
        Some((_, there)) => there.0,
        None if flat.len() == solid.len() => return,
        None => 1,
    };
    let what = format!("differs from {} in more than the dimension", DOORS[0]);
    complaints.push(Complaint::new(DOORS[1], line, what));
}

/// `dim2/` and `dim3/` must have the same files, apart from the listed [`SINGLES`].
fn check_dimensions(sources: &[Source], complaints: &mut Vec<Complaint>) {
    let exists = |path: &str| sources.iter().any(|source| source.path == path);
    for source in sources {
        let Some(twin) = twin(&source.path) else { continue };
        if !SINGLES.iter().any(|(path, _)| *path == source.path) && !exists(&twin) {
            let what = format!("has no twin {twin}, and is not listed as single");
            complaints.push(Complaint::new(&source.path, 1, what));
        }
    }
    for (path, _) in SINGLES {
        let has_twin = twin(path).is_some_and(|twin| exists(&twin));
        if !sources.is_empty() && (!exists(path) || has_twin) {
            complaints.push(Complaint::new(path, 1, "is listed as single but is not"));
        }
    }
}

fn twin(path: &str) -> Option<String> {
    let flat = path.strip_prefix("src/dim2/").map(|rest| format!("src/dim3/{rest}"));
    flat.or_else(|| path.strip_prefix("src/dim3/").map(|rest| format!("src/dim2/{rest}")))
}

#[cfg(test)]
mod tests {
    use super::{SINGLES, check_dimensions, check_doors, check_features};
    use crate::Complaint;
    use crate::source::Source;

    fn of_features(path: &str, text: &str) -> usize {
        let mut complaints = Vec::new();
        check_features(&Source::new(path, text), &mut complaints);
        complaints.len()
    }

    #[test]
    fn only_the_doors_test_the_dimension() {
        for feature in ["dim2", "dim3", "f32", "f64", "parry3d-f64"] {
            let text = format!("#[cfg(all(test, feature = \"{feature}\"))]");
            assert_eq!(of_features("src/model/a.rs", &text), 1, "{feature}");
            assert_eq!(of_features("src/lib3d.rs", &text), 0, "{feature}");
        }
        assert_eq!(of_features("src/model/a.rs", "#[cfg(feature = \"serde-serialize\")]"), 0);
        assert_eq!(of_features("src/model/a.rs", "// cfg(feature = \"f64\")"), 0);
    }

    #[test]
    fn only_tasks_test_for_threads() {
        let text = "#[cfg(not(feature = \"parallel\"))]";
        assert_eq!(of_features("src/step/mod.rs", text), 1);
        assert_eq!(of_features("src/base/tasks/mod.rs", text), 0);
    }

    fn of(check: fn(&[Source], &mut Vec<Complaint>), files: &[(&str, &str)]) -> Vec<Complaint> {
        let sources: Vec<_> = files.iter().map(|(path, text)| Source::new(path, text)).collect();
        let mut complaints = Vec::new();
        check(&sources, &mut complaints);
        complaints
    }

    #[test]
    fn the_doors_are_twins() {
        let (flat, solid) = ("mod dim2; mod base;", "mod dim3;\nmod base;");
        assert!(of(check_doors, &[("src/lib2d.rs", flat), ("src/lib3d.rs", solid)]).is_empty());
        let solid = "mod dim3;\nmod step;";
        let complaints = of(check_doors, &[("src/lib2d.rs", flat), ("src/lib3d.rs", solid)]);
        assert_eq!(complaints.iter().map(|c| c.line).collect::<Vec<_>>(), [2]);
        let solid = "mod dim3; mod base; mod step;";
        let complaints = of(check_doors, &[("src/lib2d.rs", flat), ("src/lib3d.rs", solid)]);
        assert_eq!(complaints.len(), 1);
    }

    #[test]
    fn dimensions_have_the_same_files() {
        let singles = SINGLES.map(|(path, _)| (path, ""));
        assert!(of(check_dimensions, &singles).is_empty());
        let mut files = singles.to_vec();
        files.push(("src/dim3/motion.rs", ""));
        assert_eq!(of(check_dimensions, &files)[0].file, "src/dim3/motion.rs");
        files.push(("src/dim2/motion.rs", ""));
        assert!(of(check_dimensions, &files).is_empty());
        files.push(("src/dim2/collide/cuboid_faces.rs", ""));
        assert_eq!(of(check_dimensions, &files)[0].file, "src/dim3/collide/cuboid_faces.rs");
    }
}
