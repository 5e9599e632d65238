//! Running time of contact generation. Run with `--release -- --ignored --nocapture timing`.

use crate::base::random::Random;
use crate::collide::manifolds::{ManifoldScratch, compute_manifolds};
use crate::collide::matching::inherit_impulses;
use crate::collide::pair::ShapePair;
use crate::dim::collide::samples;
use crate::dim::math::{Pose, Vector};
use parry::shape::{Shape, SharedShape};
use smallvec::SmallVec;
use std::time::Instant;

/// Pairs of one kind that just touch, at random rotations around one another.
fn touching(shape1: &SharedShape, shape2: &SharedShape, random: &mut Random) -> Vec<Pose> {
    let mut poses = Vec::new();
    while poses.len() < 1_000 {
        let direction = samples::rotation(random) * Vector::X;
        let rotation = samples::rotation(random);
        let (mut low, mut high) = (0.0, 10.0);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            let pose = Pose::from_parts(direction * middle, rotation);
            let hit = parry::query::intersection_test(&Pose::IDENTITY, &**shape1, &pose, &**shape2);
            if hit.is_ok_and(|hit| hit.intersecting) { low = middle } else { high = middle }
        }
        poses.push(Pose::from_parts(direction * (low - 0.01), rotation));
    }
    poses
}

fn time(name: &str, shape1: &dyn Shape, shape2: &dyn Shape, poses: &[Pose]) {
    let mut scratch = ManifoldScratch::default();
    let mut out = SmallVec::new();
    let (mut points, mut fastest) = (0, f64::INFINITY);
    // A step of a pile: the bodies have moved a little since the manifolds of the last step.
    let aside = Pose::from_translation(Vector::splat(1.0e-3));
    let previous: Vec<SmallVec<_>> = poses
        .iter()
        .map(|pose| {
            let mut found = SmallVec::new();
            let pose = &(aside * *pose);
            let pair = ShapePair::alone(pose, [shape1, shape2], 0.02);
            compute_manifolds(&pair, &[], None, &mut scratch, &mut found);
            found
        })
        .collect();
    for _ in 0..rounds() {
        points = 0;
        let start = Instant::now();
        for (pose, previous) in poses.iter().zip(&previous) {
            let pair = ShapePair::alone(pose, [shape1, shape2], 0.02);
            compute_manifolds(&pair, previous, None, &mut scratch, &mut out);
            inherit_impulses(&mut out, previous);
            points += out.iter().map(|manifold| manifold.contacts().len()).sum::<usize>();
        }
        fastest = fastest.min(start.elapsed().as_secs_f64());
    }
    let (nanoseconds, count) = (fastest * 1.0e9 / poses.len() as f64, poses.len() as f64);
    println!("{name:28} {nanoseconds:7.0} ns, {:.2} points", points as f64 / count);
}

/// Repetitions; the fastest counts. More for a profile.
fn rounds() -> usize {
    std::env::var("ROUNDS").ok().and_then(|rounds| rounds.parse().ok()).unwrap_or(20)
}

#[test]
#[ignore = "prints timings and checks nothing"]
fn timing() {
    println!("{} bytes a manifold", size_of::<crate::model::contact::ContactManifold>());
    let mut random = Random(1);
    let ball = SharedShape::ball(0.5);
    let cube = samples::cuboid(Vector::splat(0.5));
    let capsule = SharedShape::capsule_y(0.5, 0.3);
    let hull = samples::shape(samples::HULL, &mut random, 0.5);
    let plane = SharedShape::halfspace(Vector::Y);
    let shapes = [("ball", &ball), ("box", &cube), ("capsule", &capsule), ("hull", &hull)];
    for (index, (name1, shape1)) in shapes.iter().enumerate() {
        for (name2, shape2) in &shapes[index..] {
            let name = format!("{name1} - {name2}");
            let poses = touching(shape1, shape2, &mut random);
            if std::env::var("ONLY").is_ok_and(|only| only != name) {
                continue;
            }
            time(&name, &***shape1, &***shape2, &poses);
        }
    }
    let stacked: Vec<_> = (0..1_000)
        .map(|_| {
            let aside = samples::vector(&mut random, 0.3) * (Vector::ONE - Vector::Y);
            Pose::from_translation(Vector::Y * 0.995 + aside)
        })
        .collect();
    time("box on box", &*cube, &*cube, &stacked);
    time(
        "box over box, apart",
        &*cube,
        &*cube,
        &stacked
            .iter()
            .map(|p| Pose::from_parts(p.translation * 1.1, p.rotation))
            .collect::<Vec<_>>(),
    );
    time("plane - box", &*plane, &*cube, &stacked);
    time("hull on box", &*cube, &*hull, &stacked);
}
