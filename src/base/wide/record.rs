//! Records of lanes: the functions of vectors, rotations and matrices that act on each component alone.
//!
//! Macros replace closures here, because a closure with a register argument is not inlined (see
//! [`Kernel`](super::Kernel)).

/// Reading and writing of a record with these components, and of one of its lanes.
macro_rules! record_of_lanes {
    ($record:ident of $single:ty { $($field:ident),+ }) => {
        impl $record<Lane> {
            /// Zero in every component of every lane.
            pub const ZERO: Self = Self { $($field: Lane::ZERO),+ };

            /// Sets the value of one lane.
            pub fn set_lane(&mut self, lane: usize, value: $single) {
                $(self.$field.0[lane] = value.$field;)+
            }
        }

        impl<W: Wide> $record<W> {
            /// Reads a value per lane from memory.
            #[inline(always)]
            pub fn load(from: &$record<Lane>) -> Self {
                Self { $($field: W::load(&from.$field)),+ }
            }

            /// Writes a value per lane to memory.
            #[inline(always)]
            pub fn store(self, to: &mut $record<Lane>) {
                $(self.$field.store(&mut to.$field);)+
            }
        }
    };
}

/// Arithmetic of a vector with these components. Sums over components begin with the first.
macro_rules! vector_of_lanes {
    ($vector:ident of $single:ident { $first:ident $(, $rest:ident)+ }) => {
        impl $vector<Lane> {
            /// The vector of one lane.
            pub fn lane(&self, lane: usize) -> $single {
                $single::new(self.$first.0[lane] $(, self.$rest.0[lane])+)
            }
        }

        impl<W: Wide> $vector<W> {
            /// The same vector in every lane.
            #[inline(always)]
            pub fn splat(value: $single) -> Self {
                Self { $first: W::splat(value.$first) $(, $rest: W::splat(value.$rest))+ }
            }

            /// The zero vector in every lane.
            #[inline(always)]
            pub fn zero() -> Self {
                Self { $first: W::zero() $(, $rest: W::zero())+ }
            }

            /// The dot product.
            #[inline(always)]
            pub fn dot(self, other: Self) -> W {
                self.$first * other.$first $(+ self.$rest * other.$rest)+
            }

            /// The product of each component with the same component of `other`.
            #[inline(always)]
            pub fn component_mul(self, other: Self) -> Self {
                Self { $first: self.$first * other.$first $(, $rest: self.$rest * other.$rest)+ }
            }

            /// The smaller of each component.
            #[inline(always)]
            pub fn min(self, other: Self) -> Self {
                Self {
                    $first: self.$first.min(other.$first) $(, $rest: self.$rest.min(other.$rest))+
                }
            }

            /// The larger of each component.
            #[inline(always)]
            pub fn max(self, other: Self) -> Self {
                Self {
                    $first: self.$first.max(other.$first) $(, $rest: self.$rest.max(other.$rest))+
                }
            }

            /// The vector, shortened to this length where it is longer, and one bit per lane where it is.
            #[inline(always)]
            pub fn clamped(self, length_max: Real) -> (Self, u32) {
                let square = self.dot(self);
                let is_longer = W::splat(length_max * length_max).lt(square);
                if !W::any(is_longer) {
                    return (self, 0);
                }
                let shortened = self * (W::splat(length_max) / square.sqrt());
                (Self::select(is_longer, shortened, self), W::bits(is_longer))
            }

            /// Returns whether no component is larger than that of the other.
            #[inline(always)]
            pub fn all_le(self, other: Self) -> W::Mask {
                self.$first.le(other.$first) $(& self.$rest.le(other.$rest))+
            }

            /// `yes` in the lanes where the mask is set, `no` in the others.
            #[inline(always)]
            pub fn select(mask: W::Mask, yes: Self, no: Self) -> Self {
                Self {
                    $first: W::select(mask, yes.$first, no.$first)
                    $(, $rest: W::select(mask, yes.$rest, no.$rest))+
                }
            }
        }

        impl<W: Wide> Add for $vector<W> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self { $first: self.$first + other.$first $(, $rest: self.$rest + other.$rest)+ }
            }
        }

        impl<W: Wide> Sub for $vector<W> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self { $first: self.$first - other.$first $(, $rest: self.$rest - other.$rest)+ }
            }
        }

        impl<W: Wide> Neg for $vector<W> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self { $first: -self.$first $(, $rest: -self.$rest)+ }
            }
        }

        impl<W: Wide> Mul<W> for $vector<W> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, factor: W) -> Self {
                Self { $first: self.$first * factor $(, $rest: self.$rest * factor)+ }
            }
        }
    };
}

pub(crate) use {record_of_lanes, vector_of_lanes};
