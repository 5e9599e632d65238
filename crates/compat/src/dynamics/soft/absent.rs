//! Soft bodies and their parts. No value of these types exists.

use super::{
    CellParticles, SoftBodyCellModel, SoftBodyEdgeKind, SoftBodyMaterial, SoftBodyParticleSettings,
    SoftBodySet, SoftMeshMapping, SurfaceElement,
};
use crate::dynamics::{RigidBodyHandle, RigidBodySet};
use crate::geometry::ColliderHandle;
use crate::math::{DIM, Matrix, Pose, Real, Vector};
use engine::dynamics::{SoftBodyHandle, SoftMeshId, SpringCoefficients};

/// A field of this type makes a type without values.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
enum Absent {}

/// The body of functions that cannot be called.
fn cannot_be_called() -> ! {
    unreachable!("the engine has no soft bodies")
}

/// Defines a type without values, and its functions.
macro_rules! absent {
    (
        $(#[$doc:meta])* $name:ident { $($field:ident: $type:ty,)* }
        $(fn $function:ident($($arguments:tt)*) $(-> $result:ty)?;)*
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug)]
        #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
        pub struct $name {
            $(#[doc = "A part of a soft body: no value exists."] pub $field: $type,)*
            #[allow(dead_code, reason = "it makes the type uninhabited")]
            absent: Absent,
        }

        #[allow(unused_variables, reason = "the functions cannot be called")]
        impl $name {
            $(
                #[doc = "A function of a soft body: it cannot be called, because no value exists."]
                pub fn $function($($arguments)*) $(-> $result)? {
                    cannot_be_called()
                }
            )*
        }
    };
}

absent! {
    /// A soft body.
    SoftBody {
        user_data: u128,
    }
    fn add_force(&mut self, force: Vector, wake_up: bool);
    fn add_particle_force(&mut self, i: usize, force: Vector, wake_up: bool);
    fn apply_impulse(&mut self, impulse: Vector, wake_up: bool);
    fn apply_impulse_at_point(&mut self, impulse: Vector, point: Vector, falloff_radius: Real, wake_up: bool);
    fn apply_particle_impulse(&mut self, i: usize, impulse: Vector, wake_up: bool);
    fn apply_radial_impulse(&mut self, center: Vector, magnitude: Real, falloff_radius: Real, wake_up: bool);
    fn attach_particle(&mut self, i: usize, body: RigidBodyHandle, bodies: &RigidBodySet);
    fn boundary(&self) -> &[SurfaceElement];
    fn cell_model(&self) -> SoftBodyCellModel;
    fn cells(&self) -> &[SoftBodyCell];
    fn center_of_mass(&self) -> Vector;
    fn cluster(&self, i: u32) -> Option<&SoftBodyCluster>;
    fn cluster_mut(&mut self, i: u32) -> Option<&mut SoftBodyCluster>;
    fn cluster_proxy(&self, i: u32) -> Option<RigidBodyHandle>;
    fn clusters(&self) -> &[SoftBodyCluster];
    fn collision_mesh(&self) -> Option<&SoftCollisionMesh>;
    fn connected_pieces(&self) -> Vec<Vec<u32>>;
    fn crossing_elements(&self, blade: &[Vector; DIM]) -> (Vec<u32>, Vec<u32>);
    fn detach_particle(&mut self, i: usize) -> bool;
    fn dihedrals(&self) -> &[SoftBodyDihedral];
    fn edge_contact_segments(&self, soft_bodies: &SoftBodySet) -> std::vec::IntoIter<(Vector,Vector)>;
    fn edges(&self) -> &[SoftBodyEdge];
    fn enable_cluster_shape_matching(&mut self, i: u32, enabled: bool);
    fn enable_volume_preservation(&mut self, enabled: bool);
    fn has_pending_tears(&self) -> bool;
    fn is_enabled(&self) -> bool;
    fn is_sleeping(&self) -> bool;
    fn live_clusters(&self) -> std::vec::IntoIter<(u32,&SoftBodyCluster)>;
    fn mass(&self) -> Real;
    fn mass_of(&self, particles: &[u32]) -> Real;
    fn material(&self) -> &SoftBodyMaterial;
    fn material_mut(&mut self) -> &mut SoftBodyMaterial;
    fn mesh(&self, id: SoftMeshId) -> Option<&SoftCollisionMesh>;
    fn mesh_of(&self, collider: ColliderHandle) -> Option<&SoftCollisionMesh>;
    fn meshes(&self) -> std::vec::IntoIter<&SoftCollisionMesh>;
    fn num_live_clusters(&self) -> usize;
    fn num_particles(&self) -> usize;
    fn num_solver_colors(&self) -> usize;
    fn origin(&self) -> Option<SoftBodyHandle>;
    fn particle_attachments(&self) -> &[SoftParticleAttachment];
    fn particle_position(&self, i: usize) -> Vector;
    fn particle_positions(&self) -> std::vec::IntoIter<Vector>;
    fn particle_radius(&self) -> Real;
    fn particle_settings(&self) -> &SoftBodyParticleSettings;
    fn particle_velocities(&self) -> std::vec::IntoIter<Vector>;
    fn particle_velocity(&self, i: usize) -> Vector;
    fn particles(&self) -> &[SoftBodyParticle];
    fn pieces(&self) -> &[SoftBodyHandle];
    fn reset_forces(&mut self, wake_up: bool);
    fn reset_plasticity(&mut self);
    fn rest_measure(&self) -> Real;
    fn rest_measure_of(&self, particles: &[u32]) -> Real;
    fn rest_volume(&self) -> Real;
    fn root_body(&self) -> RigidBodyHandle;
    fn seeded_components(&self, members: Option<&[u32]>, seeds: &[[u32; 2]]) -> Vec<Vec<u32>>;
    fn set_additional_pgs_iterations(&mut self, iterations: usize);
    fn set_cell_tear_resistance(&mut self, i: usize, resistance: Real);
    fn set_cluster_edge_softness(&mut self, i: u32, softness: Option<SpringCoefficients<Real>>);
    fn set_cluster_kinematic_target(&mut self, i: u32, pose: Pose);
    fn set_cluster_pinned(&mut self, i: u32, pinned: bool);
    fn set_cluster_stiffness_scale(&mut self, i: u32, scale: Real);
    fn set_cluster_tear_resistance(&mut self, i: u32, resistance: Real);
    fn set_edge_tear_resistance(&mut self, i: usize, resistance: Real);
    fn set_enabled(&mut self, enabled: bool);
    fn set_material(&mut self, material: SoftBodyMaterial);
    fn set_particle_damaged(&mut self, i: usize, damaged: bool);
    fn set_particle_kinematic_target(&mut self, i: usize, position: Vector);
    fn set_particle_pinned(&mut self, i: usize, pinned: bool);
    fn set_particle_position(&mut self, i: usize, position: Vector);
    fn set_particle_velocity(&mut self, i: usize, velocity: Vector);
    fn set_volume_factor(&mut self, factor: Real);
    fn tear_cell(&mut self, i: usize);
    fn tear_edge(&mut self, i: usize);
    fn topology_version(&self) -> u32;
    fn validate_topology(&self) -> Result<(),String>;
    fn vertex_contact_segments(&self, soft_bodies: &SoftBodySet) -> std::vec::IntoIter<(Vector,Vector)>;
    fn volume(&self) -> Real;
    fn volume_contacts(&self) -> std::vec::IntoIter<&SoftVolumeContact>;
    fn volume_factor(&self) -> Real;
    fn volume_pieces(&self) -> &[SoftVolumePiece];
    fn volume_preservation_enabled(&self) -> bool;
    fn wake_up(&mut self);
}

absent! {
    /// A cell of a soft body.
    SoftBodyCell {
        rest_volume: Real,
        stiffness_scale: Real,
        tear_resistance: Real,
        vertices: CellParticles,
    }
    fn plastic_stretch(&self) -> Matrix;
    fn stress(&self) -> Real;
}

absent! {
    /// Particles of a soft body that a rigid body represents.
    SoftBodyCluster {
    }
    fn is_live(&self) -> bool;
    fn mesh(&self, i: u32) -> Option<&SoftCollisionMesh>;
    fn meshes(&self) -> std::vec::IntoIter<&SoftCollisionMesh>;
    fn particles(&self) -> &[u32];
    fn proxy(&self) -> RigidBodyHandle;
    fn set_shape_matching_target(&mut self, target: Option<Pose>);
    fn shape_matching_enabled(&self) -> bool;
}

absent! {
    /// An angle between two triangles.
    SoftBodyDihedral {
        rest_angle: Real,
        vertices: CellParticles,
    }
    fn initial_rest_angle(&self) -> Real;
    fn plastic_set(&self) -> Real;
}

absent! {
    /// An edge between two particles.
    SoftBodyEdge {
        kind: SoftBodyEdgeKind,
        rest_length: Real,
        softness: Option<SpringCoefficients<Real>>,
        tear_resistance: Real,
        tension_only: bool,
        vertices: [u32; 2],
    }
    fn impulse(&self) -> Real;
    fn initial_rest_length(&self) -> Real;
    fn plastic_strain(&self) -> Real;
    fn stress(&self) -> Real;
}

absent! {
    /// A particle of a soft body.
    SoftBodyParticle {
    }
    fn force(&self) -> Vector;
    fn initial_rest_position(&self) -> Vector;
    fn inv_mass(&self) -> Real;
    fn is_damaged(&self) -> bool;
    fn is_on_surface(&self) -> bool;
    fn is_pinned(&self) -> bool;
    fn kinematic_target(&self) -> Option<Vector>;
    fn mass(&self) -> Real;
    fn position(&self) -> Vector;
    fn rest_position(&self) -> Vector;
    fn velocity(&self) -> Vector;
}

absent! {
    /// A surface of a soft body.
    SoftCollisionMesh {
    }
    fn arity(&self) -> usize;
    fn binding(&self) -> &SoftMeshMapping;
    fn collider(&self) -> ColliderHandle;
    fn collision_enabled(&self) -> bool;
    fn element(&self, i: usize) -> &[u32];
    fn id(&self) -> SoftMeshId;
    fn indices(&self) -> &[SurfaceElement];
    fn is_closed(&self) -> bool;
    fn is_oriented(&self) -> bool;
    fn is_skinned(&self) -> bool;
    fn is_solid(&self) -> bool;
    fn is_wire(&self) -> bool;
    fn self_contacts_enabled(&self) -> bool;
    fn topology_version(&self) -> u32;
    fn vertex(&self, body: &SoftBody, i: usize) -> Vector;
    fn vertex_anchors(&self, body: &SoftBody, i: usize) -> (CellParticles,[Real; DIM + 1]);
    fn vertex_count(&self) -> usize;
    fn vertex_positions(&self, body: &SoftBody) -> std::vec::IntoIter<Vector>;
    fn vertex_velocity(&self, body: &SoftBody, i: usize) -> Vector;
    fn vertices(&self) -> &[Vector];
}

absent! {
    /// A particle that a rigid body holds.
    SoftParticleAttachment {
        body: RigidBodyHandle,
        local_anchor: Vector,
        particle: u32,
    }
    fn impulse(&self) -> Vector;
}

absent! {
    /// A contact of volumes.
    SoftVolumeContact {
        center: Vector,
        gradients: Vec<(Vector,Vector)>,
        normal: Vector,
        volume: Real,
    }
}

absent! {
    /// A part of a soft body with a volume.
    SoftVolumePiece {
    }
    fn elements(&self) -> &[u32];
    fn particles(&self) -> &[u32];
    fn rest_volume(&self) -> Real;
    fn volume(&self, body: &SoftBody) -> Real;
}
