//! Progress: a bar on a terminal, plain lines elsewhere, JSON lines for programs.

use std::io::IsTerminal;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use landform::core::units::YEAR;
use landform::core::verb::{Outcome, Stopped};
use landform::io::memory;
use landform::recipe::Signal;
use serde_json::json;

/// How progress is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Style {
    /// A bar on a terminal, plain lines elsewhere.
    Auto,
    /// A bar.
    Bar,
    /// Plain lines.
    Plain,
    /// One JSON object a line, on standard output: times in years (null where rounds have no length
    /// in time), volumes in cubic metres.
    Json,
    /// Nothing.
    None,
}

/// Seconds between plain lines within one stage.
const PLAIN_EVERY: f64 = 5.0;
const JSON_EVERY: f64 = 0.25;

/// Shows signals.
pub(crate) struct Reporter {
    style: Style,
    state: Mutex<State>,
}

struct State {
    bar: Option<ProgressBar>,
    last: Instant,
    stage: usize,
    /// Whether steps have no length in time.
    timeless: bool,
    /// Why a line could not be printed.
    untold: Option<std::io::Error>,
}

impl Reporter {
    pub(crate) fn new(style: Style) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let style = match style {
            Style::Auto if terminal => Style::Bar,
            Style::Auto => Style::Plain,
            other => other,
        };
        let state = State { bar: None, last: Instant::now(), stage: 0, timeless: false, untold: None };
        Self { style, state: Mutex::new(state) }
    }

    pub(crate) fn take(&self, signal: Signal) {
        let Ok(mut state) = self.state.lock() else { return };
        if let Signal::Stage { timeless, .. } = signal {
            state.timeless = timeless;
        }
        match self.style {
            Style::Bar => bar(&mut state, &signal),
            Style::Plain => plain(&mut state, &signal),
            Style::Json => as_json(&mut state, &signal),
            Style::None | Style::Auto => {}
        }
    }

    pub(crate) fn finish(&self) {
        if let Ok(mut state) = self.state.lock()
            && let Some(bar) = state.bar.take()
        {
            bar.finish_and_clear();
        }
    }

    pub(crate) fn files(&self, files: &[PathBuf], seconds: f64) {
        let Ok(mut state) = self.state.lock() else { return };
        match self.style {
            Style::Json => state
                .tell(&json!({ "event": "done", "files": files, "seconds": seconds, "peak_bytes": memory::peak() })),
            Style::None => {}
            _ => {
                for file in files {
                    state.tell(&file.display());
                }
                complain!("done in {seconds:.1} s");
            }
        }
    }

    /// Success, if all that was to be told could be printed.
    pub(crate) fn told(&self) -> ExitCode {
        let untold = self.state.lock().ok().and_then(|mut state| state.untold.take());
        let Some(e) = untold else { return ExitCode::SUCCESS };
        complain!("error: cannot write to standard output: {e}; the run itself is complete");
        ExitCode::FAILURE
    }
}

impl State {
    /// Prints a line; a run goes on even if the output is closed or full.
    fn tell(&mut self, line: &dyn std::fmt::Display) {
        use std::io::Write;
        if let Err(e) = writeln!(std::io::stdout(), "{line}")
            && e.kind() != std::io::ErrorKind::BrokenPipe
        {
            self.untold = Some(e);
        }
    }
}

fn stage_line(index: usize, of: usize, name: &str, cached: bool) -> String {
    format!("[{index}/{of}] {name}{}", if cached { " (cached)" } else { "" })
}

fn years(seconds: f64) -> String {
    let years = seconds / YEAR;
    if years >= 1e6 {
        format!("{:.3} Myr", years / 1e6)
    } else if years >= 1e3 {
        format!("{:.1} kyr", years / 1e3)
    } else {
        format!("{years:.1} yr")
    }
}

/// The clock after a step; nothing where steps have no length in time.
fn clock(time: f64, timeless: bool) -> String {
    if timeless { String::new() } else { format!(", {}", years(time)) }
}

fn step_line(steps: u64, time: f64, residual: Option<f64>, timeless: bool) -> String {
    let residual = residual.map(|r| format!(", residual {r:.1e}")).unwrap_or_default();
    format!("step {steps}{}{residual}", clock(time, timeless))
}

fn outcome_line(o: &Outcome, timeless: bool) -> String {
    let why = match o.stopped {
        Stopped::EndTime => "end of time",
        Stopped::MaxSteps => "step limit",
        Stopped::Steady => "steady",
        Stopped::Cancelled => "cancelled",
        Stopped::ByObserver => "stopped",
        Stopped::AtRest => "at rest",
        Stopped::AtRestTooSoon => "at rest before the end that was asked for",
    };
    let residual = o.residual.map(|r| format!(", residual {r:.2e}")).unwrap_or_default();
    let exported = o.budget.change.exported;
    let gone = if exported > 0.0 { format!("; {exported:.3e} m3 left the map") } else { String::new() };
    format!(
        "{why} after {} steps{}{residual}; mass closes to {:.0e}{gone}",
        o.steps,
        clock(o.time, timeless),
        o.budget.imbalance()
    )
}

fn bar(state: &mut State, signal: &Signal) {
    match signal {
        Signal::Stage { index, of, name, cached, .. } => {
            if let Some(bar) = state.bar.take() {
                bar.finish_and_clear();
            }
            complain!("{}", stage_line(*index, *of, name, *cached));
            let bar = ProgressBar::new(1000);
            if let Ok(style) = ProgressStyle::with_template("  {bar:32} {percent:>3} %  {msg}  {elapsed} (left {eta})")
            {
                bar.set_style(style);
            }
            bar.enable_steady_tick(Duration::from_millis(200));
            state.bar = Some(bar);
        }
        Signal::Step { steps, time, part, residual } => {
            if let Some(bar) = &state.bar {
                bar.set_position((part.unwrap_or(0.0).clamp(0.0, 1.0) * 1000.0) as u64);
                bar.set_message(step_line(*steps, *time, *residual, state.timeless));
            }
        }
        Signal::Outcome(o) => say(state, &format!("  {}", outcome_line(o, state.timeless))),
        Signal::Note(text) => say(state, &format!("note: {text}")),
    }
}

fn say(state: &State, text: &str) {
    match &state.bar {
        Some(bar) => bar.suspend(|| complain!("{text}")),
        None => complain!("{text}"),
    }
}

fn plain(state: &mut State, signal: &Signal) {
    match signal {
        Signal::Stage { index, of, name, cached, .. } => {
            complain!("{}", stage_line(*index, *of, name, *cached));
            state.last = Instant::now();
        }
        Signal::Step { steps, time, part, residual } => {
            if state.last.elapsed().as_secs_f64() >= PLAIN_EVERY {
                state.last = Instant::now();
                let part = part.map(|p| format!("{:>3.0} %, ", p.clamp(0.0, 1.0) * 100.0)).unwrap_or_default();
                complain!("  {part}{}", step_line(*steps, *time, *residual, state.timeless));
            }
        }
        Signal::Outcome(o) => complain!("  {}", outcome_line(o, state.timeless)),
        Signal::Note(text) => complain!("note: {text}"),
    }
}

fn as_json(state: &mut State, signal: &Signal) {
    let line = match signal {
        Signal::Stage { index, of, name, cached, .. } => {
            state.stage = *index;
            json!({ "event": "stage", "stage": index, "of": of, "name": name, "cached": cached })
        }
        Signal::Step { steps, time, part, residual } => {
            if *steps > 1 && state.last.elapsed().as_secs_f64() < JSON_EVERY {
                return;
            }
            state.last = Instant::now();
            let years = (!state.timeless).then_some(time / YEAR);
            json!({ "event": "step", "stage": state.stage, "steps": steps, "years": years, "part": part, "residual": residual })
        }
        Signal::Outcome(o) => {
            let years = (!state.timeless).then_some(o.time / YEAR);
            json!({ "event": "outcome", "stage": state.stage, "steps": o.steps, "years": years,
                "stopped": o.stopped, "residual": o.residual, "budget": o.budget, "imbalance": o.budget.imbalance() })
        }
        Signal::Note(text) => json!({ "event": "note", "text": text }),
    };
    state.tell(&line);
}
