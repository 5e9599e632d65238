//! Worlds: creation, steps, parameters and the hash.

use crate::events::fill;
use crate::fault::{Fault, non_negative};
use crate::hooks::Hooks;
use crate::memory;
use crate::rapier::dynamics::{CONTACT_ERP_SCALE, IntegrationParameters, SpringCoefficients};
use crate::rapier::math::Real;
use crate::rapier::pipeline::PhysicsWorld;
use crate::registry::{free_world, insert_world, moved, read, stepped, update_queries, write};
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
    pub const ADDITIONAL_FRICTION_ITERATIONS: u32 = 10;

    /// The names in TypeScript.
    pub const NAMES: [&str; 11] = [
        "the timestep dt",
        "numSolverIterations",
        "numInternalPgsIterations",
        "maxCcdSubsteps",
        "lengthUnit",
        "contact_erp",
        "normalizedAllowedLinearError",
        "normalizedPredictionDistance",
        "contact_natural_frequency",
        "contact_damping_ratio",
        "numAdditionalFrictionIterations",
    ];
}

/// The parameters that are whole numbers.
const COUNTS: [u32; 4] = [
    parameter::SOLVER_ITERATIONS,
    parameter::PGS_ITERATIONS,
    parameter::CCD_SUBSTEPS,
    parameter::ADDITIONAL_FRICTION_ITERATIONS,
];

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
        parameter::ADDITIONAL_FRICTION_ITERATIONS => {
            parameters.num_additional_friction_iterations as f64
        }
        parameter::CONTACT_DAMPING_RATIO => parameters.damping_ratio.into(),
        _ => f64::NAN,
    }
}

/// The fraction of a contact's error that a substep removes, for the frequency of a spring (1/s) with the
/// damping of the published packages. Their default frequency selects the engine's default.
fn erp_of_spring(frequency: Real, substep: Real) -> Real {
    let published = SpringCoefficients::contact_defaults();
    if frequency == published.natural_frequency {
        return IntegrationParameters::default().erp;
    }
    let fraction = SpringCoefficients::new(frequency, published.damping_ratio).erp(substep);
    (fraction / CONTACT_ERP_SCALE).min(1.0)
}

fn change_parameter(
    parameters: &mut IntegrationParameters,
    number: u32,
    value: f64,
) -> Result<(), Fault> {
    let Some(&name) = parameter::NAMES.get(number as usize) else {
        return Err(Fault::number("the parameter", number.into(), "a Parameter"));
    };
    let (real, count) = (non_negative(name, value)? as Real, value as usize);
    if COUNTS.contains(&number) && value.fract() != 0.0 {
        return Err(Fault::number(name, value, "a whole number"));
    }
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
            changed.erp = erp_of_spring(real, changed.substep());
        }
        parameter::ADDITIONAL_FRICTION_ITERATIONS => {
            changed.num_additional_friction_iterations = count;
        }
        _ => changed.damping_ratio = real,
    }
    changed.validate().map_err(|error| Fault::number(name, value, error.expected))?;
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

    /// A hash of the simulated state, the same before and after queries.
    fn world_hash(world: u32) -> u64 {
        moved(world)?.hash()
    }

    /// A parameter of the steps.
    fn world_parameter(world: u32, number: u32) -> f64 {
        parameter_of(&read(world)?.integration_parameters, number)
    }

    /// Changes a parameter of the steps.
    fn world_set_parameter(world: u32, number: u32, value: f64) {
        change_parameter(&mut write(world)?.integration_parameters, number, value)?;
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

    /// Updates the trees of queries. Queries do it, too.
    fn world_update_queries(world: u32) {
        update_queries(world)?;
    }

    /// Wakes all bodies.
    fn world_wake_all(world: u32) {
        write(world)?.wake_up_all(true);
    }
}
