//! Mass ratios that stretch chains in many engines.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "heavy_chain",
    description: "Chains of ten light links carry balls of 10, 100 and 500 times the mass of a link.",
    category: Category::Robustness,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: -6.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::heavy_chain(View::flat())
}
