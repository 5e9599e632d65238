//! Recovery from initial overlap.
//!
//! After 200 steps no overlap is deeper than 0.05: boxes still roll and fall. No body is below 0.1 or
//! farther out than 36.0.

use crate::common::{Law, Scene, SceneInfo, plays};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "deep_overlap",
    description: "48 boxes are created inside each other, push apart at a limited speed, and scatter without bursting.",
    category: Category::Robustness,
    steps: 240,
    law: Law { overlap_max: 0.05, height_min: 0.1, reach_max: 36.0, ..Law::after(200) },
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::deep_overlap(View::orbit(14.0, 16.0))
}
