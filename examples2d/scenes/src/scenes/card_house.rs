//! A house of cards, held by friction alone.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::world_with_floor;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "card_house",
    description: "Thin cards lean against each other, five storeys high.",
    category: Category::Robustness,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, top_loss_max: 0.1, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Half length and half thickness of a card.
const CARD: [Real; 2] = [0.8, 0.02];
/// Angle of a card from the vertical (rad).
const ANGLE: Real = 0.43;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(5)
}

/// Builds a house with this many storeys.
pub fn build_sized(storeys: usize) -> Scene {
    let mut world = world_with_floor(50.0);
    let [length, thickness] = CARD;
    let card = ColliderBuilder::cuboid(thickness, length).friction(0.8);
    // Height and width of a leaning card; two of them make a tent.
    let rise = length * ANGLE.cos() + thickness * ANGLE.sin();
    let run = length * ANGLE.sin() + thickness * ANGLE.cos();
    let spacing = 2.0 * length + 2.0 * thickness;
    for storey in 0..storeys {
        let floor = storey as Real * (2.0 * rise + 2.0 * thickness);
        let tents = storeys - storey;
        for tent in 0..tents {
            let x = spacing * (tent as Real - (tents - 1) as Real / 2.0);
            for side in [-1.0, 1.0] {
                let body = RigidBodyBuilder::dynamic()
                    .translation(Vector::new(x + side * run, floor + rise))
                    .rotation(side * ANGLE);
                world.insert(body, card.clone());
            }
            if tent + 1 < tents {
                // A horizontal card connects the top of this tent to the top of the next.
                let middle = Vector::new(x + 0.5 * spacing, floor + 2.0 * rise + thickness);
                let lying = ColliderBuilder::cuboid(length, thickness).friction(0.8);
                world.insert(RigidBodyBuilder::dynamic().translation(middle), lying);
            }
        }
    }
    Scene::new(world, View::flat())
}
