//! What a page asks for.

use serde::Deserialize;
use serde_json::{Map, Value as Json};

use crate::text::Key;

/// A request with its number.
#[derive(Debug, Deserialize)]
pub(crate) struct Numbered {
    /// Number that the answer carries.
    #[serde(default)]
    pub(crate) request: u64,
    #[serde(flatten)]
    pub(crate) what: Request,
}

/// What is asked for.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
pub(crate) enum Request {
    /// The state of all, for a page that begins.
    Hello {
        #[serde(default)]
        protocol: Option<u32>,
    },
    /// A recipe of the gallery, or one of a file.
    Open {
        #[serde(default)]
        gallery: Option<String>,
        #[serde(default)]
        path: Option<String>,
    },
    /// The whole text.
    Text {
        text: String,
    },
    /// One value of the text.
    Set {
        #[serde(default)]
        stage: Option<usize>,
        #[serde(default)]
        process: Option<usize>,
        key: Vec<Key>,
        #[serde(default)]
        value: Json,
        #[serde(default)]
        dragging: bool,
        #[serde(default)]
        stamp: Option<f64>,
    },
    /// A new step, or a new process in a step.
    Insert {
        at: usize,
        #[serde(rename = "use")]
        name: String,
        #[serde(default)]
        process_of: Option<usize>,
    },
    Remove {
        stage: usize,
        #[serde(default)]
        process: Option<usize>,
    },
    Move {
        stage: usize,
        to: usize,
    },
    Toggle {
        stage: usize,
    },
    Undo,
    Redo,
    /// A run at a level.
    Run {
        #[serde(default = "auto")]
        level: String,
    },
    Pause,
    Play {
        /// Least time from step to step, ms.
        #[serde(default)]
        pace: Option<f64>,
    },
    Step,
    Stop,
    /// Which fields this page wants, and after which step all look.
    Show {
        #[serde(default)]
        fields: Option<Vec<String>>,
        #[serde(default)]
        stage: Option<usize>,
    },
    Ack {
        frame: u64,
    },
    /// A piece of a stroke into the model that runs or is held.
    Paint {
        #[serde(default)]
        field: Option<String>,
        tool: String,
        radius: f64,
        strength: f64,
        points: Vec<Vec<f64>>,
    },
    /// A stroke that becomes part of a value of the text.
    Stroke {
        stage: usize,
        #[serde(default)]
        process: Option<usize>,
        key: Vec<Key>,
        #[serde(default)]
        tool: Option<String>,
        radius: Json,
        strength: Json,
        points: Vec<Vec<f64>>,
    },
    Build,
    CancelBuild,
    Export {
        #[serde(rename = "use")]
        name: String,
        #[serde(default)]
        parameters: Map<String, Json>,
    },
    Contact {
        seeds: Vec<u64>,
    },
    Save {
        #[serde(default)]
        path: Option<String>,
    },
    Command,
}

fn auto() -> String {
    "auto".into()
}

/// Reads a message.
///
/// # Errors
/// Why it is none, with its number if that can be read.
pub(crate) fn read(text: &str) -> Result<Numbered, (u64, String)> {
    serde_json::from_str::<Numbered>(text).map_err(|e| {
        let number = serde_json::from_str::<Json>(text).ok().and_then(|json| json["request"].as_u64());
        (number.unwrap_or(0), e.to_string())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_are_read_and_nonsense_is_not() {
        let set =
            read(r#"{"do":"set","request":7,"stage":1,"process":null,"key":["a",2],"value":"5 m","dragging":true}"#);
        let Ok(Numbered { request: 7, what: Request::Set { key, dragging: true, .. } }) = set else { panic!() };
        assert_eq!(key, [Key::Name("a".into()), Key::Place(2)]);
        assert!(matches!(read(r#"{"do":"undo"}"#), Ok(Numbered { what: Request::Undo, .. })));
        assert!(matches!(read(r#"{"do":"build"}"#), Ok(Numbered { what: Request::Build, .. })));
        for nonsense in ["", "[]", "{}", r#"{"do":"fly"}"#, r#"{"do":"ack"}"#, "{\"do\":\"ack\",\"frame\":-1}"] {
            assert!(read(nonsense).is_err(), "{nonsense}");
        }
        assert_eq!(read(r#"{"do":"fly","request":9}"#).unwrap_err().0, 9);
    }
}
