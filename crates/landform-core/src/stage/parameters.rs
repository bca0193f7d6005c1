//! Parameters of a type that only their stage knows.

use std::any::Any;
use std::sync::Arc;

use serde_json::Value as Json;

use crate::verb::{Params, Reach};
use crate::{Error, Result};

/// Why parameters were refused.
#[derive(Debug)]
pub enum Refusal {
    /// By their shape, at a path.
    Shape(serde_path_to_error::Error<serde_json::Error>),
    /// By their value.
    Value(Error),
}

/// Parameters of a type that only their stage knows.
#[derive(Clone)]
pub(super) struct Parameters {
    pub(super) value: Arc<dyn Any + Send + Sync>,
    pub(super) normal: Json,
    pub(super) outputs: Vec<String>,
    pub(super) leaves: Vec<String>,
    pub(super) reach: Reach,
    pub(super) jitters: bool,
    pub(super) bytes_a_node: Option<u64>,
    pub(super) places: Vec<(&'static str, [f64; 2])>,
}

impl Parameters {
    pub(super) fn new<P: Params>(params: P) -> Result<Self> {
        let normal = serde_json::to_value(&params).map_err(|e| Error::format("parameters", e))?;
        let (outputs, leaves) = (params.outputs(), params.leaves());
        let (reach, jitters, places) = (params.reach(), params.jitters(), params.places());
        let bytes_a_node = params.bytes_a_node();
        Ok(Self { value: Arc::new(params), normal, outputs, leaves, reach, jitters, bytes_a_node, places })
    }
}

/// Parameters as what they are.
pub(super) fn typed<P: 'static>(params: &dyn Any) -> Result<&P> {
    let wrong = || Error::Recipe { at: None, what: "parameters of another stage".into(), hint: None };
    params.downcast_ref::<P>().ok_or_else(wrong)
}
