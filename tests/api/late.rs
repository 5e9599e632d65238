//! Contact results are written back at the first read, without side effects.

use crate::dim::{self, cuboid, vec};
use rapier::prelude::*;

/// Heap with removals, pushes, additional solver iterations and links at intervals.
struct Heap {
    world: PhysicsWorld,
    step: usize,
}

impl Heap {
    fn new() -> Self {
        let mut world = PhysicsWorld::new();
        world.insert_collider(cuboid(30.0, 1.0).translation(vec(0.0, -1.0)), None);
        for k in 0..120_u8 {
            let (column, row) = (Real::from(k % 6), Real::from(k / 6));
            let at = vec(column * 0.9 + row * 0.07 - 3.0, 0.6 + row * 0.9);
            let body = RigidBodyBuilder::dynamic().translation(at).rotation(dim::about_z(row));
            let collider = if k % 4 == 0 { ColliderBuilder::ball(0.4) } else { cuboid(0.4, 0.3) };
            world.insert(body, collider.restitution(0.1 * column));
        }
        Self { world, step: 0 }
    }

    fn step(&mut self) {
        let world = &mut self.world;
        let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
        let chosen = bodies[(self.step * 37) % bodies.len()];
        match self.step % 40 {
            5 => drop(world.remove_body(chosen)),
            12 => world.bodies[chosen].set_additional_solver_iterations(3),
            20 => world.bodies[chosen].set_additional_solver_iterations(0),
            25 => {
                let at = vec(0.0, 9.0);
                let link = RigidBodyBuilder::dynamic().translation(at);
                let (one, _) = world.insert(link.clone(), cuboid(0.2, 0.2));
                let (two, _) = world.insert(link.translation(at + Vector::X), cuboid(0.2, 0.2));
                let joint = dim::loose_joint(0, vec(0.5, 0.0), vec(-0.5, 0.0));
                assert!(world.insert_multibody_joint(one, two, joint).is_some());
            }
            30 => world.bodies[chosen].apply_impulse(vec(20.0, 5.0), true),
            33 => world.integration_parameters.dt = 1.0 / 100.0,
            37 => world.integration_parameters.dt = 1.0 / 60.0,
            _ => {}
        }
        let is_rough = (8..17).contains(&(self.step % 40));
        let model = if is_rough { FrictionModel::Coulomb } else { FrictionModel::Standard };
        world.integration_parameters.friction_model = model;
        world.step();
        self.step += 1;
    }

    /// Returns all numbers of all contacts.
    fn contacts(&self) -> Vec<Real> {
        let pairs = self.world.contact_pairs().map(|(_, _, pair)| pair);
        pairs.flat_map(numbers).collect()
    }

    fn bodies(&self) -> Vec<Real> {
        let bodies = self.world.bodies.iter().map(|(_, body)| body);
        bodies.flat_map(|body| (body.translation() + body.linvel()).to_array()).collect()
    }
}

/// Returns all numbers of the contacts of a pair.
fn numbers(pair: &ContactPair) -> Vec<Real> {
    let mut numbers = Vec::new();
    for manifold in &pair.manifolds {
        numbers.extend(manifold.data.normal.to_array());
        for contact in manifold.contacts() {
            numbers.extend([contact.impulse, contact.warmstart_impulse, contact.dist]);
            numbers.extend(contact.point.to_array());
            numbers.extend(contact.warmstart_tangent_impulse);
        }
    }
    numbers
}

const STEPS: usize = 200;

/// Reading all contacts after each step, or those of one collider, or none, does not change a bit of any
/// result.
#[test]
fn reads_change_nothing() {
    let (mut never, mut always, mut sometimes) = (Heap::new(), Heap::new(), Heap::new());
    for step in 0..STEPS {
        [&mut never, &mut always, &mut sometimes].into_iter().for_each(Heap::step);
        let seen = always.contacts();
        let colliders: Vec<_> =
            sometimes.world.colliders.iter().map(|(handle, _)| handle).collect();
        let one = colliders[step % colliders.len()];
        let of_one = |heap: &Heap| -> Vec<Real> {
            heap.world.contact_pairs_with(one).flat_map(numbers).collect()
        };
        assert_eq!(of_one(&always), of_one(&sometimes), "in step {step}");
        if step % 50 == 49 {
            assert!(seen.iter().any(|number| *number > 0.1));
            assert_eq!(seen, sometimes.contacts(), "in step {step}");
        }
    }
    assert_eq!(never.bodies(), always.bodies());
    assert_eq!(never.bodies(), sometimes.bodies());
    assert_eq!(never.contacts(), always.contacts());
}

/// Several threads may read or copy the same contacts at the same time, each for the first time.
#[test]
fn several_threads_may_read_at_once() {
    let mut heap = Heap::new();
    for _ in 0..60 {
        heap.step();
        let start = std::sync::Barrier::new(4);
        let (heap, start) = (&heap, &start);
        let look = move |copies: bool| {
            start.wait();
            if !copies {
                return heap.contacts();
            }
            let copy = heap.world.narrow_phase.clone();
            copy.contact_pairs().flat_map(|(.., pair)| numbers(pair)).collect()
        };
        let found: Vec<_> = std::thread::scope(|scope| {
            let readers: Vec<_> = (0..4).map(|k| scope.spawn(move || look(k % 2 == 1))).collect();
            readers.into_iter().map(|reader| reader.join().expect("no panic")).collect()
        });
        assert!(found.iter().all(|contacts| *contacts == found[0]));
    }
}

/// A copy made before the first read has the same results, and continues in the same way.
#[test]
fn a_copy_has_the_same_results() {
    let mut heap = Heap::new();
    (0..70).for_each(|_| heap.step());
    let copy = heap.world.narrow_phase.clone();
    let of_copy: Vec<Real> = copy.contact_pairs().flat_map(|(_, _, pair)| numbers(pair)).collect();
    assert_eq!(heap.contacts(), of_copy);

    let (mut kept, mut exchanged) = (Heap::new(), Heap::new());
    for _ in 0..STEPS {
        kept.step();
        exchanged.step();
        exchanged.world.narrow_phase = exchanged.world.narrow_phase.clone();
    }
    assert_eq!(kept.bodies(), exchanged.bodies());
    assert_eq!(kept.contacts(), exchanged.contacts());
}

/// A pipeline may step two different worlds in turn.
#[test]
fn two_worlds_share_a_pipeline() {
    let (mut alone, mut large, mut small) = (Heap::new(), Heap::new(), Heap::new());
    let all: Vec<_> = small.world.bodies.iter().map(|(handle, _)| handle).collect();
    all.into_iter().skip(10).for_each(|body| drop(small.world.remove_body(body)));
    for _ in 0..STEPS {
        alone.step();
        large.step();
        std::mem::swap(&mut large.world.physics_pipeline, &mut small.world.physics_pipeline);
        small.world.step();
        std::mem::swap(&mut large.world.physics_pipeline, &mut small.world.physics_pipeline);
    }
    assert_eq!(alone.bodies(), large.bodies());
    assert_eq!(alone.contacts(), large.contacts());
}

/// Detection alone moves no body and applies no impulses. The next step starts with the impulses of the last
/// step.
#[test]
fn detection_between_steps_clears_impulses_and_keeps_the_warm_start() {
    let (mut plain, mut detected) = (Heap::new(), Heap::new());
    for _ in 0..100 {
        plain.step();
        detected.step();
    }
    detected.world.detect_collisions(&(), &());
    let impulse = |heap: &Heap| -> Real {
        heap.world.contact_pairs().map(|(_, _, pair)| pair.total_impulse_magnitude()).sum()
    };
    assert!(impulse(&plain) > 0.1);
    assert_eq!(impulse(&detected), 0.0);
    let kept = |heap: &Heap| -> Real {
        let pairs = heap.world.contact_pairs().map(|(_, _, pair)| pair);
        let manifolds = pairs.flat_map(|pair| &pair.manifolds);
        manifolds.flat_map(|manifold| manifold.contacts()).map(|c| c.warmstart_impulse).sum()
    };
    assert!(kept(&detected) > 0.1);
}
