//! `landform studio`.

use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};

use landform::core::Result;
use landform_studio::{Server, Settings};

use crate::run::salt;
use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The recipe; without it, the studio offers landscapes of the gallery.
    recipe: Option<PathBuf>,
    /// Port on this machine; any that is free if not given.
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    port: u16,
    /// Prints the address and opens no browser.
    #[arg(long)]
    no_open: bool,
    /// Output folder of builds.
    #[arg(short, long, default_value = "out")]
    output: PathBuf,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let settings = Settings {
        recipe: args.recipe.clone(),
        root: None,
        output: args.output.clone(),
        port: args.port,
        salt: salt(),
    };
    let server = Server::bind(&settings)?;
    let address = server.address();
    say!("landform studio: {address}");
    say!("It answers on this machine alone. Ctrl-C ends it.");
    if !args.no_open {
        open(&address);
    }
    let (end, asked) = (server.ender(), AtomicBool::new(false));
    ctrlc::set_handler(move || {
        // What is computed may take a while to end; whoever asks twice does not wait for it.
        if asked.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
        end();
    })
    .ok();
    server.serve()?;
    Ok(ExitCode::SUCCESS)
}

/// Opens an address in the browser; where there is none, the user has the address.
fn open(address: &str) {
    let (program, before): (&str, &[&str]) = match std::env::consts::OS {
        "macos" => ("open", &[]),
        "windows" => ("rundll32", &["url.dll,FileProtocolHandler"]),
        _ => ("xdg-open", &[]),
    };
    let mut command = Command::new(program);
    command.args(before).arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().ok();
}
