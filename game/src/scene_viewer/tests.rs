use super::ViewerOptions;
use super::app::SceneViewer;
use super::document::Document;
use crate::desktop::{App, Commands, Event, Pointer};
use crate::input::Key;
use crate::screen::Size;
use crate::storage::text_file;
use geometry::DVec2;
use std::path::PathBuf;
use std::time::Duration;
use tracer::transport::SourceForm;

const DRAWING: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 200 100\"><!-- mine -->
  <circle class=\"lamp\"   cx='50' cy=\"50\" r=\"4\" fill=\"#fff\"/>
  <path class=\"prism\" d=\"M 120 30 L 160 30 L 140 60 Z\" fill=\"#123\"/>
</svg>\n";

struct Viewer {
    app: SceneViewer,
    commands: Commands,
    file: PathBuf,
    now: Duration,
}

impl Viewer {
    /// A window of 400 x 200 pixels: two for each millimetre.
    fn new(name: &str) -> Viewer {
        let folder = std::env::temp_dir().join(format!("caustic-view-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("the folder can be made");
        let file = folder.join(name);
        std::fs::write(&file, DRAWING).expect("the file can be written");
        let document = Document::open(&file).expect("it is sound");
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("there is a thread");
        let options = ViewerOptions { size: None, fullscreen: false, integrator: None, white_kelvin: None };
        let mut app = SceneViewer::new(document, options, pool).expect("there is a thread");
        app.frame_input(Size { width: 400, height: 200 });
        Viewer { app, commands: Commands::default(), file, now: Duration::ZERO }
    }

    fn pointer(&mut self, pointer: Pointer) {
        self.app.event(Event::Pointer(pointer), &mut self.commands);
    }

    fn drag(&mut self, from: DVec2, to: DVec2) {
        self.pointer(Pointer::Moved(from));
        self.pointer(Pointer::Pressed);
        self.pointer(Pointer::Moved((from + to) * 0.5));
        self.pointer(Pointer::Moved(to));
        self.pointer(Pointer::Released);
    }

    fn press(&mut self, key: Key) {
        self.app.event(Event::Key { key, down: true }, &mut self.commands);
    }

    fn later(&mut self, ms: u64) {
        self.now += Duration::from_millis(ms);
        self.app.update(self.now, &mut self.commands);
    }

    fn lamp(&self) -> DVec2 {
        match self.app.document.scene().scene.sources[0].form {
            SourceForm::Disc { center, .. } => center,
            other => panic!("a disc was drawn: {other:?}"),
        }
    }

    fn text(&self) -> String {
        text_file::read(&self.file).expect("it is there")
    }
}

/// What is dragged moves as far as the mouse, is written where it is, and nothing else in the file changes.
#[test]
fn a_lamp_is_dragged_and_the_drawing_written() {
    let mut viewer = Viewer::new("drag.svg");
    viewer.drag(DVec2::new(101.0, 99.0), DVec2::new(141.0, 79.0));
    assert!(viewer.lamp().distance(DVec2::new(70.0, 40.0)) < 1e-6, "{}", viewer.lamp());
    assert_eq!(viewer.text(), DRAWING, "it is written only when that is asked for");
    viewer.press(Key::KeyE);
    let expected = DRAWING.replace("<circle class", "<circle transform=\"translate(20 -10)\" class");
    assert_eq!(viewer.text(), expected);
    viewer.drag(DVec2::new(141.0, 79.0), DVec2::new(101.0, 99.0));
    viewer.press(Key::KeyE);
    assert_eq!(viewer.text(), expected.replace("20 -10", "0 0"));
}

#[test]
fn moves_are_taken_back_one_by_one() {
    let mut viewer = Viewer::new("undo.svg");
    viewer.drag(DVec2::new(100.0, 100.0), DVec2::new(120.0, 100.0));
    viewer.drag(DVec2::new(280.0, 80.0), DVec2::new(280.0, 100.0));
    // A click moves nothing.
    viewer.drag(DVec2::new(120.0, 100.0), DVec2::new(120.0, 100.0));
    viewer.press(Key::KeyZ);
    assert!(viewer.lamp().distance(DVec2::new(60.0, 50.0)) < 1e-6);
    viewer.press(Key::KeyZ);
    assert!(viewer.lamp().distance(DVec2::new(50.0, 50.0)) < 1e-6);
    assert!(!viewer.app.document.is_changed());
    viewer.press(Key::KeyZ);
    assert_eq!(viewer.app.status(), "nothing was moved");
}

/// Leaving is asked twice where something would be lost, and only there.
#[test]
fn what_was_moved_is_not_left_by_one_key() {
    let mut viewer = Viewer::new("leave.svg");
    viewer.press(Key::KeyQ);
    assert!(viewer.commands.quit);
    viewer.commands.quit = false;
    viewer.drag(DVec2::new(100.0, 100.0), DVec2::new(120.0, 100.0));
    viewer.press(Key::KeyQ);
    assert!(!viewer.commands.quit && viewer.app.status().contains("E writes it"), "{}", viewer.app.status());
    viewer.press(Key::KeyQ);
    assert!(viewer.commands.quit);
}

/// The wheel leaves what is under the mouse there; dragging the ground moves the page with the mouse.
#[test]
fn the_page_stays_under_the_mouse() {
    let mut viewer = Viewer::new("zoom.svg");
    let (size, at) = (Size { width: 400, height: 200 }, DVec2::new(300.0, 150.0));
    let place = |viewer: &Viewer, at: DVec2| {
        let view = viewer.app.camera.view(size);
        view.origin_mm + at * view.mm_per_px
    };
    let before = place(&viewer, at);
    viewer.pointer(Pointer::Moved(at));
    viewer.pointer(Pointer::Wheel(5.0));
    assert!(place(&viewer, at).distance(before) < 1e-9 && viewer.app.camera.view(size).mm_per_px < 0.3);
    viewer.drag(at, at - DVec2::new(30.0, 10.0));
    assert!(place(&viewer, at - DVec2::new(30.0, 10.0)).distance(before) < 1e-9);
    viewer.press(Key::Digit0);
    assert_eq!(place(&viewer, at), before);
}

/// A file that another program has saved is read again, and is not written over.
#[test]
fn another_programs_changes_are_read_and_never_lost() {
    let mut viewer = Viewer::new("reload.svg");
    viewer.drag(DVec2::new(100.0, 100.0), DVec2::new(120.0, 100.0));
    let theirs = DRAWING.replace("cx='50'", "cx='80'");
    std::fs::write(&viewer.file, &theirs).expect("the file can be written");
    viewer.press(Key::KeyE);
    assert!(viewer.app.status().contains("another program has changed it"), "{}", viewer.app.status());
    assert_eq!(viewer.text(), theirs);
    let mut viewer = Viewer::new("reload.svg");
    std::fs::write(&viewer.file, theirs.replace("80", "90")).expect("the file can be written");
    (0..10).for_each(|_| viewer.later(200));
    assert!(viewer.lamp().distance(DVec2::new(90.0, 50.0)) < 1e-6);
    std::fs::write(&viewer.file, "<svg").expect("the file can be written");
    (0..10).for_each(|_| viewer.later(200));
    assert!(viewer.lamp().distance(DVec2::new(90.0, 50.0)) < 1e-6, "what was good last is shown");
    assert!(viewer.app.status().contains("reload.svg"), "{}", viewer.app.status());
}

/// A mistake that another program had saved was told only when the mouse moved, and for five seconds from the saving on.
#[test]
fn a_broken_file_is_told_at_once_and_for_as_long_as_it_is_broken() {
    let mut viewer = Viewer::new("broken.svg");
    /// What is told within a second of now, by a frame that was asked for.
    fn told(viewer: &mut Viewer) -> String {
        for _ in 0..5 {
            let before = viewer.app.status();
            viewer.commands.redraw = false;
            viewer.later(200);
            let after = viewer.app.status();
            if after != before && (after.contains("broken.svg") || before.contains("broken.svg")) {
                assert!(viewer.commands.redraw, "{after}");
                return after;
            }
        }
        panic!("nothing was told: {}", viewer.app.status());
    }
    viewer.later(200);
    for broken in [DRAWING.replace("r=\"4\"", "r=\"x\""), String::new(), "<svg".to_string()] {
        std::fs::write(&viewer.file, broken).expect("the file can be written");
        let sentence = told(&mut viewer);
        (0..100).for_each(|_| viewer.later(200));
        assert_eq!(viewer.app.status(), sentence);
    }
    std::fs::remove_file(&viewer.file).expect("the file can be removed");
    let sentence = told(&mut viewer);
    viewer.press(Key::KeyZ);
    assert_eq!(viewer.app.status(), "nothing was moved");
    (0..100).for_each(|_| viewer.later(200));
    assert_eq!(viewer.app.status(), sentence);
    std::fs::write(&viewer.file, DRAWING).expect("the file can be written");
    assert!(!told(&mut viewer).contains("broken.svg"));
}
