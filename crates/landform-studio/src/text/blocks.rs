//! The lines of a recipe's text, parted into its steps.
//!
//! # Method
//! Comments right above a header belong to what it begins; those at the head of the file to the
//! file. A step that is off stands as comments of its own kind, `#off [[stage]]`, that programs
//! other than the studio pass over.

use std::ops::Range;

/// What begins a line of a step that is off.
const OFF: &str = "#off ";

/// A step of a text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Block {
    /// Whether it is off.
    pub(crate) off: bool,
    /// From its leading comments to those of what follows.
    pub(crate) whole: Range<usize>,
    /// From its header to its last line with something in it.
    pub(crate) body: Range<usize>,
    /// Line of its header, from 1.
    pub(crate) line: usize,
}

impl Block {
    /// The step as TOML, as if it were on.
    pub(crate) fn toml(&self, text: &str) -> String {
        let body = &text[self.body.clone()];
        if self.off { switched_on(body) } else { body.to_string() }
    }
}

/// The same lines as comments that [`switched_on`] reads back.
pub(crate) fn switched_off(body: &str) -> String {
    body.split_inclusive('\n').flat_map(|line| [OFF, line]).collect()
}

/// Lines without what marks them as off.
pub(crate) fn switched_on(body: &str) -> String {
    let lines = body.split_inclusive('\n');
    lines.map(|line| line.strip_prefix(OFF).or(line.strip_prefix("#off")).unwrap_or(line)).collect()
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Blank,
    Comment,
    Off {
        begins: bool,
    },
    Stage,
    /// A table that belongs to the step above it.
    Below,
    Other,
    Content,
}

struct Line {
    range: Range<usize>,
    kind: Kind,
}

/// The steps of a text, in order.
pub(crate) fn blocks(text: &str) -> Vec<Block> {
    let lines = lines(text);
    let begins = |k: usize| match lines[k].kind {
        Kind::Stage | Kind::Other | Kind::Off { begins: true } => true,
        Kind::Off { begins: false } => false,
        _ => false,
    };
    let anchors: Vec<usize> = (0..lines.len()).filter(|&k| begins(k)).collect();
    let lead = |anchor: usize| {
        let above = lines[..anchor].iter().rev().take_while(|line| line.kind == Kind::Comment).count();
        // What heads the file stays there.
        if above == anchor { lines[anchor].range.start } else { lines[anchor - above].range.start }
    };
    let mut found = Vec::new();
    for (k, &anchor) in anchors.iter().enumerate() {
        let off = match lines[anchor].kind {
            Kind::Stage => false,
            Kind::Off { .. } => true,
            _ => continue,
        };
        let next = anchors.get(k + 1);
        let end = next.map_or(text.len(), |&next| lead(next));
        let own = lines[anchor..next.copied().unwrap_or(lines.len())].iter();
        let last = own.rev().find(|line| match line.kind {
            Kind::Blank | Kind::Comment => false,
            Kind::Off { .. } => off,
            _ => true,
        });
        let body = lines[anchor].range.start..last.map_or(end, |line| line.range.end);
        found.push(Block { off, whole: lead(anchor)..end.max(body.end), body, line: anchor + 1 });
    }
    found
}

/// Every line with what it holds; lines within a text or a list that began above are content.
fn lines(text: &str) -> Vec<Line> {
    let mut state = Within::default();
    let mut at = 0;
    let mut found = Vec::new();
    for line in text.split_inclusive('\n') {
        let range = at..at + line.len();
        at = range.end;
        let kind = if state.is_open() { Kind::Content } else { kind_of(line) };
        if !matches!(kind, Kind::Off { .. } | Kind::Stage | Kind::Below | Kind::Other) {
            state.pass(line);
        }
        found.push(Line { range, kind });
    }
    found
}

fn kind_of(line: &str) -> Kind {
    let trimmed = line.trim();
    if line.starts_with(OFF) || line.trim_end() == "#off" {
        let begins = kind_of(line.strip_prefix(OFF).unwrap_or_default()) == Kind::Stage;
        return Kind::Off { begins };
    }
    match trimmed.chars().next() {
        None => Kind::Blank,
        Some('#') => Kind::Comment,
        Some('[') => {
            let name: String = trimmed.trim_start_matches('[').chars().take_while(|c| *c != ']').collect();
            let mut parts = name.split('.').map(|part| part.trim().trim_matches(['"', '\'']));
            match (parts.next(), parts.next()) {
                (Some("stage"), None) if trimmed.starts_with("[[") => Kind::Stage,
                (Some("stage"), Some(_)) => Kind::Below,
                _ => Kind::Other,
            }
        }
        Some(_) => Kind::Content,
    }
}

/// Whether a place in a text lies within a list or a text of several lines.
#[derive(Default)]
struct Within {
    depth: usize,
    /// What ends the text of several lines that was begun.
    quote: Option<&'static str>,
}

impl Within {
    fn is_open(&self) -> bool {
        self.depth > 0 || self.quote.is_some()
    }

    fn pass(&mut self, line: &str) {
        let mut rest = line;
        while !rest.is_empty() {
            rest = match self.quote {
                Some(end) => self.pass_text(rest, end),
                None => self.pass_plain(rest),
            };
        }
    }

    /// Passes a piece of a text of several lines.
    fn pass_text<'t>(&mut self, rest: &'t str, end: &'static str) -> &'t str {
        if end == "\"\"\"" && rest.starts_with('\\') {
            return skip(rest, 2);
        }
        if let Some(after) = rest.strip_prefix(end) {
            self.quote = None;
            return after;
        }
        skip(rest, 1)
    }

    fn pass_plain<'t>(&mut self, rest: &'t str) -> &'t str {
        for quote in ["\"\"\"", "'''"] {
            if let Some(after) = rest.strip_prefix(quote) {
                self.quote = Some(quote);
                return after;
            }
        }
        match rest.as_bytes()[0] {
            b'#' => "",
            b'[' | b'{' => {
                self.depth += 1;
                &rest[1..]
            }
            b']' | b'}' => {
                self.depth = self.depth.saturating_sub(1);
                &rest[1..]
            }
            quote @ (b'"' | b'\'') => after_text(&rest[1..], quote),
            _ => skip(rest, 1),
        }
    }
}

/// What follows a text of one line.
fn after_text(mut rest: &str, quote: u8) -> &str {
    while let Some(&first) = rest.as_bytes().first() {
        match first {
            b'\\' if quote == b'"' => rest = skip(rest, 2),
            b'\n' => return rest,
            c if c == quote => return &rest[1..],
            _ => rest = skip(rest, 1),
        }
    }
    rest
}

/// The text without its first characters.
fn skip(text: &str, characters: usize) -> &str {
    text.char_indices().nth(characters).map_or("", |(at, _)| &text[at..])
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# A title.\n# Look at: it.\nseed = 3\n\n[environment]\nrainfall = \"1 m/yr\"\n\n# The start.\n[[stage]]\nuse = \"flat\" # plain\n[stage.grid]\nsize = [\n  \"1 km\", # not [[stage]]\n  \"1 km\",\n]\n\n#off [[stage]]\n#off use = \"add\"\n\n[[stage]]\nuse = \"write_raster\"\nnote = \"\"\"\n[[stage]]\n\"\"\"\n";

    #[test]
    fn a_text_is_parted_into_its_steps() {
        let found = blocks(TEXT);
        let bodies: Vec<_> = found.iter().map(|b| (b.off, &TEXT[b.body.clone()])).collect();
        assert_eq!(bodies.len(), 3, "{bodies:?}");
        assert!(bodies[0].1.starts_with("[[stage]]\nuse = \"flat\"") && bodies[0].1.ends_with("]\n"));
        assert_eq!(bodies[1], (true, "#off [[stage]]\n#off use = \"add\"\n"));
        assert!(bodies[2].1.ends_with("\"\"\"\n"));
        assert!(TEXT[found[0].whole.clone()].starts_with("# The start.\n"));
        assert_eq!(found[0].whole.end, found[1].whole.start);
        assert_eq!((found[0].line, found[2].line), (9, 20));
        assert_eq!(found[1].toml(TEXT), "[[stage]]\nuse = \"add\"\n");
    }

    #[test]
    fn off_and_on_again_gives_the_same_bytes() {
        for body in ["[[stage]]\r\nuse = \"x\"\r\n\r\nkey = 1", "[[stage]]\n\n#off kept\na = 1\n"] {
            assert_eq!(switched_on(&switched_off(body)), body);
        }
    }

    #[test]
    fn a_head_of_comments_alone_stays() {
        let text = "# Title\n[[stage]]\nuse = \"flat\"\n";
        assert_eq!(blocks(text)[0].whole, 8..text.len());
        assert!(blocks("").is_empty() && blocks("\"\"\"").is_empty() && blocks("é\\\"é'").is_empty());
    }
}
