//! Recovery from initial overlap.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "deep_overlap",
    description: "48 boxes are created inside each other, push apart at a limited speed, and scatter without bursting.",
    category: Category::Robustness,
    steps: 240,
    law: Law { overlap_max: 0.05, height_min: 0.0, reach_max: 37.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::deep_overlap(View::flat())
}
