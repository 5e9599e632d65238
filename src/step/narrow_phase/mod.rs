//! # Narrow phase — where exactly do they touch?

mod ball;
mod convex;
mod generate;
mod matching;
mod parts;
mod voxels;
#[cfg(test)]
mod tests;
