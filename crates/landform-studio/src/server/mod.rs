//! The server: pages, files, the connection.

mod guard;
mod pages;
mod socket;

use std::net::{Ipv4Addr, SocketAddr};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use axum::Router;
use axum::middleware::from_fn_with_state;
use axum::routing::get;
use landform::{Error, Result};
use tokio::net::TcpListener;
use tokio::sync::Notify;

use crate::root::random_word;
use crate::studio::Studio;

/// How the studio is started.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// Recipe to open; none for an empty studio.
    pub recipe: Option<PathBuf>,
    /// Folder below which recipes and what they read must lie; that of the recipe, or the current
    /// one, if none.
    pub root: Option<PathBuf>,
    /// Folder that builds write to.
    pub output: PathBuf,
    /// Port, 1 to 65535; any that is free with 0.
    pub port: u16,
    /// Part of the cache's keys that differs between builds of the program.
    pub salt: String,
}

/// What every connection shares.
#[derive(Clone)]
struct Shared {
    studio: Arc<Studio>,
    token: Arc<str>,
    /// Name of the cookie; another for every port.
    cookie: Arc<str>,
}

/// A studio that listens, and does not answer yet.
///
/// ```
/// use landform_studio::{Server, Settings};
///
/// let server = Server::bind(&Settings::default())?;
/// assert!(server.address().starts_with("http://127.0.0.1:"));
/// # Ok::<(), landform::Error>(())
/// ```
pub struct Server {
    listener: std::net::TcpListener,
    address: SocketAddr,
    shared: Shared,
    end: Arc<Notify>,
}

impl Server {
    /// Listens on this machine's own address, and opens the recipe.
    ///
    /// # Errors
    /// [`Error::Io`] if the port is taken, or the recipe cannot be read. A recipe with mistakes is
    /// opened, and the page shows them.
    pub fn bind(settings: &Settings) -> Result<Self> {
        let here = |e| Error::io("listen on", format!("127.0.0.1:{}", settings.port), e);
        let listener = std::net::TcpListener::bind((Ipv4Addr::LOCALHOST, settings.port)).map_err(here)?;
        listener.set_nonblocking(true).map_err(here)?;
        let address = listener.local_addr().map_err(here)?;
        let beside = settings.recipe.as_deref().and_then(Path::parent);
        let root = settings.root.as_deref().or(beside).unwrap_or(Path::new("."));
        let output = std::path::absolute(if settings.output.as_os_str().is_empty() {
            Path::new("out")
        } else {
            &settings.output
        });
        let output = output.map_err(|e| Error::io("find", &settings.output, e))?;
        let studio = Arc::new(Studio::new(root, &output, &settings.salt)?);
        if let Some(recipe) = &settings.recipe {
            let real = recipe.canonicalize().map_err(|e| Error::io("read", recipe, e))?;
            studio.open(None, Some(&real.display().to_string()))?;
        }
        let cookie = format!("landform_studio_{}", address.port()).into();
        let shared = Shared { studio, token: random_word()?.into(), cookie };
        Ok(Self { listener, address, shared, end: Arc::new(Notify::new()) })
    }

    /// The address that lets a browser in, with the secret.
    pub fn address(&self) -> String {
        format!("http://{}/?token={}", self.address, self.shared.token)
    }

    /// What ends the server when it is called.
    pub fn ender(&self) -> impl Fn() + Send + Sync + 'static {
        let end = self.end.clone();
        move || end.notify_one()
    }

    /// Answers until it is ended.
    ///
    /// # Errors
    /// [`Error::Io`] if it cannot listen any more.
    pub fn serve(self) -> Result<()> {
        let failed = |e| Error::io("listen on", self.address.to_string(), e);
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(failed)?;
        let shared = self.shared.clone();
        runtime
            .block_on(async {
                let listener = TcpListener::from_std(self.listener)?;
                let end = self.end.clone();
                let studio = shared.studio.clone();
                tokio::select! {
                    served = async { axum::serve(listener, routes(shared)).await } => served,
                    () = end.notified() => {
                        studio.hub.close();
                        Ok(())
                    }
                }
            })
            .map_err(failed)
    }
}

fn routes(shared: Shared) -> Router {
    Router::new()
        .route("/", get(pages::index))
        .route("/schema.json", get(pages::schema_json))
        .route("/stages.json", get(pages::stages_json))
        .route("/gallery.json", get(pages::gallery_json))
        .route("/files", get(pages::download))
        .route("/session", get(socket::session))
        .route("/{*path}", get(pages::file))
        .layer(from_fn_with_state(shared.clone(), guard::guard))
        .with_state(shared)
}
