//! Scenes are recorded and replayed.

use replay::{Failure, Request, flat, play, solid};

fn request(scene: &str) -> Request<'_> {
    Request { scene, steps: Some(60), stages: true }
}

/// Scenes with scripts, hooks, joints and vehicles.
#[test]
fn scenes_are_replayed_with_the_same_hashes() {
    for scene in ["dominoes", "conveyor_belts", "one_way_platforms", "vehicle", "characters"] {
        let recording = solid::record(&request(scene)).expect(scene);
        let summary = play(&recording).unwrap_or_else(|failure| panic!("{scene}: {failure}"));
        assert_eq!((summary.dimension, summary.steps), (3, 60));
        assert_eq!(summary.title, format!("3d/{scene}"));
        let again = solid::record(&request(scene)).expect(scene);
        assert_eq!(solid::compare(&recording, &again), Ok(()), "{scene}");
    }
    let recording = flat::record(&request("dominoes")).expect("it can be saved");
    assert_eq!(play(&recording).map(|summary| summary.dimension), Ok(2));
}

#[test]
fn failures_name_their_cause() {
    let failure = solid::record(&request("no_such_scene")).expect_err("there is none");
    assert!(failure.to_string().contains("no 3D scene `no_such_scene`"), "{failure}");
    assert!(matches!(play(b"no recording"), Err(Failure::Recording(_))));
    let short = Request { steps: Some(3), ..request("dominoes") };
    let [long, short] = [request("dominoes"), short].map(|it| solid::record(&it).expect("it can"));
    let difference = solid::compare(&long, &short).expect_err("one has 3 steps");
    assert!(difference.to_string().contains("ends after 3 steps"), "{difference}");
    let cut = &short[..short.len() - 1];
    assert!(play(cut).is_err_and(|failure| failure.to_string().contains("step 2")));
}
