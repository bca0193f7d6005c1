//! The page and what it reads once.

use std::sync::LazyLock;

use axum::extract::{Path, Query, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use landform::recipe::{GALLERY, describe, schema, stages};
use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::Shared;
use crate::root::check_below;
use crate::session::verb;

include!(concat!(env!("OUT_DIR"), "/assets.rs"));

/// Landscapes that an empty studio offers, where no pictures say which.
const OFFERED: [&str; 6] =
    ["alpine_range", "folded_range", "desert_basin", "painted_island", "coral_island", "star_dunes"];

/// Greatest file that is handed out, bytes.
const MOST_FILE: u64 = 2 << 30;

/// A file of the page.
pub(super) async fn asset(path: &str) -> Response {
    let Some((_, bytes)) = ASSETS.iter().find(|asset| asset.0 == path) else {
        return (StatusCode::NOT_FOUND, "there is no such page\n").into_response();
    };
    ([(header::CONTENT_TYPE, kind_of(path))], *bytes).into_response()
}

fn kind_of(path: &str) -> &'static str {
    match path.rsplit_once('.').map_or("", |(_, end)| end) {
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "png" => "image/png",
        "jpg" => "image/jpeg",
        "svg" => "image/svg+xml",
        "json" => "application/json",
        "txt" | "md" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

pub(super) async fn index() -> Response {
    asset("index.html").await
}

pub(super) async fn file(Path(path): Path<String>) -> Response {
    asset(&path).await
}

fn json_of(text: &'static str) -> Response {
    ([(header::CONTENT_TYPE, "application/json")], text).into_response()
}

pub(super) async fn schema_json() -> Response {
    static TEXT: LazyLock<String> = LazyLock::new(|| schema().to_string());
    json_of(&TEXT)
}

pub(super) async fn stages_json() -> Response {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        let one = |stage: &'static landform::recipe::Stage| {
            let sources = stage.sources.iter().map(|s| json!({ "authors": s.authors, "title": s.title, "doi": s.doi }));
            let text = (stage.form.schema)()["description"].as_str().unwrap_or_default().to_string();
            json!({ "name": stage.name, "verb": verb(stage.name), "folder": stage.folder(), "summary": stage.summary(),
                "text": text, "kinds": stage.kinds().map(|kind| kind.name()).collect::<Vec<_>>(),
                "sources": sources.collect::<Vec<_>>() })
        };
        let evolve = json!({ "name": "evolve", "verb": "process", "folder": "evolve", "summary": describe("evolve"),
            "text": describe("evolve"), "kinds": ["height field", "mesh"], "sources": [] });
        let all: Vec<Json> = stages().map(one).chain([evolve]).collect();
        json!(all).to_string()
    });
    json_of(&TEXT)
}

pub(super) async fn gallery_json() -> Response {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        let picture = |name: &str| {
            let file = GALLERY.iter().find(|r| r.name == name).map_or(name, |r| r.file.trim_end_matches(".toml"));
            let mut paths =
                [file, name].into_iter().flat_map(|stem| ["jpg", "png"].map(|end| format!("gallery/{stem}.{end}")));
            paths.find(|path| ASSETS.iter().any(|asset| asset.0 == path))
        };
        let with_pictures: Vec<&str> = GALLERY.iter().map(|r| r.name).filter(|name| picture(name).is_some()).collect();
        let names = if with_pictures.is_empty() { OFFERED.to_vec() } else { with_pictures };
        let one = |name: &str| {
            let recipe = GALLERY.iter().find(|recipe| recipe.name == name)?;
            let line = |start: &str| recipe.text.lines().find_map(|line| line.strip_prefix(start)).map(str::trim);
            let title = line("title = ").map_or(name, |title| title.trim_matches('"'));
            Some(json!({ "name": name, "title": title, "text": line("# "), "look": line("# Look at:"),
                "picture": picture(name).map(|path| format!("/{path}")) }))
        };
        let offered: Vec<Json> = names.into_iter().filter_map(one).collect();
        json!(offered).to_string()
    });
    json_of(&TEXT)
}

#[derive(Deserialize)]
pub(super) struct Wanted {
    path: String,
}

/// A file that a build wrote.
pub(super) async fn download(State(shared): State<Shared>, Query(Wanted { path }): Query<Wanted>) -> Response {
    let refused = (StatusCode::NOT_FOUND, "there is no such file in the output folder\n").into_response();
    let Ok(output) = shared.studio.output.canonicalize() else { return refused };
    let Ok(below) = landform::core::verb::relative_path(&path) else { return refused };
    let file = output.join(below);
    if check_below(&file, &[&output], &path).is_err() {
        return refused;
    }
    match std::fs::metadata(&file) {
        Ok(meta) if meta.is_file() && meta.len() <= MOST_FILE => {}
        _ => return refused,
    }
    let Ok(bytes) = std::fs::read(&file) else { return refused };
    let name: String = file.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let name: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() || "._-".contains(c) { c } else { '_' }).collect();
    let headers = [
        (header::CONTENT_TYPE, kind_of_file(&name).to_string()),
        (header::CONTENT_DISPOSITION, format!("attachment; filename=\"{name}\"")),
    ];
    (headers, bytes).into_response()
}

/// What a file of the output is; a page among them is not shown as one of the studio's.
fn kind_of_file(name: &str) -> &'static str {
    match kind_of(name) {
        kind if kind.starts_with("image/p") || kind.starts_with("image/j") => kind,
        _ => "application/octet-stream",
    }
}
