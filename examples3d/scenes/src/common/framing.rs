//! The camera of every scene frames the moving bodies: they cover a part of the picture and are not hidden.

use crate::SCENES;
use crate::rapier::math::DIM;
use crate::scene::Artist;
use drawing::{Camera, Drawing, Role, raster};
use gallery::Category;
use std::collections::HashSet;

/// Size of the pictures, in pixels.
const SIZE: [usize; 2] = [240, 135];
/// Smallest fraction of the pixels that moving bodies cover. Flat scenes show long tracks with small bodies
/// on them.
const COVERED_MIN: f32 = if DIM == 2 { 0.0045 } else { 0.01 };
/// Smallest fraction of the moving colliders in the picture that are visible, by kind of scene. Most
/// colliders of a heap are inside it.
const VISIBLE_MIN: f32 = 0.25;
const VISIBLE_IN_HEAPS_MIN: f32 = 0.06;
/// Number of colliders from which a scene counts as a heap.
const HEAP: usize = 150;
/// Steps before the picture: enough for bodies to arrive in the camera's view.
const STEPS: usize = 120;

/// Fractions of a picture.
struct Framing {
    covered: f32,
    visible: f32,
    moving: usize,
}

fn framing(drawing: &Drawing, camera: &Camera) -> Framing {
    let seen = raster::visible(drawing, camera, SIZE);
    let moving = |role: Role| role == Role::Moving;
    let pixels = seen.iter().flatten().filter(|(role, _)| moving(*role)).count();
    let ids: HashSet<u32> =
        seen.iter().flatten().filter(|(role, _)| moving(*role)).map(|(_, id)| *id).collect();
    let all: HashSet<u32> = drawing
        .instances()
        .filter(|(_, instance)| moving(instance.role))
        .map(|(_, instance)| instance.id)
        .collect();
    Framing {
        covered: pixels as f32 / seen.len() as f32,
        visible: ids.len() as f32 / all.len().max(1) as f32,
        moving: all.len(),
    }
}

#[test]
fn cameras_frame_moving_bodies() {
    let mut complaints = Vec::new();
    for info in &SCENES {
        let mut scene = (info.build)();
        let stress = info.category == Category::Stress;
        scene.run(if stress { 2 } else { info.steps.min(STEPS) });
        let drawing = Artist::default().draw(&scene);
        let camera = drawing.camera(&scene.view, SIZE);
        let Framing { covered, visible, moving } = framing(&drawing, &camera);
        let visible_min = if moving > HEAP { VISIBLE_IN_HEAPS_MIN } else { VISIBLE_MIN };
        if covered < COVERED_MIN || visible < visible_min {
            complaints.push(format!(
                "{}: covers {covered:.3}, {visible:.2} of {moving} visible",
                info.name
            ));
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}
