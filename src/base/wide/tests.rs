//! Every register type gives the bits of the scalar formulas. Transposition is checked, too.

use super::{Kernel, LANES, Lane, Simd, Wide, gather, portable, scatter};
use parry::math::Real;

type Portable = portable::Array<Real, LANES>;

/// Runs a kernel on every register that this machine has.
fn run_on_all<K: Kernel>(kernel: impl Fn() -> K) -> Vec<(&'static str, K::Output)> {
    vec![
        ("portable", kernel().run::<Portable>()),
        ("baseline", Simd::baseline().run(kernel())),
        ("detected", Simd::detect().run(kernel())),
    ]
}

/// The scalar form of an operation. NaN of an arithmetic operation may be any NaN.
struct Operation {
    name: &'static str,
    arithmetic: bool,
    formula: fn(Real, Real) -> Real,
}

const fn arithmetic(name: &'static str, formula: fn(Real, Real) -> Real) -> Operation {
    Operation { name, arithmetic: true, formula }
}

const fn choice(name: &'static str, formula: fn(Real, Real) -> Real) -> Operation {
    Operation { name, arithmetic: false, formula }
}

/// In the order in which [`AllOperations`] gives its results.
const OPERATIONS: [Operation; 13] = [
    arithmetic("add", |a, b| a + b),
    arithmetic("sub", |a, b| a - b),
    arithmetic("mul", |a, b| a * b),
    arithmetic("div", |a, b| a / b),
    arithmetic("sqrt", |a, _| a.sqrt()),
    // The two roundings must not become one.
    arithmetic("multiply and add", |a, b| a * b + a),
    choice("neg", |a, _| -a),
    choice("abs", |a, _| a.abs()),
    choice("min", |a, b| if a < b { a } else { b }),
    choice("max", |a, b| if a > b { a } else { b }),
    choice("lt", |a, b| if a < b { b } else { a }),
    choice("le", |a, b| if a <= b { b } else { a }),
    choice("masks", |a, b| if (a < b && b <= 1.0) || b < a { b } else { a }),
];

struct AllOperations<'a> {
    a: &'a [Lane],
    b: &'a [Lane],
}

impl Kernel for AllOperations<'_> {
    type Output = Vec<[Lane; OPERATIONS.len()]>;

    #[inline(always)]
    fn run<W: Wide>(self) -> Self::Output {
        let mut results = vec![[Lane::ZERO; OPERATIONS.len()]; self.a.len()];
        for ((a, b), result) in self.a.iter().zip(self.b).zip(&mut results) {
            let (a, b) = (W::load(a), W::load(b));
            let masks = (a.lt(b) & b.le(W::splat(1.0))) | b.lt(a);
            let values = [
                a + b,
                a - b,
                a * b,
                a / b,
                a.sqrt(),
                a * b + a,
                -a,
                a.abs(),
                a.min(b),
                a.max(b),
                W::select(a.lt(b), b, a),
                W::select(a.le(b), b, a),
                W::select(masks, b, a),
            ];
            for (value, lane) in values.into_iter().zip(result) {
                value.store(lane);
            }
        }
        results
    }
}

/// Critical numbers, then numbers of all sizes and bit patterns.
fn numbers() -> Vec<Real> {
    let mut numbers = vec![0.0, 1.0, 3.0, 0.1, 1.0e20, 1.0e-20];
    numbers.extend([Real::MAX, Real::MIN_POSITIVE, Real::EPSILON, Real::INFINITY, Real::NAN]);
    numbers.extend([Real::from_bits(1), Real::from_bits(Real::NAN.to_bits() | 5)]);
    numbers.extend([Real::MIN_POSITIVE / 3.0, 1.0 + Real::EPSILON, 1.0 - Real::EPSILON]);
    numbers.extend(numbers.clone().iter().map(|x| -x));
    let mut state = 1_u64;
    for count in 0..200 {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let scale = if count % 2 == 0 { 1.0 } else { 1.0e6 };
        numbers.push(((state >> 11) as Real / (1_u64 << 53) as Real - 0.5) * scale);
        numbers.push(Real::from_bits((state >> (64 - 8 * size_of::<Real>())) as _));
    }
    numbers
}

fn in_lanes(numbers: impl Iterator<Item = Real>) -> Vec<Lane> {
    let numbers: Vec<Real> = numbers.collect();
    let lanes = numbers.chunks(LANES).map(|chunk| {
        Lane(core::array::from_fn(|lane| chunk.get(lane).copied().unwrap_or_default()))
    });
    lanes.collect()
}

#[test]
fn registers_agree_with_the_formulas_bit_for_bit() {
    let numbers = numbers();
    let pairs = || numbers.iter().flat_map(|&a| numbers.iter().map(move |&b| (a, b)));
    let a = in_lanes(pairs().map(|pair| pair.0));
    let b = in_lanes(pairs().map(|pair| pair.1));
    for (registers, results) in run_on_all(|| AllOperations { a: &a, b: &b }) {
        for (index, (x, y)) in pairs().enumerate() {
            for (operation, lane) in OPERATIONS.iter().zip(&results[index / LANES]) {
                let (expected, found) = ((operation.formula)(x, y), lane.0[index % LANES]);
                let any_nan = operation.arithmetic && expected.is_nan() && found.is_nan();
                assert!(
                    any_nan || expected.to_bits() == found.to_bits(),
                    "{registers}: {} of {x:e} and {y:e} is {expected:e}, but here {found:e}",
                    operation.name,
                );
            }
        }
    }
}

struct AnyBelow(Lane, Real);

impl Kernel for AnyBelow {
    type Output = (bool, u32);
    #[inline(always)]
    fn run<W: Wide>(self) -> (bool, u32) {
        let mask = W::load(&self.0).lt(W::splat(self.1));
        (W::any(mask), W::bits(mask))
    }
}

#[test]
fn any_finds_a_yes_in_each_lane() {
    for lane in 0..LANES {
        let mut numbers = Lane::splat(2.0);
        numbers.0[lane] = 1.0;
        for (registers, (found, bits)) in run_on_all(|| AnyBelow(numbers, 1.5)) {
            assert!(found && bits == 1 << lane, "{registers} misses lane {lane}");
        }
        for (registers, (found, bits)) in run_on_all(|| AnyBelow(numbers, 1.0)) {
            assert!(!found && bits == 0, "{registers}: a false hit");
        }
        for (registers, (_, bits)) in run_on_all(|| AnyBelow(numbers, 3.0)) {
            assert_eq!(bits, (1 << LANES) - 1, "{registers}");
        }
    }
}

/// Adds to each component of the records its own number and writes them back.
struct AddToRecords<'a, const N: usize> {
    records: &'a mut [[Real; N]],
    /// The record of each lane; every record at most once.
    lanes: [Option<usize>; LANES],
}

impl<const N: usize> Kernel for AddToRecords<'_, N> {
    /// The content of register `k` when the records were read.
    type Output = [Lane; N];

    #[inline(always)]
    fn run<W: Wide>(self) -> Self::Output {
        let nothing = [0.0; N];
        let sources = self.lanes.map(|lane| lane.map_or(&nothing, |index| &self.records[index]));
        let mut components = gather::<W, N>(sources);
        let mut found = [Lane::ZERO; N];
        for k in 0..N {
            components[k].store(&mut found[k]);
            components[k] = components[k] + W::splat(1000.0 * (k + 1) as Real);
        }
        let mut targets = [const { None }; LANES];
        for (index, record) in self.records.iter_mut().enumerate() {
            if let Some(lane) = self.lanes.iter().position(|&lane| lane == Some(index)) {
                targets[lane] = Some(record);
            }
        }
        scatter(components, targets);
        found
    }
}

fn check_records<const N: usize>() {
    let before: Vec<[Real; N]> =
        (0..2 * LANES).map(|record| core::array::from_fn(|k| (N * record + k) as Real)).collect();
    // Each other record, last one first, and nothing for lane 2.
    let lanes = core::array::from_fn(|lane| (lane != 2).then_some(2 * LANES - 1 - 2 * lane));
    let runs = [
        |k: AddToRecords<N>| k.run::<Portable>(),
        |k: AddToRecords<N>| Simd::baseline().run(k),
        |k: AddToRecords<N>| Simd::detect().run(k),
    ];
    for run in runs {
        let mut after = before.clone();
        let found = run(AddToRecords { records: &mut after, lanes });
        for (lane, record) in lanes.iter().enumerate() {
            for k in 0..N {
                let expected = record.map_or(0.0, |index| before[index][k]);
                assert_eq!(found[k].0[lane], expected, "component {k} of lane {lane}");
            }
        }
        for (index, record) in after.iter().enumerate() {
            let added = if lanes.contains(&Some(index)) { 1000.0 } else { 0.0 };
            for k in 0..N {
                assert_eq!(record[k], before[index][k] + added * (k + 1) as Real);
            }
        }
    }
}

#[test]
fn records_come_back_from_the_registers_where_they_belong() {
    check_records::<8>();
    check_records::<16>();
    check_records::<24>();
}
