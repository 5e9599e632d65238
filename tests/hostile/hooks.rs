//! Hooks that answer nonsense, and hooks and event handlers that panic.

use super::listener::{listen, names};
use super::scene::Scene;
use super::values::{EDGES, edge_vectors};
use super::world::check;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Calls closures instead of having opinions of its own.
#[derive(Default)]
struct Hooks<'a> {
    filter: Option<&'a (dyn Fn() -> bool + Sync)>,
    modify: Option<&'a (dyn Fn(&mut ContactModificationContext) + Sync)>,
}

impl PhysicsHooks for Hooks<'_> {
    fn filter_contact_pair(&self, _: &PairFilterContext) -> bool {
        self.filter.is_none_or(|filter| filter())
    }

    fn filter_intersection_pair(&self, _: &PairFilterContext) -> bool {
        self.filter.is_none_or(|filter| filter())
    }

    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        if let Some(modify) = self.modify {
            modify(context);
        }
    }
}

/// A scene whose first pile is at the mercy of hooks, and never sleeps.
fn scene() -> Scene {
    let mut scene = Scene::new();
    *scene.body().activation_mut() = RigidBodyActivation::cannot_sleep();
    for handle in scene.neighbours {
        let collider = scene.world.bodies[handle].colliders()[0];
        scene.world.colliders[collider].set_active_hooks(ActiveHooks::all());
    }
    let sensor = ColliderBuilder::ball(1.0).sensor(true).active_hooks(ActiveHooks::all());
    scene.world.insert_collider(sensor, Some(scene.body));
    scene
}

fn steps(scene: &mut Scene, hooks: &Hooks<'_>, count: usize) {
    for _ in 0..count {
        scene.world.step_with_events(hooks, &());
        check(&scene.world);
    }
}

#[test]
fn filters_that_change_their_mind_are_felt_by_nobody_else() {
    let mut untouched = scene();
    steps(&mut untouched, &Hooks::default(), 40);
    let expected = untouched.bystanders_in_the_end();
    for period in [1, 2, 3, 7] {
        let calls = AtomicUsize::new(0);
        let filter = || (calls.fetch_add(1, Relaxed) / period).is_multiple_of(2);
        let mut scene = scene();
        steps(&mut scene, &Hooks { filter: Some(&filter), modify: None }, 40);
        assert!(calls.into_inner() > 40, "the filter was asked");
        assert!(scene.bystanders_in_the_end() == expected, "period {period} is felt far away");
    }
}

#[test]
fn contacts_modified_at_random_are_felt_by_nobody_else() {
    let mut untouched = scene();
    steps(&mut untouched, &Hooks::default(), 40);
    let expected = untouched.bystanders_in_the_end();
    type Modify = (&'static str, fn(&mut ContactModificationContext, usize));
    let modifications: [Modify; 6] = [
        ("cleared", |c, i| {
            if i % 2 == 0 {
                c.clear_contacts()
            }
        }),
        ("thinned out", |c, i| c.retain_contacts(|contact| contact.point.x > 0.0 || i % 3 == 0)),
        ("flags", |c, i| c.set_solver_flags(SolverFlags::from_bits_retain(i as u32 * 7))),
        ("user data", |c, i| {
            c.set_user_data(u32::MAX - i as u32);
            c.update_as_oneway_platform(Vector::Y, 0.1);
        }),
        ("one way, no way", |c, i| {
            let angles = [Real::NAN, Real::INFINITY, 0.0, -1.0, 1.0e9, Real::MAX];
            c.update_as_oneway_platform(-Vector::Y, angles[i % 6]);
        }),
        ("everything", |c, i| {
            c.set_friction(EDGES[i % EDGES.len()]);
            c.set_restitution(EDGES[i / 3 % EDGES.len()]);
            c.set_tangent_velocity(Vector::X * EDGES[i / 5 % EDGES.len()]);
        }),
    ];
    for (name, modify) in modifications {
        let calls = AtomicUsize::new(0);
        let modify = |context: &mut ContactModificationContext| {
            modify(context, calls.fetch_add(1, Relaxed));
        };
        let mut scene = scene();
        listen(|| steps(&mut scene, &Hooks { filter: None, modify: Some(&modify) }, 40));
        assert!(calls.into_inner() > 40, "{name}: the hook was called");
        assert!(scene.bystanders_in_the_end() == expected, "{name} is felt far away");
    }
}

/// Numbers given to a hook are taken or refused by name.
#[test]
fn numbers_of_a_contact_are_taken_or_refused_by_name() {
    for value in EDGES {
        let modify = |context: &mut ContactModificationContext| {
            let before = (context.friction(), context.restitution());
            context.set_friction(value);
            context.set_restitution(value);
            let after = (context.friction(), context.restitution());
            assert!(after == (value, value) || after == before, "{value}");
        };
        let hooks = Hooks { filter: None, modify: Some(&modify) };
        let mut scene = scene();
        let ((), heard) = listen(|| steps(&mut scene, &hooks, 10));
        if value.is_nan() || value.is_infinite() || value < 0.0 {
            assert!(heard.iter().any(|text| names(text, value)), "{value}: {heard:?}");
        }
    }
    for vector in edge_vectors() {
        let modify = |context: &mut ContactModificationContext| {
            context.set_tangent_velocity(vector);
        };
        let hooks = Hooks { filter: None, modify: Some(&modify) };
        let mut scene = scene();
        let ((), heard) = listen(|| steps(&mut scene, &hooks, 10));
        if !vector.is_finite() {
            assert!(heard.iter().any(|text| text.contains("velocity")), "{vector}: {heard:?}");
        }
    }
}

/// Panics in every step that touches something.
struct Panicking;

impl EventHandler for Panicking {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        panic!("an event handler");
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        panic!("an event handler");
    }
}

/// A panic of the user's own code reaches the user. Whoever catches it has a world that goes on.
#[test]
fn a_world_outlives_the_panics_of_hooks_and_handlers() {
    let mut scene = scene();
    scene.collider().set_active_events(ActiveEvents::all());
    for round in 0..12 {
        let filter = || {
            assert!(round % 3 != 0, "a filter");
            true
        };
        let modify = |_: &mut ContactModificationContext| assert!(round % 3 != 1, "a hook");
        let hooks = Hooks { filter: Some(&filter), modify: Some(&modify) };
        let handler: &dyn EventHandler = if round % 3 == 2 { &Panicking } else { &() };
        let step = AssertUnwindSafe(|| scene.world.step_with_events(&hooks, handler));
        assert!(catch_unwind(step).is_err(), "round {round}");
        steps(&mut scene, &Hooks::default(), round % 4);
    }
    scene.steps(60);
}

/// Nothing gets through a plate because a hook panicked while its path was searched.
#[test]
fn nothing_passes_while_a_hook_panics() {
    for at in 0..20 {
        let mut world = PhysicsWorld::new();
        world.insert_collider(cuboid(50.0, 0.05), None);
        let balls: [_; 8] = core::array::from_fn(|k| {
            let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, 2.0));
            let ball = ColliderBuilder::ball(0.1).active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS);
            world.insert(body.linvel(vec(0.0, -300.0)).ccd_enabled(k % 2 == 0), ball).0
        });
        let calls = AtomicUsize::new(0);
        let filter = || {
            assert!(calls.fetch_add(1, Relaxed) != at, "a filter");
            true
        };
        let hooks = Hooks { filter: Some(&filter), modify: None };
        let mut step = || {
            let step = AssertUnwindSafe(|| world.step_with_events(&hooks, &()));
            catch_unwind(step).is_err()
        };
        assert_eq!((0..30).filter(|_| step()).count(), 1, "panics of call {at}");
        for ball in balls {
            let height = world.bodies[ball].translation().y;
            assert!(height > 0.0, "at {height} after a panic of call {at}");
        }
    }
}

/// A hook may use the pool of the step, step another world, and ask the world that is stepped.
#[test]
fn hooks_may_do_all_that_is_parallel() {
    let filter = || {
        let mut other = PhysicsWorld::new();
        other.insert_collider(cuboid(5.0, 0.5), None);
        for k in 0..40 {
            let at = vec(0.0, 1.0 + Real::from(k as u8));
            other.insert(RigidBodyBuilder::dynamic().translation(at), ColliderBuilder::ball(0.4));
        }
        other.step();
        let rays: Vec<Ray> = (0..200).map(|_| Ray::new(vec(0.0, 90.0), vec(0.0, -1.0))).collect();
        let view = other.query_pipeline();
        let hits = view.cast_rays(&rays, 1000.0, true);
        let (left, right) = rayon::join(|| hits.len(), || rays.len());
        left == right
    };
    let hooks = Hooks { filter: Some(&filter), modify: None };
    let run = |hooks: &Hooks<'_>| {
        let mut scene = scene();
        steps(&mut scene, hooks, 10);
        scene.bystanders_in_the_end()
    };
    let expected = run(&Hooks::default());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool");
    assert_eq!(pool.install(|| run(&hooks)), expected);
}
