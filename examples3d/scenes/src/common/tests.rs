//! The list of scenes is valid, and every scene runs.

use crate::rapier::prelude::*;
use crate::scene::gap;
use crate::{SCENES, Scene};
use gallery::SceneRun;

#[test]
fn names_are_distinct_words() {
    for (i, info) in SCENES.iter().enumerate() {
        assert!(SCENES[..i].iter().all(|other| other.name != info.name), "{} twice", info.name);
        let is_word = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        assert!(info.name.chars().all(is_word), "{}", info.name);
        assert!(info.steps > 0 && info.description.ends_with('.'), "{}", info.name);
    }
}

/// Number of bodies from which a scene is large: its law takes minutes.
const LARGE_BODY_COUNT: usize = 400;

/// Every scene of ordinary size satisfies its law at the end of its steps and after three times as many.
#[test]
fn every_scene_satisfies_its_law() {
    check_laws(|start| start.world.bodies.len() < LARGE_BODY_COUNT);
}

/// Large scenes satisfy their laws.
#[test]
#[ignore = "takes minutes; `.ci/deep laws` runs it"]
fn large_scenes_satisfy_their_laws() {
    check_laws(|start| start.world.bodies.len() >= LARGE_BODY_COUNT);
}

/// Checks the laws of some scenes.
fn check_laws(is_chosen: impl Fn(&Scene) -> bool) {
    let mut complaints = Vec::new();
    for info in &SCENES {
        let start = (info.build)();
        if !is_chosen(&start) {
            continue;
        }
        let mut scene = (info.build)();
        let mut check = |steps: usize| {
            scene.run(steps);
            let fault = info.law.check(&start, &scene).err()?;
            Some(format!("{} after {} steps: {fault}", info.name, scene.steps_taken))
        };
        complaints.extend([info.steps, 2 * info.steps].into_iter().filter_map(&mut check));
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// Every scene runs, stays in a finite space, and can be drawn.
#[test]
fn every_scene_runs() {
    for info in &SCENES {
        let mut scene = (info.build)();
        scene.run(20);
        for (_, body) in scene.world.bodies.iter() {
            let place = body.translation();
            assert!(place.is_finite() && place.length() < 1.0e3, "{}: {place}", info.name);
        }
        let instances = scene.draw().instances().count();
        assert!(instances > 0, "{} shows nothing", info.name);
        assert!(scene.stats().bodies > 0, "{} is empty", info.name);
    }
}

/// The scenes that other crates measure have the size in their names.
#[test]
fn the_pyramids_have_their_size() {
    let bodies = |name: &str| crate::find(name).map(|info| (info.build)().world.bodies.len());
    assert_eq!(bodies("pyramid20"), Some(210 + 1));
    assert_eq!(bodies("large_pyramid"), Some(5050 + 1));
    assert_eq!(bodies("many_pyramids"), Some(if DIM == 2 { 22_000 } else { 10_780 } + 1));
    assert_eq!(bodies("no such scene"), None);
}

/// A copy has its own events: it continues like the original, step by step beside it.
#[test]
fn copies_react_to_their_own_events() {
    for name in ["contact_forces", "sensors"] {
        let mut scene = after(name, 20);
        let mut copy = scene.clone();
        for _ in 0..100 {
            scene.step();
            copy.step();
        }
        assert_eq!(scene.world.hash(), copy.world.hash(), "{name}");
        let without_events = scene.world.bodies.iter().all(|(_, body)| body.gravity_scale() == 1.0)
            && scene.world.bodies.len() == after(name, 0).world.bodies.len();
        assert!(!without_events, "{name} has no event to react to");
    }
}

/// Returns the scene with this name, after some steps.
fn after(name: &str, steps: usize) -> crate::Scene {
    let info = crate::find(name).expect("is in the list");
    let mut scene = (info.build)();
    scene.run(steps);
    scene
}

/// The machine walks upright in strides of its own length. Its many loops of bars stay closed, to 4.5 mm on
/// average. A foot that hits a cube opens them for a moment, by up to 26 mm in eight walks of ten seconds.
#[test]
fn the_strider_walks() {
    let mut scene = after("strider", 30);
    let body = scene.world.impulse_joints.iter().last().map(|(_, joint)| joint.body1());
    let body = body.expect("the last joint is the motor's");
    let start = scene.world.bodies[body].translation();
    for _ in 0..20 {
        scene.run(10);
        let place = scene.world.bodies[body].translation();
        let level = scene.world.bodies[body].rotation().inverse() * Vector::Y;
        assert!((place.y - start.y).abs() < 0.2, "at {place}");
        assert!(level.y > 0.97, "leans {level}");
        assert!(gap(&scene.world) < 0.04, "bars are {} apart", gap(&scene.world));
    }
    // Feet move 0.68 · 2 in half a revolution of the crank, which takes π / 4 s. Slip and the start reduce
    // the distance.
    let way = scene.world.bodies[body].translation().x - start.x;
    assert!(way > 3.0, "walked {way}");
}

/// The arm's tip follows the target with a delay. Critically damped motors of 10 Hz follow a ramp after `2 /
/// ω`, 0.03 s, and the target moves at up to 4 units per second. The bound is twice that, because the search
/// has twenty steps each time.
#[test]
fn the_arm_follows_its_target() {
    let mut scene = after("robot_arm", 200);
    for _ in 0..20 {
        scene.run(20);
        let PhysicsWorld { bodies, multibody_joints, .. } = &scene.world;
        let arm = multibody_joints.multibodies().next().expect("there is an arm");
        let tip = arm.links().last().map(|link| link.local_to_world().translation);
        let target = bodies.iter().find(|(_, body)| body.is_kinematic());
        let target = target.map(|(_, body)| body.translation());
        let error = (tip.expect("it has links") - target.expect("there is a target")).length();
        assert!(error < 0.26, "off by {error}");
    }
}

/// One bridge carries its load. Only weak hinges of the other bridge break.
#[test]
fn one_bridge_carries_its_load_and_the_other_breaks() {
    let scene = after("bridge", 240);
    let joints = scene.world.impulse_joints.iter().map(|(_, joint)| joint.data);
    let (weak, strong): (Vec<_>, Vec<_>) = joints.partition(|joint| joint.break_force.is_finite());
    assert!(weak.iter().any(|joint| !joint.is_enabled()));
    assert!(strong.iter().all(GenericJoint::is_enabled));
    assert!(gap(&scene.world) < 0.05, "planks are {} apart", gap(&scene.world));
}

/// The car arrives on its four wheels (2D: two).
#[test]
fn the_car_drives() {
    let scene = after("jointed_car", 250);
    let dynamic = scene.world.bodies.iter().filter(|(_, body)| body.is_dynamic());
    let chassis = dynamic.max_by(|a, b| a.1.mass().total_cmp(&b.1.mass())).expect("there is one").1;
    let (place, up) = (chassis.translation(), *chassis.rotation() * Vector::Y);
    assert!(place.x > 0.0 && up.y > 0.8, "at {place}, up is {up}");
    assert!(gap(&scene.world) < 0.02, "joints are {} apart", gap(&scene.world));
}
