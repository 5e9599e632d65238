//! 
mod broad_phase;
mod narrow_phase;
mod solver;
