//! Builders of soft bodies. They store what they are given and compute nothing.

use super::{
    CellParticles, SoftBodyCellModel, SoftBodyMaterial, SoftBodyParticleSettings, SurfaceElement,
};
use crate::geometry::ColliderBuilder;
use crate::math::{Real, Vector};
use engine::dynamics::SpringCoefficients;

/// Describes a soft body. The engine makes none.
#[derive(Clone, Debug)]
#[allow(missing_docs, reason = "the fields have no effect")]
pub struct SoftBodyBuilder {
    pub positions: Vec<Vector>,
    pub masses: Vec<Real>,
    pub particle_mass: Real,
    pub particle_radius: Real,
    pub particle_settings: SoftBodyParticleSettings,
    pub pinned: Vec<u32>,
    pub edges: Vec<[u32; 2]>,
    pub bend_edges: Vec<[u32; 2]>,
    pub tension_only_edges: Vec<u32>,
    pub edge_softness: Vec<(u32, SpringCoefficients<Real>)>,
    pub edge_tear_resistance: Vec<(u32, Real)>,
    pub cells: Vec<CellParticles>,
    pub cell_model: SoftBodyCellModel,
    #[cfg(feature = "dim3")]
    pub dihedrals: Vec<[u32; 4]>,
    pub surface: Vec<SurfaceElement>,
    pub wire: Vec<[u32; 2]>,
    pub skin: Option<(Vec<Vector>, Vec<SurfaceElement>)>,
    pub skin_collision: bool,
    pub oriented: Option<bool>,
    pub self_contacts: bool,
    pub shape_matching: bool,
    pub volume_preservation: bool,
    pub volume_factor: Real,
    pub material: SoftBodyMaterial,
    #[cfg(feature = "fem")]
    pub solver: super::SoftBodySolver,
    pub collider_template: Option<ColliderBuilder>,
    pub user_data: u128,
}

impl Default for SoftBodyBuilder {
    fn default() -> Self {
        Self::new(Vec::new())
    }
}

/// Defines functions that set a field.
macro_rules! setters {
    ($($name:ident($($argument:ident: $type:ty)?) $place:ident $(. $part:ident)? = $value:expr;)*) => {
        impl SoftBodyBuilder {
            $(
                #[doc = concat!("Sets `", stringify!($place $(. $part)?), "`.")]
                #[must_use]
                pub fn $name(mut self $(, $argument: $type)?) -> Self {
                    self.$place $(. $part)? = $value;
                    self
                }
            )*
        }
    };
}

setters! {
    positions(positions: Vec<Vector>) positions = positions;
    masses(masses: Vec<Real>) masses = masses;
    particle_mass(mass: Real) particle_mass = mass;
    mass(mass: Real) particle_mass = mass;
    particle_radius(radius: Real) particle_radius = radius;
    particle_settings(settings: SoftBodyParticleSettings) particle_settings = settings;
    pinned_particles(pinned: impl IntoIterator<Item = u32>) pinned = pinned.into_iter().collect();
    edges(edges: Vec<[u32; 2]>) edges = edges;
    bend_edges(edges: Vec<[u32; 2]>) bend_edges = edges;
    edge_tear_resistance(edges: impl IntoIterator<Item = (u32, Real)>)
        edge_tear_resistance = edges.into_iter().collect();
    cells(cells: Vec<CellParticles>) cells = cells;
    cell_model(model: SoftBodyCellModel) cell_model = model;
    surface(surface: Vec<SurfaceElement>) surface = surface;
    wire(segments: Vec<[u32; 2]>) wire = segments;
    skin_collision(enabled: bool) skin_collision = enabled;
    oriented(oriented: bool) oriented = Some(oriented);
    self_contacts(enabled: bool) self_contacts = enabled;
    shape_matching(enabled: bool) shape_matching = enabled;
    volume_preservation(enabled: bool) volume_preservation = enabled;
    volume_factor(factor: Real) volume_factor = factor;
    material(material: SoftBodyMaterial) material = material;
    softness(softness: SpringCoefficients<Real>) material = SoftBodyMaterial::uniform(softness);
    interior_strength(strength: Real) material.interior_strength = strength;
    min_piece(elements: u32) material.min_piece = Some(elements);
    tear_force(force: Real) material.tear_force = Some(force);
    tear_strain(strain: Real) material.tear_strain = Some(strain);
    tear_smoothing(seconds: Real) material.tear_smoothing = seconds;
    additional_pgs_iterations(iterations: usize)
        particle_settings.additional_pgs_iterations = iterations;
    additional_solver_iterations(iterations: usize)
        particle_settings.additional_solver_iterations = iterations;
    can_sleep(can_sleep: bool) particle_settings.can_sleep = can_sleep;
    gravity_scale(scale: Real) particle_settings.gravity_scale = scale;
    linear_damping(damping: Real) particle_settings.linear_damping = damping;
    dominance_group(group: i8) particle_settings.dominance_group = group;
    surface_collider(collider: ColliderBuilder) collider_template = Some(collider);
    no_surface_collider() collider_template = None;
    user_data(data: u128) user_data = data;
}

#[cfg(feature = "dim3")]
setters! {
    dihedrals(dihedrals: Vec<[u32; 4]>) dihedrals = dihedrals;
}

#[cfg(feature = "fem")]
setters! {
    solver(solver: super::SoftBodySolver) solver = solver;
}

/// Defines constructors of shapes. Their builders have no particles, because the engine makes no soft body.
macro_rules! shapes {
    ($($name:ident($($argument:ident: $type:ty),*);)*) => {
        #[allow(unused_variables, reason = "the builders have no particles")]
        #[allow(clippy::too_many_arguments, reason = "the signatures of Rapier 0.36")]
        impl SoftBodyBuilder {
            $(
                #[doc = "A builder without particles: the engine makes no soft body."]
                pub fn $name($($argument: $type),*) -> Self {
                    Self::default()
                }
            )*
        }
    };
}

shapes! {
    rope(start: Vector, end: Vector, num_particles: usize);
}

#[cfg(feature = "dim2")]
shapes! {
    disk(center: Vector, radius: Real, subdivisions: usize);
    grid(center: Vector, half_extents: Vector, nx: usize, ny: usize);
}

#[cfg(feature = "dim3")]
shapes! {
    cloth(origin: Vector, du: Vector, dv: Vector, nu: usize, nv: usize);
    cloth_anisotropic(
        origin: Vector, du: Vector, dv: Vector, nu: usize, nv: usize,
        warp: SpringCoefficients<Real>, weft: SpringCoefficients<Real>, shear: SpringCoefficients<Real>
    );
    cloth_tube(
        origin: Vector, axis: Vector, radius_start: Real, radius_end: Real, num_around: usize,
        num_along: usize
    );
    cuboid(center: Vector, half_extents: Vector, nx: usize, ny: usize, nz: usize);
    sphere(center: Vector, radius: Real, subdivisions: usize);
}

impl SoftBodyBuilder {
    /// A builder with these particles.
    pub fn new(positions: Vec<Vector>) -> Self {
        Self {
            positions,
            masses: Vec::new(),
            particle_mass: 1.0,
            particle_radius: 0.0,
            particle_settings: SoftBodyParticleSettings::default(),
            pinned: Vec::new(),
            edges: Vec::new(),
            bend_edges: Vec::new(),
            tension_only_edges: Vec::new(),
            edge_softness: Vec::new(),
            edge_tear_resistance: Vec::new(),
            cells: Vec::new(),
            cell_model: SoftBodyCellModel::default(),
            #[cfg(feature = "dim3")]
            dihedrals: Vec::new(),
            surface: Vec::new(),
            wire: Vec::new(),
            skin: None,
            skin_collision: false,
            oriented: None,
            self_contacts: false,
            shape_matching: false,
            volume_preservation: false,
            volume_factor: 1.0,
            material: SoftBodyMaterial::default(),
            #[cfg(feature = "fem")]
            solver: super::SoftBodySolver::default(),
            collider_template: Some(ColliderBuilder::ball(0.0)),
            user_data: 0,
        }
    }

    /// The positions of the particles.
    pub fn particle_positions(&self) -> &[Vector] {
        &self.positions
    }

    /// Moves all particles.
    #[must_use]
    pub fn translated(mut self, translation: Vector) -> Self {
        self.positions.iter_mut().for_each(|position| *position += translation);
        self
    }

    /// Adds edges.
    #[must_use]
    pub fn add_edges(mut self, edges: impl IntoIterator<Item = [u32; 2]>) -> Self {
        self.edges.extend(edges);
        self
    }

    /// Sets that no edge resists compression.
    #[must_use]
    pub fn tension_only(mut self) -> Self {
        self.tension_only_edges = (0..self.edges.len() as u32).collect();
        self
    }

    /// Sets the surface that is drawn.
    #[must_use]
    pub fn skin(mut self, vertices: Vec<Vector>, indices: Vec<SurfaceElement>) -> Self {
        self.skin = Some((vertices, indices));
        self
    }

    /// Adds the particles and edges of another builder.
    #[must_use]
    pub fn append(mut self, other: SoftBodyBuilder) -> Self {
        let first = self.positions.len() as u32;
        self.positions.extend(other.positions);
        self.edges.extend(other.edges.into_iter().map(|edge| edge.map(|end| first + end)));
        self.cells.extend(other.cells.into_iter().map(|cell| cell.map(|end| first + end)));
        self
    }

    /// The edges of all cells.
    pub fn cell_edges(&self) -> Vec<[u32; 2]> {
        unique_edges(self.cells.iter().map(|cell| cell.as_slice()))
    }

    /// The edges of the surface.
    pub fn surface_edges(&self) -> Vec<[u32; 2]> {
        unique_edges(self.surface.iter().map(|element| element.as_slice()))
    }

    /// The angles of the surface: none, because the engine makes no soft body.
    #[cfg(feature = "dim3")]
    pub fn surface_dihedrals(&self) -> Vec<[u32; 4]> {
        Vec::new()
    }

    /// A builder with the vertices and edges of a triangle mesh.
    pub fn trimesh(vertices: Vec<Vector>, indices: Vec<[u32; 3]>) -> Option<Self> {
        let edges = unique_edges(indices.iter().map(|triangle| triangle.as_slice()));
        Some(Self::new(vertices).edges(edges))
    }

    /// A builder with the vertices and edges of a line.
    #[cfg(feature = "dim2")]
    pub fn polyline(vertices: Vec<Vector>, indices: Option<Vec<[u32; 2]>>) -> Option<Self> {
        Some(Self::new(vertices).edges(indices.unwrap_or_default()))
    }

    /// A builder with the vertices of a polygon as particles.
    #[cfg(feature = "dim2")]
    pub fn polygon(vertices: Vec<Vector>) -> Self {
        Self::new(vertices)
    }

    /// No builder: the engine makes no soft body.
    pub fn volumetric(
        _vertices: &[Vector],
        _indices: &[SurfaceElement],
        _cell_size: Real,
    ) -> Option<Self> {
        None
    }

    /// No builder: the engine makes no soft body.
    pub fn volumetric_skinned(
        _vertices: &[Vector],
        _indices: &[SurfaceElement],
        _cell_size: Real,
    ) -> Option<Self> {
        None
    }
}

/// The edges between all particles of each element, each once.
fn unique_edges<'a>(elements: impl Iterator<Item = &'a [u32]>) -> Vec<[u32; 2]> {
    let pairs = elements.flat_map(|element| {
        element.iter().enumerate().flat_map(move |(i, one)| {
            element[i + 1..].iter().map(move |other| [*one.min(other), *one.max(other)])
        })
    });
    let mut edges: Vec<_> = pairs.collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}
