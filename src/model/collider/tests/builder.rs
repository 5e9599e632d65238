//! Results and refusals of the builder.

use super::{NOT_COORDINATES, NOT_LENGTHS};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::{
    ActiveCollisionTypes, ActiveEvents, ActiveHooks, CoefficientCombineRule, Collider,
    ColliderBuilder, ColliderMassProps, Group, InteractionGroups, InvalidCollider,
};
use parry::mass_properties::MassProperties;
use parry::shape::{Ball, SharedShape};

#[test]
fn defaults_are_as_documented() {
    let collider = ColliderBuilder::ball(0.5).build();
    assert_eq!(collider.friction(), 0.5);
    assert_eq!(collider.restitution(), 0.0);
    assert_eq!(collider.density(), 1.0);
    assert_eq!(collider.contact_skin(), 0.0);
    assert_eq!(collider.friction_combine_rule(), CoefficientCombineRule::Average);
    assert_eq!(collider.collision_groups(), InteractionGroups::all());
    assert_eq!(collider.active_collision_types(), ActiveCollisionTypes::default());
    assert_eq!(collider.active_events(), ActiveEvents::empty());
    assert_eq!(collider.user_data(), 0);
    assert!(collider.is_enabled() && !collider.is_sensor() && collider.parent().is_none());
}

#[test]
fn everything_that_is_set_arrives() {
    let groups = InteractionGroups::new(Group::GROUP_1, Group::GROUP_2);
    let collider = ColliderBuilder::ball(0.5)
        .user_data(123)
        .collision_groups(groups)
        .solver_groups(InteractionGroups::none())
        .sensor(true)
        .active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS)
        .active_events(ActiveEvents::COLLISION_EVENTS)
        .active_collision_types(ActiveCollisionTypes::all())
        .friction(0.7)
        .friction_combine_rule(CoefficientCombineRule::Max)
        .restitution(0.3)
        .restitution_combine_rule(CoefficientCombineRule::Min)
        .mass(4.0)
        .contact_force_event_threshold(Real::INFINITY)
        .translation(Vector::X * 2.0)
        .contact_skin(0.01)
        .enabled(false)
        .build();
    assert_eq!(collider.user_data, 123);
    assert_eq!(collider.collision_groups(), groups);
    assert_eq!(collider.solver_groups(), InteractionGroups::none());
    assert_eq!(collider.active_hooks(), ActiveHooks::MODIFY_SOLVER_CONTACTS);
    assert_eq!(collider.active_events(), ActiveEvents::COLLISION_EVENTS);
    assert_eq!(collider.active_collision_types(), ActiveCollisionTypes::all());
    assert_eq!((collider.friction(), collider.restitution()), (0.7, 0.3));
    assert_eq!(collider.material().friction_combine_rule, CoefficientCombineRule::Max);
    assert_eq!(collider.restitution_combine_rule(), CoefficientCombineRule::Min);
    assert_eq!(collider.mass(), 4.0);
    assert_eq!(collider.contact_force_event_threshold(), Real::INFINITY);
    assert_eq!(collider.translation(), Vector::X * 2.0);
    assert_eq!(collider.contact_skin(), 0.01);
    assert!(collider.is_sensor() && !collider.is_enabled());
}

/// Building must report the parameter, and `build` must give a collider that does nothing.
#[track_caller]
fn assert_refused(builder: &ColliderBuilder, parameter: &str) {
    let reason = builder.try_build().map(|_| ()).expect_err("nothing was refused");
    assert!(reason.to_string().contains(parameter), "{reason} does not name {parameter}");
    let stand_in = builder.clone().user_data(7).build();
    assert!(!stand_in.is_enabled());
    assert_eq!((stand_in.mass(), stand_in.user_data), (0.0, 7));
    let aabb = stand_in.compute_aabb();
    assert!(aabb.mins.is_finite() && aabb.maxs.is_finite());
}

#[test]
fn numbers_out_of_range_are_refused_by_name() {
    let ball = || ColliderBuilder::ball(0.5);
    for bad in NOT_LENGTHS {
        if bad != 0.0 {
            assert_refused(&ColliderBuilder::ball(bad), "radius");
            assert_refused(&ball().friction(bad), "friction");
            assert_refused(&ball().restitution(bad), "restitution");
            assert_refused(&ball().density(bad), "density");
            assert_refused(&ball().mass(bad), "mass");
            assert_refused(&ball().contact_skin(bad), "contact_skin");
        }
    }
    for bad in [Real::NAN, -1.0] {
        let builder = ball().contact_force_event_threshold(bad);
        assert_refused(&builder, "contact_force_event_threshold");
        let properties = MassProperties { inv_mass: bad, ..MassProperties::from_ball(1.0, 1.0) };
        assert_refused(&ball().mass_properties(properties), "mass_properties");
    }
    for bad in NOT_COORDINATES {
        assert_refused(&ball().translation(Vector::X * bad), "pose");
    }
}

#[test]
fn a_shape_put_into_the_builder_by_hand_is_checked_as_well() {
    let mut builder = ColliderBuilder::new(SharedShape::new(Ball::new(Real::NAN)));
    assert_refused(&builder, "radius");
    builder.shape = SharedShape::ball(1.0);
    assert!(builder.try_build().is_ok());
    builder.mass_properties = ColliderMassProps::Density(-1.0);
    assert_refused(&builder, "density");
}

#[test]
fn the_value_is_in_the_error() {
    let reason = ColliderBuilder::ball(-2.5).try_build().expect_err("a negative radius");
    assert!(
        matches!(reason, InvalidCollider::Number { parameter: "radius", value, .. } if value == -2.5)
    );
    assert!(reason.to_string().contains("-2.5"), "{reason}");
}

#[test]
fn a_builder_converts_into_a_collider() {
    let collider: Collider = ColliderBuilder::ball(2.0).position(Pose::IDENTITY).into();
    assert_eq!(collider.shape().as_ball().map(|ball| ball.radius), Some(2.0));
}
