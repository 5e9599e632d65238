//! Seesaws: torque is weight times moment arm.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "seesaw",
    description: "Planks on pivots: equal weights, a double weight on half the arm, and one that falls and throws another.",
    category: Category::Joints,
    steps: 200,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 12.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::seesaw(View::orbit(12.0, 14.0))
}
