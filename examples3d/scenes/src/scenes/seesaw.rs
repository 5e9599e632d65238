//! Seesaws: torque is weight times moment arm.
//!
//! After 200 steps no overlap is deeper than 0.01. No body is below 0.2 or farther out than 13.0. No joint is
//! open by more than 0.005.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "seesaw",
    description: "Planks on pivots: equal weights, a double weight on half the arm, and one that falls and throws another.",
    category: Category::Joints,
    steps: 200,
    law: Law {
        overlap_max: 0.01,
        height_min: 0.2,
        reach_max: 13.0,
        gap_max: 0.005,
        ..Law::after(200)
    },
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::seesaw(View::orbit(12.0, 14.0))
}
