//! The studio's protocol, spoken without a browser.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::time::{Duration, Instant};

use futures_util::{SinkExt, StreamExt};
use landform_studio::{Server, Settings};
use serde_json::{Value as Json, json};
use tokio::net::TcpStream as Stream;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::{self, Message};
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream, connect_async};

const RISING: &str = "# A hill.\nseed = 1\n\n[[stage]]\nuse = \"noise\"\ngrid = { size = [\"3 km\", \"3 km\"], cell_size = \"50 m\" } # small\n\n\
    [[stage]]\nuse = \"evolve\"\nclock = { dt = \"10 kyr\", duration = \"200 kyr\" }\nprocess = [\n  { use = \"uplift\", rate = \"1 mm/yr\" },\n  \
    { use = \"stream_power\" },\n]\n\n[[stage]]\nuse = \"write_raster\"\npath = \"ground.tif\"\n";

/// Longest wait for anything.
const PATIENCE: Duration = Duration::from_secs(60);

/// A server with its address; it ends with the test.
struct Running {
    host: String,
    token: String,
    folder: tempfile::TempDir,
    end: Box<dyn Fn() + Send + Sync>,
}

impl Running {
    fn new(text: Option<&str>) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let recipe = text.map(|text| {
            let path = folder.path().join("hill.toml");
            std::fs::write(&path, text).unwrap();
            path
        });
        let (root, output) = (Some(folder.path().into()), folder.path().join("out"));
        let server = Server::bind(&Settings { recipe, root, output, ..Settings::default() }).unwrap();
        let address = server.address();
        let (host, token) = address.trim_start_matches("http://").split_once("/?token=").unwrap();
        let (host, token) = (host.to_string(), token.to_string());
        let end = Box::new(server.ender());
        std::thread::spawn(move || server.serve().unwrap());
        Self { host, token, folder, end }
    }

    fn cookie(&self) -> String {
        let port = self.host.rsplit_once(':').unwrap().1;
        format!("landform_studio_{port}={}", self.token)
    }

    /// Status and whole answer of a request with these headers.
    fn get(&self, path: &str, headers: &[(&str, &str)]) -> (u16, String) {
        self.ask(&format!("GET {path} HTTP/1.1"), headers)
    }

    fn ask(&self, line: &str, headers: &[(&str, &str)]) -> (u16, String) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        let headers: String = headers.iter().map(|(k, v)| format!("{k}: {v}\r\n")).collect();
        write!(stream, "{line}\r\n{headers}Connection: close\r\n\r\n").unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).ok();
        let answer = String::from_utf8_lossy(&answer).into_owned();
        (answer.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0), answer)
    }

    fn folder(&self) -> &Path {
        self.folder.path()
    }

    async fn page(&self) -> Page {
        let socket = connect(self, &self.cookie(), Some(&format!("http://{}", self.host))).await.unwrap();
        let mut page = Page { socket, tells: Vec::new(), frames: Vec::new(), number: 0, acks: true };
        page.ask(json!({ "do": "hello", "protocol": 1 })).await;
        page
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        (self.end)();
    }
}

type Socket = WebSocketStream<MaybeTlsStream<Stream>>;

async fn connect(server: &Running, cookie: &str, origin: Option<&str>) -> Result<Socket, tungstenite::Error> {
    let mut request = format!("ws://{}/session", server.host).into_client_request().unwrap();
    request.headers_mut().insert("cookie", cookie.parse().unwrap());
    if let Some(origin) = origin {
        request.headers_mut().insert("origin", origin.parse().unwrap());
    }
    connect_async(request).await.map(|found| found.0)
}

/// A page as a browser would be.
struct Page {
    socket: Socket,
    tells: Vec<Json>,
    frames: Vec<(Json, Vec<u8>)>,
    number: u64,
    acks: bool,
}

impl Page {
    /// Sends a request; returns its answer.
    async fn ask(&mut self, mut what: Json) -> Json {
        self.number += 1;
        let number = self.number;
        what["request"] = number.into();
        self.socket.send(Message::text(what.to_string())).await.unwrap();
        self.until(move |tell| tell["request"] == number).await
    }

    /// As [`Page::until`], or what has come already.
    async fn had(&mut self, wanted: impl Fn(&Json) -> bool) -> Json {
        match self.tells.iter().rev().find(|tell| wanted(tell)).cloned() {
            Some(tell) => tell,
            None => self.until(wanted).await,
        }
    }

    async fn until(&mut self, wanted: impl Fn(&Json) -> bool) -> Json {
        let began = Instant::now();
        loop {
            assert!(began.elapsed() < PATIENCE, "it did not come; the last: {:?}", self.tells.last());
            let Some(tell) = self.next(PATIENCE).await else { continue };
            if wanted(&tell) {
                return tell;
            }
        }
    }

    /// The next tell, if one comes in time and is no frame.
    async fn next(&mut self, patience: Duration) -> Option<Json> {
        let message = tokio::time::timeout(patience, self.socket.next()).await.ok()?.expect("it is open").unwrap();
        match message {
            Message::Text(text) => {
                let tell: Json = serde_json::from_str(&text).unwrap();
                self.tells.push(tell.clone());
                Some(tell)
            }
            Message::Binary(bytes) => {
                assert!(bytes.len() <= 1 << 20);
                let length = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
                let header: Json = serde_json::from_slice(&bytes[4..4 + length]).unwrap();
                if self.acks && header["last"] == true {
                    self.acknowledge(&header).await;
                }
                self.frames.push((header, bytes[(4 + length).next_multiple_of(8)..].to_vec()));
                None
            }
            _ => None,
        }
    }

    async fn acknowledge(&mut self, header: &Json) {
        let ack = json!({ "do": "ack", "frame": header["frame"] });
        self.socket.send(Message::text(ack.to_string())).await.unwrap();
    }

    /// Waits until a preview has ended, and its frame is here.
    async fn at_rest(&mut self, level: &str) {
        let began = Instant::now();
        let fits = |header: &Json| header["level"] == level && header["last"] == true;
        while !self.frames.iter().any(|(header, _)| fits(header)) {
            assert!(began.elapsed() < PATIENCE, "{:?}", self.tells.last());
            self.next(Duration::from_millis(200)).await;
        }
        if self.tells.iter().rev().find(|tell| tell["tell"] == "state").is_none_or(|state| state["running"] == true) {
            self.until(|tell| tell["tell"] == "state" && tell["running"] == false).await;
        }
    }

    /// Waits until a frame fits, of those that are here or come.
    async fn shows(&mut self, what: &str, fits: impl Fn(&Json) -> bool) {
        let began = Instant::now();
        while !self.frames.iter().any(|(header, _)| fits(header)) {
            let times: Vec<_> = self.frames.iter().map(|(h, _)| (&h["layer"], &h["time"])).collect();
            assert!(began.elapsed() < PATIENCE, "{what}: {times:?} {:?}", self.tells.last());
            self.next(Duration::from_millis(200)).await;
        }
    }

    /// Lets pass what comes in a while.
    async fn pass(&mut self, while_: Duration) {
        let end = Instant::now() + while_;
        while Instant::now() < end {
            self.next(Duration::from_millis(50)).await;
        }
    }
}

fn run(test: impl Future<Output = ()>) {
    tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap().block_on(test);
}

#[test]
fn strangers_are_kept_out() {
    let server = Running::new(None);
    let (host, cookie) = (server.host.clone(), server.cookie());
    let own = [("Host", host.as_str()), ("Cookie", cookie.as_str())];
    let (status, page) = server.get("/", &own);
    assert_eq!(status, 200, "{page}");
    let lower = page.to_lowercase();
    for header in
        ["content-security-policy: default-src 'self'", "x-content-type-options: nosniff", "cache-control: no-store"]
    {
        assert!(lower.contains(header), "{page}");
    }
    assert!(!lower.contains("access-control"));
    // Neither token nor cookie, a wrong one, another's name for this machine, another site.
    assert_eq!(server.get("/", &[("Host", &host)]).0, 403);
    assert_eq!(server.get("/schema.json", &[("Host", &host)]).0, 403);
    assert_eq!(server.get("/?token=0123", &[("Host", &host)]).0, 403);
    assert_eq!(server.get("/", &[("Host", &host), ("Cookie", &cookie[..cookie.len() - 1])]).0, 403);
    for other in ["evil.example", "127.0.0.1.evil.example", "evil.example:80"] {
        assert_eq!(server.get("/", &[("Host", other), ("Cookie", &cookie)]).0, 403, "{other}");
        assert_eq!(server.get(&format!("/?token={}", server.token), &[("Host", other)]).0, 403, "{other}");
    }
    assert_eq!(server.get("/", &[("Cookie", &cookie)]).0, 403, "no host");
    for origin in ["http://evil.example", "null", "http://127.0.0.1:1", "https://evil.example"] {
        assert_eq!(server.get("/", &[own[0], own[1], ("Origin", origin)]).0, 403, "{origin}");
    }
    assert_eq!(server.ask("POST / HTTP/1.1", &own).0, 405);
    let (status, entered) = server.get(&format!("/?token={}", server.token), &[("Host", &host)]);
    assert_eq!(status, 303);
    assert!(entered.to_lowercase().contains("httponly; samesite=strict"), "{entered}");
    // A tunnel has another port.
    assert_eq!(
        server.get("/", &[("Host", "localhost:9999"), ("Cookie", &cookie), ("Origin", "http://localhost:9999")]).0,
        200
    );
    for path in ["/../Cargo.toml", "/..%2f..%2fetc/passwd", "/gallery/../../x", "/no_such"] {
        assert!([400, 404].contains(&server.get(path, &own).0), "{path}");
    }
}

#[test]
fn the_connection_needs_cookie_and_origin() {
    let server = Running::new(None);
    run(async {
        let origin = format!("http://{}", server.host);
        assert!(connect(&server, &server.cookie(), Some(&origin)).await.is_ok());
        for (cookie, origin) in [
            (server.cookie(), None),
            (server.cookie(), Some("http://evil.example")),
            (server.cookie(), Some("null")),
            ("landform_studio=x".into(), Some(origin.as_str())),
        ] {
            match connect(&server, &cookie, origin).await {
                Err(tungstenite::Error::Http(answer)) => assert_eq!(answer.status(), 403),
                other => panic!("{cookie} {origin:?}: {:?}", other.map(|_| ())),
            }
        }
    });
}

#[test]
fn lists_are_there_to_be_read() {
    let server = Running::new(None);
    let (host, cookie) = (server.host.clone(), server.cookie());
    let own = [("Host", host.as_str()), ("Cookie", cookie.as_str())];
    let json = |path: &str| -> Json {
        let (status, answer) = server.get(path, &own);
        assert_eq!(status, 200, "{path}");
        serde_json::from_str(answer.split_once("\r\n\r\n").unwrap().1).unwrap()
    };
    assert!(json("/schema.json")["$defs"]["stream_power"].is_object());
    let stages = json("/stages.json");
    let uplift = stages.as_array().unwrap().iter().find(|s| s["name"] == "uplift").unwrap();
    assert_eq!((&uplift["verb"], &uplift["folder"]), (&json!("process"), &json!("uplift")));
    assert_eq!(json("/gallery.json").as_array().unwrap().len(), 6);
    std::fs::create_dir_all(server.folder().join("out/maps")).unwrap();
    std::fs::write(server.folder().join("out/maps/a.txt"), "hello").unwrap();
    assert!(server.get("/files?path=maps/a.txt", &own).1.ends_with("hello"));
    std::fs::write(server.folder().join("secret"), "secret").unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(server.folder().join("secret"), server.folder().join("out/link")).unwrap();
    for path in ["../secret", "link", "/etc/passwd", "maps", "", "maps/../../secret", "%2e%2e/secret"] {
        assert_eq!(server.get(&format!("/files?path={path}"), &own).0, 404, "{path}");
    }
}

#[test]
fn a_recipe_is_shown_changed_and_built() {
    let server = Running::new(Some(RISING));
    run(async {
        let mut page = server.page().await;
        assert!(page.tells.iter().any(|t| t["tell"] == "welcome" && t["protocol"] == 1));
        page.at_rest("1").await;
        let (header, data) = page.frames.last().unwrap().clone();
        assert_eq!((&header["rows"], &header["cols"], &header["encoding"]), (&json!(61), &json!(61), &json!("f32")));
        assert_eq!(data.len(), 61 * 61 * 4);
        assert!((header["time"].as_f64().unwrap() - 2e5 * 31_557_600.0).abs() < 1.0);
        let charts = page.had(|t| t["tell"] == "charts").await;
        assert!(charts["summary"]["relief"].as_f64().unwrap() > 1.0 && charts["card"].is_array());
        // One value of the text changes, and the ground with it.
        let set = json!({ "do": "set", "stage": 1, "process": 0, "key": ["rate"], "value": "3 mm/yr", "stamp": 17.5 });
        assert_eq!(page.ask(set).await["tell"], "done");
        page.frames.clear();
        page.at_rest("1").await;
        let higher = page.frames.last().unwrap().0["max"].as_f64().unwrap();
        assert!(higher > header["max"].as_f64().unwrap() + 50.0, "{higher}");
        let latency = page.had(|t| t["tell"] == "latency" && t["stamp"] == 17.5).await;
        assert!(latency["received"].as_f64() < latency["computed"].as_f64(), "{latency}");
        let recipe = page.tells.iter().rev().find(|t| t["tell"] == "recipe").unwrap();
        assert_eq!(recipe["text"], RISING.replace("1 mm/yr", "3 mm/yr"));
        // Mistakes come with their place, and the ground stays.
        let wrong = json!({ "do": "set", "stage": 1, "process": 0, "key": ["rate"], "value": "3 apples" });
        page.ask(wrong).await;
        let recipe = page.tells.iter().rev().find(|t| t["tell"] == "recipe").unwrap();
        assert_eq!((&recipe["errors"][0]["stage"], &recipe["errors"][0]["line"]), (&json!(1), &json!(12)));
        assert_eq!(page.ask(json!({ "do": "build" })).await["tell"], "refused");
        page.ask(json!({ "do": "undo" })).await;
        // Files of a build.
        page.ask(json!({ "do": "build" })).await;
        let built = page.until(|t| t["tell"] == "built").await;
        assert_eq!(built["files"][0]["path"], "ground.tif");
        assert!(server.folder().join("out/ground.tif").is_file());
        page.ask(json!({ "do": "export", "use": "write_heightmap", "parameters": { "path": "h.tif" } })).await;
        let built = page.until(|t| t["tell"] == "built" || t["tell"] == "failed").await;
        assert_eq!(built["files"][0]["path"], "h.tif", "{built}");
        assert_eq!(page.ask(json!({ "do": "export", "use": "uplift" })).await["tell"], "refused");
        assert_eq!(
            page.ask(json!({ "do": "export", "use": "write_raster", "parameters": { "path": "../x.tif" } })).await["tell"],
            "refused"
        );
        page.ask(json!({ "do": "contact", "seeds": [1, 2] })).await;
        for _ in 0..2 {
            let contact = page.until(|t| t["tell"] == "contact" || t["tell"] == "failed").await;
            assert!(contact["png"].as_str().unwrap().starts_with("iVBOR"), "{contact}");
        }
        let saved = page.ask(json!({ "do": "save" })).await;
        assert_eq!(saved["tell"], "done", "{saved}");
        let on_disk = std::fs::read_to_string(server.folder().join("hill.toml")).unwrap();
        assert_eq!(on_disk, RISING.replace("1 mm/yr", "3 mm/yr"));
        assert!(page.ask(json!({ "do": "command" })).await["command"].as_str().unwrap().starts_with("landform run "));
    });
}

#[test]
fn a_run_is_held_stepped_and_goes_on() {
    let server = Running::new(Some(RISING));
    run(async {
        let mut page = server.page().await;
        page.at_rest("1").await;
        page.ask(json!({ "do": "show", "fields": ["drainage_area", "slope"], "stage": null })).await;
        // What is shown at once is of the run that ended: it is waited for, or it would come among the steps.
        page.shows("fields", |h| h["layer"] == "slope" && h["last"] == true).await;
        page.ask(json!({ "do": "pause" })).await;
        page.frames.clear();
        let at = |header: &Json| (header["time"].as_f64().unwrap() / 31_557_600.0 / 1e4).round();
        let times = |page: &Page| -> Vec<f64> {
            page.frames.iter().filter(|(h, _)| h["layer"] == "elevation").map(|(h, _)| at(h)).collect()
        };
        page.ask(json!({ "do": "step" })).await;
        page.shows("a step", |h| h["layer"] == "slope" && h["last"] == true).await;
        assert_eq!(times(&page), [1.0]);
        page.ask(json!({ "do": "step" })).await;
        page.shows("two steps", |h| h["layer"] == "slope" && h["last"] == true && at(h) > 1.0).await;
        assert_eq!(times(&page), [1.0, 2.0]);
        // Another tab sees the same.
        let mut other = server.page().await;
        other.shows("another tab", |h| h["layer"] == "elevation").await;
        assert_eq!(times(&other), [2.0]);
        other.had(|t| t["tell"] == "state" && t["paused"] == true && t["steps"] == 2).await;
        page.ask(json!({ "do": "play", "pace": 5.0 })).await;
        page.until(|t| t["tell"] == "state" && t["running"] == false).await;
        page.shows("the end", |h| h["layer"] == "elevation" && at(h) >= 20.0).await;
        assert_eq!(times(&page).last(), Some(&20.0));
        assert!(times(&page).windows(2).all(|pair| pair[0] <= pair[1]), "{:?}", times(&page));
        // A held run ends when it is stopped.
        page.ask(json!({ "do": "step" })).await;
        page.until(|t| t["tell"] == "state" && t["paused"] == true && t["running"] == true).await;
        page.ask(json!({ "do": "stop" })).await;
        page.until(|t| t["tell"] == "state" && t["running"] == false).await;
    });
}

#[test]
fn a_dragged_value_settles_and_then_runs_from_the_start() {
    let server = Running::new(Some(RISING));
    run(async {
        let mut page = server.page().await;
        page.at_rest("1").await;
        page.frames.clear();
        for k in 1..=10 {
            let value = format!("{} mm/yr", 1.0 + 0.1 * f64::from(k));
            let set = json!({ "do": "set", "stage": 1, "process": 0, "key": ["rate"], "value": value, "dragging": true, "stamp": k });
            page.ask(set).await;
            page.had(|t| t["tell"] == "latency" && t["stamp"] == f64::from(k)).await;
        }
        assert!(page.tells.iter().any(|t| t["tell"] == "state" && t["settling"] == true));
        // The process went on: its time is beyond the end.
        let end = 2e5 * 31_557_600.0;
        assert!(page.frames.last().unwrap().0["time"].as_f64().unwrap() > end + 1.0);
        let tells = page.tells.len();
        page.ask(json!({ "do": "set", "stage": 1, "process": 0, "key": ["rate"], "value": "2 mm/yr", "stamp": 99 }))
            .await;
        page.had(|t| t["tell"] == "latency" && t["stamp"] == 99.0).await;
        while !page.tells[tells..].iter().any(|t| t["tell"] == "charts") {
            page.until(|t| t["tell"] == "charts").await;
        }
        page.shows("the end", |h| h["time"].as_f64() == Some(end)).await;
        assert_eq!(page.frames.last().unwrap().0["time"].as_f64().unwrap(), end);
    });
}

#[test]
fn a_held_model_is_painted_and_a_stroke_lifts_the_land() {
    let server = Running::new(Some(RISING));
    run(async {
        let mut page = server.page().await;
        page.at_rest("1").await;
        page.ask(json!({ "do": "pause" })).await;
        page.ask(json!({ "do": "step" })).await;
        page.had(|t| t["tell"] == "state" && t["paused"] == true && t["running"] == true).await;
        page.shows("a step", |h| h["time"].as_f64().is_some_and(|t| (t - 1e4 * 31_557_600.0).abs() < 1.0)).await;
        let before = page.frames.last().unwrap().0["max"].as_f64().unwrap();
        let paint = |tool: &str| {
            json!({ "do": "paint", "field": "elevation", "tool": tool, "radius": 500.0, "strength": 4000.0,
            "points": [[1000.0, 1500.0, 1.0, 0.0], [2000.0, 1500.0, 1.0, 0.5]] })
        };
        assert_eq!(page.ask(paint("raise")).await["tell"], "done");
        page.shows("raised", |h| h["max"].as_f64().unwrap() > before + 1_500.0).await;
        let raised = page.frames.last().unwrap().0["max"].as_f64().unwrap();
        page.frames.clear();
        for tool in ["smooth", "level", "lower"] {
            assert_eq!(page.ask(paint(tool)).await["tell"], "done");
        }
        assert_eq!(page.ask(paint("melt")).await["tell"], "refused");
        page.shows("lowered", |h| h["max"].as_f64().unwrap() < raised - 500.0).await;
        page.ask(json!({ "do": "play" })).await;
        page.until(|t| t["tell"] == "state" && t["running"] == false).await;
        let ended = |h: &Json| h["last"] == true && h["time"].as_f64().is_some_and(|t| t > 1.99e5 * 31_557_600.0);
        let max = |h: &Json| h["max"].as_f64().unwrap();
        page.shows("the end", ended).await;
        let painted = page.frames.last().map(|(h, _)| max(h)).unwrap();
        // What was painted is not in the text: a run from the start has it not.
        page.frames.clear();
        page.ask(json!({ "do": "run", "level": "auto" })).await;
        page.shows("a run from the start", |h| ended(h) && max(h) != painted).await;
        let again = page.frames.last().map(|(h, _)| max(h)).unwrap();
        let stroke = json!({ "do": "stroke", "stage": 1, "process": 0, "key": ["rate"], "tool": "raise", "radius": 600, "strength": 5,
            "points": [[500.0, 1500.0, 1.0, 0.0], [2500.0, 1500.0, 1.0, 1.0]] });
        page.frames.clear();
        assert_eq!(page.ask(stroke).await["tell"], "done");
        page.shows("a stroke", |h| ended(h) && max(h) > again + 300.0).await;
        page.frames.clear();
        page.ask(json!({ "do": "undo" })).await;
        page.shows("the stroke taken back", |h| ended(h) && max(h) == again).await;
        for bad in ["[]", "[[0]]", "[[0,1e300]]", "[[0,0,7]]"] {
            let points: Json = serde_json::from_str(bad).unwrap();
            let paint = json!({ "do": "paint", "tool": "raise", "radius": 1.0, "strength": 1.0, "points": points });
            assert_eq!(page.ask(paint).await["tell"], "refused", "{bad}");
        }
    });
}

#[test]
fn a_page_that_never_acknowledges_gets_two_frames_and_then_the_newest() {
    let server = Running::new(Some(RISING));
    run(async {
        let mut page = server.page().await;
        page.acks = false;
        let mut tells = 0;
        for k in 1..30 {
            tells = page.tells.len();
            let value = format!("{k} mm/yr");
            page.ask(
                json!({ "do": "set", "stage": 1, "process": 0, "key": ["rate"], "value": value, "dragging": k < 29 }),
            )
            .await;
            page.pass(Duration::from_millis(20)).await;
        }
        while !page.tells[tells..].iter().any(|t| t["tell"] == "charts") {
            page.until(|t| t["tell"] == "charts").await;
        }
        page.pass(Duration::from_millis(500)).await;
        let numbers: Vec<u64> = page.frames.iter().map(|(h, _)| h["frame"].as_u64().unwrap()).collect();
        assert!(numbers.len() <= 2, "{numbers:?}");
        let last = page.frames.last().unwrap().0.clone();
        page.acknowledge(&last).await;
        let number = last["frame"].as_u64().unwrap();
        page.shows("the newest", |h| h["frame"].as_u64().unwrap() > number + 1).await;
        let (newest, _) = page.frames.last().unwrap();
        let revision = page.tells.iter().rev().find(|t| t["tell"] == "recipe").unwrap()["revision"].clone();
        assert_eq!(newest["revision"], revision);
    });
}

#[test]
fn floods_and_long_messages_do_no_harm() {
    let server = Running::new(Some(RISING));
    run(async {
        let mut page = server.page().await;
        // Nothing is read meanwhile: answers wait, and the requests behind them.
        for k in 0..3_000 {
            let what = json!({ "do": if k % 2 == 0 { "command" } else { "fly" }, "request": 100_000 + k });
            page.socket.feed(Message::text(what.to_string())).await.unwrap();
        }
        page.socket.flush().await.unwrap();
        page.until(|t| t["request"] == 102_999).await;
        let answers = page.tells.iter().filter(|t| t["request"].as_u64().is_some_and(|n| n >= 100_000)).count();
        assert_eq!(answers, 3_000);
        // A message that is too long ends the connection, not the server.
        let long = json!({ "do": "text", "text": "#".repeat(2 << 20) });
        page.socket.send(Message::text(long.to_string())).await.ok();
        loop {
            match page.socket.next().await {
                None | Some(Err(_) | Ok(Message::Close(_))) => break,
                Some(Ok(_)) => {}
            }
        }
        let mut page = server.page().await;
        let long = json!({ "do": "text", "text": "#".repeat(600 << 10) });
        assert_eq!(page.ask(long).await["tell"], "refused");
        assert_eq!(page.ask(json!({ "do": "text", "text": "[[stage" })).await["tell"], "done");
        assert_eq!(page.ask(json!({ "do": "open", "path": "../../etc/passwd" })).await["tell"], "refused");
        assert_eq!(page.ask(json!({ "do": "undo" })).await["tell"], "done");
    });
}

#[test]
fn pages_are_not_without_number() {
    let server = Running::new(None);
    run(async {
        let origin = format!("http://{}", server.host);
        let mut open = Vec::new();
        while let Ok(socket) = connect(&server, &server.cookie(), Some(&origin)).await {
            open.push(socket);
            assert!(open.len() < 100);
        }
        assert_eq!(open.len(), 16);
        drop(open);
        tokio::time::sleep(Duration::from_millis(200)).await;
        assert!(connect(&server, &server.cookie(), Some(&origin)).await.is_ok(), "a place is free again");
    });
}
