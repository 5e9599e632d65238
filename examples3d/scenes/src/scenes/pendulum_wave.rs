//! A row of pendulums with decreasing lengths.
//!
//! After 200 steps no overlap is deeper than 0.01. No body is below -1.9 or farther out than 9.4. No joint is
//! open by more than 0.005.

use crate::common::{Law, Scene, SceneInfo, plays};
use crate::kit::near;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "pendulum_wave",
    description: "Twelve pendulums of graded lengths lose their phase, and regain it after a minute.",
    category: Category::Joints,
    steps: 300,
    law: Law {
        overlap_max: 0.01,
        height_min: -1.9,
        reach_max: 9.4,
        gap_max: 0.005,
        ..Law::after(200)
    },
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::pendulum_wave(View::orbit(60.0, 14.0), |i| near(-0.7 * i))
}
