//! # Fuzzer — random and hostile use of the engine
//!
//! Reads a string of bytes as a sequence of operations on a world, runs them, and checks the invariants of
//! the world after each step. Most operations are valid, some are impossible, and any may follow any other.
//!
//! Seeds generate the strings (`cargo test -p fuzzer`, and without limit `cargo run --profile fuzz -p
//! fuzzer`), or a coverage-guided fuzzer (`fuzz/` beside the workspace). Each finding has its own test,
//! mostly in `tests/hostile/`. A new operation here changes the meaning of strings, but not of tests.
//!
//! The code is compiled four times, once against each crate. Files in `both/` use the names `rapier` and
//! `dim`, and the modules here bind these names.

#![expect(
    clippy::duplicate_mod,
    reason = "the files of `both` are compiled once against each of the four crates"
)]

mod choices;
pub mod deliberate_panic;
pub mod findings;

pub use choices::random_bytes;

/// Names of the families: worlds of one kind, each with an invariant.
pub const FAMILIES: [&str; 5] = ["closed", "thin", "driven", "trees", "crowds"];
/// Number of equally frequent kinds of strings: one per family, and the others mix all operations.
const KINDS: usize = 16;

/// Returns the family of a string from its first byte.
fn family_of(first: usize) -> Option<usize> {
    (first % KINDS).checked_sub(KINDS - FAMILIES.len())
}

/// Turns a string into one of a family.
pub fn set_family(bytes: &mut [u8], family: usize) {
    if let Some(first) = bytes.first_mut() {
        *first = (KINDS - FAMILIES.len() + family) as u8;
    }
}

/// Counts of the work in one world.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Number of operations, without steps.
    pub operations: usize,
    /// Number of steps.
    pub steps: usize,
}

impl Tally {
    /// Adds the counts of another world.
    pub fn add(&mut self, other: Self) {
        self.operations += other.operations;
        self.steps += other.steps;
    }
}

/// Runs the operations of the bytes on a world.
///
/// Panics if an invariant is violated.
pub type Run = fn(&[u8]) -> Tally;

/// The four crates with their names.
pub const CRATES: [(&str, Run); 4] = [
    ("rapier2d", flat::run),
    ("rapier3d", solid::run),
    ("rapier2d-f64", flat_f64::run),
    ("rapier3d-f64", solid_f64::run),
];

/// The crate for 2D.
pub mod flat {
    use rapier2d as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "drive.rs"]
    mod drive;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}

/// The crate for 3D.
pub mod solid {
    use rapier3d as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "drive.rs"]
    mod drive;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}

/// The crate for 2D with double precision.
#[path = "flat"]
pub mod flat_f64 {
    use rapier2d_f64 as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "drive.rs"]
    mod drive;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}

/// The crate for 3D with double precision.
#[path = "solid"]
pub mod solid_f64 {
    use rapier3d_f64 as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "drive.rs"]
    mod drive;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}
