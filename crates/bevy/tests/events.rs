//! Events of contacts and sensors.

use crate::dim::{cube, floor, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::prelude::*;

#[derive(Resource, Default)]
struct Received {
    started: Vec<CollisionStarted>,
    stopped: Vec<CollisionStopped>,
    forces: Vec<ContactForce>,
}

fn recording(mut app: App) -> App {
    app.init_resource::<Received>()
        .add_observer(|on: On<CollisionStarted>, mut received: ResMut<Received>| {
            received.started.push(*on)
        })
        .add_observer(|on: On<CollisionStopped>, mut received: ResMut<Received>| {
            received.stopped.push(*on)
        })
        .add_observer(|on: On<ContactForce>, mut received: ResMut<Received>| {
            received.forces.push(*on)
        });
    app
}

fn received(app: &App) -> &Received {
    app.world().resource()
}

#[test]
fn a_contact_starts_and_stops_once_on_each_entity() {
    let mut app = recording(app());
    let ground = app.world_mut().spawn((floor(), at(0.0, -1.0))).id();
    let bundle = (RigidBody::Dynamic, cube(0.5), CollisionEvents, at(0.0, 1.0));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 128);
    let started: Vec<_> =
        received(&app).started.iter().map(|event| (event.entity, event.other)).collect();
    assert_eq!(started.len(), 2);
    assert!(started.contains(&(ground, body)) && started.contains(&(body, ground)));
    assert!(received(&app).started.iter().all(|event| !event.is_sensor));
    assert!(received(&app).stopped.is_empty());
    edit::<Transform>(&mut app, body).translation.y = 10.0;
    run(&mut app, 2);
    assert_eq!(received(&app).started.len(), 2);
    assert_eq!(received(&app).stopped.len(), 2);
    assert!(received(&app).stopped.iter().all(|event| !event.is_removed));
}

#[test]
fn observers_of_one_entity_receive_its_events_only() {
    #[derive(Component, Default)]
    struct Hits(usize);
    let mut app = app();
    app.world_mut().spawn((floor(), at(0.0, -1.0)));
    let count = |on: On<CollisionStarted>, mut hits: Query<&mut Hits>| {
        if let Ok(mut hits) = hits.get_mut(on.entity) {
            hits.0 += 1;
        }
    };
    let bundle = |x| (RigidBody::Dynamic, cube(0.5), CollisionEvents, Hits::default(), at(x, 1.0));
    let observed = app.world_mut().spawn(bundle(-3.0)).observe(count).id();
    let other = app.world_mut().spawn(bundle(3.0)).id();
    run(&mut app, 64);
    assert_eq!(get::<Hits>(&app, observed).0, 1);
    assert_eq!(get::<Hits>(&app, other).0, 0);
}

#[test]
fn a_despawned_collider_ends_its_contacts() {
    let mut app = recording(app());
    let ground = app.world_mut().spawn((floor(), at(0.0, -1.0))).id();
    let bundle = (RigidBody::Dynamic, cube(0.5), CollisionEvents, at(0.0, 0.5));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 8);
    app.world_mut().entity_mut(body).despawn();
    run(&mut app, 8);
    let stopped: Vec<_> =
        received(&app).stopped.iter().map(|event| (event.entity, event.other)).collect();
    assert_eq!(stopped.len(), 2);
    assert!(stopped.contains(&(ground, body)) && stopped.contains(&(body, ground)));
    assert!(received(&app).stopped.iter().all(|event| event.is_removed));
}

#[test]
fn a_sensor_reports_passing_bodies_and_exerts_no_force() {
    let mut app = recording(app());
    let gate = app.world_mut().spawn((cube(1.0), Sensor, CollisionEvents)).id();
    let ball = app.world_mut().spawn((RigidBody::Dynamic, Collider::ball(0.2), at(0.0, 3.0))).id();
    run(&mut app, 96);
    assert_eq!(received(&app).started.len(), 2);
    assert_eq!(received(&app).stopped.len(), 2);
    assert!(received(&app).started.iter().all(|event| event.is_sensor));
    assert_near(get::<Velocity>(&app, ball).linear.y, -1.5 * G, 1.0e-4);
    // A sensor that becomes solid stops the next ball.
    app.world_mut().entity_mut(gate).remove::<Sensor>();
    edit::<Transform>(&mut app, ball).translation.y = 3.0;
    edit::<Velocity>(&mut app, ball).linear = Vector::ZERO;
    run(&mut app, 128);
    assert_near(position(&app, ball).y, 1.2, 0.01);
}

#[test]
fn the_contact_force_of_a_body_at_rest_is_its_weight() {
    let mut app = recording(app());
    let ground = app.world_mut().spawn((floor(), at(0.0, -1.0))).id();
    let events = ContactForceEvents { threshold: 10.0 };
    let bundle = (RigidBody::Dynamic, cube(0.5), ColliderMass::Mass(2.0), events, at(0.0, 0.5));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 32);
    app.world_mut().resource_mut::<Received>().forces.clear();
    app.update();
    let forces = received(&app).forces.clone();
    assert_eq!(forces.len(), 2);
    for (entity, sign) in [(body, 1.0), (ground, -1.0)] {
        let event = forces.iter().find(|event| event.entity == entity).expect("an event of each");
        assert_near(event.total_force.y, sign * 2.0 * G, 0.2);
        assert!(!event.is_started);
    }
    // Below the threshold there is no event.
    edit::<ContactForceEvents>(&mut app, body).threshold = 30.0;
    app.world_mut().resource_mut::<Received>().forces.clear();
    run(&mut app, 4);
    assert!(received(&app).forces.is_empty());
}

#[test]
fn without_the_marker_no_contact_starts_an_event() {
    let mut app = recording(app());
    app.world_mut().spawn((floor(), at(0.0, -1.0)));
    let bundle = (RigidBody::Dynamic, cube(0.5), CollisionEvents, at(0.0, 0.6));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 32);
    assert_eq!(received(&app).started.len(), 2);
    app.world_mut().entity_mut(body).remove::<CollisionEvents>();
    run(&mut app, 2);
    edit::<Velocity>(&mut app, body).linear = vector(0.0, 2.0);
    run(&mut app, 64);
    // The contact that had started stops; the next one is silent.
    assert_near(position(&app, body).y, 0.5, 0.01);
    assert_eq!((received(&app).started.len(), received(&app).stopped.len()), (2, 2));
}

#[test]
fn an_event_propagates_to_the_body_on_request() {
    #[derive(Resource, Default)]
    struct Targets(Vec<Entity>);
    let mut app = app();
    app.init_resource::<Targets>();
    app.add_observer(|mut on: On<CollisionStarted>, mut targets: ResMut<Targets>| {
        targets.0.push(on.entity);
        on.propagate(true);
    });
    let ground = app.world_mut().spawn((floor(), at(0.0, -1.0))).id();
    let body = app.world_mut().spawn((RigidBody::Dynamic, at(0.0, 0.6))).id();
    let part = app.world_mut().spawn((cube(0.5), CollisionEvents, ChildOf(body))).id();
    run(&mut app, 32);
    let targets = &app.world().resource::<Targets>().0;
    assert_eq!(targets.len(), 3);
    assert!([ground, body, part].iter().all(|entity| targets.contains(entity)));
}

#[test]
fn a_despawn_between_step_and_report_ends_the_contact() {
    let mut app = recording(app());
    let ground = app.world_mut().spawn((floor(), at(0.0, -1.0))).id();
    let bundle = (RigidBody::Dynamic, cube(0.5), CollisionEvents, at(0.0, 0.5));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 8);
    let remove = move |mut commands: Commands| commands.entity(body).try_despawn();
    let after_step = remove.after(PhysicsSystems::Step).before(PhysicsSystems::Report);
    app.add_systems(FixedPostUpdate, after_step);
    run(&mut app, 4);
    let stopped = &received(&app).stopped;
    assert_eq!(stopped.iter().filter(|event| event.entity == ground).count(), 1);
}
