//! Surface material: friction and restitution, and how those of two surfaces combine.

use crate::dim::math::Real;

/// Combination rule for the coefficients of two surfaces.
///
/// If the two surfaces have different rules, the one that comes later in this list applies.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum CoefficientCombineRule {
    /// The mean of both coefficients.
    #[default]
    Average = 0,
    /// The smaller coefficient: ice is slippery under any shoe.
    Min = 1,
    /// The product.
    Multiply = 2,
    /// The larger coefficient.
    Max = 3,
    /// The sum, at most 1.
    ClampedSum = 4,
    /// The square root of the product.
    #[cfg(not(feature = "upstream-032"))]
    GeometricMean = 5,
}

impl CoefficientCombineRule {
    /// The combined coefficient of two surfaces. It is symmetric in the surfaces.
    #[cfg(not(feature = "upstream-036"))]
    pub fn combine(coefficient1: Real, rule1: Self, coefficient2: Real, rule2: Self) -> Real {
        Self::combined(coefficient1, rule1, coefficient2, rule2)
    }

    pub(crate) fn combined(
        coefficient1: Real,
        rule1: Self,
        coefficient2: Real,
        rule2: Self,
    ) -> Real {
        let (a, b) = (coefficient1, coefficient2);
        match rule1.max(rule2) {
            Self::Average => 0.5 * (a + b),
            Self::Min => a.min(b),
            Self::Multiply => a * b,
            Self::Max => a.max(b),
            Self::ClampedSum => (a + b).min(1.0),
            #[cfg(not(feature = "upstream-032"))]
            Self::GeometricMean => (a * b).max(0.0).sqrt(),
        }
    }
}

/// Friction and restitution of a surface.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ColliderMaterial {
    /// Largest ratio of the tangential to the normal force, 0 (frictionless) or more; usually at
    /// most 1.
    pub friction: Real,
    /// Ratio of the speeds of separation and approach: 0 does not bounce, 1 keeps the speed, more than 1
    /// gains energy.
    pub restitution: Real,
    /// Combination rule for friction.
    pub friction_combine_rule: CoefficientCombineRule,
    /// Combination rule for restitution.
    pub restitution_combine_rule: CoefficientCombineRule,
}

impl ColliderMaterial {
    /// A surface with the given friction and restitution, both combined by averaging.
    pub const fn new(friction: Real, restitution: Real) -> Self {
        Self {
            friction,
            restitution,
            friction_combine_rule: CoefficientCombineRule::Average,
            restitution_combine_rule: CoefficientCombineRule::Average,
        }
    }
}

impl Default for ColliderMaterial {
    /// Friction 0.5, no restitution.
    fn default() -> Self {
        Self::new(0.5, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::CoefficientCombineRule as Rule;

    #[test]
    fn each_rule_has_its_named_formula() {
        let cases = [
            (Rule::Average, 0.5),
            (Rule::Min, 0.2),
            (Rule::Multiply, 0.2 * 0.8),
            (Rule::Max, 0.8),
            (Rule::ClampedSum, 1.0),
            (Rule::GeometricMean, 0.4),
        ];
        for (rule, expected) in cases {
            let combined = Rule::combine(0.2, rule, 0.8, rule);
            assert!((combined - expected).abs() < 1.0e-6, "{rule:?}: {combined}");
        }
        assert_eq!(Rule::combine(0.75, Rule::ClampedSum, 0.75, Rule::ClampedSum), 1.0);
        assert_eq!(Rule::combine(0.25, Rule::ClampedSum, 0.5, Rule::ClampedSum), 0.75);
    }

    #[test]
    fn the_rule_of_higher_rank_wins() {
        let rising = [
            Rule::Average,
            Rule::Min,
            Rule::Multiply,
            Rule::Max,
            Rule::ClampedSum,
            Rule::GeometricMean,
        ];
        for (rank, low) in rising.into_iter().enumerate() {
            for high in rising.into_iter().skip(rank) {
                let expected = Rule::combine(0.2, high, 0.8, high);
                assert_eq!(Rule::combine(0.2, low, 0.8, high), expected, "{low:?} {high:?}");
                assert_eq!(Rule::combine(0.2, high, 0.8, low), expected, "{high:?} {low:?}");
            }
        }
    }
}
