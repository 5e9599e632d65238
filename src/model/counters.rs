//! Times and counts of the last step.

use crate::base::timer::Timer;

/// Times and numbers of the last step of a pipeline.
///
/// Numbers are always counted. Times are zero until [`Self::enable`]: reading the clocks takes longer than
/// all else in an empty world. Copies of worlds, and worlds that were loaded, have a pipeline of their own:
/// it does not measure times.
#[derive(Copy, Clone, Debug)]
pub struct Counters {
    enabled: bool,
    /// The whole step.
    pub step_time: Timer,
    /// The stages of the step.
    pub stages: StagesCounters,
    /// Parts of collision detection.
    pub cd: CollisionDetectionCounters,
    /// Parts of the solver.
    pub solver: SolverCounters,
    /// Parts of continuous collision detection.
    pub ccd: CCDCounters,
}

/// Times of the stages of a step, in the order they happen.
#[derive(Copy, Clone, Debug, Default)]
pub struct StagesCounters {
    /// Application of the user's edits since the last step.
    pub user_changes: Timer,
    /// Broad phase and narrow phase.
    pub collision_detection_time: Timer,
    /// Merging, splitting, waking and sleep of islands, and colouring of constraints.
    pub island_construction_time: Timer,
    /// Solution of the constraints, and integration of the bodies.
    pub solver_time: Timer,
    /// Continuous collision detection: the stops of fast bodies at impacts.
    pub ccd_time: Timer,
    /// Update of collider poses, boxes and sleep timers, and delivery of events.
    pub update_time: Timer,
}

/// Times and numbers of collision detection.
#[derive(Copy, Clone, Debug, Default)]
pub struct CollisionDetectionCounters {
    /// Search for pairs whose boxes overlap.
    pub broad_phase_time: Timer,
    /// Computation of contact points and intersections of these pairs.
    pub narrow_phase_time: Timer,
    /// Number of pairs whose boxes overlap.
    pub ncontact_pairs: usize,
    /// Number of pairs with a sensor whose boxes overlap.
    pub nintersection_pairs: usize,
    /// Number of colliders that had more neighbours than
    /// [`max_neighbors_per_collider`](crate::model::params::IntegrationParameters::max_neighbors_per_collider):
    /// some of their pairs have no contacts.
    pub ncrowded: usize,
    /// Number of colliders that overlapped more sensors, or as sensors more colliders, than
    /// [`max_sensor_neighbors_per_collider`](crate::model::params::IntegrationParameters::max_sensor_neighbors_per_collider):
    /// some of these pairs are not reported.
    pub ncrowded_sensors: usize,
    /// Number of computed contact pairs whose contacts were culled to the deepest of each region, for example
    /// of a large body on a fine mesh.
    pub nculled_pairs: usize,
}

/// Times and numbers of the solver.
#[derive(Copy, Clone, Debug, Default)]
pub struct SolverCounters {
    /// Loading of bodies and constraints.
    pub velocity_assembly_time: Timer,
    /// The substeps.
    pub velocity_resolution_time: Timer,
    /// Write-back of velocities, poses and impulses.
    pub velocity_writeback_time: Timer,
    /// Number of contact manifolds and joints solved.
    pub nconstraints: usize,
    /// Number of contact points solved.
    pub ncontacts: usize,
    /// Number of bodies that the step disabled because of unusable numbers.
    pub nquarantined: usize,
    /// Number of bodies that exceeded
    /// [`normalized_max_linear_velocity`](crate::model::params::IntegrationParameters::normalized_max_linear_velocity)
    /// and were slowed down. A multibody counts as one. The value is the maximum over the substeps of each
    /// group. Speeds have no other limit.
    pub nlimited_bodies: usize,
}

/// Times and numbers of continuous collision detection.
#[derive(Copy, Clone, Debug, Default)]
pub struct CCDCounters {
    /// Computation of times of impact.
    pub toi_computation_time: Timer,
    /// Number of bodies that were stopped at an impact, including the bodies that joints connect to them.
    pub num_substeps: usize,
    /// Number of bodies whose paths were searched: fast bodies, and all links of a multibody with a fast
    /// link.
    pub num_fast_bodies: usize,
    /// Number of searches for the time of impact of two colliders.
    pub num_searches: usize,
    /// Number of times that a fast body passed a sensor between two steps.
    pub num_sensors_passed: usize,
}

impl Default for Counters {
    fn default() -> Self {
        Self::new(false)
    }
}

impl Counters {
    /// Counters that are all zero; timers run only when `enabled`.
    pub fn new(enabled: bool) -> Self {
        let mut counters = Self {
            enabled,
            step_time: Timer::default(),
            stages: StagesCounters::default(),
            cd: CollisionDetectionCounters::default(),
            solver: SolverCounters::default(),
            ccd: CCDCounters::default(),
        };
        counters.set_enabled(enabled);
        counters
    }

    /// Returns whether the timers run.
    pub fn enabled(&self) -> bool {
        self.enabled
    }

    /// Enables the timers from the next step on.
    pub fn enable(&mut self) {
        self.set_enabled(true);
    }

    /// Stops all timers. Numbers are still counted.
    pub fn disable(&mut self) {
        self.set_enabled(false);
    }

    fn set_enabled(&mut self, enabled: bool) {
        self.enabled = enabled;
        for timer in self.timers() {
            timer.set_enabled(enabled);
        }
    }

    /// Sets all times and numbers to zero; every step begins with it.
    pub fn reset(&mut self) {
        *self = Self::new(self.enabled);
    }

    /// Duration of the step (ms).
    pub fn step_time_ms(&self) -> f64 {
        self.step_time.time_ms()
    }

    /// Duration of applying the user's changes (ms).
    pub fn user_changes_time_ms(&self) -> f64 {
        self.stages.user_changes.time_ms()
    }

    /// Duration of broad phase and narrow phase (ms).
    pub fn collision_detection_time_ms(&self) -> f64 {
        self.stages.collision_detection_time.time_ms()
    }

    /// Duration of the broad phase (ms).
    pub fn broad_phase_time_ms(&self) -> f64 {
        self.cd.broad_phase_time.time_ms()
    }

    /// Duration of the narrow phase (ms).
    pub fn narrow_phase_time_ms(&self) -> f64 {
        self.cd.narrow_phase_time.time_ms()
    }

    /// Duration of the work on islands and colours (ms).
    pub fn island_construction_time_ms(&self) -> f64 {
        self.stages.island_construction_time.time_ms()
    }

    /// Duration of the solver (ms).
    pub fn solver_time_ms(&self) -> f64 {
        self.stages.solver_time.time_ms()
    }

    /// Duration of continuous collision detection (ms).
    pub fn ccd_time_ms(&self) -> f64 {
        self.stages.ccd_time.time_ms()
    }

    /// Duration of moving the colliders along and reporting events (ms).
    pub fn update_time_ms(&self) -> f64 {
        self.stages.update_time.time_ms()
    }

    fn timers(&mut self) -> [&mut Timer; 13] {
        let Self { step_time, stages, cd, solver, ccd, .. } = self;
        [
            step_time,
            &mut stages.user_changes,
            &mut stages.collision_detection_time,
            &mut stages.island_construction_time,
            &mut stages.solver_time,
            &mut stages.ccd_time,
            &mut stages.update_time,
            &mut cd.broad_phase_time,
            &mut cd.narrow_phase_time,
            &mut solver.velocity_assembly_time,
            &mut solver.velocity_resolution_time,
            &mut solver.velocity_writeback_time,
            &mut ccd.toi_computation_time,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::Counters;
    use core::time::Duration;

    #[test]
    fn disabling_reaches_every_timer() {
        let mut counters = Counters::default();
        counters.disable();
        for timer in counters.timers() {
            timer.measure(|| std::thread::sleep(Duration::from_micros(10)));
            assert_eq!(timer.time(), Duration::ZERO);
        }
        counters.enable();
        counters.stages.solver_time.measure(|| std::thread::sleep(Duration::from_millis(1)));
        counters.solver.ncontacts = 3;
        assert!(counters.solver_time_ms() >= 1.0);
        counters.reset();
        assert_eq!((counters.solver_time_ms(), counters.solver.ncontacts), (0.0, 0));
        assert!(counters.enabled());
    }
}
