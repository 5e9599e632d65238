//! The distribution of a mass over shapes that have none.
//!
//! A density gives no mass to shapes without volume. A mass that is set for such shapes, or for a body that
//! has no others, is distributed evenly. It covers their surface, or their length where they have no surface.
//! Without that rule the body would have no angular inertia, and no impulse could rotate it.

use super::mass::volume_properties;
use super::{Collider, ColliderMassProps};
use crate::dim::mass::{
    SecondMoment, mass_from_moments, mass_is_valid, second_moment, thickened, total_mass,
};
use crate::dim::math::{Pose, Real, Vector};
use crate::dim::shapes;
use parry::mass_properties::MassProperties;
use parry::shape::{Shape, SharedShape, TypedShape};

/// A line has this fraction of its second moment along each axis, like a rod of 1/20 of its length. An
/// inertia of zero about itself would be ill-conditioned once it is rotated and summed.
const ROD_FRACTION: Real = 1.0e-3;

/// A triangle with a smaller height than this fraction of its longest side counts as a line.
const TRIANGLE_HEIGHT_FRACTION_MIN: Real = 1.0e-6;

/// The geometry over which a mass is distributed, in rising order. Only the elements of the highest rank
/// carry mass.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
enum Rank {
    Length,
    Surface,
    Volume,
}

/// A mass distribution of unit density over some shapes.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct MassSpread {
    /// Whether the shapes have a positive density, so that they give mass to a body that has none.
    has_density: bool,
    rank: Rank,
    properties: MassProperties,
}

impl MassSpread {
    /// The distribution over a shape; `None` if it is infinite or too large or small for the number type.
    pub fn over(shape: &dyn Shape) -> Option<Self> {
        let volume = volume_properties(shape, 1.0);
        let (rank, properties) = if volume.inv_mass > 0.0 {
            (Rank::Volume, volume)
        } else {
            match shape.as_typed_shape() {
                TypedShape::Compound(compound) => {
                    let posed = |(pose, part): &(Pose, SharedShape)| {
                        Self::over(&**part).map(|spread| spread.at(pose))
                    };
                    return compound.shapes().iter().filter_map(posed).reduce(Self::and);
                }
                TypedShape::Custom(custom) => (Rank::Volume, box_properties(custom)),
                typed => over_elements(typed)?,
            }
        };
        let is_usable = properties.inv_mass > 0.0 && mass_is_valid(&properties);
        is_usable.then_some(Self { has_density: false, rank, properties })
    }

    /// The distribution over an enabled collider without mass, in the frame of its body. Its own density
    /// scales it.
    pub fn over_collider(collider: &Collider) -> Option<Self> {
        let pose = collider.position_wrt_parent()?;
        let mut spread = Self::over(collider.shape())?.at(pose);
        if let ColliderMassProps::Density(density) = collider.mass_props
            && density > 0.0
        {
            let mass = density * spread.properties.mass();
            spread.properties.set_mass(mass, true);
            spread.has_density = mass_is_valid(&spread.properties);
        }
        (spread.properties.inv_mass > 0.0).then_some(spread)
    }

    /// Both together: a density outweighs none, and then the higher rank the lower.
    pub fn and(self, other: Self) -> Self {
        let order = |spread: &Self| (spread.has_density, spread.rank);
        match order(&self).cmp(&order(&other)) {
            core::cmp::Ordering::Less => other,
            core::cmp::Ordering::Greater => self,
            core::cmp::Ordering::Equal => {
                Self { properties: total_mass(&[self.properties, other.properties]), ..self }
            }
        }
    }

    /// The distribution scaled to a mass.
    pub fn scaled_to(&self, mass: Real) -> MassProperties {
        let mut properties = self.properties;
        properties.set_mass(mass, true);
        properties
    }

    /// Returns whether all numbers can be computed with.
    pub fn is_valid(&self) -> bool {
        mass_is_valid(&self.properties)
    }

    /// The mass that the densities give; `None` if all are zero.
    pub fn density_mass(&self) -> Option<MassProperties> {
        self.has_density.then_some(self.properties)
    }

    fn at(self, pose: &Pose) -> Self {
        Self { properties: self.properties.transform_by(pose), ..self }
    }
}

/// A user-defined shape without mass counts as its box.
fn box_properties(shape: &dyn Shape) -> MassProperties {
    let aabb = shape.compute_local_aabb();
    let solid = MassProperties::from_cuboid(1.0, aabb.half_extents());
    MassProperties { local_com: aabb.center(), ..solid }
}

fn over_elements(shape: TypedShape<'_>) -> Option<(Rank, MassProperties)> {
    let mut surface = Moments::default();
    let mut length = Moments::default();
    match shape {
        TypedShape::Segment(segment) => length.add(&[segment.a, segment.b]),
        TypedShape::Capsule(capsule) => length.add(&[capsule.segment.a, capsule.segment.b]),
        TypedShape::Polyline(line) => line.segments().for_each(|s| length.add(&[s.a, s.b])),
        other => shapes::for_each_element(other, |corners| match *corners {
            [a, b, c] => match line_of([a, b, c]) {
                Some(line) => length.add(&line),
                None => surface.add(corners),
            },
            _ => length.add(corners),
        }),
    }
    let surface = surface.properties(0.0).map(|properties| (Rank::Surface, properties));
    surface.or_else(|| Some((Rank::Length, length.properties(ROD_FRACTION)?)))
}

/// The longest side of a triangle that is so flat that it counts as a line.
fn line_of([a, b, c]: [Vector; 3]) -> Option<[Vector; 2]> {
    let sides = [[a, b], [b, c], [c, a]];
    let [from, to] =
        sides.into_iter().max_by(|p, q| measure(p).total_cmp(&measure(q))).unwrap_or([a, b]);
    let length = measure(&[from, to]);
    (measure(&[a, b, c]) <= 0.5 * TRIANGLE_HEIGHT_FRACTION_MIN * length * length)
        .then_some([from, to])
}

/// The moments of a mass distribution of unit density over segments or triangles.
#[derive(Default)]
struct Moments {
    /// The first corner. Moments about it keep their digits far from the frame's origin.
    origin: Option<Vector>,
    mass: Real,
    first: Vector,
    second: SecondMoment,
}

impl Moments {
    /// Adds a segment or a triangle.
    ///
    /// About the origin, let `s` be the sum of the `n` corners of a simplex with measure `m`. Its first
    /// moment is `m s / n`, its second moment `m / (n (n + 1)) (Σ c cᵀ + s sᵀ)`.
    fn add(&mut self, corners: &[Vector]) {
        let origin = *self.origin.get_or_insert(corners[0]);
        let measure = measure(corners);
        let count = corners.len() as Real;
        let offsets = corners.iter().map(|corner| *corner - origin);
        let sum = offsets.clone().sum::<Vector>();
        let squares = offsets.fold(second_moment(sum), |total, r| total + second_moment(r));
        self.mass += measure;
        self.first += sum * (measure / count);
        self.second += squares * (measure / (count * (count + 1.0)));
    }

    fn properties(&self, fraction: Real) -> Option<MassProperties> {
        let origin = self.origin.filter(|_| self.mass > 0.0)?;
        let com = self.first / self.mass;
        let about_com = self.second - second_moment(com) * self.mass;
        Some(mass_from_moments(origin + com, self.mass, thickened(about_com, fraction)))
    }
}

/// The length of a segment, or the area of a triangle: half of base times height.
fn measure(corners: &[Vector]) -> Real {
    let along = corners[1] - corners[0];
    match corners.get(2) {
        None => along.length(),
        Some(third) => {
            let direction = along.normalize_or_zero();
            let other = *third - corners[0];
            0.5 * along.length() * (other - direction * other.dot(direction)).length()
        }
    }
}
