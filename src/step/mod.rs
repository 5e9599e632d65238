//! 
mod narrow_phase;
mod solver;
