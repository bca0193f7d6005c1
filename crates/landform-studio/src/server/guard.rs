//! Who may come in.
//!
//! # Method
//! The server answers on this machine's own address alone. A page of another site could still send
//! requests there, or have its own name lead there; so `Host` must be this machine's name, an
//! `Origin` must be that host, and every request must carry a secret. The secret is in the address
//! that the program prints; it is traded for a cookie that scripts and other sites do not get.

use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Method, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::Shared;

const POLICY: &str = "default-src 'self'; img-src 'self' blob: data:; worker-src 'self' blob:; \
    style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Names of this machine, as it calls itself.
const OWN: [&str; 3] = ["127.0.0.1", "localhost", "[::1]"];

/// Lets a request pass, or refuses it; marks every answer.
pub(super) async fn guard(State(shared): State<Shared>, request: Request, next: Next) -> Response {
    let mut response = match check(&shared, &request) {
        Ok(()) => next.run(request).await,
        Err(refused) => *refused,
    };
    let headers = response.headers_mut();
    for (name, value) in [
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::X_FRAME_OPTIONS, "DENY"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::CACHE_CONTROL, "no-store"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.insert("cross-origin-resource-policy", HeaderValue::from_static("same-origin"));
    headers.insert("cross-origin-opener-policy", HeaderValue::from_static("same-origin"));
    response
}

fn check(shared: &Shared, request: &Request) -> Result<(), Box<Response>> {
    let headers = request.headers();
    let refuse = |status: StatusCode, why: &'static str| Err(Box::new((status, why).into_response()));
    if request.method() != Method::GET {
        return refuse(StatusCode::METHOD_NOT_ALLOWED, "only GET\n");
    }
    let Some(host) = one(headers, header::HOST).filter(|host| is_own(host)) else {
        return refuse(StatusCode::FORBIDDEN, "this host is not served here\n");
    };
    let upgrades = headers.contains_key(header::UPGRADE) || request.uri().path() == "/session";
    match (headers.contains_key(header::ORIGIN), one(headers, header::ORIGIN)) {
        (true, Some(origin)) if origin == format!("http://{host}") => {}
        (false, _) if !upgrades => {}
        _ => return refuse(StatusCode::FORBIDDEN, "this origin is not served here\n"),
    }
    if let Some(token) = token_of(request.uri().query().unwrap_or_default()).filter(|_| request.uri().path() == "/") {
        return Err(Box::new(if same(token, &shared.token) { enter(shared) } else { stay_out() }));
    }
    if cookies(headers, &shared.cookie).any(|value| same(value, &shared.token)) {
        Ok(())
    } else {
        Err(Box::new(stay_out()))
    }
}

/// The value of a header that is there once, and readable.
fn one(headers: &HeaderMap, name: header::HeaderName) -> Option<&str> {
    let mut values = headers.get_all(name).iter();
    match (values.next(), values.next()) {
        (Some(value), None) => value.to_str().ok(),
        _ => None,
    }
}

/// Whether a host is this machine, by whatever port: a tunnel may have another.
fn is_own(host: &str) -> bool {
    let (name, port) = match host.rsplit_once(':') {
        Some((name, port)) if !port.contains(']') => (name, port),
        _ => (host, "80"),
    };
    OWN.contains(&name) && !port.is_empty() && port.len() <= 5 && port.bytes().all(|b| b.is_ascii_digit())
}

fn token_of(query: &str) -> Option<&str> {
    query.split('&').find_map(|pair| pair.strip_prefix("token="))
}

fn cookies<'h>(headers: &'h HeaderMap, name: &'h str) -> impl Iterator<Item = &'h str> {
    let texts = headers.get_all(header::COOKIE).iter().filter_map(|value| value.to_str().ok());
    let pairs = texts.flat_map(|text| text.split(';')).filter_map(|pair| pair.trim().split_once('='));
    pairs.filter(move |pair| pair.0 == name).map(|pair| pair.1)
}

/// Whether two texts are equal, in a time that does not tell where they differ.
fn same(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.bytes().zip(b.bytes()).fold(0, |differ, (a, b)| differ | (a ^ b)) == 0
}

/// Gives the cookie, and leads to the page without the secret in its address.
fn enter(shared: &Shared) -> Response {
    let cookie = format!("{}={}; HttpOnly; SameSite=Strict; Path=/", shared.cookie, shared.token);
    (StatusCode::SEE_OTHER, [(header::SET_COOKIE, cookie), (header::LOCATION, "/".into())]).into_response()
}

fn stay_out() -> Response {
    let page = "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>landform studio</title>\
        <h1>landform studio</h1><p>Open the whole address that <code>landform studio</code> printed in its terminal, \
        with what follows <code>?token=</code>. If you came from there by a link, <a href=\"/\">go on</a>.</p></html>";
    (StatusCode::FORBIDDEN, [(header::CONTENT_TYPE, "text/html; charset=utf-8")], Body::from(page)).into_response()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_this_machine_is_served() {
        for own in ["127.0.0.1:8000", "localhost:1", "localhost", "[::1]:8000", "[::1]"] {
            assert!(is_own(own), "{own}");
        }
        for other in [
            "evil.example",
            "127.0.0.1.evil.example:80",
            "localhost.evil:1",
            "127.0.0.1:",
            "127.0.0.1:x",
            "10.0.0.1:80",
            "",
            "localhost:1:2",
            "[::1",
        ] {
            assert!(!is_own(other), "{other}");
        }
    }

    #[test]
    fn tokens_are_equal_or_not() {
        assert!(same("abc", "abc") && !same("abc", "abd") && !same("abc", "ab") && !same("", "a"));
        assert_eq!(token_of("a=1&token=xyz&b"), Some("xyz"));
        assert_eq!(token_of("tokens=1"), None);
    }
}
