//! Outlines of shapes with notches.

use rapier::prelude::*;

/// Returns outlines with notches: a comb of 12 m² with its notches from 0.5 m up, an L, a U and a star.
pub fn outlines() -> Vec<(&'static str, Vec<[Real; 2]>)> {
    let mut comb = vec![[0.0, 0.0], [9.0, 0.0]];
    for k in (0..5_u8).rev() {
        let x = 2.0 * Real::from(k);
        comb.extend([[x + 1.0, 2.0], [x, 2.0]]);
        if k > 0 {
            comb.extend([[x, 0.5], [x - 1.0, 0.5]]);
        }
    }
    let star = (0..10_u8).map(|k| {
        let reach = if k % 2 == 0 { 2.0 } else { 0.8 };
        let (sine, cosine) = (0.1 * core::f64::consts::TAU as Real * Real::from(k)).sin_cos();
        [reach * cosine, reach * sine]
    });
    let l = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
    let u = [
        [2.0, 3.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 3.0],
        [0.0, 3.0],
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 3.0],
    ];
    vec![("comb", comb), ("L", l.to_vec()), ("U", u.to_vec()), ("star", star.collect())]
}

/// Returns the area of an outline.
pub fn area(outline: &[[Real; 2]]) -> Real {
    let next = |k: usize| outline[(k + 1) % outline.len()];
    let parts = outline.iter().enumerate().map(|(k, p)| p[0] * next(k)[1] - p[1] * next(k)[0]);
    0.5 * parts.sum::<Real>()
}
