//! `landform schema`.

use std::process::ExitCode;

use landform::core::Error;
use landform::recipe::schema;

use crate::show_error::Failure;

pub(crate) fn run() -> Result<ExitCode, Failure> {
    let text = serde_json::to_string_pretty(&schema()).map_err(|e| Error::format("JSON", e))?;
    say!("{text}");
    Ok(ExitCode::SUCCESS)
}
