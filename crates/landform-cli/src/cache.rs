//! `landform cache`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::str::FromStr;
use std::time::{Duration, SystemTime};

use landform::core::Result;
use landform::core::error::bytes_text;
use landform::recipe::Cache;

use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Output folder of the runs.
    #[arg(default_value = "out")]
    output: PathBuf,
    /// Removes all terrains.
    #[arg(long)]
    clear: bool,
    /// Removes the least recently used terrains, down to this size.
    #[arg(long, value_name = "SIZE", conflicts_with = "clear")]
    limit: Option<Size>,
}

/// A size such as "500 MiB" or "2 GB".
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size(u64);

impl Size {
    pub(crate) fn bytes(self) -> u64 {
        self.0
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let end = text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
        let factor = match text[end..].trim().to_ascii_lowercase().as_str() {
            "" | "b" => 1.0,
            "kb" => 1e3,
            "mb" => 1e6,
            "gb" => 1e9,
            "tb" => 1e12,
            "kib" | "k" => 1024.0,
            "mib" | "m" => 1024.0 * 1024.0,
            "gib" | "g" => 1024.0 * 1024.0 * 1024.0,
            "tib" | "t" => 1024.0 * 1024.0 * 1024.0 * 1024.0,
            unit => return Err(format!("`{unit}` is no unit of size; write 500 MiB or 2 GB")),
        };
        match text[..end].parse::<f64>() {
            Ok(number) if number * factor < 1e18 => Ok(Self((number * factor) as u64)),
            _ => Err("write a size such as 500 MiB or 2 GB".into()),
        }
    }
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let cache = Cache::on_disk(&args.output.join(".landform/cache"));
    if args.clear {
        say!("removed {}", bytes_text(cache.clear()?));
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(limit) = args.limit {
        let freed = cache.with_limit(limit.bytes()).trim();
        say!("removed {}", bytes_text(freed));
        return Ok(ExitCode::SUCCESS);
    }
    let kept = cache.kept()?;
    for item in &kept {
        let age = SystemTime::now().duration_since(item.used).unwrap_or_default();
        let stage = item.stage.as_deref().unwrap_or("(cannot be read)");
        say!("{:<32}  {:>10}  used {} ago", stage, bytes_text(item.bytes), age_text(age));
    }
    let total = kept.iter().map(|item| item.bytes).sum();
    let terrains = if kept.len() == 1 { "terrain" } else { "terrains" };
    say!("{} {terrains}, {}", kept.len(), bytes_text(total));
    Ok(ExitCode::SUCCESS)
}

fn age_text(age: Duration) -> String {
    match age.as_secs() {
        s @ ..120 => format!("{s} s"),
        s @ 120..7_200 => format!("{} min", s / 60),
        s @ 7_200..172_800 => format!("{} h", s / 3_600),
        s => format!("{} days", s / 86_400),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read() {
        let read = |text: &str| text.parse::<Size>().map(Size::bytes);
        assert_eq!(read("4 GiB"), Ok(4 << 30));
        assert_eq!(read("1.5kB"), Ok(1_500));
        assert_eq!(read("0"), Ok(0));
        assert!(read("4 miles").is_err() && read("GiB").is_err() && read("-1 MB").is_err());
    }
}
