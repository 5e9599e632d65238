//! Hooks with inconsistent results, and hooks and event handlers that panic.

use super::listener::{listen, names};
use super::scene::Scene;
use super::values::{EDGES, edge_vectors};
use super::world::check;
use crate::dim::{cuboid, vec};
use crate::suite::api::detection::detect;
use rapier::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// Hooks that call closures.
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

/// Returns a scene with hooks on its first pile, which never sleeps.
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
fn inconsistent_filters_affect_no_other_body() {
    let mut untouched = scene();
    steps(&mut untouched, &Hooks::default(), 40);
    let expected = untouched.distant_in_the_end();
    for period in [1, 2, 3, 7] {
        let calls = AtomicUsize::new(0);
        let filter = || (calls.fetch_add(1, Relaxed) / period).is_multiple_of(2);
        let mut scene = scene();
        steps(&mut scene, &Hooks { filter: Some(&filter), modify: None }, 40);
        assert!(calls.into_inner() > 40, "the filter was called");
        assert!(scene.distant_in_the_end() == expected, "period {period} affects distant bodies");
    }
}

#[test]
fn randomly_modified_contacts_affect_no_other_body() {
    let mut untouched = scene();
    steps(&mut untouched, &Hooks::default(), 40);
    let expected = untouched.distant_in_the_end();
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
        assert!(scene.distant_in_the_end() == expected, "{name} affects distant bodies");
    }
}

/// Numbers passed to a contact are accepted, or rejected by name.
#[test]
fn numbers_of_a_contact_are_accepted_or_rejected_by_name() {
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

/// Handler that panics in every step with a contact.
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

/// A panic of user code reaches the caller. After a caught panic, the world continues.
#[test]
fn worlds_survive_panics_of_hooks_and_handlers() {
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

/// A detection that defers edits applies removals only. Removals reorder the list of awake bodies, also if a
/// hook panics before the end of the detection. The record of an edit contains an index into this list, and
/// must not restore the old one.
#[test]
fn an_edited_body_keeps_its_index_after_a_detection_that_panicked() {
    for panics in [false, true] {
        let mut world = PhysicsWorld::new();
        let bodies: [_; 4] = core::array::from_fn(|k| {
            let ball = ColliderBuilder::ball(0.5).active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS);
            world.insert(RigidBodyBuilder::dynamic().translation(vec(0.9 * k as Real, 0.0)), ball).0
        });
        world.step();
        world.bodies[bodies[3]].set_linvel(Vector::Y, true);
        world.remove_body(bodies[0]);
        let filter = || {
            assert!(!panics, "a filter");
            true
        };
        let hooks = Hooks { filter: Some(&filter), modify: None };
        let detection = AssertUnwindSafe(|| detect(&mut world, false, &hooks, &()));
        assert_eq!(catch_unwind(detection).is_err(), panics);
        for _ in 0..3 {
            world.step();
            check(&world);
        }
    }
}

/// Recorded events: colliders that began or stopped to touch, and disabled bodies.
type Events = Vec<(bool, ColliderHandle, ColliderHandle)>;

/// Handler that records events, and panics a given number of times.
#[derive(Default)]
struct Notes {
    events: Mutex<Events>,
    quarantined: AtomicUsize,
    panics: AtomicUsize,
}

impl Notes {
    fn take_note(&self, note: (bool, ColliderHandle, ColliderHandle)) {
        self.events.lock().unwrap_or_else(PoisonError::into_inner).push(note);
        let left = self.panics.fetch_update(Relaxed, Relaxed, |left| left.checked_sub(1));
        assert!(left.is_err(), "a handler, with {left:?} panics left");
    }

    fn into_events(self) -> Events {
        self.events.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

impl EventHandler for Notes {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        self.take_note((event.started(), event.collider1(), event.collider2()));
    }

    fn handle_quarantine_event(&self, _: &QuarantineEvent, _: &RigidBodySet, _: &ColliderSet) {
        self.quarantined.fetch_add(1, Relaxed);
    }
}

/// Returns the events of sixty steps of bullets that fall onto a plate, some of which are removed again.
/// Steps that panic are repeated. `panics_at` is the index of the hook call that panics.
fn bullets_on_a_plate(panics_at: Option<usize>, notes: Notes) -> Events {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(50.0, 0.05), None);
    let balls: [_; 6] = core::array::from_fn(|k| {
        let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, 2.0));
        let ball = ColliderBuilder::ball(0.1)
            .active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS)
            .active_events(ActiveEvents::all());
        world.insert(body.linvel(vec(0.0, -300.0)).ccd_enabled(k % 2 == 0), ball).0
    });
    let calls = AtomicUsize::new(0);
    let filter = || {
        assert!(Some(calls.fetch_add(1, Relaxed)) != panics_at, "a filter");
        true
    };
    let hooks = Hooks { filter: Some(&filter), modify: None };
    for step in 0..60 {
        if step == 30 {
            world.remove_body(balls[0]);
            world.remove_body(balls[3]);
        }
        let mut once = || world.step_with_events(&hooks, &notes);
        if catch_unwind(AssertUnwindSafe(&mut once)).is_err() {
            once();
        }
    }
    notes.into_events()
}

/// A hook may panic at any call in any stage. Earlier findings of the step are sent as events, and later ones
/// are sent by the next step.
#[test]
fn no_event_is_lost_when_a_hook_panics() {
    let mut expected = bullets_on_a_plate(None, Notes::default());
    expected.sort_unstable();
    assert_eq!(expected.iter().filter(|(started, ..)| *started).count(), 6, "{expected:?}");
    assert_eq!(expected.len(), 8, "two were removed: {expected:?}");
    for panics_at in 0..260 {
        let mut events = bullets_on_a_plate(Some(panics_at), Notes::default());
        events.sort_unstable();
        assert_eq!(events, expected, "after a panic of call {panics_at}");
    }
}

/// A handler that panics still gets the other events, in the same step and the same order.
#[test]
fn no_event_is_lost_when_a_handler_panics() {
    let expected = bullets_on_a_plate(None, Notes::default());
    for panics in [1, 2, 3] {
        let notes = Notes { panics: AtomicUsize::new(panics), ..Notes::default() };
        assert_eq!(bullets_on_a_plate(None, notes), expected, "after {panics} panics");
    }
}

/// The event of a disabled body is sent even if the step ends with a panic.
#[test]
fn quarantine_events_are_sent_when_a_hook_panics() {
    for panics_at in 0..6 {
        let mut scene = scene();
        let force = Vector::Y * 1.0e30;
        scene.world.bodies[scene.body].add_force(force, true);
        let calls = AtomicUsize::new(0);
        let filter = || {
            assert!(calls.fetch_add(1, Relaxed) != panics_at, "a filter");
            true
        };
        let (hooks, notes) = (Hooks { filter: Some(&filter), modify: None }, Notes::default());
        for _ in 0..3 {
            let step = AssertUnwindSafe(|| scene.world.step_with_events(&hooks, &notes));
            let ((), _) = listen(|| drop(catch_unwind(step)));
        }
        assert!(scene.body().quarantine().is_some(), "panic of call {panics_at}");
        assert_eq!(notes.quarantined.into_inner(), 1, "panic of call {panics_at}");
        steps(&mut scene, &Hooks::default(), 10);
    }
}

/// Handler that queries the world of its events, and steps another world with the same handler.
struct ReentrantHandler {
    calls: AtomicUsize,
    inner: ChannelEventCollector,
}

impl EventHandler for ReentrantHandler {
    fn handle_collision_event(
        &self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        event: &CollisionEvent,
        pair: Option<&ContactPair>,
    ) {
        self.inner.handle_collision_event(bodies, colliders, event, pair);
        let living = [event.collider1(), event.collider2()].map(|handle| colliders.get(handle));
        for collider in living.into_iter().flatten() {
            let down = Ray::new(collider.translation() + Vector::Y * 9.0, -Vector::Y);
            assert!(collider.shape().intersects_ray(collider.position(), &down, 20.0));
        }
        if self.calls.fetch_add(1, Relaxed) < 2 {
            let mut other = scene();
            other.collider().set_active_events(ActiveEvents::all());
            let (left, right) = rayon::join(
                || other.world.step_with_events(&Hooks::default(), self),
                || colliders.len(),
            );
            let ((), count) = (left, right);
            assert!(count > 0);
        }
    }
}

#[test]
fn handlers_may_call_the_engine() {
    let (send_collision, collisions) = std::sync::mpsc::channel();
    let (send_force, _forces) = std::sync::mpsc::channel();
    let inner = ChannelEventCollector::new(send_collision, send_force);
    let handler = ReentrantHandler { calls: AtomicUsize::new(0), inner };
    let mut scene = scene();
    let (body, _) = scene.world.insert(
        RigidBodyBuilder::dynamic().translation(vec(0.0, 3.6)),
        cuboid(0.5, 0.5).active_events(ActiveEvents::all()),
    );
    for _ in 0..30 {
        scene.world.step_with_events(&Hooks::default(), &handler);
        check(&scene.world);
    }
    scene.world.remove_body(body);
    scene.world.step_with_events(&Hooks::default(), &handler);
    let calls = handler.calls.into_inner();
    drop(handler.inner);
    assert!(calls >= 2, "{calls} calls");
    assert_eq!(collisions.try_iter().count(), calls);
}

/// No body passes a plate because a hook panics during the search of its path.
#[test]
fn no_body_passes_while_a_hook_panics() {
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

/// A hook may use the pool of the step, step another world, and query the world in the step.
#[test]
fn hooks_may_use_threads() {
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
        scene.distant_in_the_end()
    };
    let expected = run(&Hooks::default());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool");
    assert_eq!(pool.install(|| run(&hooks)), expected);
}
