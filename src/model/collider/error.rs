//! Error of an invalid collider.

use crate::dim::math::{Pose, Real, Vector};
use parry::shape::TriMeshBuilderError;

/// The reason why a collider cannot be built, with the parameter and its value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidCollider {
    /// A number is out of its range.
    #[error("{parameter} is {value}, but must be {expected}")]
    Number {
        /// The parameter.
        parameter: &'static str,
        /// The refused value.
        value: Real,
        /// The admissible values.
        expected: &'static str,
    },
    /// A point or vector has a coordinate that is not finite, or too large to calculate with.
    #[error(
        "{parameter} number {position} is {value}, but coordinates must be finite and at most 1e15"
    )]
    Point {
        /// The parameter.
        parameter: &'static str,
        /// Index of the point, from 0.
        position: usize,
        /// The point.
        value: Vector,
    },
    /// A direction is not of unit length.
    #[error("{parameter} is {value}, but must be of length 1")]
    Direction {
        /// The parameter.
        parameter: &'static str,
        /// The vector.
        value: Vector,
    },
    /// A pose is not finite, or its rotation not of unit length.
    #[error(
        "the pose is {value:?}, but must be a finite translation and a rotation of unit length"
    )]
    Pose {
        /// The pose.
        value: Pose,
    },
    /// A list is too short.
    #[error("{parameter} holds {count} elements, but at least {least} are needed")]
    TooFew {
        /// The list.
        parameter: &'static str,
        /// Its length.
        count: usize,
        /// The necessary elements.
        least: usize,
    },
    /// The grid has more cells than can be stored.
    #[error("{parameter} results in {cells} cells, but at most {most} are possible")]
    TooFine {
        /// The parameter.
        parameter: &'static str,
        /// Resulting number of cells.
        cells: Real,
        /// Largest possible number.
        most: Real,
    },
    /// An element contains the index of a missing vertex.
    #[error(
        "element {position} of {parameter} has the index {index}, but there are only {count} vertices"
    )]
    IndexOutOfRange {
        /// The list of elements.
        parameter: &'static str,
        /// Index of the element, from 0.
        position: usize,
        /// The vertex index.
        index: u32,
        /// Number of vertices.
        count: usize,
    },
    /// The shape is degenerate: it lacks a necessary extent.
    #[error("the {shape} is degenerate: {reason}")]
    Degenerate {
        /// Kind of shape.
        shape: &'static str,
        /// The missing extent.
        reason: &'static str,
    },
    /// A part of a compound is itself made of parts.
    #[error("part {part} of the compound is a composite shape, which is not supported")]
    NestedCompound {
        /// Index of the part, from 0.
        part: usize,
    },
    /// A part of a compound is invalid.
    #[error("part {part} of the compound: {reason}")]
    Part {
        /// Index of the part, from 0.
        part: usize,
        /// The error of the part.
        reason: Box<InvalidCollider>,
    },
    /// The triangles of a mesh are inconsistent.
    #[error(transparent)]
    TriMesh(#[from] TriMeshBuilderError),
}
