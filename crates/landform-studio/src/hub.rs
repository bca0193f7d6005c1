//! The pages that look on, and what is on its way to each.
//!
//! # Method
//! Of what changes all the time (recipe, state, charts, the ground) a page gets the newest: older
//! ones that were not sent are dropped. Answers wait for room, and with them the page's further
//! requests. So a page that does not read costs a bounded amount of memory.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};
use std::time::{Duration, Instant};

use serde_json::{Value as Json, json};
use tokio::sync::Notify;

use crate::protocol::{Band, Encoding, Frame, bands};

/// Frames that were sent and not acknowledged.
pub(crate) const MOST_IN_FLIGHT: usize = 2;
/// Answers that wait to be sent.
const MOST_ANSWERS: usize = 64;
/// Lines of the log and single events that wait to be sent; older ones are dropped.
const MOST_EVENTS: usize = 100;
/// Fields that one page may ask for.
const MOST_FIELDS: usize = 8;
/// Pages at once.
pub(crate) const MOST_PAGES: usize = 16;
/// Acknowledgements that take longer ask for smaller messages.
const SLOW: Duration = Duration::from_millis(150);

/// A lock that a panic elsewhere does not close.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What is kept in its newest form alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slot {
    Recipe,
    State,
    Charts,
    Fields,
}

/// How many slots there are.
const SLOTS: usize = 4;

/// All pages.
pub(crate) struct Hub {
    /// Name of the session.
    pub(crate) session: String,
    /// When the server began: its clock.
    began: Instant,
    pages: Mutex<Vec<Weak<Page>>>,
    newest: Mutex<Newest>,
    numbers: AtomicU64,
}

#[derive(Default)]
struct Newest {
    slots: [Option<Arc<str>>; SLOTS],
    frame: Option<Arc<Frame>>,
}

/// A page.
pub(crate) struct Page {
    mail: Mutex<Mail>,
    /// There is something to send.
    post: Notify,
    /// There is room for answers.
    room: Notify,
}

#[derive(Default)]
struct Mail {
    answers: VecDeque<String>,
    slots: [Option<Arc<str>>; SLOTS],
    events: VecDeque<Arc<str>>,
    frame: Option<Arc<Frame>>,
    /// Bands of the frame that is being sent.
    bands: VecDeque<Band>,
    in_flight: VecDeque<(u64, Instant)>,
    fields: Vec<String>,
    slow: bool,
    closed: bool,
}

/// What is sent.
pub(crate) enum Letter {
    Text(String),
    Band(Vec<u8>),
    Close,
}

impl Hub {
    pub(crate) fn new(session: String) -> Self {
        let (pages, newest, numbers) = Default::default();
        Self { session, began: Instant::now(), pages, newest, numbers }
    }

    /// Milliseconds since the server began.
    pub(crate) fn clock(&self) -> f64 {
        self.began.elapsed().as_secs_f64() * 1e3
    }

    /// Lets a page in; none if there are too many.
    pub(crate) fn join(&self) -> Option<Arc<Page>> {
        let mut pages = lock(&self.pages);
        pages.retain(|page| page.strong_count() > 0);
        if pages.len() >= MOST_PAGES {
            return None;
        }
        let page = Arc::new(Page { mail: Mutex::default(), post: Notify::new(), room: Notify::new() });
        pages.push(Arc::downgrade(&page));
        Some(page)
    }

    fn pages(&self) -> Vec<Arc<Page>> {
        lock(&self.pages).iter().filter_map(Weak::upgrade).collect()
    }

    /// Everything that a page needs to begin.
    pub(crate) fn welcome(&self, page: &Page) {
        let newest = lock(&self.newest);
        let mut mail = lock(&page.mail);
        mail.slots.clone_from(&newest.slots);
        mail.frame.clone_from(&newest.frame);
        mail.in_flight.clear();
        drop(mail);
        page.post.notify_one();
    }

    /// Tells all pages the newest of something.
    pub(crate) fn tell(&self, slot: Slot, what: &Json) {
        let text: Arc<str> = what.to_string().into();
        lock(&self.newest).slots[slot as usize] = Some(text.clone());
        for page in self.pages() {
            lock(&page.mail).slots[slot as usize] = Some(text.clone());
            page.post.notify_one();
        }
    }

    /// Tells all pages something, unless it is as it was.
    pub(crate) fn tell_if_new(&self, slot: Slot, what: &Json) {
        let is_old = lock(&self.newest).slots[slot as usize].as_deref() == Some(what.to_string().as_str());
        if !is_old {
            self.tell(slot, what);
        }
    }

    /// Tells all pages something that happened.
    pub(crate) fn event(&self, what: &Json) {
        let text: Arc<str> = what.to_string().into();
        self.pages().iter().for_each(|page| page.event(text.clone()));
    }

    /// A line of the log.
    pub(crate) fn log(&self, kind: &str, text: &str) {
        self.event(&json!({ "tell": "log", "kind": kind, "text": text }));
    }

    /// Forgets ground and charts of what was before.
    pub(crate) fn forget(&self) {
        let mut newest = lock(&self.newest);
        newest.frame = None;
        newest.slots[Slot::Charts as usize] = None;
        newest.slots[Slot::Fields as usize] = None;
        for page in self.pages() {
            let mut mail = lock(&page.mail);
            mail.frame = None;
            mail.slots[Slot::Charts as usize] = None;
        }
    }

    pub(crate) fn next_number(&self) -> u64 {
        self.numbers.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Shows the ground to all pages.
    pub(crate) fn show(&self, frame: Frame) {
        let frame = Arc::new(frame);
        lock(&self.newest).frame = Some(frame.clone());
        for page in self.pages() {
            lock(&page.mail).frame = Some(frame.clone());
            page.post.notify_one();
        }
    }

    /// Whether a page could take another frame.
    pub(crate) fn has_room(&self) -> bool {
        self.pages().iter().any(|page| {
            let mail = lock(&page.mail);
            mail.frame.is_none() && mail.bands.is_empty() && mail.in_flight.len() < MOST_IN_FLIGHT
        })
    }

    /// The fields that pages ask for, beside elevation.
    pub(crate) fn fields(&self) -> Vec<String> {
        let mut all: Vec<String> = Vec::new();
        for page in self.pages() {
            for field in &lock(&page.mail).fields {
                if all.len() < 2 * MOST_FIELDS && !all.contains(field) {
                    all.push(field.clone());
                }
            }
        }
        all
    }

    /// Ends all pages.
    pub(crate) fn close(&self) {
        self.pages().iter().for_each(|page| page.close());
    }
}

impl Page {
    /// Waits for room, then puts an answer to the others.
    pub(crate) async fn answer(&self, what: Json) {
        loop {
            let room = self.room.notified();
            {
                let mut mail = lock(&self.mail);
                if mail.closed {
                    return;
                }
                if mail.answers.len() < MOST_ANSWERS {
                    mail.answers.push_back(what.to_string());
                    break;
                }
            }
            room.await;
        }
        self.post.notify_one();
    }

    fn event(&self, text: Arc<str>) {
        let mut mail = lock(&self.mail);
        if mail.events.len() >= MOST_EVENTS {
            mail.events.pop_front();
        }
        mail.events.push_back(text);
        drop(mail);
        self.post.notify_one();
    }

    pub(crate) fn close(&self) {
        lock(&self.mail).closed = true;
        self.post.notify_one();
        self.room.notify_one();
    }

    pub(crate) fn is_closed(&self) -> bool {
        lock(&self.mail).closed
    }

    /// A frame was drawn; those before it are taken as drawn too.
    pub(crate) fn acknowledge(&self, frame: u64) {
        let mut mail = lock(&self.mail);
        while let Some(&(number, sent)) = mail.in_flight.front()
            && number <= frame
        {
            mail.slow = sent.elapsed() > SLOW;
            mail.in_flight.pop_front();
        }
        drop(mail);
        self.post.notify_one();
    }

    /// Which fields it wants; whether that is new.
    pub(crate) fn want(&self, fields: Vec<String>) -> bool {
        let mut wanted: Vec<String> = fields.into_iter().filter(|f| f != "elevation" && f.len() <= 100).collect();
        wanted.truncate(MOST_FIELDS);
        let mut mail = lock(&self.mail);
        let is_new = mail.fields != wanted;
        mail.fields = wanted;
        is_new
    }

    /// Waits for the next thing to send.
    pub(crate) async fn next(&self, hub: &Hub) -> Letter {
        loop {
            let post = self.post.notified();
            if let Some(letter) = self.take(hub) {
                return letter;
            }
            post.await;
        }
    }

    fn take(&self, hub: &Hub) -> Option<Letter> {
        let mut mail = lock(&self.mail);
        if mail.closed {
            return Some(Letter::Close);
        }
        // A page that is told that its edit is done has the new text.
        if let Some(text) = mail.slots[Slot::Recipe as usize].take() {
            return Some(Letter::Text(text.to_string()));
        }
        if let Some(answer) = mail.answers.pop_front() {
            self.room.notify_one();
            return Some(Letter::Text(answer));
        }
        if let Some(text) = mail.slots.iter_mut().find_map(Option::take) {
            return Some(Letter::Text(text.to_string()));
        }
        if let Some(text) = mail.events.pop_front() {
            return Some(Letter::Text(text.to_string()));
        }
        if mail.bands.is_empty() && mail.in_flight.len() < MOST_IN_FLIGHT {
            let frame = mail.frame.take()?;
            mail.bands = bands(&frame, &mail.fields).into();
            mail.in_flight.push_back((frame.number, Instant::now()));
            if let Some(stamp) = frame.stamp {
                let latency = json!({ "tell": "latency", "stamp": stamp.page, "received": stamp.received,
                    "computed": stamp.computed, "sent": hub.clock() });
                mail.events.push_back(latency.to_string().into());
            }
        }
        let band = mail.bands.pop_front()?;
        let encoding = match (mail.slow, band.is_of_much()) {
            (true, _) => Encoding::U16DeltaDeflate,
            (false, true) => Encoding::U16,
            (false, false) => Encoding::F32,
        };
        // Writing takes a while.
        drop(mail);
        Some(Letter::Band(band.write(&hub.session, encoding)))
    }
}
