//! Hostile values in every recipe of the gallery: each is refused or run, without a panic, a hang
//! or an endless step.
//!
//! Lines `key = value` of the recipes, made small, get values that no one should write. A few in
//! the tests; `cargo xtask validate` sets `LANDFORM_HOSTILE` to as many as it wants.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Duration;

use landform::core::Error;
use landform::core::random::{Draws, Seed};
use landform::core::verb::{CancelToken, MemoryOutput};
use landform::recipe::{GALLERY, Level, Options, Recipe};

/// Values tried in the tests.
const FEW: usize = 60;
/// A value that runs longer is cancelled, and must then end.
const LONGEST: Duration = Duration::from_secs(20);
const ENDS_WITHIN: Duration = Duration::from_secs(60);
/// What takes more memory is refused, as the program does with more than there is.
const MOST_BYTES: u64 = 1 << 30;
/// Values that are written in place of others.
const VALUES: &[&str] = &[
    "0",
    "-1",
    "1e308",
    "-1e308",
    "1e-308",
    "nan",
    "inf",
    "-inf",
    "18446744073709551616",
    "1e18",
    "0.5",
    "true",
    "\"\"",
    "[]",
    "{}",
    "\"1e308 m\"",
    "\"-5 m\"",
    "\"1e-300 m\"",
    "\"nan m\"",
    "\"3 parsecs\"",
    "\"1 kyr\"",
    "\"0 m/yr\"",
    "\"1e300 m/yr\"",
    "[\"1 m\"]",
    "[\"0 m\", \"0 m\"]",
    "[\"1e12 m\", \"1e12 m\"]",
    "{ formula = \"1/0\", unit = \"m\" }",
    "{ formula = \"x*\", unit = \"m\" }",
    "{ formula = \"log(-1)\" }",
    "{ image = \"missing.png\", black = 0.0, white = 1.0 }",
    "{ field = \"nothing\" }",
    "\"\\u0000\"",
    "\"../../x\"",
    "9999999999",
    "-9223372036854775808",
];

/// A recipe with a hostile value in one of its lines, and which.
fn hostile(draws: &mut Draws) -> (String, String) {
    let recipe = &GALLERY[draws.below(GALLERY.len())];
    let lines: Vec<&str> = recipe.text.lines().collect();
    let is_value =
        |l: &&str| l.contains(" = ") && !l.starts_with(['#', 't']) && !l.starts_with("use") && !l.starts_with("label");
    let places: Vec<usize> = (0..lines.len()).filter(|&k| is_value(&lines[k])).collect();
    let place = places[draws.below(places.len())];
    // The innermost of the line's values, or the whole.
    let starts: Vec<usize> = lines[place].match_indices(" = ").map(|m| m.0 + 3).collect();
    let start = starts[draws.below(starts.len())];
    let rest = &lines[place][start..];
    let end = match rest.as_bytes().first() {
        Some(b'"') => rest[1..].find('"').map_or(rest.len(), |k| k + 2),
        Some(b'[' | b'{') => rest.len(),
        _ => rest.find([',', ' ', '}', ']']).unwrap_or(rest.len()),
    };
    let value = VALUES[draws.below(VALUES.len())];
    let line = format!("{}{value}{}", &lines[place][..start], &rest[end..]);
    let all = lines.iter().enumerate().map(|(k, l)| if k == place { line.as_str() } else { l }).collect::<Vec<_>>();
    (all.join("\n"), format!("{}, line {}: {line}", recipe.name, place + 1))
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery")
}

/// Runs a recipe small; true if it was refused.
fn is_refused(text: &str, cancel: &CancelToken) -> bool {
    let run = || {
        let recipe = Recipe::parse(text, "hostile.toml", &folder(), &[])?;
        let small = recipe.at("1/16".parse::<Level>()?)?;
        let needed = small.plan(None, "")?.bytes;
        if needed > MOST_BYTES {
            return Err(Error::Memory { what: "this recipe".into(), needed, available: MOST_BYTES });
        }
        small.run(&mut MemoryOutput::default(), &Options { cancel: cancel.clone(), ..Options::default() })
    };
    match run() {
        Ok(_) => false,
        Err(error) => {
            // An error is a sentence, and no dump.
            let said = error.to_string();
            assert!(!said.is_empty() && said.len() < 2_000, "{said}");
            true
        }
    }
}

#[test]
fn no_value_makes_a_run_panic_or_hang() {
    let count = std::env::var("LANDFORM_HOSTILE").ok().and_then(|n| n.parse().ok()).unwrap_or(FEW);
    let (mut refused, mut wrong) = (0, Vec::new());
    for k in 0..count {
        let (text, what) = hostile(&mut Seed(7).with(k as u64).draws());
        let cancel = CancelToken::default();
        let (tell, told) = mpsc::channel();
        let token = cancel.clone();
        std::thread::spawn(move || tell.send(catch_unwind(AssertUnwindSafe(|| is_refused(&text, &token)))));
        let ended = told.recv_timeout(LONGEST).or_else(|_| {
            cancel.cancel();
            told.recv_timeout(ENDS_WITHIN)
        });
        match ended {
            Ok(Ok(was)) => refused += usize::from(was),
            Ok(Err(_)) => wrong.push(format!("{what}: panics")),
            Err(_) => wrong.push(format!("{what}: does not end when it is cancelled")),
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    // Some are in range.
    assert!(refused * 2 > count, "{refused} of {count} are refused");
}
