//! The tests of the plugin in 2D. Both dimensions share their source.

use rapier2d_bevy as plugin;

#[path = "../../tests/dim2.rs"]
mod dim;
#[path = "../../tests/scene.rs"]
mod scene;

#[path = "../../tests/determinism.rs"]
mod determinism;
#[path = "../../tests/events.rs"]
mod events;
#[path = "../../tests/hierarchy.rs"]
mod hierarchy;
#[path = "../../tests/hooks.rs"]
mod hooks;
#[path = "../../tests/interpolation.rs"]
mod interpolation;
#[path = "../../tests/invalid.rs"]
mod invalid;
#[path = "../../tests/joints.rs"]
mod joints;
#[path = "../../tests/lifecycle.rs"]
mod lifecycle;
#[cfg(feature = "debug-lines")]
#[path = "../../tests/lines.rs"]
mod lines;
#[path = "../../tests/motion.rs"]
mod motion;
#[path = "../../tests/planar.rs"]
mod planar;
#[path = "../../tests/queries.rs"]
mod queries;
#[path = "../../tests/scale.rs"]
mod scale;
