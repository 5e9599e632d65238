//! A row of pendulums with decreasing lengths.

use crate::common::{Law, Scene, SceneInfo, plays};
use crate::kit::near;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "pendulum_wave",
    description: "Twelve pendulums of graded lengths lose their phase, and regain it after a minute.",
    category: Category::Joints,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: -2.0, reach_max: 9.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    plays::pendulum_wave(View::orbit(60.0, 14.0), |i| near(-0.7 * i))
}
