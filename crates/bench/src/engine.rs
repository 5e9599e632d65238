//! What the benchmark wants from an engine.

/// The engines that can take part.
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
    /// All, in the order in which they take turns.
    pub const ALL: [Kind; 4] = [Kind::This, Kind::Rapier, Kind::Box, Kind::Double];

    /// What the command line calls it.
    pub fn name(self) -> &'static str {
        match self {
            Kind::This => "this",
            Kind::Rapier => "rapier",
            Kind::Box => "box",
            Kind::Double => "double",
        }
    }

    /// Is it another engine than this one?
    pub fn is_peer(self) -> bool {
        matches!(self, Kind::Rapier | Kind::Box)
    }
}

/// Questions that are put to every engine: lines of one length, and balls that go along them.
pub struct Probes {
    /// Where they begin; in 2D the third number means nothing.
    pub origins: Vec<[f32; 3]>,
    /// Where they go, as unit vectors.
    pub directions: Vec<[f32; 3]>,
    /// How far they go.
    pub reach: f32,
    /// The radius of the balls.
    pub radius: f32,
}

impl Probes {
    /// Random ones that begin within a box (lowest and highest corner).
    pub fn random(count: usize, [low, high]: [[f32; 3]; 2], seed: u64) -> Self {
        let mut dice = scenes3d::common::Dice::new(seed);
        let mut origins = Vec::with_capacity(count);
        let mut directions = Vec::with_capacity(count);
        while origins.len() < count {
            let direction = [(); 3].map(|()| dice.between(-1.0, 1.0));
            // In 2D a scene is flat, and so is what is asked of it.
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

/// A world in some engine, made from a scene.
pub trait Engine {
    /// Advances by 1/60 s.
    fn step(&mut self);

    /// Counts what it simulates, by its own account. Not part of the time measured.
    fn counts(&self) -> Counts;

    /// Counts, and measures how good the world is as it is now. Not part of the time measured.
    fn stats(&self) -> Stats;

    /// Sends rays, or balls of a radius, as far as they go, and counts those that hit something; `None` if it
    /// cannot be asked.
    fn cast(&self, probes: &Probes, radius: Option<f32>) -> Option<usize> {
        let _ = (probes, radius);
        None
    }

    /// The whole world as bytes, in the way that the engine's authors recommend; `None` if it cannot be saved.
    fn save(&self) -> Option<Vec<u8>> {
        None
    }

    /// Restores a world from bytes, and drops it. Returns whether there was one.
    fn load(&self, bytes: &[u8]) -> bool {
        let _ = bytes;
        false
    }

    /// Saves the world in memory, where an earlier save lies, and returns to it: the milliseconds that both take; `None` if it cannot.
    fn save_and_return(&mut self) -> Option<f64> {
        None
    }

    /// Bytes that it holds outside the reach of Rust's allocator.
    fn foreign_bytes(&self) -> usize {
        0
    }
}

/// How much an engine simulates, by its own account.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Counts {
    /// Bodies of all kinds.
    pub bodies: usize,
    /// Dynamic bodies that are awake.
    pub awake: usize,
    /// Substeps of a step.
    pub substeps: usize,
    /// Pairs of colliders that touch or are about to.
    pub pairs: usize,
    /// The contact points of these pairs.
    pub points: usize,
}

/// What a world is like at one moment.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Stats {
    /// What is simulated.
    pub counts: Counts,
    /// How deep pairs overlap, measured from shapes and poses in the same way for all engines.
    pub overlap: Overlap,
    /// How far the worst of all joints has come apart (length units), measured likewise; `None` without joints.
    pub separation: Option<f64>,
    /// Kinetic energy of all dynamic bodies.
    pub kinetic_energy: f64,
}

/// How deep pairs overlap (length units).
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Overlap {
    /// The deepest pair. It is one of thousands, so it varies between runs that differ in their last bits.
    pub deepest: f64,
    /// The 99th percentile of the pairs that overlap: one pair in a hundred is deeper. It varies little.
    pub percentile99: f64,
}

impl Overlap {
    /// Summarises the depths of all pairs; pairs apart have depth 0 and do not count.
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

/// Why an engine cannot take part in a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(pub String);

impl Unsupported {
    /// For the reason that the words give.
    pub fn because(reason: impl Into<String>) -> Self {
        Self(reason.into())
    }
}

/// A scene, ready to be built in any engine.
pub trait Template {
    /// Number of bodies that move by themselves.
    fn dynamic_bodies(&self) -> usize;

    /// The box around all bodies that move: its lowest and its highest corner (in 2D the third number is zero).
    fn region(&self) -> [[f32; 3]; 2];

    /// A fresh world in the given engine.
    fn start(&self, kind: Kind, threads: usize) -> Result<Box<dyn Engine + '_>, Unsupported>;

    /// Runs in this engine, on the threads of the pool in which it is called, and tells where the time of a step went (ms): each stage with
    /// its mean, and at the end the time that all threads spent on processors.
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
