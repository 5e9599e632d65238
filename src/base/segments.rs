//! Closest points of two segments (Ericson 2005, "Real-Time Collision Detection", section 5.1.9).

use parry::math::{Real, Vector};

/// Two segments as the products that their nearest points depend on.
#[derive(Copy, Clone, Debug)]
pub struct Segments {
    /// `along1 · along1`, `along1 · along2`, `along2 · along2`.
    pub products: [Real; 3],
    /// `along1` and `along2` times the vector from the start of the second to that of the first.
    pub offsets: [Real; 2],
}

impl Segments {
    /// Two segments, given by their starts and directions.
    pub fn new([start1, start2]: [Vector; 2], [along1, along2]: [Vector; 2]) -> Self {
        let offset = start1 - start2;
        Self {
            products: [along1.dot(along1), along1.dot(along2), along2.dot(along2)],
            offsets: [along1.dot(offset), along2.dot(offset)],
        }
    }

    /// The point on the first that is nearest to one on the second, both as fractions of the lengths.
    pub fn on_first(&self, fraction2: Real) -> Real {
        let ([a, b, _], [d, _]) = (self.products, self.offsets);
        clamped(b * fraction2 - d, a)
    }

    /// The place on the second that is nearest to one on the first.
    pub fn on_second(&self, fraction1: Real) -> Real {
        let ([_, b, c], [_, e]) = (self.products, self.offsets);
        clamped(b * fraction1 + e, c)
    }

    /// The point of the first that is nearest to the line of the second, if they are not parallel.
    pub fn crossing(&self) -> Real {
        let ([a, b, c], [d, e]) = (self.products, self.offsets);
        clamped(b * e - c * d, a * c - b * b)
    }

    /// The nearest places, searched from one on the first.
    pub fn nearest_from(&self, fraction1: Real) -> [Real; 2] {
        // Each fraction in turn is optimal for the other; twice, because the first was not clamped yet.
        let fraction1 = self.on_first(self.on_second(fraction1));
        [fraction1, self.on_second(fraction1)]
    }
}

fn clamped(x: Real, length_squared: Real) -> Real {
    if length_squared > 0.0 { (x / length_squared).clamp(0.0, 1.0) } else { 0.0 }
}
