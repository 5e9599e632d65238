//! Lines that sketch a shape, and their level of detail.

use parry::math::{Pose, Real, Vector};

/// Number of straight pieces for a full turn, and for a rounded border.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Detail {
    /// Pieces of a full circle.
    pub subdivisions: u32,
    /// Pieces of the quarter turn of a rounded border.
    pub border_subdivisions: u32,
}

impl Detail {
    /// The nearest detail that makes sense: neither invisible nor endless.
    pub fn new(subdivisions: u32, border_subdivisions: u32) -> Self {
        Self {
            subdivisions: subdivisions.clamp(4, 512),
            border_subdivisions: border_subdivisions.clamp(1, 128),
        }
    }
}

/// A sketch: points, and pairs of them that are joined by a line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The points, in the shape's frame.
    pub points: Vec<Vector>,
    /// Positions in `points` of the two ends of each line.
    pub lines: Vec<[u32; 2]>,
}

impl From<(Vec<Vector>, Vec<[u32; 2]>)> for Outline {
    fn from((points, lines): (Vec<Vector>, Vec<[u32; 2]>)) -> Self {
        Self { points, lines }
    }
}

impl Outline {
    /// Adds a line from `a` to `b`.
    pub fn segment(&mut self, a: Vector, b: Vector) {
        self.chain(&[a, b]);
    }

    /// Adds lines from each point to the next.
    pub fn chain(&mut self, points: &[Vector]) {
        let first = self.points.len() as u32;
        self.points.extend_from_slice(points);
        self.lines.extend((1..points.len() as u32).map(|i| [first + i - 1, first + i]));
    }

    /// Adds lines from each point to the next, and from the last to the first.
    pub fn ring(&mut self, points: &[Vector]) {
        let first = self.points.len() as u32;
        self.chain(points);
        if points.len() > 2 {
            self.lines.push([first + points.len() as u32 - 1, first]);
        }
    }

    /// Adds another sketch, moved by `pose`.
    pub fn append(&mut self, other: &Outline, pose: &Pose) {
        let first = self.points.len() as u32;
        self.points.extend(other.points.iter().map(|&point| *pose * point));
        self.lines.extend(other.lines.iter().map(|line| line.map(|i| first + i)));
    }

    /// Adds the arc from angle `from` to angle `to` (radians) of a circle about `center`. `axes` contains its
    /// radii at angle 0 and at a right angle.
    pub fn arc(&mut self, center: Vector, axes: [Vector; 2], [from, to]: [Real; 2], pieces: u32) {
        let step = (to - from) / pieces as Real;
        let points: Vec<Vector> = (0..=pieces)
            .map(|i| {
                let (sin, cos) = (from + step * i as Real).sin_cos();
                center + axes[0] * cos + axes[1] * sin
            })
            .collect();
        self.chain(&points);
    }

    /// Keeps one of the lines that join the same two points.
    pub fn without_repeats(mut self) -> Self {
        for line in &mut self.lines {
            line.sort_unstable();
        }
        self.lines.sort_unstable();
        self.lines.dedup();
        self
    }
}
