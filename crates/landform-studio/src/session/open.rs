//! Recipes from the gallery and from files, and back to files.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use landform::core::error::nearest;
use landform::io::files::{read_whole, write_whole};
use landform::recipe::GALLERY;
use landform::{Error, Result};

use super::{MOST_TEXT, Session};
use crate::text::History;

impl Session {
    /// Opens a recipe of the gallery, whose data are put into the scratch folder.
    ///
    /// # Errors
    /// [`Error::Recipe`] if there is none of that name; [`Error::Io`].
    pub(crate) fn open_gallery(&mut self, name: &str) -> Result<()> {
        let Some(recipe) = GALLERY.iter().find(|recipe| recipe.name == name) else {
            let hint =
                nearest(name, GALLERY.iter().map(|recipe| recipe.name)).map(|near| format!("did you mean `{near}`?"));
            return Err(Error::Recipe { at: None, what: format!("the gallery has no `{name}`"), hint });
        };
        let folder = self.root.scratch().join(recipe.name);
        for (path, bytes) in recipe.data {
            put(&folder.join(path), bytes)?;
        }
        fs::create_dir_all(&folder).map_err(|e| Error::io("create folder", &folder, e))?;
        (self.path, self.saved) = (None, None);
        self.begin(recipe.text, recipe.name, &folder);
        Ok(())
    }

    /// Opens a recipe file below the root.
    ///
    /// # Errors
    /// [`Error::Outside`], [`Error::Io`], [`Error::Format`] if it is no text or too long.
    pub(crate) fn open_file(&mut self, path: &str) -> Result<()> {
        let file = self.root.file(path)?;
        let size = fs::metadata(&file).map_err(|e| Error::io("read", &file, e))?.len();
        if size > MOST_TEXT as u64 {
            return Err(Error::parameter(
                "path",
                format!("a file of {size} bytes"),
                &format!("at most {MOST_TEXT} bytes"),
            ));
        }
        let text = String::from_utf8(read_whole(&file)?).map_err(|e| Error::format("recipe", e))?;
        let name = file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let folder = file.parent().unwrap_or(self.root.folder()).to_path_buf();
        self.saved = Some(text.as_str().into());
        self.path = Some(file);
        self.begin(&text, &name, &folder);
        Ok(())
    }

    fn begin(&mut self, text: &str, name: &str, folder: &Path) {
        (self.name, self.folder) = (name.into(), folder.into());
        (self.shown, self.seconds) = (None, Vec::new());
        self.history = History::of(text);
        self.understand();
    }

    /// Writes the text to a file below the root: the one given, else the one it came from, else one
    /// of its name, which must be new. Data of the gallery come along.
    ///
    /// # Errors
    /// [`Error::Outside`], [`Error::Io`].
    pub(crate) fn save(&mut self, path: Option<&str>) -> Result<PathBuf> {
        let own = || self.path.as_ref().map(|path| path.display().to_string());
        let said = path.map(String::from).or_else(own).unwrap_or_else(|| format!("{}.toml", self.name));
        if !said.to_lowercase().ends_with(".toml") {
            return Err(Error::extension("path", &said, &["toml"]));
        }
        let file = self.root.file(&said)?;
        let is_own = self.path.as_ref() == Some(&file);
        if !is_own && file.exists() {
            let hint = Some("give another name".into());
            return Err(Error::Recipe { at: None, what: format!("{} is already there", file.display()), hint });
        }
        if is_own && self.saved.as_ref().is_some_and(|saved| read_whole(&file).is_ok_and(|now| now != saved.as_bytes()))
        {
            let what = format!("{} was changed by another program since it was opened", file.display());
            return Err(Error::Recipe {
                at: None,
                what,
                hint: Some("save under another name, or open it again".into()),
            });
        }
        let folder = file.parent().unwrap_or(self.root.folder()).to_path_buf();
        fs::create_dir_all(&folder).map_err(|e| Error::io("create folder", &folder, e))?;
        let text: Arc<str> = self.history.now().clone();
        if folder != self.folder {
            self.bring(&folder)?;
        }
        write_whole(&file, text.as_bytes())?;
        (self.saved, self.path) = (Some(text), Some(file.clone()));
        if folder != self.folder {
            self.folder = folder;
            self.understand();
        }
        Ok(file)
    }

    /// Copies data of the gallery to where the recipe goes, unless they are there.
    fn bring(&self, folder: &Path) -> Result<()> {
        let Some(recipe) = GALLERY.iter().find(|recipe| self.folder == self.root.scratch().join(recipe.name)) else {
            return Ok(());
        };
        recipe.data.iter().filter(|data| !folder.join(data.0).exists()).try_for_each(|(path, bytes)| {
            let file = folder.join(path);
            let said = file.display().to_string();
            put(&self.root.file(&said)?, bytes)
        })
    }
}

fn put(file: &Path, bytes: &[u8]) -> Result<()> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder).map_err(|e| Error::io("create folder", folder, e))?;
    }
    write_whole(file, bytes)
}
