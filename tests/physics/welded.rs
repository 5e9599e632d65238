//! Bodies that joints hold rigidly at each other: their contact changes nothing.

use super::stage::{RATES, Sample, add_ground, penetration, run, weightless, world};
use crate::dim::{about_z, ang_length, cuboid, moment, spin_momentum, vec};
use rapier::prelude::*;

/// Angular momentum of all bodies about the origin (kg·m²/s).
fn momentum(world: &PhysicsWorld) -> Real {
    let of_one = |body: &RigidBody| {
        moment(body.center_of_mass(), body.linvel() * body.mass()) + spin_momentum(body)
    };
    ang_length(world.bodies.iter().map(|(_, body)| of_one(body)).sum())
}

/// Adds boxes at these places, which rotate about the origin. Returns their handles.
fn add_boxes(world: &mut PhysicsWorld, places: &[[Real; 2]], spin: Real) -> Vec<RigidBodyHandle> {
    let add = |&[x, y]: &[Real; 2]| {
        let body = RigidBodyBuilder::dynamic().can_sleep(false).translation(vec(x, y));
        let body = body.linvel(vec(-spin * y, spin * x)).angvel(about_z(spin));
        world.insert(body, cuboid(0.5, 0.5)).0
    };
    places.iter().map(add).collect()
}

/// Welds two of these boxes in their middle.
fn weld(places: &[[Real; 2]], ends: [usize; 2]) -> FixedJointBuilder {
    let [from, to] = ends.map(|k| vec(places[k][0], places[k][1]));
    FixedJointBuilder::new().local_anchor1(0.5 * (to - from)).local_anchor2(0.5 * (from - to))
}

/// Welded boxes that rotate in empty space keep their angular momentum, although they overlap: two in a row,
/// three around a corner, and a square of four without a weld between the first and the last.
///
/// Their contact would press them apart with any force. It acts on the bodies where they were when the step
/// began, so it would be a couple, and bring them to rest within seconds.
#[test]
fn welded_boxes_keep_their_angular_momentum() {
    let mut sample = Sample::one_of(5);
    for (rate, iterations) in RATES.into_iter().flat_map(|rate| [1, 4, 16].map(|n| (rate, n))) {
        for overlap in [0.0, 0.005, 0.02, 0.3] {
            let side = 1.0 - overlap;
            let [low, high] = [-0.5 * side, 0.5 * side];
            let square = [[low, low], [high, low], [high, high], [low, high]];
            let row = [[low, 0.0], [high, 0.0]];
            for places in [&row[..], &square[..3], &square[..]] {
                for spin in [0.2, 1.0, 5.0] {
                    if !sample.has_next() {
                        continue;
                    }
                    let mut world = weightless(rate);
                    world.integration_parameters.num_solver_iterations = iterations;
                    let boxes = add_boxes(&mut world, places, spin);
                    for k in 1..boxes.len() {
                        let joint = weld(places, [k - 1, k]);
                        world.insert_impulse_joint(boxes[k - 1], boxes[k], joint);
                    }
                    let start = momentum(&world);
                    run(&mut world, 2.0);
                    let kept = momentum(&world) / start;
                    let what = format!(
                        "{} boxes, {overlap} m of overlap, {spin} rad/s, {rate} Hz, {iterations} iterations",
                        boxes.len()
                    );
                    assert!((kept - 1.0).abs() < 0.01, "{what}: {kept} of the momentum is left");
                }
            }
        }
    }
}

/// Towers of welded crates keep their height on the ground, with and without contacts between the crates.
#[test]
fn welded_towers_keep_their_height() {
    for count in [2, 4, 8, 9, 20] {
        let mut world = world(60);
        add_ground(&mut world, 0.5);
        let places: Vec<_> = (0..count).map(|k| [0.0, k as Real + 0.5]).collect();
        let boxes = add_boxes(&mut world, &places, 0.0);
        for k in 1..count {
            world.insert_impulse_joint(boxes[k - 1], boxes[k], weld(&places, [k - 1, k]));
        }
        run(&mut world, 5.0);
        let top = world.bodies[boxes[count - 1]].translation().y + 0.5;
        assert!((top / count as Real - 1.0).abs() < 0.01, "{count} crates are {top} m high");
    }
}

/// A way to end a weld.
type Ending = fn(&mut PhysicsWorld, ImpulseJointHandle, RigidBodyHandle);

/// The contact of two boxes that are welded to a third is reported. They part when the weld of one of them
/// ends, in whatever way.
#[test]
fn boxes_part_without_their_weld() {
    let places = [[-0.45, 0.0], [0.0, 5.0], [0.45, 0.0]];
    let endings: [(&str, Ending); 6] = [
        ("removal", |world, joint, _| {
            world.impulse_joints.remove(joint, true);
        }),
        ("removal of the third", |world, _, third| {
            world.remove_body(third);
        }),
        ("the third is disabled", |world, _, third| world.bodies[third].set_enabled(false)),
        ("disabled", |world, joint, _| {
            world.impulse_joints.get_mut(joint).expect("it is there").data.set_enabled(false);
        }),
        ("free translations", |world, joint, _| {
            let joint = world.impulse_joints.get_mut(joint).expect("it is there");
            joint.data.locked_axes = JointAxesMask::ANG_AXES;
        }),
        ("a spring", |world, joint, _| {
            let joint = world.impulse_joints.get_mut(joint).expect("it is there");
            joint.data.set_softness(Some(SpringCoefficients::new(0.1, 1.0)));
        }),
    ];
    for (how, end) in endings {
        let mut world = weightless(60);
        let boxes = add_boxes(&mut world, &places, 0.0);
        let joint = world.insert_impulse_joint(boxes[0], boxes[1], weld(&places, [0, 1]));
        world.insert_impulse_joint(boxes[1], boxes[2], weld(&places, [1, 2]));
        run(&mut world, 0.5);
        let overlap = penetration(&world);
        assert!((overlap - 0.1).abs() < 1e-3, "{how}: the welds hold an overlap of {overlap} m");
        end(&mut world, joint, boxes[1]);
        run(&mut world, 5.0);
        let left = penetration(&world);
        assert!(left < 0.01, "{how}: {left} m of overlap are left");
    }
}

/// A program that writes a weld as it is, each step, disturbs no body.
#[test]
fn a_weld_that_is_written_again_changes_nothing() {
    let places = [[-0.45, 0.0], [0.45, 0.0]];
    let [untouched, touched] = [false, true].map(|is_touched| {
        let mut world = weightless(60);
        let boxes = add_boxes(&mut world, &places, 1.0);
        let other =
            world.insert(RigidBodyBuilder::dynamic().translation(vec(0.9, 0.9)), cuboid(0.5, 0.5));
        let joint = world.insert_impulse_joint(boxes[0], boxes[1], weld(&places, [0, 1]));
        for _ in 0..120 {
            if is_touched {
                let joint = world.impulse_joints.get_mut(joint).expect("it is there");
                joint.data.set_enabled(true);
            }
            world.step();
        }
        [boxes[0], boxes[1], other.0].map(|body| *world.bodies[body].position())
    });
    assert_eq!(untouched, touched);
}
