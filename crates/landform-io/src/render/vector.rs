//! Vectors of three numbers: x east, y north, z up.

use crate::render::colour::scale;

pub(super) type Vector = [f64; 3];

pub(super) fn along(from: Vector, direction: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|k| from[k] + t * direction[k])
}

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + b[k])
}

pub(super) fn sub(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn normalize(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    if length > 0.0 { scale(v, 1.0 / length) } else { v }
}
