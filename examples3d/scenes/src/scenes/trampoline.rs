//! Motors as springs under balls.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "trampoline",
    description: "Balls bounce on planks whose springs are ever stiffer.",
    category: Category::Joints,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 9.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::trampoline(View::orbit(12.0, 14.0))
}
