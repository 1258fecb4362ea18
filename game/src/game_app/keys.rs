//! Keys: what the game's application does when a key goes down.

use super::app::GameApp;
use crate::Buttons;
use crate::desktop::Commands;
use crate::input::{self, Action, Key, ReplayAction, UiAction};
use crate::session::{Modal, Session, zoom};

impl GameApp {
    /// A key went down or came up.
    pub(super) fn key(&mut self, key: Key, down: bool, commands: &mut Commands) {
        let held = self.held.buttons();
        if down {
            self.press(key, commands)
        } else {
            self.held.release(key)
        }
        if self.held.buttons() != held {
            self.await_picture();
        }
    }

    /// A key went down.
    fn press(&mut self, key: Key, commands: &mut Commands) {
        commands.redraw = true;
        if let Session::Replay(replay) = &mut self.session
            && self.modal == Modal::None
            && let Some(action) = input::replay_action(key)
        {
            return match action {
                ReplayAction::TogglePause => replay.toggle_pause(),
                ReplayAction::SeekBack => replay.seek(false),
                ReplayAction::SeekForward => replay.seek(true),
                ReplayAction::Faster => replay.speed = replay.speed.faster(),
                ReplayAction::Slower => replay.speed = replay.speed.slower(),
            };
        }
        match input::action(key) {
            Some(Action::Button(buttons)) => self.held.press(key, buttons),
            Some(Action::Plunge) => self.plunge(key),
            Some(Action::Ui(action)) => self.act(action, commands),
            None => {}
        }
    }

    /// When the keyboard goes to another window, nothing is held any more and the player's game waits.
    pub(super) fn lose_focus(&mut self, commands: &mut Commands) {
        self.held.release_all();
        let plays = matches!(&self.session, Session::Live(game) if game.badge().is_none());
        if plays && self.modal == Modal::None {
            self.open_modal(Modal::Paused, commands);
        }
    }

    fn plunge(&mut self, key: Key) {
        match &self.session {
            // A modal goes away without a ball being shot.
            _ if self.modal != Modal::None => self.close_modal(),
            Session::Live(game) if game.is_on() => self.held.press(key, Buttons::PLUNGER),
            Session::Live(_) => self.held.press(key, Buttons::START),
            Session::Replay(_) => {}
        }
    }

    fn act(&mut self, action: UiAction, commands: &mut Commands) {
        match action {
            UiAction::Pause => self.pause(commands),
            UiAction::Help if self.modal == Modal::Help => self.close_modal(),
            UiAction::Help => self.open_modal(Modal::Help, commands),
            UiAction::Quit => commands.quit |= self.modal != Modal::None || matches!(self.session, Session::Replay(_)),
            UiAction::Fullscreen => commands.toggle_fullscreen = true,
            UiAction::DebugOverlay => self.view.debug_overlay = !self.view.debug_overlay,
            UiAction::Screenshot => commands.screenshot = true,
            UiAction::LastBall => self.last_ball(commands),
            UiAction::ZoomIn => self.view.zoom = zoom::closer(self.view.zoom),
            UiAction::ZoomOut => self.view.zoom = zoom::farther(self.view.zoom),
        }
    }

    fn pause(&mut self, commands: &mut Commands) {
        match &mut self.session {
            Session::Replay(_) if self.modal == Modal::None => commands.quit = true,
            Session::Live(game) if game.is_watching() => {
                game.return_to_game();
                self.open_modal(Modal::Paused, commands);
            }
            _ if self.modal != Modal::None => self.close_modal(),
            _ => self.open_modal(Modal::Paused, commands),
        }
    }

    fn open_modal(&mut self, modal: Modal, commands: &mut Commands) {
        self.held.release_all();
        self.modal = modal;
        commands.redraw = true;
    }

    fn close_modal(&mut self) {
        self.held.release_all();
        self.modal = Modal::None;
    }

    /// Shows the last ball again, or goes back from it to the game.
    fn last_ball(&mut self, commands: &mut Commands) {
        let Session::Live(game) = &mut self.session else { return };
        if game.is_watching() {
            game.return_to_game();
            self.open_modal(Modal::Paused, commands);
        } else if game.watch_last_ball() {
            self.close_modal();
        } else {
            self.tell("No ball has been played yet.".to_string(), commands);
        }
    }
}
