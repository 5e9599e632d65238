//! The 2D scenes.
