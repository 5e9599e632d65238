//! Interface of an engine to the benchmark.

/// Engines of the benchmark.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// This engine.
    This,
    /// Rapier, from its published crates.
    Rapier,
    /// Box3D in 3D, Box2D in 2D.
    Box,
    /// This engine in double precision.
    Double,
}

impl Kind {
    /// All engines, in the order of their turns.
    pub const ALL: [Kind; 4] = [Kind::This, Kind::Rapier, Kind::Box, Kind::Double];

    /// Returns the name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Kind::This => "this",
            Kind::Rapier => "rapier",
            Kind::Box => "box",
            Kind::Double => "double",
        }
    }

    /// Returns whether this is another engine than this one.
    pub fn is_peer(self) -> bool {
        matches!(self, Kind::Rapier | Kind::Box)
    }
}

/// Queries for every engine: rays of one length, and balls that are cast along them.
pub struct Probes {
    /// Origins of the rays; 2D ignores the third number.
    pub origins: Vec<[f32; 3]>,
    /// Directions of the rays, unit vectors.
    pub directions: Vec<[f32; 3]>,
    /// Length of the rays.
    pub reach: f32,
    /// Radius of the balls.
    pub radius: f32,
}

impl Probes {
    /// Returns random rays that begin within a box (lowest and highest corner).
    pub fn random(count: usize, [low, high]: [[f32; 3]; 2], seed: u64) -> Self {
        let mut dice = scenes3d::common::Dice::new(seed);
        let mut origins = Vec::with_capacity(count);
        let mut directions = Vec::with_capacity(count);
        while origins.len() < count {
            let direction = [(); 3].map(|()| dice.between(-1.0, 1.0));
            // In 2D, the box and the directions are flat.
            let flat = if high[2] > low[2] { direction[2] } else { 0.0 };
            let direction = [direction[0], direction[1], flat];
            let length = direction.iter().map(|x| x * x).sum::<f32>().sqrt();
            if (0.1..1.0).contains(&length) {
                directions.push(direction.map(|x| x / length));
                let origin = |k: usize| low[k] + (high[k] - low[k]) * dice.between(0.0, 1.0);
                origins.push([0, 1, 2].map(origin));
            }
        }
        let size = |k: usize| high[k] - low[k];
        Self { origins, directions, reach: size(0).max(size(2)), radius: 0.01 * size(1) }
    }
}

/// World in some engine, made from a scene.
pub trait Engine {
    /// Advances the world by 1/60 s.
    fn step(&mut self);

    /// Returns the engine's own counts. The time is not measured.
    fn counts(&self) -> Counts;

    /// Returns the counts and the measured quality of the present state. The time is not measured.
    fn stats(&self) -> Stats;

    /// Casts rays, or balls of a radius, and returns the number of hits; `None` if the engine has no such
    /// query.
    fn cast(&self, probes: &Probes, radius: Option<f32>) -> Option<usize> {
        let _ = (probes, radius);
        None
    }

    /// Returns the world as bytes, as the engine's authors recommend; `None` if it cannot be saved.
    fn save(&self) -> Option<Vec<u8>> {
        None
    }

    /// Restores a world from bytes and drops it. Returns whether the restoration succeeded.
    fn load(&self, bytes: &[u8]) -> bool {
        let _ = bytes;
        false
    }

    /// Copies the world into an earlier copy in memory and returns to it. Returns the time of both (ms), or
    /// `None` if the engine cannot.
    fn save_and_return(&mut self) -> Option<f64> {
        None
    }

    /// Returns the bytes that the engine allocated outside of Rust's allocator.
    fn foreign_bytes(&self) -> usize {
        0
    }
}

/// An engine's own counts of its simulated objects.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Counts {
    /// Bodies of all kinds.
    pub bodies: usize,
    /// Dynamic bodies that are awake.
    pub awake: usize,
    /// Substeps of a step.
    pub substeps: usize,
    /// Pairs of colliders that touch or are about to touch.
    pub pairs: usize,
    /// Contact points of these pairs.
    pub points: usize,
}

/// State of a world at one moment.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Stats {
    /// Counts of simulated objects.
    pub counts: Counts,
    /// Overlap of pairs, measured from shapes and poses in the same way for all engines.
    pub overlap: Overlap,
    /// Largest separation of any joint (length units), measured likewise; `None` without joints.
    pub separation: Option<f64>,
    /// Kinetic energy of all dynamic bodies.
    pub kinetic_energy: f64,
}

/// Overlap of pairs (length units).
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Overlap {
    /// Depth of the deepest pair. It varies between runs that differ in their last bits.
    pub deepest: f64,
    /// The 99th percentile over the overlapping pairs: one pair in a hundred is deeper. It varies little.
    pub percentile99: f64,
}

impl Overlap {
    /// Summarises the depths of all pairs. Pairs apart have depth 0 and do not count.
    pub fn of_depths(mut depths: Vec<f64>) -> Self {
        depths.retain(|&depth| depth > 0.0);
        depths.sort_by(f64::total_cmp);
        let at = |rank: usize| depths.get(rank).copied().unwrap_or_default();
        Self {
            deepest: at(depths.len().saturating_sub(1)),
            percentile99: at((depths.len() * 99).div_ceil(100).saturating_sub(1)),
        }
    }
}

/// Reason why an engine cannot run a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(pub String);

impl Unsupported {
    /// Creates the error with this reason.
    pub fn because(reason: impl Into<String>) -> Self {
        Self(reason.into())
    }
}

/// Scene that any engine can build.
pub trait Template {
    /// Returns the number of dynamic bodies.
    fn dynamic_bodies(&self) -> usize;

    /// Returns the box around all moving bodies: its lowest and its highest corner (in 2D the third number is
    /// zero).
    fn region(&self) -> [[f32; 3]; 2];

    /// Creates a fresh world in the given engine.
    fn start(&self, kind: Kind, threads: usize) -> Result<Box<dyn Engine + '_>, Unsupported>;

    /// Runs in this engine on the calling pool's threads. Returns the mean time of each stage of a step (ms),
    /// and last the processor time of all threads.
    fn profile(&self, steps: usize, after_step: &mut dyn FnMut(usize)) -> Vec<(&'static str, f64)>;
}

#[cfg(test)]
mod tests {
    use super::Overlap;

    #[test]
    fn the_percentile_ignores_pairs_that_are_apart() {
        let depths = (0..1000).map(|n| if n < 500 { 0.0 } else { f64::from(n - 499) });
        let overlap = Overlap::of_depths(depths.rev().collect());
        assert_eq!(overlap, Overlap { deepest: 500.0, percentile99: 495.0 });
        assert_eq!(Overlap::of_depths(vec![0.0; 3]), Overlap::default());
    }
}
