//! A chain, and a ball at its end.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "wrecking_ball",
    description: "A heavy ball on a chain of eight links swings into a wall of boxes.",
    category: Category::Joints,
    steps: 200,
    // The ball compresses a pile of boxes that have a fortieth of its mass.
    law: Law { overlap_max: 0.2, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::wrecking_ball(View::orbit(20.0, 12.0))
}
