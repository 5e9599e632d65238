//! Shapes at the border of what collides: without thickness, mirrored, with one side, and with notches.

mod decomposition;
mod flat;
mod mirrored;
pub mod outlines;
mod sides;
