//! The game's application without a window: synthetic events in, frame inputs out.

use super::DisplayOptions;
use super::app::GameApp;
use super::painter::FrameInput;
use crate::desktop::{App, Commands, Event};
use crate::input::Key;
use crate::screen::Size;
use crate::session::{LiveGame, ReplaySession, Session};
use crate::storage::{assets, recordings, tables};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// An application, the time it has come to, and what it has asked for.
struct Headless {
    app: GameApp,
    now: Duration,
    commands: Commands,
}

impl Headless {
    fn new(session: Session) -> Headless {
        let options = DisplayOptions { size: None, fullscreen: false, light: None, zoom: 1.0 };
        let mut headless = Headless {
            app: GameApp::new(session, options, Path::new("no folder")),
            now: Duration::ZERO,
            commands: Commands::default(),
        };
        headless.wait_ms(0);
        headless
    }

    fn game() -> Headless {
        let table = Arc::new(tables::load("spectrum").expect("the table of the project is whole"));
        let game = LiveGame::unrecorded(table, 7, false).expect("the rules run");
        Headless::new(Session::Live(Box::new(game)))
    }

    fn replay() -> Headless {
        let demo = assets::demos().expect("the demos").remove(0);
        let replay = ReplaySession::new(recordings::open_to_show(&demo).expect("a demo can be played again"));
        Headless::new(Session::Replay(Box::new(replay)))
    }

    fn wait_ms(&mut self, ms: u64) {
        self.now += Duration::from_millis(ms);
        self.app.update(self.now, &mut self.commands);
    }

    fn key(&mut self, key: Key, down: bool) {
        self.wait_ms(0);
        self.app.event(Event::Key { key, down }, &mut self.commands);
    }

    fn frame(&mut self) -> FrameInput {
        self.app.frame_input(Size { width: 64, height: 64 })
    }

    fn tick(&mut self) -> u64 {
        self.frame().current.tick
    }
}

#[test]
fn a_key_counts_from_the_millisecond_in_which_it_goes_down() {
    let (mut pressed, mut idle) = (Headless::game(), Headless::game());
    // The opening presses start: from then on the flippers are alive.
    for _ in 0..7 {
        pressed.wait_ms(100);
        idle.wait_ms(100);
    }
    pressed.wait_ms(50);
    pressed.key(Key::ShiftLeft, true);
    idle.wait_ms(50);
    assert_eq!(pressed.frame().current, idle.frame().current, "the ticks before it are played without it");
    pressed.wait_ms(50);
    idle.wait_ms(50);
    assert_eq!((pressed.tick(), idle.tick()), (800, 800));
    let lifted_rad = |pressed: &mut Headless, idle: &mut Headless| {
        let [up, rest] = [pressed, idle].map(|headless| headless.frame().current.pose.flippers_rad[0].1);
        (up - rest).abs()
    };
    assert!(lifted_rad(&mut pressed, &mut idle) > 0.5, "the left flipper is up");
    pressed.key(Key::ShiftLeft, false);
    for _ in 0..10 {
        pressed.wait_ms(100);
        idle.wait_ms(100);
    }
    assert!(lifted_rad(&mut pressed, &mut idle) < 0.01, "it lies at its stop again");
}

#[test]
fn a_frame_lies_between_the_last_two_ticks() {
    let mut headless = Headless::game();
    headless.now += Duration::from_micros(20_250);
    headless.wait_ms(0);
    let input = headless.frame();
    assert_eq!((input.previous.tick, input.current.tick), (19, 20));
    assert!((input.alpha - 0.25).abs() < 1e-9, "{}", input.alpha);
    assert!(headless.commands.redraw);
}

#[test]
fn a_paused_game_stands_and_can_be_left() {
    let mut headless = Headless::game();
    headless.wait_ms(30);
    headless.key(Key::KeyQ, true);
    assert!(!headless.commands.quit, "a game in play is not left by one key");
    headless.key(Key::KeyP, true);
    headless.wait_ms(80);
    let input = headless.frame();
    assert_eq!((input.current.tick, input.alpha), (30, 1.0));
    assert!(input.ui_state.dialog.is_some() && !headless.app.is_animating());
    headless.key(Key::KeyQ, true);
    assert!(headless.commands.quit);
}

#[test]
fn losing_the_keyboard_pauses_the_game_and_lets_every_key_go() {
    let mut headless = Headless::game();
    headless.key(Key::ShiftLeft, true);
    headless.app.event(Event::FocusLost, &mut headless.commands);
    assert!(!headless.app.is_animating());
    headless.key(Key::Space, true);
    assert!(headless.app.is_animating(), "space goes on");
    let mut idle = Headless::game();
    headless.wait_ms(60);
    idle.wait_ms(60);
    assert_eq!(headless.frame().current, idle.frame().current, "nothing is held");
}

#[test]
fn a_replay_is_paused_sought_and_left() {
    let mut headless = Headless::replay();
    headless.wait_ms(40);
    assert_eq!(headless.tick(), 40);
    headless.key(Key::ArrowRight, true);
    assert_eq!(headless.tick(), 5040);
    headless.key(Key::Space, true);
    headless.wait_ms(90);
    assert_eq!(headless.tick(), 5040);
    headless.key(Key::Escape, true);
    assert!(headless.commands.quit);
}
