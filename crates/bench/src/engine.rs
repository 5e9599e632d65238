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
}

impl Kind {
    /// All, in the order in which they take turns.
    pub const ALL: [Kind; 3] = [Kind::This, Kind::Rapier, Kind::Box];

    /// What the command line calls it.
    pub fn name(self) -> &'static str {
        match self {
            Kind::This => "this",
            Kind::Rapier => "rapier",
            Kind::Box => "box",
        }
    }
}

/// A world in some engine, made from a scene.
pub trait Engine {
    /// Advances by 1/60 s.
    fn step(&mut self);

    /// Looks at the world as it is now. Not part of the time measured.
    fn stats(&self) -> Stats;

    /// Bytes that it holds outside the reach of Rust's allocator.
    fn foreign_bytes(&self) -> usize {
        0
    }
}

/// What a world is like at one moment.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Stats {
    /// Pairs of colliders that touch or are about to, by the engine's own account.
    pub pairs: usize,
    /// The contact points of these pairs.
    pub points: usize,
    /// How deep the worst of all pairs overlaps (length units), measured from shapes and poses in the
    /// same way for all engines.
    pub overlap: f64,
    /// Kinetic energy of all dynamic bodies.
    pub kinetic_energy: f64,
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

    /// A fresh world in the given engine.
    fn start(&self, kind: Kind, threads: usize) -> Result<Box<dyn Engine + '_>, Unsupported>;

    /// Runs in this engine and adds up where the time went.
    fn profile(&self, steps: usize, after_step: &mut dyn FnMut(usize)) -> Vec<(&'static str, f64)>;
}
