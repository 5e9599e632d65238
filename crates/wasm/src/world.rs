//! Worlds: creation, steps, parameters and the hash.

use crate::events::fill;
use crate::fault::{Fault, finite, non_negative};
use crate::hooks::Hooks;
use crate::memory;
use crate::rapier::dynamics::{IntegrationParameters, SpringCoefficients};
use crate::rapier::math::Real;
use crate::rapier::pipeline::PhysicsWorld;
use crate::registry::{free_world, insert_world, read, stepped, write};
use crate::threads;

/// Parameters, in the order of `Parameter` in TypeScript.
mod parameter {
    pub const DT: u32 = 0;
    pub const SOLVER_ITERATIONS: u32 = 1;
    pub const PGS_ITERATIONS: u32 = 2;
    pub const CCD_SUBSTEPS: u32 = 3;
    pub const LENGTH_UNIT: u32 = 4;
    pub const CONTACT_ERP: u32 = 5;
    pub const ALLOWED_LINEAR_ERROR: u32 = 6;
    pub const PREDICTION_DISTANCE: u32 = 7;
    pub const CONTACT_FREQUENCY: u32 = 8;
    pub const CONTACT_DAMPING_RATIO: u32 = 9;
}

fn parameter_of(parameters: &IntegrationParameters, number: u32) -> f64 {
    match number {
        parameter::DT => parameters.dt.into(),
        parameter::SOLVER_ITERATIONS => parameters.num_solver_iterations as f64,
        parameter::PGS_ITERATIONS => parameters.num_internal_pgs_iterations as f64,
        parameter::CCD_SUBSTEPS => parameters.max_ccd_substeps as f64,
        parameter::LENGTH_UNIT => parameters.length_unit.into(),
        parameter::CONTACT_ERP => parameters.erp.into(),
        parameter::ALLOWED_LINEAR_ERROR => parameters.allowed_linear_error.into(),
        parameter::PREDICTION_DISTANCE => parameters.normalized_prediction_distance.into(),
        _ => parameters.damping_ratio.into(),
    }
}

fn change_parameter(
    parameters: &mut IntegrationParameters,
    number: u32,
    value: f64,
) -> Result<(), Fault> {
    let (real, count) = (non_negative("the parameter", value)? as Real, value as usize);
    let mut changed = *parameters;
    match number {
        parameter::DT => changed.dt = real,
        parameter::SOLVER_ITERATIONS => changed.num_solver_iterations = count,
        parameter::PGS_ITERATIONS => changed.num_internal_pgs_iterations = count,
        parameter::CCD_SUBSTEPS => changed.max_ccd_substeps = count,
        parameter::LENGTH_UNIT => changed.length_unit = real,
        parameter::CONTACT_ERP => changed.erp = real,
        parameter::ALLOWED_LINEAR_ERROR => changed.allowed_linear_error = real,
        parameter::PREDICTION_DISTANCE => changed.normalized_prediction_distance = real,
        parameter::CONTACT_FREQUENCY => {
            changed.erp = SpringCoefficients::new(real, changed.damping_ratio).erp(changed.dt);
        }
        parameter::CONTACT_DAMPING_RATIO => changed.damping_ratio = real,
        _ => return Err(Fault::number("the parameter", number.into(), "a Parameter")),
    }
    changed.validate().map_err(Fault::invalid)?;
    *parameters = changed;
    Ok(())
}

/// Stages with measured times, in the order of `Timing` in TypeScript.
fn timings(world: &PhysicsWorld) -> [f64; 13] {
    let counters = &world.physics_pipeline.counters;
    let milliseconds = |timer: &crate::rapier::pipeline::Timer| timer.time_ms();
    [
        counters.step_time_ms(),
        counters.collision_detection_time_ms(),
        counters.broad_phase_time_ms(),
        counters.narrow_phase_time_ms(),
        counters.solver_time_ms(),
        milliseconds(&counters.solver.velocity_assembly_time),
        milliseconds(&counters.solver.velocity_resolution_time),
        counters.update_time_ms(),
        milliseconds(&counters.solver.velocity_writeback_time),
        counters.ccd_time_ms(),
        milliseconds(&counters.ccd.toi_computation_time),
        counters.island_construction_time_ms(),
        counters.user_changes_time_ms(),
    ]
}

exports! {
    /// Creates a world. Returns its number.
    fn world_new() -> u32 {
        insert_world(PhysicsWorld::new())
    }

    /// Frees a world with all its objects.
    fn world_free(world: u32) {
        free_world(world)?;
    }

    /// Moves the world forward by one time step. The scratch block holds the gravity. A queue of 0 drops
    /// events.
    fn world_step(world: u32, queue_number: u32, hooks: u32) {
        let gravity = memory::vector(0, "gravity")?;
        stepped(world, queue_number, |world, sets, events| {
            world.gravity = gravity;
            threads::choose(world, hooks != 0);
            fill(events, |events| world.step_with_events(&Hooks::new(hooks, sets), events));
        })?;
    }

    /// Updates contacts and intersections, and moves no body.
    fn world_detect_collisions(world: u32, queue_number: u32, hooks: u32) {
        stepped(world, queue_number, |world, sets, events| {
            threads::choose(world, hooks != 0);
            fill(events, |events| world.detect_collisions(&Hooks::new(hooks, sets), events));
        })?;
    }

    /// A hash of the simulated state.
    fn world_hash(world: u32) -> u64 {
        read(world)?.hash()
    }

    /// A parameter of the steps.
    fn world_parameter(world: u32, number: u32) -> f64 {
        parameter_of(&read(world)?.integration_parameters, number)
    }

    /// Changes a parameter of the steps.
    fn world_set_parameter(world: u32, number: u32, value: f64) {
        change_parameter(&mut write(world)?.integration_parameters, number, finite("the parameter", value)?)?;
    }

    /// Returns whether the stages are timed.
    fn world_is_timed(world: u32) -> bool {
        read(world)?.physics_pipeline.counters.enabled()
    }

    /// Switches the timing of stages on or off.
    fn world_set_timed(world: u32, enabled: u32) {
        let counters = &mut write(world)?.physics_pipeline.counters;
        if enabled != 0 { counters.enable() } else { counters.disable() }
    }

    /// Milliseconds of a stage of the last step.
    fn world_timing(world: u32, stage: usize) -> f64 {
        timings(read(world)?).get(stage).copied().unwrap_or(0.0)
    }

    /// Wakes all bodies.
    fn world_wake_all(world: u32) {
        write(world)?.wake_up_all(true);
    }
}
