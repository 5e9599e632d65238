//! The list is in order, and every scene runs.

use crate::SCENES;
use crate::rapier::prelude::*;
use gallery::{Category, Line, Pen, SceneRun, Triangle};

#[test]
fn names_are_distinct_words() {
    for (i, info) in SCENES.iter().enumerate() {
        assert!(SCENES[..i].iter().all(|other| other.name != info.name), "{} twice", info.name);
        let is_word = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        assert!(info.name.chars().all(is_word), "{}", info.name);
        assert!(info.steps > 0 && info.description.ends_with('.'), "{}", info.name);
    }
}

/// Counts what is drawn, and checks that it can be.
#[derive(Default)]
struct Counter {
    lines: usize,
    triangles: usize,
}

impl Pen for Counter {
    fn line(&mut self, line: Line) {
        assert!([line.from, line.to].as_flattened().iter().all(|c| c.is_finite()));
        self.lines += 1;
    }

    fn triangle(&mut self, triangle: Triangle) {
        assert!(triangle.corners.as_flattened().iter().all(|c| c.is_finite()));
        self.triangles += 1;
    }
}

/// The first steps of every scene: enough for those that edit their world to have begun with it.
#[test]
fn every_scene_runs_and_can_be_drawn() {
    for info in &SCENES {
        let mut scene = (info.build)();
        scene.run(if info.category == Category::Stress { 2 } else { 100 });
        for (_, body) in scene.world.bodies.iter() {
            let place = body.translation();
            assert!(place.is_finite() && place.length() < 1.0e3, "{}: {place}", info.name);
        }
        let mut counter = Counter::default();
        scene.draw(&mut counter);
        assert!(counter.lines > 0 && counter.triangles > 0, "{} shows nothing", info.name);
        assert!(scene.stats().bodies > 0, "{} is empty", info.name);
    }
}

/// The scenes that other crates measure have the size that their names promise.
#[test]
fn the_pyramids_have_their_size() {
    let bodies = |name: &str| crate::find(name).map(|info| (info.build)().world.bodies.len());
    assert_eq!(bodies("pyramid20"), Some(210 + 1));
    assert_eq!(bodies("large_pyramid"), Some(5050 + 1));
    assert_eq!(bodies("many_pyramids"), Some(if DIM == 2 { 22_000 } else { 10_780 } + 1));
    assert_eq!(bodies("no such scene"), None);
}
