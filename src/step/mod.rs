//! 
mod narrow_phase;
