//! The document: a drawing's text as it is being changed, and the scene that it says.

use crate::Failure;
use crate::drawn_scene::DrawnScene;
use crate::storage::{file_failure, new_file, text_file};
use geometry::DVec2;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Steps that can be taken back.
const MOST_STEPS: usize = 1000;

/// A drawing that is being changed.
pub struct Document {
    path: PathBuf,
    /// As it is in the file, as far as known.
    saved: String,
    text: String,
    scene: Arc<DrawnScene>,
    /// Counts up with each other scene.
    version: u64,
    /// The texts before the last steps.
    before: Vec<String>,
}

impl Document {
    /// Reads a drawing.
    ///
    /// # Errors
    /// One sentence for each mistake in it.
    pub fn open(path: &Path) -> Result<Document, Vec<Failure>> {
        let text = read(path)?;
        let scene = scene(path, &text)?;
        Ok(Document { path: path.to_path_buf(), saved: text.clone(), text, scene, version: 0, before: Vec::new() })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// What it draws.
    pub fn scene(&self) -> &Arc<DrawnScene> {
        &self.scene
    }

    /// Another number for each other scene.
    pub fn version(&self) -> u64 {
        self.version
    }

    fn set(&mut self, text: String, scene: Arc<DrawnScene>) {
        (self.text, self.scene) = (text, scene);
        self.version += 1;
    }

    /// Whether there is something that is not in the file.
    pub fn is_changed(&self) -> bool {
        self.text != self.saved
    }

    /// Begins a step that [`Document::undo`] takes back: gives what it is a step from.
    pub fn begin_step(&mut self) -> Arc<DrawnScene> {
        if self.before.len() == MOST_STEPS {
            self.before.remove(0);
        }
        self.before.push(self.text.clone());
        self.scene.clone()
    }

    /// Moves a shape of the scene that the step began from, mm.
    ///
    /// # Errors
    /// If it cannot be there: nothing has moved then.
    pub fn move_shape(&mut self, from: &DrawnScene, shape: usize, by_mm: DVec2) -> Result<(), Failure> {
        let Some(text) = from.drawing.moved(&from.drawing.shapes[shape], by_mm) else { return Ok(()) };
        let scene = scene(&self.path, &text).map_err(Failure::of_many)?;
        self.set(text, scene);
        Ok(())
    }

    /// Ends a step; one that changed nothing is none.
    pub fn end_step(&mut self) {
        if self.before.last() == Some(&self.text) {
            self.before.pop();
        }
    }

    /// Takes the last step back; `false` if there is none.
    pub fn undo(&mut self) -> bool {
        let Some(text) = self.before.pop() else { return false };
        // It was read before.
        if let Ok(scene) = scene(&self.path, &text) {
            self.set(text, scene);
        }
        true
    }

    /// Writes it to its file: what was moved, and every other byte as it was.
    ///
    /// # Errors
    /// If it cannot be written, or the file has been changed since it was read.
    pub fn save(&mut self) -> Result<(), Failure> {
        if read(&self.path).map_err(Failure::of_many)? != self.saved {
            let what = "another program has changed it since; Z until nothing of yours is left reads it again";
            return Err(Failure::new(format!("{}: {what}", self.path.display())));
        }
        new_file::write(&self.path, |file| file.write_all(self.text.as_bytes()))
            .map_err(|error| file_failure("write", &self.path, &error))?;
        self.saved.clone_from(&self.text);
        Ok(())
    }

    /// Reads the file again; `false` if it is as it was. What was changed here and not saved is a step that can be taken back.
    ///
    /// # Errors
    /// If it cannot be read; what is shown stays.
    pub fn reload(&mut self) -> Result<bool, Failure> {
        let text = read(&self.path).map_err(Failure::of_many)?;
        if text == self.saved {
            return Ok(false);
        }
        let scene = scene(&self.path, &text).map_err(Failure::of_many)?;
        self.begin_step();
        self.saved.clone_from(&text);
        self.set(text, scene);
        self.end_step();
        Ok(true)
    }
}

fn read(path: &Path) -> Result<String, Vec<Failure>> {
    text_file::read(path).map_err(|failure| vec![failure])
}

fn scene(path: &Path, text: &str) -> Result<Arc<DrawnScene>, Vec<Failure>> {
    DrawnScene::read(&path.display().to_string(), text.as_bytes().to_vec()).map(Arc::new)
}
