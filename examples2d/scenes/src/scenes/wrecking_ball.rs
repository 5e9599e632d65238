//! A chain, and a ball at its end.
//!
//! After 200 steps no overlap is deeper than 0.01. No body is below 0.1 or farther out than 6.8. No joint is
//! open by more than 0.005.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "wrecking_ball",
    description: "A heavy ball on a chain of eight links swings into a wall of boxes.",
    category: Category::Joints,
    steps: 200,
    law: Law {
        overlap_max: 0.01,
        height_min: 0.1,
        reach_max: 6.8,
        gap_max: 0.005,
        ..Law::after(200)
    },
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::wrecking_ball(View::flat())
}
