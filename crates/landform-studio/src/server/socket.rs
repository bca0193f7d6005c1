//! The connection of a page.

use std::time::Duration;

use axum::extract::State;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use serde_json::json;

use super::Shared;
use crate::hub::{Letter, Page};
use crate::protocol::read;

/// Most bytes of a message of a page.
const MOST_MESSAGE: usize = 1 << 20;
/// A page that takes nothing for so long is let go.
const PATIENCE: Duration = Duration::from_secs(60);

pub(super) async fn session(State(shared): State<Shared>, upgrade: WebSocketUpgrade) -> Response {
    let Some(page) = shared.studio.hub.join() else {
        return (StatusCode::SERVICE_UNAVAILABLE, "too many pages are open\n").into_response();
    };
    let upgrade = upgrade.max_message_size(MOST_MESSAGE).max_frame_size(MOST_MESSAGE);
    upgrade.on_upgrade(move |socket| async move {
        let (to, from) = socket.split();
        let writing = tokio::spawn({
            let (page, shared) = (page.clone(), shared.clone());
            async move { write(to, &page, &shared).await }
        });
        listen(from, &page, &shared).await;
        page.close();
        writing.await.ok();
    })
}

/// Sends what there is for a page.
async fn write(mut to: SplitSink<WebSocket, Message>, page: &Page, shared: &Shared) {
    loop {
        let message = match page.next(&shared.studio.hub).await {
            Letter::Text(text) => Message::Text(text.into()),
            Letter::Band(bytes) => Message::Binary(bytes.into()),
            Letter::Close => break,
        };
        match tokio::time::timeout(PATIENCE, to.send(message)).await {
            Ok(Ok(())) => {}
            _ => break,
        }
    }
    page.close();
    tokio::time::timeout(Duration::from_secs(1), to.close()).await.ok();
}

/// Takes requests, one after the other.
async fn listen(mut from: SplitStream<WebSocket>, page: &Page, shared: &Shared) {
    while let Some(Ok(message)) = from.next().await {
        match message {
            Message::Text(text) => match read(&text) {
                Ok(request) => shared.studio.take(page, request).await,
                Err((request, what)) => {
                    let hint = "see the protocol of the studio";
                    page.answer(json!({ "tell": "refused", "request": request, "what": what, "hint": hint })).await;
                }
            },
            Message::Close(_) => break,
            _ => {}
        }
        if page.is_closed() {
            break;
        }
        // Other pages are heard too.
        tokio::task::yield_now().await;
    }
}
