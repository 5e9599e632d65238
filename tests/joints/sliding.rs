//! Prismatic joints, their limits, and fixed joints.

use super::stage::{bob, post};
use crate::dim::{about_z, angle, cuboid, vec};
use crate::suite::physics::stage::{G, RATES, Sample, run, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

#[test]
fn sliders_fall_along_their_axis_as_on_a_smooth_slope() {
    for rate in RATES {
        let mut world = world(rate);
        let post = post(&mut world, Vector::ZERO);
        let load = world.insert_body(bob(1.0, 0.2));
        let axis = vec(0.6, -0.8);
        world.insert_impulse_joint(post, load, PrismaticJointBuilder::new(axis));
        run(&mut world, 1.0);
        let (at, h) = (world.bodies[load].translation(), world.integration_parameters.substep());
        // The acceleration is g sin θ, with the step's time t (t + h) / 2.
        let exact = 0.8 * G * 0.5 * (1.0 + h);
        assert!((at - axis * exact).length() < 2.0e-3, "{at} at {rate} Hz instead of {exact}");
        assert!(angle(world.bodies[load].rotation()).abs() < 1.0e-4);
    }
}

#[test]
fn sliders_on_a_turning_body_follow_it() {
    let mut world = crate::suite::physics::stage::weightless(60);
    let arm = RigidBodyBuilder::kinematic_velocity_based().angvel(about_z(2.0));
    let arm = world.insert_body(arm);
    let load = world.insert_body(bob(1.0, 0.2).translation(vec(0.5, 0.0)).linvel(vec(0.0, 1.0)));
    world.insert_impulse_joint(arm, load, PrismaticJointBuilder::new(Vector::X));
    run(&mut world, 1.0);
    // r'' = ω² r from rest on the arm: r = r₀ cosh(ω t).
    let exact = 0.5 * Real::cosh(2.0);
    let at = world.bodies[load].translation();
    assert!((at.length() / exact - 1.0).abs() < 0.03, "{at} instead of {exact}");
    let along = at.y.atan2(at.x);
    let turned = angle(world.bodies[arm].rotation());
    assert!((along - turned).abs() < 1.0e-2, "{along} beside {turned}");
}

#[test]
fn fixed_joints_keep_bodies_together() {
    for rate in RATES {
        let mut world = world(rate);
        let mut last = post(&mut world, Vector::ZERO);
        for k in 0..5_u8 {
            let at = vec(0.5 + Real::from(k), 0.0);
            let (plank, _) = world
                .insert(RigidBodyBuilder::dynamic().translation(at), cuboid(0.5, 0.1).density(1.0));
            let anchor = if k == 0 { Vector::ZERO } else { vec(0.5, 0.0) };
            let joint = FixedJointBuilder::new()
                .local_anchor1(anchor)
                .local_anchor2(vec(-0.5, 0.0))
                .contacts_enabled(false);
            world.insert_impulse_joint(last, plank, joint);
            last = plank;
        }
        run(&mut world, 3.0);
        let (tip, bend) = (world.bodies[last].translation(), angle(world.bodies[last].rotation()));
        println!("cantilever of 5 planks at {rate} Hz: sags {}, bends {bend}", -tip.y);
        assert!(tip.y > -0.02 && bend.abs() < 0.01, "{tip} at {rate} Hz");
    }
}

/// Number of sections of a telescope, and the travel of each relative to the one before.
const SECTIONS: usize = 5;
const TRAVEL: Real = 0.5;

/// Adds a telescope on a post: sections of mass 1 that slide in each other along `axis` from 0 to [`TRAVEL`].
/// They start at `out`, with a load at the middle of the last section.
fn telescope(
    world: &mut PhysicsWorld,
    axis: Vector,
    out: Real,
    load: Real,
) -> Vec<RigidBodyHandle> {
    let mut last = post(world, Vector::ZERO);
    let mut sections = Vec::new();
    for k in 1..=SECTIONS {
        let mass = if k == SECTIONS { 1.0 + load } else { 1.0 };
        let section = world.insert_body(bob(mass, 0.3).translation(axis * (out * k as Real)));
        let joint = PrismaticJointBuilder::new(axis).limits([0.0, TRAVEL]);
        world.insert_impulse_joint(last, section, joint);
        sections.push(section);
        last = section;
    }
    sections
}

/// Returns the largest error of a section along the axis, for a telescope at `out`, and the largest distance
/// of a section from the axis.
fn off(world: &PhysicsWorld, sections: &[RigidBodyHandle], axis: Vector, out: Real) -> [Real; 2] {
    let [mut along, mut beside]: [Real; 2] = [0.0; 2];
    for (k, &section) in (1..).zip(sections) {
        let at = world.bodies[section].translation();
        let way = at.dot(axis);
        along = along.max((way / k as Real - out).abs());
        beside = beside.max((at - axis * way).length());
    }
    [along, beside]
}

/// Telescopes hang, stand and lie, with and without a load. Every section stops at its limit, and
/// none sags.
#[test]
fn telescopes_stop_at_their_limits_and_do_not_sag() {
    let columns = ["rate", "axis", "load", "off per section (m)", "sag (m)"];
    let mut table = Table::new("a telescope of five sections", &columns);
    let mut sample = Sample::one_of(3);
    // Start positions, and expected rest positions.
    let ways = [
        (vec(0.0, -1.0), 0.1, TRAVEL),
        (vec(0.0, 1.0), 0.1, 0.0),
        (vec(0.6, -0.8), 0.1, TRAVEL),
        (vec(1.0, 0.0), TRAVEL, TRAVEL),
    ];
    for rate in RATES {
        for (axis, from, to) in ways {
            for load in [0.0, 10.0] {
                if !sample.has_next() {
                    continue;
                }
                let mut world = world(rate);
                let sections = telescope(&mut world, axis, from, load);
                run(&mut world, 10.0);
                let [mut along, mut beside]: [Real; 2] = [0.0; 2];
                for _ in 0..rate {
                    world.step();
                    let off = off(&world, &sections, axis, to);
                    (along, beside) = (along.max(off[0]), beside.max(off[1]));
                }
                table.row([
                    rate.to_string(),
                    format!("{axis}"),
                    load.to_string(),
                    format!("{along:e}"),
                    format!("{beside:e}"),
                ]);
                table.check("a section", along, 0.0, 5.0e-4);
                table.check("the sag", beside, 0.0, 1.0e-4);
            }
        }
    }
}

#[test]
fn soft_joints_yield_like_springs() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let load = world.insert_body(bob(3.0, 0.2));
    let softness = SpringCoefficients::new(2.0, 1.0);
    let joint = FixedJointBuilder::new().softness(Some(softness));
    world.insert_impulse_joint(post, load, joint);
    run(&mut world, 5.0);
    // A spring with the angular frequency ω yields by g / ω² under its mass.
    let exact = G / (softness.angular_frequency() * softness.angular_frequency());
    let found = -world.bodies[load].translation().y;
    assert!((found / exact - 1.0).abs() < 0.02, "{found} instead of {exact}");
}
