//! Who may import whom, inside the crates (between crates the compiler sees to it): ranks of
//! modules, and no circle among the files or folders of any folder.
//!
//! # Method
//! Imports are read as text: `use` groups and paths that begin with `crate` or `super`. A name that
//! a `mod.rs` passes on from one of its children counts as the child's. A `mod.rs` may use its
//! children and they it; between siblings arrows run one way.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Inside core a module may import those of lower rank, and its own.
const CORE_RANKS: &[(&str, u32)] = &[
    ("error", 0),
    ("units", 1),
    ("math", 1),
    ("random", 1),
    ("parallel", 1),
    ("recent", 1),
    ("feature", 2),
    ("grid", 2),
    ("field", 3),
    ("terrain", 4),
    ("algo", 5),
    ("agents", 6),
    ("verb", 7),
    ("analysis", 8),
    ("sim", 8),
    ("stage", 9),
];
/// Modules of rank 1 may use each other downwards.
const SAME_RANK_ALLOWED: u32 = 1;

/// Whether a module may import another.
type Rule = fn(&str, &str) -> bool;

/// Checks the tree; prints every breach.
pub(crate) fn check() -> bool {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates");
    let mut breaches = Vec::new();
    let crates: [(&str, Rule); 5] = [
        ("landform-core", core),
        ("landform-process", process),
        ("landform-io", io),
        ("landform", |_, _| true),
        ("landform-studio", studio),
    ];
    for (name, rule) in crates {
        let tree = Tree::read(&root.join(name).join("src"));
        for (file, target) in tree.imports() {
            if let (Some(from), Some(to)) = (file.first(), target.first())
                && from != to
                && tree.is_module(std::slice::from_ref(to))
                && !rule(from, to)
            {
                breaches.push(format!("{name}: {} imports `{to}`", file.join("/")));
            }
        }
        breaches.extend(tree.circles().into_iter().map(|circle| format!("{name}: a circle of {circle}")));
    }
    breaches.dedup();
    for b in &breaches {
        eprintln!("layers: {b}");
    }
    println!("layers: {}", if breaches.is_empty() { "clean" } else { "broken" });
    breaches.is_empty()
}

fn core(module: &str, target: &str) -> bool {
    let rank = |m: &str| CORE_RANKS.iter().find(|r| r.0 == m).map(|r| r.1);
    match (rank(module), rank(target)) {
        (Some(m), Some(t)) => t < m || (t == m && m == SAME_RANK_ALLOWED),
        _ => false,
    }
}

fn process(_: &str, target: &str) -> bool {
    target == "mechanism"
}

fn io(module: &str, target: &str) -> bool {
    match module {
        "render" => target != "format",
        "format" => !["render", "report", "export"].contains(&target),
        _ => true,
    }
}

/// Text and protocol know nothing of sessions, jobs and servers.
fn studio(module: &str, target: &str) -> bool {
    match module {
        "text" => false,
        "protocol" => target == "text",
        "root" => false,
        "hub" => target == "protocol",
        "session" | "jobs" => !["server", "studio"].contains(&target) && (module != "session" || target != "jobs"),
        "studio" => target != "server",
        _ => true,
    }
}

/// A module's path from the root of its crate.
type Module = Vec<String>;

/// The modules of a crate, and what each imports.
struct Tree {
    code: BTreeMap<Module, String>,
    /// Names that a module passes on, and the child that has them.
    passed_on: BTreeMap<Module, BTreeMap<String, String>>,
}

impl Tree {
    fn read(src: &Path) -> Self {
        let mut code = BTreeMap::new();
        for file in sources(src) {
            let relative = file.strip_prefix(src).unwrap_or(&file).with_extension("");
            let mut module: Module = relative.iter().map(|p| p.to_string_lossy().into_owned()).collect();
            if module.contains(&"tests".to_string()) {
                continue;
            }
            if module.last().is_some_and(|m| m == "mod" || m == "lib") {
                module.pop();
            }
            let text = fs::read_to_string(&file).unwrap_or_default();
            // What stands below the tests' mark may import what it likes.
            let own = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
            let lines = own.lines().filter(|l| !l.trim_start().starts_with("//"));
            code.insert(module, lines.collect::<Vec<_>>().join("\n"));
        }
        let mut tree = Self { code, passed_on: BTreeMap::new() };
        for (module, text) in &tree.code {
            let mut names = BTreeMap::new();
            for path in used(text) {
                if let [child, .., name] = path.as_slice()
                    && tree.is_module(&[module.as_slice(), std::slice::from_ref(child)].concat())
                {
                    names.insert(name.clone(), child.clone());
                }
            }
            tree.passed_on.insert(module.clone(), names);
        }
        tree
    }

    fn is_module(&self, path: &[String]) -> bool {
        self.code.contains_key(path)
    }

    /// Importing module and what it imports, as paths from the root.
    fn imports(&self) -> Vec<(Module, Module)> {
        let mut found = Vec::new();
        for (module, text) in &self.code {
            for path in used(text) {
                let Some(mut target) = absolute(module, &path) else { continue };
                // `super::Name`, where the parent has `use child::Name`.
                if let Some((name, parent)) = target.clone().split_last()
                    && !self.is_module(&target)
                    && let Some(child) = self.passed_on.get(parent).and_then(|names| names.get(name))
                {
                    target = [parent, std::slice::from_ref(child)].concat();
                }
                found.push((module.clone(), target));
            }
        }
        found
    }

    /// Circles among the children of every module.
    fn circles(&self) -> Vec<String> {
        let mut arrows: BTreeMap<Module, BTreeMap<String, BTreeSet<String>>> = BTreeMap::new();
        for (from, to) in self.imports() {
            let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
            let (Some(a), Some(b)) = (from.get(common), to.get(common)) else { continue };
            let parent = &from[..common];
            if self.is_module(&[parent, std::slice::from_ref(b)].concat()) {
                arrows.entry(parent.to_vec()).or_default().entry(a.clone()).or_default().insert(b.clone());
            }
        }
        let mut found = Vec::new();
        for (parent, arrows) in arrows {
            let reaches = |from: &String| {
                let (mut seen, mut stack) = (BTreeSet::new(), vec![from.clone()]);
                while let Some(at) = stack.pop() {
                    let next = arrows.get(&at).into_iter().flatten();
                    stack.extend(next.filter(|n| seen.insert((*n).clone())).cloned().collect::<Vec<_>>());
                }
                seen
            };
            let all: BTreeMap<&String, BTreeSet<String>> = arrows.keys().map(|k| (k, reaches(k))).collect();
            let in_circle = |k: &&&String| all[**k].contains(**k);
            let members: Vec<&str> = all.keys().filter(in_circle).map(|k| k.as_str()).collect();
            if !members.is_empty() {
                found.push(format!("{} in {}/", members.join(", "), parent.join("/")));
            }
        }
        found
    }
}

/// A path from the root of the crate; none for other crates.
fn absolute(module: &[String], path: &[String]) -> Option<Module> {
    let up = path.iter().take_while(|p| *p == "super").count();
    match path.first()?.as_str() {
        "crate" => Some(path[1..].to_vec()),
        "super" => Some([&module[..module.len().checked_sub(up)?], &path[up..]].concat()),
        _ => None,
    }
}

/// All Rust files under a folder.
pub(crate) fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    for path in entries.flatten().map(|e| e.path()) {
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Paths in imports, and paths in code that begin with `crate::` or `super::`.
fn used(code: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    for statement in code.split("use ").skip(1) {
        let statement = statement.split(';').next().unwrap_or_default();
        if statement.len() < 4_000 {
            unfold(&[], statement, &mut found);
        }
    }
    for start in ["crate::", "super::"] {
        for (at, _) in code.match_indices(start) {
            let path =
                code[at..].split(|c: char| !c.is_alphanumeric() && c != '_' && c != ':').next().unwrap_or_default();
            let parts: Vec<String> = path.split("::").filter(|p| !p.is_empty()).map(String::from).collect();
            if !code[..at].ends_with("::") {
                found.push(parts);
            }
        }
    }
    found
}

/// Unfolds `a::{b, c::{d, e}}`.
fn unfold(before: &[String], text: &str, found: &mut Vec<Vec<String>>) {
    let text = text.trim();
    let Some((head, group)) = text.split_once('{') else {
        let name = text.split(" as ").next().unwrap_or_default();
        let parts = name.split("::").map(|p| p.trim().to_string()).filter(|p| !p.is_empty());
        let path: Vec<String> = before.iter().cloned().chain(parts).collect();
        if path.iter().all(|p| p.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '*')) {
            found.push(path);
        }
        return;
    };
    let parts = head.split("::").map(|p| p.trim().to_string()).filter(|p| !p.is_empty());
    let path: Vec<String> = before.iter().cloned().chain(parts).collect();
    let (mut depth, mut start) = (0, 0);
    let group = group.rsplit_once('}').map_or(group, |g| g.0);
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                unfold(&path, &group[start..at], found);
                start = at + 1;
            }
            _ => {}
        }
    }
    if !group[start..].trim().is_empty() {
        unfold(&path, &group[start..], found);
    }
}
