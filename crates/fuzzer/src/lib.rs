//! # Fuzzer — a user without sense
//!
//! Reads a string of bytes as a sequence of operations on a world, does them, and checks after each step that the
//! world is in order. Most operations make sense, some are impossible, and any may follow any other.
//!
//! The strings come from a seed (`cargo test -p fuzzer`, and for as long as one likes
//! `cargo run --profile fuzz -p fuzzer`), or from a fuzzer that learns which ones lead to new places in the engine
//! (`fuzz/` beside the workspace). What a string found once has a test of its own, mostly in `tests/hostile/`: a string means
//! something else as soon as an operation is added here, a test does not.
//!
//! All of it is compiled four times, once against each crate: what stands in `both/` says `rapier` and `dim`, and
//! the modules here say which ones these are.

#![expect(
    clippy::duplicate_mod,
    reason = "the files of `both` are compiled once against each of the four crates"
)]

mod choices;
pub mod farewell;
pub mod findings;

pub use choices::random_bytes;

/// The names of the families: worlds of one kind, each with a law that it obeys.
pub const FAMILIES: [&str; 5] = ["closed", "thin", "driven", "trees", "crowds"];
/// One of so many strings is of a given family. Strings of no family do anything.
const KINDS: usize = 16;

/// Returns the family of a string, which its first byte decides.
fn family_of(first: usize) -> Option<usize> {
    (first % KINDS).checked_sub(KINDS - FAMILIES.len())
}

/// Changes a string so that it is one of a family.
pub fn set_family(bytes: &mut [u8], family: usize) {
    if let Some(first) = bytes.first_mut() {
        *first = (KINDS - FAMILIES.len() + family) as u8;
    }
}

/// What was done in one world.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Operations, without steps.
    pub operations: usize,
    /// Steps.
    pub steps: usize,
}

impl Tally {
    /// Adds what was done in another world.
    pub fn add(&mut self, other: Self) {
        self.operations += other.operations;
        self.steps += other.steps;
    }
}

/// Does to a world what the bytes say.
///
/// Panics if anything is not in order.
pub type Run = fn(&[u8]) -> Tally;

/// The four crates, under their names.
pub const CRATES: [(&str, Run); 4] = [
    ("rapier2d", flat::run),
    ("rapier3d", solid::run),
    ("rapier2d-f64", flat_f64::run),
    ("rapier3d-f64", solid_f64::run),
];

/// In 2D.
pub mod flat {
    use rapier2d as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}

/// In 3D.
pub mod solid {
    use rapier3d as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}

/// In 2D with double precision.
#[path = "flat"]
pub mod flat_f64 {
    use rapier2d_f64 as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}

/// In 3D with double precision.
#[path = "solid"]
pub mod solid_f64 {
    use rapier3d_f64 as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;
    #[path = "thin.rs"]
    mod thin;

    pub use both::{forged, run};
}
