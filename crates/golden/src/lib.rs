//! # Golden — hashes that every machine must reproduce
//!
//! Each scene is a small world that exercises a part of the engine. A run folds the hash of the world after
//! each step, all events and all answers of queries into one hash. `hashes.txt` holds the expected hashes.
//! The same scenes run natively (`cargo run --release -p golden`), under emulation of another processor, and
//! as WebAssembly (`run.mjs`), and every run must reproduce the file.
//!
//! The scenes are compiled four times, once against each crate: files in `both/` say `rapier` and `dim`, and
//! the modules here bind these names.

#![expect(
    clippy::duplicate_mod,
    reason = "the files of `both` are compiled once against each of the four crates"
)]

mod fold;
mod timing;
mod web;

pub use fold::Fold;
pub use timing::{PILES, Step, time};

/// Settings of a run. No setting may change a hash.
#[derive(Copy, Clone, Debug)]
pub struct Settings {
    /// Number of threads; 0: those of the caller's pool.
    pub threads: usize,
    /// Whether the solver uses the widest registers of the machine.
    pub wide: bool,
}

/// Runs all steps of a scene and returns the hash of the run.
pub type Run = fn(Settings) -> u64;

/// A scene of one crate.
#[derive(Copy, Clone)]
pub struct Scene {
    /// The crate that runs it.
    pub engine: &'static str,
    /// The scene's name.
    pub name: &'static str,
    run: Run,
}

impl Scene {
    /// Runs all steps and returns the hash of the run.
    pub fn run(&self, settings: Settings) -> u64 {
        (self.run)(settings)
    }
}

/// The expected hashes: lines of engine, scene and hash.
pub const EXPECTED: &str = include_str!("hashes.txt");

/// All scenes of all crates.
pub fn scenes() -> Vec<Scene> {
    let engines: [(&str, &[(&str, Run)]); 4] = [
        ("rapier2d", &flat::SCENES),
        ("rapier3d", &solid::SCENES),
        ("rapier2d-f64", &flat_f64::SCENES),
        ("rapier3d-f64", &solid_f64::SCENES),
    ];
    let of_engine = |(engine, scenes): (&'static str, &'static [(&'static str, _)])| {
        scenes.iter().map(move |&(name, run)| Scene { engine, name, run })
    };
    engines.into_iter().flat_map(of_engine).collect()
}

/// The line of a scene in the file of expected hashes.
pub fn line(scene: &Scene, hash: u64) -> String {
    format!("{:<13} {:<10} {hash:016x}", scene.engine, scene.name)
}

/// In 2D.
mod flat {
    use rapier2d as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;

    pub use both::{SCENES, pile};
}

/// In 3D.
mod solid {
    use rapier3d as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;

    pub use both::{SCENES, pile};
}

/// In 2D and double precision.
#[path = "flat"]
mod flat_f64 {
    use rapier2d_f64 as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;

    pub use both::{SCENES, pile};
}

/// In 3D and double precision.
#[path = "solid"]
mod solid_f64 {
    use rapier3d_f64 as rapier;

    #[path = "../both/mod.rs"]
    mod both;
    #[path = "dim.rs"]
    mod dim;

    pub use both::{SCENES, pile};
}
