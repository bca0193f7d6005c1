//! The one folder that the studio may reach, and its own scratch folder.

use std::fs;
use std::path::{Component, Path, PathBuf};

use landform::core::verb::relative_path;
use landform::recipe::Recipe;
use landform::{Error, Result};

/// Folders that may be read.
#[derive(Debug)]
pub(crate) struct Root {
    /// Recipes and what they read lie below it.
    folder: PathBuf,
    /// Recipes of the gallery lie below it, with their data.
    scratch: Scratch,
}

impl Root {
    /// # Errors
    /// [`Error::Io`] if the folder is not there, or no scratch folder can be made.
    pub(crate) fn new(folder: &Path) -> Result<Self> {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let real = folder.canonicalize().map_err(|e| Error::io("find", folder, e))?;
        Ok(Self { folder: real, scratch: Scratch::new()? })
    }

    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    pub(crate) fn scratch(&self) -> &Path {
        &self.scratch.0
    }

    /// A file below the root, which may not exist yet.
    ///
    /// # Errors
    /// [`Error::Outside`] for a path that leads out, over a link too.
    pub(crate) fn file(&self, path: &str) -> Result<PathBuf> {
        // The page may send back what it was told.
        let below = Path::new(path).strip_prefix(&self.folder).ok().and_then(Path::to_str).unwrap_or(path);
        let file = self.folder.join(relative_path(below)?);
        check_below(&file, &[&self.folder], path)?;
        Ok(file)
    }

    /// Refuses a recipe that reads a file outside.
    ///
    /// # Errors
    /// [`Error::Outside`].
    pub(crate) fn check(&self, recipe: &Recipe) -> Result<()> {
        let allowed = [self.folder.as_path(), self.scratch()];
        recipe.inputs().try_for_each(|input| check_below(&input, &allowed, &input.display().to_string())).map_err(|e| {
            let what = format!("{e} (the studio reads nothing outside of {})", self.folder.display());
            Error::Recipe {
                at: None,
                what,
                hint: Some("copy the file beside the recipe, or start the studio there".into()),
            }
        })
    }
}

/// Refuses a path that leads out of folders, by its words or over a link.
pub(crate) fn check_below(path: &Path, folders: &[&Path], said: &str) -> Result<()> {
    let outside = |by_link| Error::Outside { name: "path".into(), path: said.into(), by_link };
    let path = std::path::absolute(path).map_err(|e| Error::io("find", path, e))?;
    let path = plain(&path);
    if !folders.iter().any(|folder| path.starts_with(folder)) {
        // A folder may itself have been named over a link.
        let real = real(&path).ok_or_else(|| outside(false))?;
        if !folders.iter().any(|folder| real.starts_with(folder)) {
            return Err(outside(false));
        }
    }
    let real = real(&path).ok_or_else(|| outside(true))?;
    if folders.iter().any(|folder| real.starts_with(folder)) { Ok(()) } else { Err(outside(true)) }
}

/// The path without steps back, by its words.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for step in path.components() {
        match step {
            Component::ParentDir => {
                plain.pop();
            }
            Component::CurDir => {}
            other => plain.push(other),
        }
    }
    plain
}

/// Where a path leads, its links followed as far as it exists.
fn real(path: &Path) -> Option<PathBuf> {
    for there in path.ancestors() {
        match fs::symlink_metadata(there) {
            // A link that leads nowhere could lead anywhere later.
            Ok(_) => return Some(there.canonicalize().ok()?.join(path.strip_prefix(there).ok()?)),
            Err(_) => continue,
        }
    }
    None
}

/// A folder that goes with the program.
#[derive(Debug)]
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Result<Self> {
        let path = std::env::temp_dir().join(format!("landform-studio-{}", random_word()?));
        let mut builder = fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
        builder.create(&path).map_err(|e| Error::io("create folder", &path, e))?;
        let real = path.canonicalize().map_err(|e| Error::io("find", &path, e))?;
        Ok(Self(real))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What cannot be removed only takes room.
        fs::remove_dir_all(&self.0).ok();
    }
}

/// 128 bits that nobody can guess, as hexadecimal digits.
///
/// # Errors
/// If the system has no randomness.
pub(crate) fn random_word() -> Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|e| {
        let what = format!("the system gives no random numbers: {e}");
        Error::Recipe { at: None, what, hint: None }
    })?;
    Ok(bytes.iter().map(|b| format!("{b:02x}")).collect())
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_below_the_root() {
        let around = tempfile::tempdir().unwrap();
        let folder = around.path().join("root");
        fs::create_dir_all(folder.join("inner")).unwrap();
        fs::write(around.path().join("secret.toml"), "").unwrap();
        std::os::unix::fs::symlink(around.path(), folder.join("out")).unwrap();
        std::os::unix::fs::symlink(around.path().join("no_such"), folder.join("nowhere.toml")).unwrap();
        let root = Root::new(&folder).unwrap();
        assert!(root.file("a.toml").is_ok() && root.file("inner/b.toml").is_ok() && root.file("new/c.toml").is_ok());
        for bad in
            ["../secret.toml", "out/secret.toml", "/etc/passwd", "nowhere.toml", "", "inner/../../secret.toml", "a\0b"]
        {
            assert!(root.file(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn a_recipe_that_reads_outside_is_refused() {
        let around = tempfile::tempdir().unwrap();
        let folder = around.path().join("root");
        fs::create_dir(&folder).unwrap();
        fs::write(around.path().join("map.png"), "").unwrap();
        std::os::unix::fs::symlink(around.path().join("map.png"), folder.join("link.png")).unwrap();
        let root = Root::new(&folder).unwrap();
        let flat = "[[stage]]\nuse = \"flat\"\n";
        let map = |path: &str| format!("{{ image = \"{path}\", black = \"0 m/yr\", white = \"1 m/yr\" }}");
        let add =
            |path: &str| format!("{flat}[[stage]]\nuse = \"add\"\nelevation = {}", map(path).replace("m/yr", "m"));
        let rain = |path: &str| format!("[environment]\nrainfall = {}\n{flat}", map(path));
        let read = |text: &str| Recipe::parse(text, "x", &folder, &[]).unwrap();
        for path in ["../map.png", "link.png", "/etc/hostname"] {
            assert!(root.check(&read(&add(path))).is_err(), "{path}");
            assert!(root.check(&read(&rain(path))).is_err(), "{path}");
        }
        assert!(root.check(&read(&add("map.png"))).is_ok());
    }
}
