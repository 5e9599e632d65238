//! The 3D scenes.
