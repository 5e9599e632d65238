//! Hooks of a user's system parameter.

use crate::dim::{cube, floor, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;

/// Passes through everything of another colour.
#[derive(Component, PartialEq)]
struct Colour(u8);

#[derive(Resource, Default)]
struct Belt(Vector);

#[derive(SystemParam)]
struct Rules<'w, 's> {
    colours: Query<'w, 's, &'static Colour>,
    belt: Res<'w, Belt>,
}

impl Rules<'_, '_> {
    fn are_alike(&self, pair: &ContactPair) -> bool {
        match self.colours.get_many([pair.collider1, pair.collider2]) {
            Ok([first, second]) => first == second,
            Err(_) => true,
        }
    }
}

impl CollisionHooks for Rules<'_, '_> {
    fn filter_contacts(&self, pair: &ContactPair) -> bool {
        self.are_alike(pair)
    }

    fn filter_intersection(&self, pair: &ContactPair) -> bool {
        self.are_alike(pair)
    }

    fn modify_contacts(&self, _: &ContactPair, contacts: &mut ModifiedContacts<'_, '_>) {
        contacts.set_tangent_velocity(self.belt.0);
    }
}

fn hooked() -> App {
    let plugin = PhysicsPlugin::default().with_hooks::<Rules>().without_interpolation();
    let mut app = App::new();
    app.init_resource::<Belt>();
    app.add_plugins((MinimalPlugins, TransformPlugin, plugin));
    frame_length(&mut app, 1.0);
    app.update();
    app
}

#[test]
fn a_filter_lets_pairs_pass() {
    let mut app = hooked();
    let filter = HookedPairs(ActiveHooks::FILTER_CONTACT_PAIRS);
    app.world_mut().spawn((floor(), filter, Colour(1), at(0.0, -1.0)));
    let ball = |x| (RigidBody::Dynamic, Collider::ball(0.5), at(x, 1.0));
    let same = app.world_mut().spawn((ball(-3.0), Colour(1))).id();
    let other = app.world_mut().spawn((ball(3.0), Colour(2))).id();
    run(&mut app, 64 * 2);
    assert_near(position(&app, same).y, 0.5, 0.01);
    assert!(position(&app, other).y < -10.0);
}

#[test]
fn pairs_without_the_component_skip_the_hooks() {
    let mut app = hooked();
    app.world_mut().spawn((floor(), Colour(1), at(0.0, -1.0)));
    let bundle = (RigidBody::Dynamic, Collider::ball(0.5), Colour(2), at(0.0, 1.0));
    let ball = app.world_mut().spawn(bundle).id();
    run(&mut app, 64 * 2);
    assert_near(position(&app, ball).y, 0.5, 0.01);
}

#[test]
fn a_filter_of_sensors_hides_intersections() {
    #[derive(Resource, Default)]
    struct Seen(Vec<Entity>);
    let mut app = hooked();
    app.init_resource::<Seen>();
    app.add_observer(|on: On<CollisionStarted>, mut seen: ResMut<Seen>| seen.0.push(on.other));
    let filter = HookedPairs(ActiveHooks::FILTER_INTERSECTION_PAIR);
    let gate = app.world_mut().spawn((cube(1.0), Sensor, CollisionEvents, filter, Colour(1))).id();
    let part = |x| (RigidBody::Dynamic, Collider::ball(0.2), GravityScale(0.0), at(x, 0.0));
    let seen = app.world_mut().spawn((part(-0.5), Colour(1))).id();
    app.world_mut().spawn((part(0.5), Colour(2)));
    run(&mut app, 4);
    let mut found = app.world().resource::<Seen>().0.clone();
    found.retain(|entity| *entity != gate);
    assert_eq!(found, [seen]);
}

#[test]
fn a_modified_contact_moves_a_box_like_a_conveyor_belt() {
    let mut app = hooked();
    let modify = HookedPairs(ActiveHooks::MODIFY_SOLVER_CONTACTS);
    app.world_mut().spawn((floor(), modify, at(0.0, -1.0)));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 0.5))).id();
    run(&mut app, 32);
    assert_near(position(&app, body).x, 0.0, 0.01);
    app.world_mut().resource_mut::<Belt>().0 = vector(2.0, 0.0);
    edit::<Velocity>(&mut app, body).linear = vector(0.0, 0.0);
    run(&mut app, 64);
    assert_near(get::<Velocity>(&app, body).linear.x.abs(), 2.0, 0.05);
}
