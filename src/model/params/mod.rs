//! Everything of a step that can be tuned: [`IntegrationParameters`].
//!
//! Each number has a unit, a reason and a warning. Lengths and velocities called `normalized_…` are
//! multiples of [`IntegrationParameters::length_unit`] (per second); the method without the prefix
//! gives them in the world's own units.

mod pass;
mod softness;
mod validate;

#[cfg(test)]
mod tests;

pub(crate) use pass::{ContactPass, ImpactPass, JointPass};
pub use softness::{CONTACT_COMPLIANCE, CONTACT_ERP_SCALE, JOINT_ERP_SCALE, Softness};
pub(crate) use validate::ITERATIONS_MAX;
pub use validate::InvalidParameters;

use crate::dim::math::Real;

/// Shape of the set of allowed friction impulses.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum FrictionModel {
    /// Friction once per manifold, at the centre of its points: two directions in the contact plane and, in
    /// 3D, one torque about the normal. All points share the load, so this needs fewer rows and converges in
    /// fewer iterations than friction at each point.
    #[default]
    Standard,
    /// Friction at each point, kept within the exact cone `|friction| ≤ µ · normal` of that point. It costs
    /// more. Use it where a single body slides and turns on a few unevenly loaded points.
    Coulomb,
}

/// Parameters of time integration: time step, accuracy, and correction of overlap.
///
/// The defaults suit bodies of about one length unit, at 60 steps a second. Change a field or two:
///
/// ```
/// # use rapier3d::prelude::*;
/// let params = IntegrationParameters { dt: 1.0 / 120.0, ..Default::default() };
/// ```
///
/// A step with invalid parameters (see [`Self::validate`]) is refused as a whole: it logs the reason and
/// leaves the world unchanged.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct IntegrationParameters {
    /// Length of one step (s, default 1/60). At 0 the step detects collisions and moves nothing.
    ///
    /// Constant steps are best: results repeat only with the same sequence of steps. Contacts stay at rest in
    /// steps of changing length, and are as soft as those of the longest of the last 0.2 s.
    pub dt: Real,
    /// Number of substeps of a step (default 4, at least 1). Each integrates for `dt` divided by this number,
    /// and iterates over all constraints once with position correction and once without.
    ///
    /// The error of stiff stacks falls with its square, the cost of the solver grows in proportion; collision
    /// detection runs once per step. Islands of up to 512 bodies get more if their stack would sag or lean,
    /// or if light bodies carry heavy ones.
    pub num_solver_iterations: usize,
    /// Additional iterations of all constraints without position correction, friction among them, per substep
    /// (default 0). For loads that hang on friction alone, such as in a gripper.
    pub num_additional_friction_iterations: usize,
    /// Iterations over all constraints, with position correction, per substep (default 1, at least 1). More
    /// substeps are nearly always the better use of the same time.
    pub num_internal_pgs_iterations: usize,
    /// The fraction of a contact's position error that a substep aims to remove (0 to 1, default 0.1). The
    /// solver multiplies it by [`CONTACT_ERP_SCALE`], whose documentation explains the reduction.
    ///
    /// The error is the overlap beyond [`Self::allowed_linear_error`]. At the default, 1 % of it is
    /// left after some 70 substeps. Larger values resolve overlap faster and make it burst apart
    /// sooner; smaller ones let stacks sag. [`Softness`] relates it to a frequency and a damping.
    pub erp: Real,
    /// Softness of contacts on top of the solver's own (0 or more, default 0: as hard as the solver
    /// converges well).
    ///
    /// The damping ratio is measured by compliance: an impulse that gives the free bodies a relative velocity
    /// `v` moves the contact at about `damping_ratio · v`. The deflection at rest under gravity `g` grows by
    /// `damping_ratio · g h² / (0.7 erp)` (`h`: length of a substep). The contact persists at any value.
    /// [`Softness`] derives this and relates it to a frequency and a damping.
    pub damping_ratio: Real,
    /// The same as [`Self::erp`], for joints (0 to 1, default 0.1).
    pub joint_erp: Real,
    /// The same as [`Self::damping_ratio`], for joints (0 or more, default 0).
    pub joint_damping_ratio: Real,
    /// Overlap that is not corrected (length units, default 0.001). In islands with more substeps than usual
    /// it is divided by the square of their ratio.
    ///
    /// A resting contact that stays slightly inside does not begin and end all the time. With a value
    /// of 0 piles tremble; with a value near the size of the bodies they visibly sink in.
    pub allowed_linear_error: Real,
    /// The largest number of parts into which impacts of fast bodies divide a step (default 1). With 0,
    /// continuous collision detection is off.
    ///
    /// With 1, a fast body that hits something stops there, and its remaining time in this step is lost. With
    /// more, the step ends at the first impact and a shorter step follows, for the whole world. Each part
    /// costs as much as a step. Parts take at least [`Self::min_ccd_dt`].
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// // A ball with 200 m/s bounces off a wall that it reaches after 80 % of a step.
    /// let end = |max_ccd_substeps| {
    ///     let mut world = PhysicsWorld::new();
    ///     world.gravity = Vector::ZERO;
    ///     world.integration_parameters.max_ccd_substeps = max_ccd_substeps;
    ///     let wall = ColliderBuilder::cuboid(0.1, 5.0, 5.0).restitution(1.0);
    ///     world.insert_collider(wall.translation(vector![2.867, 0.0, 0.0]), None);
    ///     let ball = RigidBodyBuilder::dynamic().linvel(vector![200.0, 0.0, 0.0]);
    ///     let ball = world.insert(ball, ColliderBuilder::ball(0.1).restitution(1.0)).0;
    ///     (0..3).for_each(|_| world.step());
    ///     world.bodies[ball].translation().x
    /// };
    /// // Ten metres in three steps, of which 2.667 to the wall.
    /// assert!((end(2) - -4.667).abs() < 0.01);
    /// assert!((end(1) - -4.0).abs() < 0.01, "0.667 m are lost");
    /// ```
    pub max_ccd_substeps: usize,
    /// Whether continuous collision detection also stops a body that touches or overlaps something at the
    /// start, before its middle penetrates (default true). If not, contacts alone must hold it.
    pub ccd_on_penetration: bool,
    /// Friction model (default [`FrictionModel::Standard`]). In 2D both agree except for the number of rows.
    pub friction_model: FrictionModel,

    /// The size of a typical moving body in the world's own units (default 1). In a world whose metre
    /// is 100 pixels, set it to 100: the lengths and velocities called `normalized_…` and
    /// [`Self::allowed_linear_error`] are multiples of it.
    pub length_unit: Real,
    /// Gap below which a pair already has contacts (multiples of the length unit, default 0.02). It makes an
    /// approaching body stop at the surface and not inside.
    pub normalized_prediction_distance: Real,
    /// Largest velocity at which overlap is corrected (multiples of the length unit per second, default 4).
    /// The limit keeps bodies that were created inside each other from bursting apart.
    pub normalized_max_corrective_velocity: Real,
    /// Largest velocity at which a joint without its own softness corrects the distance of its anchors
    /// (multiples of the length unit per second, default 100). Bodies that were created far from their joint
    /// anchors are corrected over many steps. Without the limit, a correction of 10 km left a body with 165
    /// km/s. The limit affects only joints whose anchors are farther apart than about 0.4 length units (at
    /// the defaults).
    pub normalized_max_joint_corrective_velocity: Real,
    /// Largest linear velocity of any body (multiples of the length unit per second; default `Real::MAX`: no
    /// limit).
    pub normalized_max_linear_velocity: Real,
    /// Relative displacement of two touching bodies above which their contact points are recomputed
    /// (multiples of the length unit, default 0.01). Below it, the points of the last computation move with
    /// the bodies. 0 recomputes them in each step.
    pub normalized_contact_recycle_distance: Real,
    /// Contacts that approach more slowly than this do not bounce, at any restitution (multiples of the
    /// length unit per second, default 1). Without this threshold, gravity alone makes resting bodies bounce
    /// for ever.
    pub normalized_restitution_velocity_threshold: Real,
    /// Fraction of the last impulses with which a substep starts (0 to 1, default 1). Smaller values weaken
    /// stacks and serve only to study the solver.
    pub warmstart_coefficient: Real,
    /// The shortest part of a step that impacts divide (s, default 1/6000): see [`Self::max_ccd_substeps`].
    pub min_ccd_dt: Real,
    /// Largest number of contact partners of a collider among others of its size, and among larger ones
    /// (default 128 each; `usize::MAX`: no limit). Sizes are rounded to powers of two.
    ///
    /// The limit applies to movable partners whose fat AABBs overlap its own. Fixed bodies, sensors (which
    /// have a separate limit), and smaller colliders are excluded: a moving floor may carry any number of
    /// crates. Bodies with which a joint or a multibody disables contacts are excluded, too. A compact body
    /// has room for less than half as many, unless bodies overlap. The limit is for worlds that create
    /// thousands of bodies at one point. The number of their pairs would be the square of their number. With
    /// the limit it is their number times this, with about 1.5 kB for each. The nearest slots are selected;
    /// the rest are deferred. The log warns when the limit is met, and
    /// [`ncrowded`](crate::model::counters::CollisionDetectionCounters::ncrowded) counts the affected
    /// colliders. Raise the limit for heaps of hundreds of long sticks, all of whose boxes overlap.
    pub max_neighbors_per_collider: usize,
    /// Largest number of sensor pairs that a collider owns with others of its size, and with larger ones
    /// (default 256 each; `usize::MAX`: no limit). Sizes are rounded to powers of two.
    ///
    /// The smaller of a sensor and another collider owns their pair. If their sizes are equal, the collider
    /// that is not a sensor owns it. So a sensor reports any number of intersecting colliders that are not
    /// larger than it. The limit applies to the sensors that one collider intersects, and to the sensors
    /// within one sensor. Pairs with fixed colliders are not limited. 5000 sensors at one point would be 12.5
    /// million pairs, 11 s a step and 2 GB. The nearest slots are selected; the log warns when the limit is
    /// reached, and
    /// [`ncrowded_sensors`](crate::model::counters::CollisionDetectionCounters::ncrowded_sensors) counts the
    /// colliders. Put sensors whose mutual intersections are not needed into different [collision
    /// groups](crate::model::collider::InteractionGroups).
    pub max_sensor_neighbors_per_collider: usize,
}

impl Default for IntegrationParameters {
    fn default() -> Self {
        Self {
            dt: 1.0 / 60.0,
            num_solver_iterations: 4,
            num_additional_friction_iterations: 0,
            num_internal_pgs_iterations: 1,
            erp: 0.1,
            damping_ratio: 0.0,
            joint_erp: 0.1,
            joint_damping_ratio: 0.0,
            allowed_linear_error: 0.001,
            max_ccd_substeps: 1,
            ccd_on_penetration: true,
            friction_model: FrictionModel::Standard,
            length_unit: 1.0,
            normalized_prediction_distance: 0.02,
            normalized_max_corrective_velocity: 4.0,
            normalized_max_joint_corrective_velocity: 100.0,
            normalized_max_linear_velocity: Real::MAX,
            normalized_contact_recycle_distance: 0.01,
            normalized_restitution_velocity_threshold: 1.0,
            warmstart_coefficient: 1.0,
            min_ccd_dt: 1.0 / 6000.0,
            max_neighbors_per_collider: 128,
            max_sensor_neighbors_per_collider: 256,
        }
    }
}

impl IntegrationParameters {
    /// Steps per second, `1 / dt`; 0 if `dt` is 0.
    #[inline]
    pub fn inv_dt(&self) -> Real {
        if self.dt == 0.0 { 0.0 } else { 1.0 / self.dt }
    }

    /// Sets the length of a step (s).
    ///
    /// # Errors
    /// If the length is negative or not finite; the old value stays.
    pub fn set_dt(&mut self, dt: Real) -> Result<(), InvalidParameters> {
        let changed = Self { dt, ..*self };
        changed.validate_dt()?;
        *self = changed;
        Ok(())
    }

    /// Sets the number of steps per second; 0 sets `dt` to 0.
    ///
    /// # Errors
    /// If the resulting `dt` is negative or not finite; the old value stays.
    pub fn set_inv_dt(&mut self, inv_dt: Real) -> Result<(), InvalidParameters> {
        self.set_dt(if inv_dt == 0.0 { 0.0 } else { 1.0 / inv_dt })
    }

    /// Length of one substep (s).
    #[inline]
    pub fn substep(&self) -> Real {
        self.dt / self.num_solver_iterations.max(1) as Real
    }

    /// Overlap that is not corrected in substeps of `substep` seconds (length).
    ///
    /// Within it a contact has no stiffness. Islands get more substeps than usual to be stiffer, so there it
    /// shrinks as the yield of contacts does, with the square of the substep.
    pub(crate) fn allowed_error(&self, substep: Real) -> Real {
        let usual = self.substep();
        let ratio = if usual > 0.0 { substep / usual } else { 1.0 };
        self.allowed_linear_error() * ratio * ratio
    }

    /// The softness of contacts in a substep of `substep` seconds.
    ///
    /// The substep is an argument because bodies may request more of them than
    /// [`Self::num_solver_iterations`].
    #[inline]
    pub fn contact_softness(&self, substep: Real) -> Softness {
        Softness::new(
            CONTACT_ERP_SCALE * self.erp,
            CONTACT_COMPLIANCE + self.damping_ratio,
            substep,
        )
    }

    /// The softness of joints without their own softness in a substep of `substep` seconds.
    #[inline]
    pub fn joint_softness(&self, substep: Real) -> Softness {
        let fraction = (JOINT_ERP_SCALE * self.joint_erp).min(1.0);
        Softness::new(fraction, self.joint_damping_ratio, substep)
    }

    /// [`Self::allowed_linear_error`](#structfield.allowed_linear_error) in the world's own units of length.
    #[inline]
    pub fn allowed_linear_error(&self) -> Real {
        self.allowed_linear_error * self.length_unit
    }

    /// [`Self::normalized_prediction_distance`] in the world's own units of length.
    #[inline]
    pub fn prediction_distance(&self) -> Real {
        self.normalized_prediction_distance * self.length_unit
    }

    /// [`Self::normalized_max_corrective_velocity`] in the world's own units of length per second.
    #[inline]
    pub fn max_corrective_velocity(&self) -> Real {
        self.normalized_max_corrective_velocity * self.length_unit
    }

    /// [`Self::normalized_max_joint_corrective_velocity`] in the world's own units of length per second.
    #[inline]
    pub fn max_joint_corrective_velocity(&self) -> Real {
        self.normalized_max_joint_corrective_velocity * self.length_unit
    }

    /// [`Self::normalized_max_linear_velocity`] in the world's own units of length per second.
    #[inline]
    pub fn max_linear_velocity(&self) -> Real {
        self.normalized_max_linear_velocity * self.length_unit
    }

    /// [`Self::normalized_contact_recycle_distance`] in the world's own units of length.
    #[inline]
    pub fn contact_recycle_distance(&self) -> Real {
        self.normalized_contact_recycle_distance * self.length_unit
    }

    /// [`Self::normalized_restitution_velocity_threshold`] in the world's own units of length per second.
    #[inline]
    pub fn restitution_velocity_threshold(&self) -> Real {
        self.normalized_restitution_velocity_threshold * self.length_unit
    }
}
