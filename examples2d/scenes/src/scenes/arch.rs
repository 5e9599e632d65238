//! An arch of loose stones.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "arch",
    description: "An arch of 17 wedges, without mortar, carries a stack of boxes.",
    category: Category::Shapes,
    steps: 360,
    law: Law {
        overlap_max: 0.01,
        height_min: 0.0,
        top_loss_max: 0.2,
        reach_max: 7.0,
        speed_max: 0.1,
        ..Law::NONE
    },
    source: file!(),
    build,
};

/// Number of wedges.
const WEDGES: usize = 17;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let (inner, outer) = (5.0, 6.4);
    let corner = |i: usize, radius: Real| {
        let angle = HALF_TURN * i as Real / WEDGES as Real;
        Vector::new(radius * angle.cos(), radius * angle.sin())
    };
    for i in 0..WEDGES {
        let wedge =
            [corner(i, inner), corner(i, outer), corner(i + 1, outer), corner(i + 1, inner)];
        let middle = wedge.iter().copied().sum::<Vector>() / 4.0;
        let wedge = wedge.map(|corner| corner - middle);
        let hull = ColliderBuilder::convex_hull(&wedge).expect("a wedge has an area");
        add(&mut world, middle, hull.friction(0.6));
    }
    for layer in 0..4 {
        let place = Vector::new(0.0, outer + 0.35 + 0.7 * layer as Real);
        add(&mut world, place, ColliderBuilder::cuboid(1.0, 0.35).friction(0.6));
    }
    Scene::new(world, View::flat())
}
