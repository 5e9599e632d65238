//! Mass properties of composite bodies, in 3D.
//!
//! parry can add mass properties too, but finds the principal axes by the trigonometric formula. The last
//! bits of its sines and cosines differ between machines, and nearly equal moments cost it half of the
//! digits. Jacobi's rotations need square roots alone and are accurate to the last few bits.

use crate::base::measure::is_point;
use crate::dim::math::{AngVector, Matrix, Real, Rotation, Vector, rotation_is_valid};
use parry::mass_properties::MassProperties;

/// Sweeps of Jacobi's method. It converges quadratically: three or four do in either precision.
const ITERATIONS_MAX: usize = 8;

/// The mass properties of a body without mass.
pub fn no_mass() -> MassProperties {
    MassProperties {
        local_com: Vector::ZERO,
        inv_mass: 0.0,
        inv_principal_inertia: AngVector::ZERO,
        principal_inertia_local_frame: Rotation::IDENTITY,
    }
}

/// Second moments of a mass about a point: the tensor `∫ r rᵀ dm`.
pub type SecondMoment = Matrix;

/// The second moment of a unit mass at `r`.
pub fn second_moment(r: Vector) -> SecondMoment {
    Matrix::from_cols(r * r.x, r * r.y, r * r.z)
}

/// The sum of `moment` and a spherical distribution with `fraction` of its trace along each axis.
pub fn thickened(moment: SecondMoment, fraction: Real) -> SecondMoment {
    let trace = moment.x_axis.x + moment.y_axis.y + moment.z_axis.z;
    moment + Matrix::from_diagonal(Vector::splat(fraction * trace))
}

/// The lesser moment of a distribution in a plane.
pub fn narrow_moment(moment: SecondMoment) -> Real {
    let [x, y, z] = [moment.x_axis, moment.y_axis, moment.z_axis];
    let trace = x.x + y.y + z.z;
    // One principal moment is zero, so the principal minors add up to the product of the others.
    let product = (x.x * y.y - x.y * y.x) + (y.y * z.z - y.z * z.y) + (z.z * x.x - z.x * x.z);
    let difference = (trace * trace - 4.0 * product).max(0.0).sqrt();
    (0.5 * (trace - difference)).max(0.0)
}

/// Mass properties from a mass, its centre, and its second moments about the centre.
///
/// The inertia tensor is `tr(S) 1 − S`.
pub fn mass_from_moments(com: Vector, mass: Real, second: SecondMoment) -> MassProperties {
    let trace = second.x_axis.x + second.y_axis.y + second.z_axis.z;
    let inertia = Matrix::from_diagonal(Vector::splat(trace)) - second;
    let (moments, axes) = principal_axes(inertia);
    let frame = Rotation::from_mat3(&axes).normalize();
    MassProperties::with_principal_inertia_frame(com, mass, moments.max(Vector::ZERO), frame)
}

/// Returns whether all values and stored inverses are finite, and none is negative where that is impossible.
pub fn mass_is_valid(mass: &MassProperties) -> bool {
    is_point(mass.local_com)
        && mass.inv_mass >= 0.0
        && mass.inv_mass.is_finite()
        && mass.mass().is_finite()
        && mass.inv_principal_inertia.min_element() >= 0.0
        && mass.inv_principal_inertia.is_finite()
        && mass.principal_inertia().is_finite()
        && rotation_is_valid(&mass.principal_inertia_local_frame)
}

/// The inverse of the smallest principal moment of inertia; zero without one.
pub fn largest_inverse_moment(mass: &MassProperties) -> Real {
    mass.inv_principal_inertia.max_element()
}

/// The mass properties of all parts together. All of them in one frame.
pub fn total_mass(parts: &[MassProperties]) -> MassProperties {
    if let [only] = parts {
        return *only;
    }
    let mass: Real = parts.iter().map(MassProperties::mass).sum();
    let moment: Vector = parts.iter().map(|part| part.local_com * part.mass()).sum();
    let com = if mass > 0.0 { moment / mass } else { Vector::ZERO };
    let inertia = parts.iter().fold(Matrix::ZERO, |sum, part| sum + inertia_about(part, com));
    let (moments, axes) = principal_axes(inertia);
    let frame = Rotation::from_mat3(&axes).normalize();
    MassProperties::with_principal_inertia_frame(com, mass, moments.max(Vector::ZERO), frame)
}

/// The inertia tensor about `center`, by the parallel axis theorem: `I + m (|d|² 1 - d dᵀ)`.
fn inertia_about(part: &MassProperties, center: Vector) -> Matrix {
    let d = center - part.local_com;
    let outer = Matrix::from_cols(d * d.x, d * d.y, d * d.z);
    let shift = Matrix::from_diagonal(Vector::splat(d.length_squared())) - outer;
    part.reconstruct_inertia_matrix() + shift * part.mass()
}

/// Eigenvalues of a symmetric matrix, and a right-handed set of unit eigenvectors (the columns).
///
/// The cyclic Jacobi method (Golub and Van Loan, "Matrix Computations", section 8.5): each rotation
/// clears one off-diagonal element. A diagonal matrix comes back as it is.
pub(crate) fn principal_axes(matrix: Matrix) -> (Vector, Matrix) {
    let (mut a, mut axes) = (matrix, Matrix::IDENTITY);
    for _ in 0..ITERATIONS_MAX {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let apq = a.col(q)[p];
            if apq == 0.0 {
                continue;
            }
            let (cos, sin) = clearing_rotation(a.col(p)[p], a.col(q)[q], apq);
            // a ← Jᵀ a J. The matrix is symmetric, so its rows are the columns of its transpose.
            rotate_columns(&mut a, p, q, cos, sin);
            a = a.transpose();
            rotate_columns(&mut a, p, q, cos, sin);
            (a.col_mut(q)[p], a.col_mut(p)[q]) = (0.0, 0.0);
            rotate_columns(&mut axes, p, q, cos, sin);
        }
    }
    (Vector::new(a.x_axis.x, a.y_axis.y, a.z_axis.z), axes)
}

/// Cosine and sine of the smaller angle that clears the off-diagonal element of
/// `[[app, apq], [apq, aqq]]`.
fn clearing_rotation(app: Real, aqq: Real, apq: Real) -> (Real, Real) {
    let theta = (aqq - app) / (2.0 * apq);
    let tan = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cos = 1.0 / (tan * tan + 1.0).sqrt();
    (cos, tan * cos)
}

/// `m ← m J` for the rotation `J` in the plane of the axes `p` and `q`.
fn rotate_columns(m: &mut Matrix, p: usize, q: usize, cos: Real, sin: Real) {
    let (column_p, column_q) = (m.col(p), m.col(q));
    *m.col_mut(p) = column_p * cos - column_q * sin;
    *m.col_mut(q) = column_p * sin + column_q * cos;
}

/// The angular momentum about the centre of mass (mass·length²/s) of a body with the world-space
/// angular velocity `angvel` (rad/s).
pub fn angular_momentum(mass: &MassProperties, rotation: Rotation, angvel: AngVector) -> AngVector {
    let to_world = rotation * mass.principal_inertia_local_frame;
    to_world * (mass.principal_inertia() * (to_world.inverse() * angvel))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dim::math::Pose;
    use parry::shape::{Cuboid, Shape};

    #[test]
    fn three_cubes_in_a_row_weigh_as_much_as_one_long_box() {
        let cube = Cuboid::new(Vector::splat(0.5)).mass_properties(2.0);
        let rotvec = Pose::rotation(Vector::new(0.4, 0.1, -1.1));
        let place = |y| cube.transform_by(&(rotvec * Pose::translation(0.0, y, 0.0)));
        let total = total_mass(&[place(-1.0), place(0.0), place(1.0)]);
        let whole =
            Cuboid::new(Vector::new(0.5, 1.5, 0.5)).mass_properties(2.0).transform_by(&rotvec);
        let angvel = Vector::new(1.0, 2.0, -3.0);
        let momentum = |mass| angular_momentum(mass, Rotation::IDENTITY, angvel);
        assert!((total.mass() - 6.0).abs() < 1.0e-5);
        assert!(total.local_com.length() < 1.0e-6);
        assert!(momentum(&total).abs_diff_eq(momentum(&whole), 1.0e-4));
        assert!(mass_is_valid(&total));
    }

    #[test]
    fn principal_axes_rebuild_the_matrix() {
        let columns = [[4.0, 1.0, -2.0], [1.0, 3.0, 0.5], [-2.0, 0.5, 6.0]];
        let matrix = Matrix::from_cols_array_2d(&columns);
        let (moments, axes) = principal_axes(matrix);
        let rebuilt = axes * Matrix::from_diagonal(moments) * axes.transpose();
        assert!(rebuilt.abs_diff_eq(matrix, 1.0e-5), "{rebuilt}");
        assert!((axes.determinant() - 1.0).abs() < 1.0e-5);
    }

    #[test]
    fn principal_axes_of_a_diagonal_matrix_are_those_of_the_frame() {
        let moments = Vector::new(3.0, 1.0, 2.0);
        let found = principal_axes(Matrix::from_diagonal(moments));
        assert_eq!(found, (moments, Matrix::IDENTITY));
    }
}
