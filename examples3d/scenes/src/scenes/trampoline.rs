//! Motors as springs under balls.
//!
//! After 200 steps no overlap is deeper than 0.01. No body is below 1.2 or farther out than 9.7. No joint is
//! open by more than 0.005.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "trampoline",
    description: "Balls bounce on planks whose springs are ever stiffer.",
    category: Category::Joints,
    steps: 240,
    law: Law {
        overlap_max: 0.01,
        height_min: 1.2,
        reach_max: 9.7,
        gap_max: 0.005,
        ..Law::after(200)
    },
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::trampoline(View::orbit(12.0, 14.0))
}
