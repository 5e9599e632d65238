//! Scenes in 2D: one for each feature of the engine, and large ones that measure its speed.
//!
//! Every scene is defined here once. The gallery runs all of them, the tests check that some of them settle,
//! and the benchmarks rebuild the large ones in other engines:
//!
//! ```
//! let mut scene = (scenes2d::find("pyramid20").expect("is in the list").build)();
//! scene.step();
//! assert!(scene.world.bodies.len() > 200);
//! ```

pub use rapier2d as rapier;
pub use scene2d as scene;

#[path = "../../../examples3d/scenes/src/common/mod.rs"]
pub mod common;
pub mod scenes;
mod kit;

pub use scene::{Scene, SceneInfo};
pub use scenes::SCENES;

/// Returns the scene with this name.
pub fn find(name: &str) -> Option<&'static SceneInfo> {
    SCENES.iter().find(|info| info.name == name)
}
