//! Memory access of the kernels. All register types give the same bits, and only own bodies are written. No
//! digits are lost far from the origin, and impulses persist.

use super::scene::{
    Body, Contact, LANE, SUBSTEP, Scene, advance, random_direction, random_turn, random_vector,
};
use crate::base::random::Random;
use crate::base::wide::{LANES, Simd};
use crate::dim::math::{
    MAX_MANIFOLD_POINTS, Real, Rotation, Vector, ang_length_squared, rotation_from_angle,
};
use crate::dim::state::BodyPose;

const ROUNDING: Real = 1000.0 * Real::EPSILON;

/// A manifold of any number of points near the origin.
fn random_manifold(random: &mut Random) -> Contact {
    let count = 1 + random.below(MAX_MANIFOLD_POINTS);
    let points: Vec<_> = (0..count).map(|_| random_vector(random, 0.5)).collect();
    let mut contact = Contact::at(random_direction(random), &points);
    for (_, separation) in &mut contact.points {
        *separation = random.within(-0.02, 0.02);
    }
    contact.friction = random.within(0.0, 1.0);
    contact.restitution = random.within(-1.0, 1.0).max(0.0);
    contact.tangent_velocity = random_vector(random, 0.1);
    contact
}

/// A step of two substeps.
fn step(scene: &mut Scene) {
    scene.prepare();
    for _ in 0..2 {
        scene.begin_substep(-Vector::Y * 10.0);
        scene.bounce();
        scene.solve();
        for state in &mut scene.states {
            advance(state, SUBSTEP);
        }
        scene.relax();
    }
}

#[test]
fn all_registers_give_the_same_bits() {
    let mut random = Random(21);
    for _ in 0..20 {
        let mut scenes = [Scene::empty(), Scene::empty()];
        scenes[0].simd = Simd::baseline();
        scenes[1].simd = Simd::detect();
        for lane in 0..LANES {
            let bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
            let contact = random_manifold(&mut random);
            for scene in &mut scenes {
                scene.pass.softness.impulse_scale = 0.05;
                scene.pass.softness.bias_rate = 20.0;
                scene.add(lane, bodies, &contact);
            }
        }
        // Different numbers are printed differently.
        let [baseline, detected] = scenes.map(|mut scene| {
            step(&mut scene);
            format!("{:?} {:?} {:?}", scene.states, scene.block, scene.input)
        });
        assert_eq!(baseline, detected);
    }
}

#[test]
fn lanes_do_not_touch_each_other() {
    let mut random = Random(22);
    let mut together = Scene::empty();
    let mut alone = Vec::new();
    for lane in 0..LANES {
        let bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
        let contact = random_manifold(&mut random);
        together.add(lane, bodies, &contact);
        alone.push(Scene::new(bodies, &contact));
    }
    step(&mut together);
    for (lane, scene) in alone.iter_mut().enumerate() {
        step(scene);
        for body in 1..=2 {
            assert_eq!(together.velocity(2 * lane + body), scene.velocity(body));
        }
    }
}

#[test]
fn read_only_bodies_and_the_world_are_not_written() {
    let mut random = Random(23);
    for read_only in [0, 1] {
        for _ in 0..20 {
            let mut bodies = [Body::random(&mut random), Body::random(&mut random)];
            bodies[read_only].read_only = true;
            let contact = random_manifold(&mut random);
            let mut scene = Scene::new(bodies.map(Some), &contact);
            scene.input.impulses[0].0[LANE] = 1.0;
            scene.prepare();
            assert_ne!(scene.velocity(2 - read_only).0, bodies[1 - read_only].linvel);
            scene.bounce();
            scene.solve();
            scene.relax();
            let body = bodies[read_only];
            assert_eq!(scene.velocity(read_only + 1), (body.linvel, body.angvel));
        }
    }
    let mut scene =
        Scene::new([None, Some(Body::random(&mut random))], &random_manifold(&mut random));
    step(&mut scene);
    assert_eq!(format!("{:?}", scene.states[0]), format!("{:?}", Scene::empty().states[0]));
}

/// A rotation of a body does not change its displacement: velocities are written, displacements are not.
#[test]
fn displacements_stay() {
    let mut random = Random(24);
    let bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
    let mut scene = Scene::new(bodies, &random_manifold(&mut random));
    scene.prepare();
    for state in &mut scene.states {
        advance(state, 0.01);
    }
    let displacements: Vec<_> = scene.states.iter().map(|state| state.displacement()).collect();
    scene.bounce();
    scene.solve();
    scene.relax();
    let after: Vec<_> = scene.states.iter().map(|state| state.displacement()).collect();
    assert_eq!(displacements, after);
}

/// A vector of few binary digits, which can be moved far away without rounding.
fn coarse(vector: Vector) -> Vector {
    (vector * 64.0).round() / 64.0
}

/// The same scene at the origin and far away. Centres and points need no rounding in either place. Moment
/// arms would, if they were computed from points in the world.
#[test]
fn moment_arms_keep_their_digits_far_from_the_origin() {
    let mut random = Random(25);
    let far = Vector::splat(10_000.0);
    for kind in 0..3 {
        for _ in 0..20 {
            let mut bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
            if kind < 2 {
                bodies[kind] = None;
            }
            for body in bodies.iter_mut().flatten() {
                body.center = coarse(body.center);
            }
            let points =
                [(); MAX_MANIFOLD_POINTS].map(|()| coarse(random_vector(&mut random, 0.5)));
            let mut contact = Contact::at(random_direction(&mut random), &points).rough(0.5);
            let mut near = Scene::new(bodies, &contact);
            for body in bodies.iter_mut().flatten() {
                body.center += far;
            }
            for (point, _) in &mut contact.points {
                *point += far;
            }
            let mut away = Scene::new(bodies, &contact);
            step(&mut near);
            step(&mut away);
            let places = [&mut near, &mut away].map(|scene| {
                let places = core::mem::take(&mut scene.block.places);
                places[0].lane(LANE)
            });
            assert_eq!(format!("{:?}", near.block), format!("{:?}", away.block));
            assert_eq!(format!("{:?}", near.states), format!("{:?}", away.states));
            assert!((places[0] + far - places[1]).length() < 1.0e5 * Real::EPSILON);
        }
    }
}

#[test]
fn points_and_separations_are_reported() {
    let mut random = Random(26);
    for _ in 0..50 {
        let mut bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
        bodies[random.below(2)] = None;
        let contact = random_manifold(&mut random);
        let mut scene = Scene::new(bodies, &contact);
        scene.prepare();
        scene.keep();
        let report = &scene.reports[LANE];
        assert!(report.is_sound());
        assert!((report.normal() - contact.normal).length() < ROUNDING);
        for (k, &(point, separation)) in contact.points.iter().enumerate() {
            assert!((report.point(k) - point).length() < ROUNDING);
            assert!((report.separation(k) - separation).abs() < ROUNDING);
        }
    }
}

/// Bodies that moved since their anchors were transformed, and contact points that moved with them.
struct Moved {
    anchored: Contact,
    /// Input of a block whose anchors are transformed now.
    now: Contact,
    before: [Option<Body>; 2],
    after: [Option<Body>; 2],
}

impl Moved {
    fn random(random: &mut Random) -> Self {
        let mut before = [Some(Body::random(random)), Some(Body::random(random))];
        if random.below(3) == 0 {
            before[random.below(2)] = None;
        }
        let mut went = [(Vector::ZERO, Rotation::IDENTITY); 2];
        let mut after = before;
        for side in 0..2 {
            let Some(body) = &mut after[side] else { continue };
            went[side] =
                (random_vector(random, 0.1), rotation_from_angle(random_turn(random, 0.3)));
            body.center += went[side].0;
            body.rotation = went[side].1 * body.rotation;
        }
        let anchored = random_manifold(random);
        let mut now = anchored.clone();
        now.normal = went[0].1 * anchored.normal;
        let centers = before.map(|body| body.map_or(Vector::ZERO, |body| body.center));
        for (point, separation) in &mut now.points {
            let surfaces = [0, 1]
                .map(|side| centers[side] + went[side].0 + went[side].1 * (*point - centers[side]));
            *point = (surfaces[0] + surfaces[1]) * 0.5;
            *separation += now.normal.dot(surfaces[1] - surfaces[0]);
        }
        Self { anchored, now, before, after }
    }

    /// The block of contacts whose anchors were transformed before the bodies moved.
    fn prepared(&self, frozen_angle: Real) -> Scene {
        let mut scene = Scene::new(self.before, &Contact { frozen_angle, ..self.anchored.clone() });
        for (side, body) in self.after.iter().enumerate() {
            let Some(body) = body else { continue };
            let index = scene.input.bodies[side][LANE] as usize;
            let (rotation, center) = (body.rotation, body.center);
            scene.poses[index] = BodyPose::new(rotation, center, body.inv_mass, &body.inv_inertia);
        }
        scene.prepare();
        scene
    }
}

#[test]
fn contacts_that_are_not_frozen_equal_contacts_transformed_now() {
    let mut random = Random(28);
    for _ in 0..50 {
        let moved = Moved::random(&mut random);
        let mut expected = Scene::new(moved.after, &moved.now);
        expected.prepare();
        let found = moved.prepared(0.0);
        for k in 0..moved.now.points.len() {
            let (found_at, expected_at) = (&found.block.points[k], &expected.block.points[k]);
            assert!((found_at.x.0[LANE] - expected_at.x.0[LANE]).abs() < ROUNDING);
            assert!(
                (found_at.separation.0[LANE] - expected_at.separation.0[LANE]).abs() < ROUNDING
            );
            assert!((found_at.mass.0[LANE] - expected_at.mass.0[LANE]).abs() < ROUNDING);
            let points = [&found, &expected].map(|scene| scene.block.places[k].lane(LANE));
            assert!((points[0] - points[1]).length() < ROUNDING);
        }
        let offsets = [&found, &expected].map(|scene| scene.block.offset.lane(LANE));
        assert!((offsets[0] - offsets[1]).length() < ROUNDING);
        assert!((found.block.normal.lane(LANE) - moved.now.normal).length() < ROUNDING);
    }
}

#[test]
fn frozen_anchors_keep_their_moment_arms_and_update_their_separations() {
    let mut random = Random(29);
    for _ in 0..50 {
        let moved = Moved::random(&mut random);
        let frozen = Contact { frozen_angle: 2.0, ..moved.anchored.clone() };
        let mut anchored = Scene::new(moved.before, &frozen);
        anchored.prepare();
        let found = moved.prepared(2.0);
        for (k, &(point, separation)) in moved.anchored.points.iter().enumerate() {
            assert_eq!(anchored.block.points[k].x, found.block.points[k].x);
            // The surfaces are where they are, and seen along the normal as it was.
            let along = found.block.points[k].separation.0[LANE] - separation;
            let (before, now) = (point, moved.now.points[k].0);
            let at = |body: &Option<Body>, other: &Option<Body>| match (body, other) {
                (Some(old), Some(new)) => {
                    let turn = new.rotation * old.rotation.inverse();
                    new.center + turn * (before - old.center)
                }
                _ => before,
            };
            let surfaces =
                [at(&moved.before[0], &moved.after[0]), at(&moved.before[1], &moved.after[1])];
            let expected = moved.anchored.normal.dot(surfaces[1] - surfaces[0]);
            assert!((along - expected).abs() < ROUNDING, "{along} instead of {expected}");
            assert!((found.block.places[k].lane(LANE) - now).length() < ROUNDING);
        }
        assert_eq!(anchored.block.offset, found.block.offset);
        assert_eq!(anchored.block.normal, found.block.normal);
    }
}

/// The impulses that a step ends with, given to the next one, act on the bodies as they did before.
#[test]
fn warm_starting_repeats_the_impulses() {
    let mut random = Random(27);
    for _ in 0..50 {
        let bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
        let contact = random_manifold(&mut random);
        let mut first = Scene::new(bodies, &contact);
        first.prepare();
        for _ in 0..3 {
            first.relax();
        }
        first.keep();
        let mut second = Scene::new(bodies, &contact);
        second.input = first.input.clone();
        second.prepare();
        for body in 1..=2 {
            let ((v1, w1), (v2, w2)) = (first.velocity(body), second.velocity(body));
            assert!((v1 - v2).length() < ROUNDING, "{v1} and {v2}");
            assert!(ang_length_squared(w1 - w2).sqrt() < ROUNDING, "{w1} and {w2}");
        }
    }
}

/// The impulses of a step are those of its substeps, each counted once however often it was visited.
#[test]
fn totals_count_each_substep_once() {
    let body = Body { linvel: -Vector::Y, ..Body::block() };
    let mut scene = Scene::new([None, Some(body)], &Contact::at(Vector::Y, &[-Vector::Y]));
    scene.prepare();
    for _ in 0..3 {
        scene.begin_substep(-Vector::Y * 10.0);
        scene.bounce();
        scene.solve();
        for is_last_iteration in [false, false, true] {
            scene.pass.is_last_iteration = is_last_iteration;
            scene.relax();
        }
    }
    // The impulse that stopped it at once, and then carried its weight.
    let expected = 1.0 + 3.0 * 10.0 * SUBSTEP;
    let total = scene.block.totals[0].0[LANE];
    assert!((total - expected).abs() < ROUNDING, "{total} instead of {expected}");
}

#[test]
fn empty_lanes_do_nothing() {
    let mut scene = Scene::empty();
    step(&mut scene);
    assert_eq!(scene.input.bodies, [[BodyPose::WORLD_INDEX; LANES]; 2]);
    assert_eq!(format!("{:?}", scene.states), format!("{:?}", Scene::empty().states));
    assert_eq!(scene.normal_impulse(), 0.0);
}
