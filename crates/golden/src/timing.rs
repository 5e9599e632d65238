//! Times of steps: one pile per crate, natively and as WebAssembly.

use crate::{flat, flat_f64, solid, solid_f64};

/// Advances a world by one step.
pub type Step = Box<dyn FnMut() + Send>;

/// Builds a pile.
pub type Pile = fn() -> Step;

/// The pile of each crate.
pub const PILES: [(&str, Pile); 4] = [
    ("rapier2d", flat::pile),
    ("rapier3d", solid::pile),
    ("rapier2d-f64", flat_f64::pile),
    ("rapier3d-f64", solid_f64::pile),
];

/// The phases of a pile: name, first step, and end.
const PHASES: [(&str, usize, usize); 2] = [("falling", 0, 100), ("settled", 300, 500)];

/// Runs a pile and returns a line with the median time of a step in each phase. `now` returns the time in
/// milliseconds.
pub fn time(engine: &str, pile: Pile, now: impl Fn() -> f64) -> String {
    // Compilers at run time need a pile to find the code that matters.
    run(&mut pile(), 120, &now);
    let times = run(&mut pile(), 500, &now);
    let phases = PHASES.map(|(name, first, end)| {
        let mut times = times[first..end].to_vec();
        times.sort_by(f64::total_cmp);
        format!("{name} {:6.3}", times[times.len() / 2])
    });
    format!("{engine:<13} ms per step: {}", phases.join(", "))
}

fn run(step: &mut Step, steps: usize, now: &impl Fn() -> f64) -> Vec<f64> {
    let timed = |_| {
        let begin = now();
        step();
        now() - begin
    };
    (0..steps).map(timed).collect()
}
