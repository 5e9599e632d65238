//! Times and counts of a step, with upstream's names.
//!
//! The engine has timers of its own. [`Counters::copy_from_engine`] copies them after a step. Timers of parts
//! that the engine lacks stay zero.

use core::fmt::{Display, Formatter, Result};
use core::time::Duration;

/// A stopwatch.
#[derive(Copy, Clone, Debug)]
pub struct Timer(engine::pipeline::Timer);

impl Default for Timer {
    fn default() -> Self {
        Self::new()
    }
}

impl Timer {
    /// A stopwatch at zero.
    pub fn new() -> Self {
        Self(engine::pipeline::Timer::new(true))
    }

    /// Sets the time to zero.
    pub fn reset(&mut self) {
        self.0.reset();
    }

    /// Sets the time to zero and starts the measurement.
    pub fn start(&mut self) {
        self.0.start();
    }

    /// Ends a measurement.
    pub fn pause(&mut self) {
        self.0.pause();
    }

    /// Starts a measurement that adds to the time.
    pub fn resume(&mut self) {
        self.0.resume();
    }

    /// The measured time.
    pub fn time(&self) -> Duration {
        self.0.time()
    }

    /// The measured time (ms).
    pub fn time_ms(&self) -> f64 {
        self.0.time_ms()
    }
}

impl Display for Timer {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{} ms", self.time_ms())
    }
}

/// Defines a group of counters.
macro_rules! group {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[derive(Copy, Clone, Debug, Default)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $type,)*
        }

        impl $name {
            /// All counters at zero.
            pub fn new() -> Self {
                Self::default()
            }

            /// Sets all counters to zero.
            pub fn reset(&mut self) {
                *self = Self::default();
            }
        }

        impl Display for $name {
            fn fmt(&self, f: &mut Formatter<'_>) -> Result {
                $(writeln!(f, "{}: {}", stringify!($field), self.$field)?;)*
                Ok(())
            }
        }
    };
}

group! {
    /// Times of the stages of a step.
    StagesCounters {
        /// Reaction to the edits of the user.
        user_changes: Timer,
        /// Collision detection.
        collision_detection_time: Timer,
        /// Update of the islands.
        island_construction_time: Timer,
        /// Zero: the engine has no such stage.
        island_constraints_collection_time: Timer,
        /// Solver.
        solver_time: Timer,
        /// Continuous collision detection.
        ccd_time: Timer,
        /// Update of the bodies after the solver.
        update_time: Timer,
    }
}

group! {
    /// Times and counts of collision detection.
    CollisionDetectionCounters {
        /// Number of contact pairs.
        ncontact_pairs: usize,
        /// Broad phase.
        broad_phase_time: Timer,
        /// Zero: the engine has one broad phase.
        final_broad_phase_time: Timer,
        /// Narrow phase.
        narrow_phase_time: Timer,
    }
}

group! {
    /// Times and counts of the solver.
    SolverCounters {
        /// Number of constraints.
        nconstraints: usize,
        /// Number of contacts.
        ncontacts: usize,
        /// Iterations.
        velocity_resolution_time: Timer,
        /// Assembly of the constraints.
        velocity_assembly_time: Timer,
        /// Zero: part of the assembly.
        velocity_assembly_time_solver_bodies: Timer,
        /// Zero: part of the assembly.
        velocity_assembly_time_constraints_init: Timer,
        /// Zero: part of the iterations.
        velocity_update_time: Timer,
        /// Storage of the results.
        velocity_writeback_time: Timer,
    }
}

group! {
    /// Times and counts of continuous collision detection.
    CCDCounters {
        /// Number of searches.
        num_substeps: usize,
        /// Search of times of impact.
        toi_computation_time: Timer,
        /// Zero: the engine's search needs no solver.
        solver_time: Timer,
        /// Zero: part of the search.
        broad_phase_time: Timer,
        /// Zero: part of the search.
        narrow_phase_time: Timer,
    }
}

/// Times and counts of a step.
#[derive(Copy, Clone, Debug)]
pub struct Counters {
    /// Whether a step measures.
    pub enabled: bool,
    /// The whole step.
    pub step_time: Timer,
    /// A stopwatch for the program.
    pub custom: Timer,
    /// Stages of the step.
    pub stages: StagesCounters,
    /// Collision detection.
    pub cd: CollisionDetectionCounters,
    /// Solver.
    pub solver: SolverCounters,
    /// Continuous collision detection.
    pub ccd: CCDCounters,
}

impl Default for Counters {
    fn default() -> Self {
        Self::new(cfg!(feature = "profiler"))
    }
}

impl Display for Counters {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "step: {}\ncustom: {}", self.step_time, self.custom)?;
        write!(f, "{}{}{}{}", self.stages, self.cd, self.solver, self.ccd)
    }
}

/// Defines the functions of a timer: begin, end, time in milliseconds.
macro_rules! timers {
    ($($begin:ident, $end:ident, $time_ms:ident: $($field:ident).+;)*) => {
        impl Counters {
            $(
                #[doc = concat!("Starts a measurement of `", stringify!($($field).+), "`.")]
                pub fn $begin(&mut self) {
                    if self.enabled {
                        self.$($field).+.start();
                    }
                }

                #[doc = concat!("Ends a measurement of `", stringify!($($field).+), "`.")]
                pub fn $end(&mut self) {
                    if self.enabled {
                        self.$($field).+.pause();
                    }
                }

                #[doc = concat!("The time of `", stringify!($($field).+), "` (ms); 0 if disabled.")]
                pub fn $time_ms(&self) -> f64 {
                    if self.enabled { self.$($field).+.time_ms() } else { 0.0 }
                }
            )*
        }
    };
}

timers! {
    step_started, step_completed, step_time_ms: step_time;
    custom_started, custom_completed, custom_time_ms: custom;
    update_started, update_completed, update_time_ms: stages.update_time;
    collision_detection_started, collision_detection_completed, collision_detection_time_ms:
        stages.collision_detection_time;
    island_construction_started, island_construction_completed, island_construction_time_ms:
        stages.island_construction_time;
    solver_started, solver_completed, solver_time_ms: stages.solver_time;
    ccd_started, ccd_completed, ccd_time_ms: stages.ccd_time;
    broad_phase_started, broad_phase_completed, broad_phase_time_ms: cd.broad_phase_time;
    narrow_phase_started, narrow_phase_completed, narrow_phase_time_ms: cd.narrow_phase_time;
    assembly_started, assembly_completed, assembly_time_ms: solver.velocity_assembly_time;
    velocity_resolution_started, velocity_resolution_completed, velocity_resolution_time_ms:
        solver.velocity_resolution_time;
    velocity_update_started, velocity_update_completed, velocity_update_time_ms:
        solver.velocity_update_time;
}

impl Counters {
    /// Counters at zero.
    pub fn new(enabled: bool) -> Self {
        Self {
            enabled,
            step_time: Timer::new(),
            custom: Timer::new(),
            stages: StagesCounters::new(),
            cd: CollisionDetectionCounters::new(),
            solver: SolverCounters::new(),
            ccd: CCDCounters::new(),
        }
    }

    /// Enables the measurements.
    pub fn enable(&mut self) {
        self.enabled = true;
    }

    /// Disables the measurements.
    pub fn disable(&mut self) {
        self.enabled = false;
    }

    /// Returns whether a step measures.
    pub fn enabled(&self) -> bool {
        self.enabled
    }

    /// The time of the step.
    pub fn step_time(&self) -> Duration {
        self.step_time.time()
    }

    /// The time of the program's stopwatch.
    pub fn custom_time(&self) -> Duration {
        self.custom.time()
    }

    /// Sets the number of constraints.
    pub fn set_nconstraints(&mut self, n: usize) {
        self.solver.nconstraints = n;
    }

    /// Sets the number of contacts.
    pub fn set_ncontacts(&mut self, n: usize) {
        self.solver.ncontacts = n;
    }

    /// Sets the number of contact pairs.
    pub fn set_ncontact_pairs(&mut self, n: usize) {
        self.cd.ncontact_pairs = n;
    }

    /// Sets all counters to zero.
    pub fn reset(&mut self) {
        *self = Self::new(self.enabled);
    }

    /// Enables or disables the engine's measurements.
    pub(crate) fn prepare_engine(&self, own: &mut engine::pipeline::Counters) {
        match self.enabled {
            true => own.enable(),
            false => own.disable(),
        }
    }

    /// Copies the engine's times and counts. The stopwatch of the program stays.
    pub(crate) fn copy_from_engine(&mut self, own: &engine::pipeline::Counters) {
        self.step_time = Timer(own.step_time);
        self.stages = StagesCounters {
            user_changes: Timer(own.stages.user_changes),
            collision_detection_time: Timer(own.stages.collision_detection_time),
            island_construction_time: Timer(own.stages.island_construction_time),
            solver_time: Timer(own.stages.solver_time),
            ccd_time: Timer(own.stages.ccd_time),
            update_time: Timer(own.stages.update_time),
            ..StagesCounters::new()
        };
        self.cd = CollisionDetectionCounters {
            ncontact_pairs: own.cd.ncontact_pairs,
            broad_phase_time: Timer(own.cd.broad_phase_time),
            narrow_phase_time: Timer(own.cd.narrow_phase_time),
            ..CollisionDetectionCounters::new()
        };
        self.solver = SolverCounters {
            nconstraints: own.solver.nconstraints,
            ncontacts: own.solver.ncontacts,
            velocity_resolution_time: Timer(own.solver.velocity_resolution_time),
            velocity_assembly_time: Timer(own.solver.velocity_assembly_time),
            velocity_writeback_time: Timer(own.solver.velocity_writeback_time),
            ..SolverCounters::new()
        };
        self.ccd = CCDCounters {
            num_substeps: own.ccd.num_substeps,
            toi_computation_time: Timer(own.ccd.toi_computation_time),
            ..CCDCounters::new()
        };
    }
}
