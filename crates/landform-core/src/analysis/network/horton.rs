//! Orders of streams and Horton's ratios.
//!
//! # Method
//! A stream is a chain of one order; its length counts the step into the next stream, its area is
//! that of its last node. A ratio is ten to the amount of the slope of the logarithm of number,
//! mean length or mean area on order, from three orders on.
//!
//! # Sources
//! Horton (1945); Strahler (1957). Kirchner (1993): almost any network has such ratios, random ones
//! too; they distinguish no kinds of network.

use serde::{Deserialize, Serialize};

use crate::algo::network::strahler;
use crate::analysis::Drainage;
use crate::grid::{Domain, Status};
use crate::math;

/// Orders and ratios.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Horton {
    /// Greatest Strahler order; 0 without channels.
    pub order: u32,
    /// Greatest Shreve magnitude: number of heads upstream.
    pub magnitude: u32,
    /// Per order from 1: number of streams, mean length in m, mean drainage area in m².
    pub streams: Vec<(usize, f64, f64)>,
    /// Bifurcation ratio.
    pub bifurcation: f64,
    /// Length ratio.
    pub length: f64,
    /// Area ratio.
    pub area: f64,
}

/// Streams of all nodes that drain at least `least` m². **Cost** O(n).
pub fn horton<D: Domain>(drainage: &Drainage<D>, least: f64) -> Horton {
    let status = drainage.domain.status();
    let is_channel = |i: usize| drainage.area[i] >= least && status[i] != Status::Masked;
    let order = strahler(&drainage.flow, is_channel);
    let mut streams: Vec<(usize, f64, f64)> = Vec::new();
    let mut magnitude = vec![0u32; order.len()];
    for &i in drainage.flow.order() {
        let i = i as usize;
        if !is_channel(i) {
            continue;
        }
        let r = drainage.flow.receivers()[i] as usize;
        magnitude[i] = magnitude[i].max(1);
        let k = order[i] as usize;
        if streams.len() < k {
            streams.resize(k, (0, 0.0, 0.0));
        }
        let stream = &mut streams[k - 1];
        if r != i {
            magnitude[r] += magnitude[i];
            stream.1 += drainage.domain.distance(i, drainage.flow.slots()[i]);
        }
        if r == i || order[r] > order[i] {
            stream.0 += 1;
            stream.2 += drainage.area[i];
        }
    }
    for s in &mut streams {
        let count = s.0.max(1) as f64;
        (s.1, s.2) = (s.1 / count, s.2 / count);
    }
    let ratio = |f: &dyn Fn(&(usize, f64, f64)) -> f64| {
        if streams.len() < 3 {
            return f64::NAN;
        }
        let points = streams.iter().enumerate().map(|(k, s)| (k as f64, math::log10(f(s))));
        math::pow(10.0, math::line_fit(points.collect::<Vec<_>>().into_iter()).0.abs())
    };
    Horton {
        order: streams.len() as u32,
        magnitude: magnitude.into_iter().max().unwrap_or(0),
        bifurcation: ratio(&|s| s.0 as f64),
        length: ratio(&|s| s.1),
        area: ratio(&|s| s.2),
        streams,
    }
}
