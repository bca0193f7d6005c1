//! Vectors of three numbers: x east, y north, z up.

pub(crate) type Vector = [f64; 3];

pub(crate) fn along(from: Vector, direction: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|k| from[k] + t * direction[k])
}

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + b[k])
}

pub(crate) fn sub(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn normalize(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    if length > 0.0 { v.map(|x| x * (1.0 / length)) } else { v }
}
