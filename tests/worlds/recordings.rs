//! Recording, replay and comparison of runs.

use super::own_shape::OwnShape;
use super::saved::{EDITS, Edit};
use super::scene::{at, cube, world};
use crate::rapier::parry::shape::Ball;
use crate::rapier::prelude::*;

/// Returns a recording of some steps, with an edit before one of them.
fn record(steps: usize, edited: usize, edit: fn(&mut PhysicsWorld)) -> (Vec<u8>, PhysicsWorld) {
    let mut world = world();
    let mut recorder = Recorder::new(&world, "one of everything").expect("it can be saved");
    for k in 0..steps {
        if k == edited {
            edit(&mut world);
        }
        recorder.step(&mut world).expect("it can be saved");
    }
    assert_eq!(recorder.steps(), steps);
    (recorder.into_bytes(), world)
}

#[test]
fn a_replay_repeats_every_edit() {
    let more: [Edit; 4] = [
        ("gravity", |world| world.gravity = Vector::X),
        ("parameters", |world| world.integration_parameters.num_solver_iterations = 2),
        ("detection", |world| world.detect_collisions(&(), &())),
        ("a joint", |world| {
            let dynamic = world.bodies.iter().filter(|(_, body)| body.is_dynamic());
            let bodies: Vec<_> = dynamic.map(|(handle, _)| handle).take(2).collect();
            world.insert_impulse_joint(bodies[0], bodies[1], RopeJointBuilder::new(1.0));
        }),
    ];
    for (name, edit) in EDITS.into_iter().chain(more) {
        let (recording, world) = record(25, 12, edit);
        let mut replay = Replay::new(&recording).expect("it was recorded");
        assert_eq!(replay.title(), "one of everything");
        while replay.step().unwrap_or_else(|error| panic!("{name}: {error}")) == Replayed::Step {
            let is_edited = replay.steps() == 13 && name != "nothing";
            assert_eq!(replay.was_edited(), is_edited, "{name}: step {}", replay.steps());
        }
        assert_eq!((replay.steps(), replay.world().hash()), (25, world.hash()), "{name}");
    }
}

/// A world cannot be saved for some steps: the recording up to then is complete, and contains nothing later.
#[test]
fn a_recording_ends_where_the_world_cannot_be_saved() {
    let mut world = world();
    let mut recorder = Recorder::new(&world, "until a shape comes").expect("it can be saved");
    (0..3).for_each(|_| recorder.step(&mut world).expect("it can be saved"));
    let own = ColliderBuilder::new(SharedShape::new(OwnShape(Ball::new(0.5))));
    let own = world.insert_collider(own.translation(at(500.0, 0.0)), None);
    let refused = recorder.step(&mut world).expect_err("nothing can save the shape");
    assert!(matches!(refused, RecordingError::Snapshot(_)), "{refused}");
    world.remove_collider(own);
    let before = world.hash();
    assert_eq!(recorder.step(&mut world), Err(refused), "a step is missing by now");
    assert_ne!(world.hash(), before, "the world goes on");

    let mut replay = Replay::new(recorder.bytes()).expect("its beginning was recorded");
    while let Replayed::Step = replay.step().expect("all that is recorded is whole") {}
    assert_eq!((replay.steps(), recorder.steps()), (3, 3));
}

/// Hooks that reject all pairs.
struct Ghosts;

impl PhysicsHooks for Ghosts {
    fn filter_contact_pair(&self, _: &PairFilterContext<'_>) -> bool {
        false
    }
}

/// Records two boxes, one of which falls onto the ground.
fn drop_box(hooks: &dyn PhysicsHooks) -> (Vec<u8>, RigidBodyHandle) {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let far = RigidBodyBuilder::dynamic().translation(at(50.0, 50.0));
    world.insert(far, cube(0.5));
    let falling = RigidBodyBuilder::dynamic().translation(at(0.0, 0.8)).build();
    let hooked = cube(0.5).active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS);
    let (falling, _) = world.insert(falling, hooked);
    let recorder = Recorder::new(&world, "a box falls").expect("it can be saved");
    let mut recorder = recorder.with_stage_hashes();
    for _ in 0..60 {
        recorder.step_with_events(&mut world, hooks, &()).expect("it can be saved");
    }
    (recorder.into_bytes(), falling)
}

/// Hooks are not recorded: a replay without them diverges at the first contact, and stops.
#[test]
fn a_divergence_names_step_stage_and_body() {
    let (recording, falling) = drop_box(&Ghosts);
    let mut replay = Replay::new(&recording).expect("it was recorded");
    let error = loop {
        match replay.step() {
            Ok(step) => assert_eq!(step, Replayed::Step, "the replay should diverge"),
            Err(error) => break error,
        }
    };
    let ReplayError::Diverged(divergence) = error else { panic!("{error}") };
    // The box falls 0.3 units in √(2 · 0.3 / 9.81) = 0.247 s; the contact exists slightly earlier.
    assert!((10..=15).contains(&divergence.step), "{divergence}");
    assert!(divergence.stage >= Some(StepStage::CollisionDetection), "{divergence}");
    let with_body = divergence.body.is_none_or(|body| body == falling);
    assert!(with_body, "{divergence}");

    let mut replay = Replay::new(&recording).expect("it was recorded");
    let mut step = || replay.step_with_events(&Ghosts, &()).expect("the hooks are the same");
    while step() == Replayed::Step {}
}

#[test]
fn recordings_are_compared() {
    let compare = |one: &[u8], two: &[u8]| compare_recordings(one, two).expect("both are whole");
    let (one, _) = record(20, 5, EDITS[1].1);
    assert_eq!(compare(&one, &record(20, 5, EDITS[1].1).0), None);
    assert_eq!(compare(&one, &record(20, 6, EDITS[1].1).0), Some(Difference::Edits { step: 5 }));
    assert_eq!(compare(&one, &record(15, 5, EDITS[1].1).0), Some(Difference::Length { steps: 15 }));
    let (ghosts, _) = drop_box(&Ghosts);
    let (solid, _) = drop_box(&());
    assert_eq!(compare(&one, &ghosts), Some(Difference::Start));
    match compare(&solid, &ghosts) {
        Some(Difference::Step { step, stage: Some(_), body }) => {
            // The falling box is the second body.
            assert!((10..=15).contains(&step) && body.is_none_or(|body| body == 1), "{body:?}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn truncated_or_changed_recordings_are_rejected() {
    let (recording, _) = record(6, 3, EDITS[1].1);
    let run = |bytes: &[u8]| {
        let mut replay = Replay::new(bytes).map_err(ReplayError::from)?;
        while replay.step()? == Replayed::Step {}
        Ok::<_, ReplayError>(replay.steps())
    };
    assert_eq!(run(&recording), Ok(6));
    let mut ends = 0;
    for length in (0..recording.len()).rev().step_by(37) {
        // The file may end between two steps.
        ends += usize::from(run(&recording[..length]).is_ok_and(|steps| steps < 6));
        let _ = compare_recordings(&recording, &recording[..length]);
    }
    assert!(ends <= 6, "{ends} of the shorter files were whole");
    assert!(matches!(Replay::new(b"a text"), Err(RecordingError::NotARecording)));
    let mut newer = recording.clone();
    newer[8] = 9;
    let refused = Replay::new(&newer).err();
    assert!(matches!(refused, Some(RecordingError::Format { found: 9, .. })), "{refused:?}");
    for at in (0..recording.len()).step_by(53) {
        let mut damaged = recording.clone();
        damaged[at] ^= 0x10;
        // Most damage is detected. A wrong hash of a body is not, because it is compared only after a
        // divergence.
        let _ = run(&damaged);
    }
}
