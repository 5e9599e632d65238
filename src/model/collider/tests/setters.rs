//! Setters: their notes for the next step, and the refused values.

use super::{NOT_COORDINATES, NOT_LENGTHS};
use crate::dim::math::{ANG_ZERO, Pose, Real, Rotation, Vector, torque};
use crate::model::body::{RigidBodyBuilder, RigidBodySet};
use crate::model::collider::{
    ActiveCollisionTypes, ActiveEvents, ActiveHooks, CoefficientCombineRule, Collider,
    ColliderBuilder, ColliderChanges as Changes, ColliderEnabled, ColliderSet, InteractionGroups,
};
use parry::mass_properties::MassProperties;
use parry::shape::SharedShape;

/// A collider whose changes have been applied.
fn settled() -> Collider {
    let mut collider = ColliderBuilder::ball(0.5).build();
    collider.changes = Changes::empty();
    collider
}

/// An attached collider whose changes have been applied.
fn attached() -> Collider {
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    let body = bodies.insert(RigidBodyBuilder::dynamic().translation(Vector::Y));
    let handle = colliders.insert_with_parent(
        ColliderBuilder::ball(0.5).translation(Vector::X),
        body,
        &mut bodies,
    );
    let mut collider = colliders[handle].clone();
    collider.changes = Changes::empty();
    collider
}

#[test]
fn each_setter_notes_what_it_changed() {
    type Setter = fn(&mut Collider);
    let table: [(Setter, Changes); 17] = [
        (|c| c.set_position(Pose::from_translation(Vector::X)), Changes::POSITION),
        (|c| c.set_translation(Vector::X), Changes::POSITION),
        (|c| c.set_rotation(quarter_turn()), Changes::POSITION),
        (|c| c.set_enabled(false), Changes::ENABLED_OR_DISABLED | Changes::LOCAL_MASS_PROPERTIES),
        (|c| c.set_sensor(true), Changes::TYPE),
        (|c| c.set_collision_groups(InteractionGroups::none()), Changes::GROUPS),
        (|c| c.set_solver_groups(InteractionGroups::none()), Changes::GROUPS),
        (|c| c.set_active_collision_types(ActiveCollisionTypes::all()), Changes::INTERACTIONS),
        (|c| c.set_active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS), Changes::HOOKS),
        (|c| c.set_active_events(ActiveEvents::COLLISION_EVENTS), Changes::EVENTS),
        (|c| c.set_friction(0.1), Changes::MATERIAL),
        (|c| c.set_restitution(0.1), Changes::MATERIAL),
        (|c| c.set_friction_combine_rule(CoefficientCombineRule::Max), Changes::MATERIAL),
        (|c| c.set_contact_skin(0.1), Changes::SHAPE),
        (|c| c.set_shape(SharedShape::ball(1.0)), Changes::SHAPE | Changes::LOCAL_MASS_PROPERTIES),
        (|c| c.set_density(2.0), Changes::LOCAL_MASS_PROPERTIES),
        (|c| c.set_mass(2.0), Changes::LOCAL_MASS_PROPERTIES),
    ];
    for (row, (setter, expected)) in table.into_iter().enumerate() {
        let mut collider = settled();
        setter(&mut collider);
        assert_eq!(collider.changes, expected, "row {row}");
    }
}

#[test]
fn setting_the_same_again_notes_nothing() {
    let mut collider = settled();
    collider.set_enabled(true);
    collider.set_sensor(false);
    collider.set_collision_groups(collider.collision_groups());
    collider.set_solver_groups(collider.solver_groups());
    collider.set_active_hooks(collider.active_hooks());
    collider.set_active_events(collider.active_events());
    collider.set_active_collision_types(collider.active_collision_types());
    collider.set_density(1.0);
    collider.set_friction(0.5);
    collider.set_restitution(0.0);
    collider.set_contact_skin(0.0);
    collider.set_shape(SharedShape::ball(0.5));
    let rotations =
        [quarter_turn(), crate::dim::shapes::tests::scaled_rotation(quarter_turn(), 1.002)];
    for rotation in rotations {
        collider.set_rotation(rotation);
        collider.changes = Changes::empty();
        collider.set_rotation(rotation);
        collider.set_rotation(collider.rotation());
    }
    collider.copy_from(&collider.clone());
    assert_eq!(collider.changes, Changes::empty());
}

/// A rotation by about a quarter turn.
fn quarter_turn() -> Rotation {
    crate::dim::math::rotation_from_angle(torque(Vector::X, Vector::Y))
}

/// Shapes with lists of points are the same only if they are shared, and primitives by their numbers.
#[test]
fn shapes_of_other_numbers_or_lists_are_other_shapes() {
    let corners = [Vector::ZERO, Vector::X, Vector::Y, Vector::ONE];
    let line = || SharedShape::polyline(corners.to_vec(), None);
    let shared = line();
    for (old, new, is_same) in [
        (SharedShape::ball(0.5), SharedShape::ball(0.5), true),
        (SharedShape::ball(0.5), SharedShape::ball(0.6), false),
        (SharedShape::capsule_x(0.5, 0.2), SharedShape::capsule_x(0.5, 0.2), true),
        (SharedShape::capsule_x(0.5, 0.2), SharedShape::capsule_y(0.5, 0.2), false),
        (SharedShape::ball(0.5), SharedShape::capsule_y(0.5, 0.2), false),
        (shared.clone(), shared, true),
        (line(), line(), false),
    ] {
        let mut collider = ColliderBuilder::new(old).build();
        collider.changes = Changes::empty();
        collider.set_shape(new);
        assert_eq!(collider.changes.is_empty(), is_same, "{:?}", collider.shape().shape_type());
    }
}

#[test]
fn values_out_of_range_change_nothing() {
    let mut collider = settled();
    for bad in NOT_LENGTHS {
        if bad != 0.0 {
            collider.set_shape(SharedShape::ball(bad));
            collider.set_friction(bad);
            collider.set_restitution(bad);
            collider.set_contact_skin(bad);
            collider.set_density(bad);
            collider.set_mass(bad);
            let properties = collider.mass_properties();
            collider.set_mass_properties(MassProperties { inv_mass: bad, ..properties });
        }
    }
    for bad in NOT_COORDINATES {
        collider.set_translation(Vector::X * bad);
        collider.set_position(Pose::from_translation(Vector::Y * bad));
    }
    collider.set_contact_force_event_threshold(Real::NAN);
    collider.set_contact_force_event_threshold(-1.0);
    assert_eq!(collider.changes, Changes::empty());
    assert_eq!((collider.friction(), collider.restitution()), (0.5, 0.0));
    assert_eq!((collider.density(), collider.contact_skin()), (1.0, 0.0));
    assert_eq!(collider.contact_force_event_threshold(), 0.0);
    assert_eq!(collider.position(), &Pose::IDENTITY);
    assert_eq!(collider.shape().as_ball().map(|b| b.radius), Some(0.5));
}

#[test]
fn the_place_on_the_body_moves_the_collider_with_it() {
    let mut collider = attached();
    assert_eq!(collider.translation(), Vector::X + Vector::Y);
    collider.set_translation_wrt_parent(Vector::X * 3.0);
    assert!(collider.translation().abs_diff_eq(Vector::X * 3.0 + Vector::Y, 1.0e-5));
    collider.set_rotation_wrt_parent(torque(Vector::X, Vector::Y));
    let place = *collider.position_wrt_parent().expect("it is attached");
    assert_eq!(place.translation, Vector::X * 3.0);
    assert!(collider.changes.contains(Changes::POSITION | Changes::LOCAL_MASS_PROPERTIES));
    collider.set_translation_wrt_parent(Vector::X * Real::NAN);
    assert_eq!(collider.position_wrt_parent(), Some(&place));
    let mut alone = settled();
    alone.set_translation_wrt_parent(Vector::X);
    alone.set_rotation_wrt_parent(ANG_ZERO);
    alone.set_position_wrt_parent(Pose::IDENTITY);
    assert_eq!((alone.position_wrt_parent(), alone.changes), (None, Changes::empty()));
}

#[test]
fn a_rotation_off_unit_length_is_normalised() {
    let mut collider = settled();
    let mut rotation = crate::dim::math::rotation_from_angle(torque(Vector::X, Vector::Y));
    let length_before = rotation.length();
    rotation = crate::dim::shapes::tests::scaled_rotation(rotation, 1.002);
    assert!((rotation.length() - length_before).abs() > 1.0e-3);
    collider.set_rotation(rotation);
    assert!((collider.rotation().length() - 1.0).abs() < 1.0e-6);
}

#[test]
fn a_shape_broken_in_place_is_replaced_and_the_collider_disabled() {
    let shared = SharedShape::ball(1.0);
    let mut collider = ColliderBuilder::new(shared.clone()).build();
    collider.changes = Changes::empty();
    collider.shape_mut().as_ball_mut().expect("a ball").radius = 2.0;
    let expected = Changes::SHAPE | Changes::LOCAL_MASS_PROPERTIES | Changes::UNCHECKED_SHAPE;
    assert_eq!(collider.changes, expected);
    assert_eq!(shared.as_ball().map(|b| b.radius), Some(1.0), "the shared original");
    collider.replace_broken_shape();
    assert!(collider.is_enabled());
    assert_eq!(collider.shape().as_ball().map(|b| b.radius), Some(2.0));
    collider.shape_mut().as_ball_mut().expect("a ball").radius = Real::NAN;
    collider.replace_broken_shape();
    assert!(!collider.is_enabled());
    assert!(collider.compute_aabb().mins.is_finite());
}

#[test]
fn enabling_does_not_override_a_disabled_body() {
    let mut collider = settled();
    collider.flags.enabled = ColliderEnabled::DisabledByParent;
    collider.set_enabled(true);
    assert!(!collider.is_enabled());
    collider.set_enabled(false);
    assert_eq!(collider.flags.enabled, ColliderEnabled::Disabled);
}

#[test]
fn a_copy_keeps_its_own_body_and_notes() {
    let other = ColliderBuilder::ball(2.0).friction(0.9).user_data(5).translation(Vector::Y * 9.0);
    let mut collider = attached();
    collider.changes = Changes::IN_MODIFIED_SET;
    let (parent, pose) = (collider.parent(), *collider.position());
    collider.copy_from(&other.build());
    assert_eq!((collider.parent(), *collider.position()), (parent, pose));
    assert_eq!((collider.friction(), collider.user_data), (0.9, 5));
    assert_eq!(collider.shape().as_ball().map(|b| b.radius), Some(2.0));
    assert!(collider.changes.contains(Changes::IN_MODIFIED_SET | Changes::SHAPE));
    assert!(!collider.changes.contains(Changes::PARENT));
    let mut alone = settled();
    alone.copy_from(&collider);
    assert_eq!((alone.parent(), *alone.position()), (None, pose));
}

#[test]
fn boxes_enclose_skin_prediction_and_motion() {
    let mut collider = settled();
    collider.set_contact_skin(0.25);
    assert_eq!(collider.compute_aabb().maxs, Vector::splat(0.5));
    assert_eq!(collider.compute_collision_aabb(0.25).maxs, Vector::splat(1.0));
    for bad in [-1.0, Real::NAN] {
        assert_eq!(collider.compute_collision_aabb(bad).maxs, Vector::splat(0.75));
    }
    let swept = collider.compute_swept_aabb(&Pose::from_translation(Vector::X * 10.0));
    assert_eq!((swept.mins.x, swept.maxs.x), (-0.5, 10.5));
}
