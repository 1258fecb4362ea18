//! Statistics of a self-play run: keeps count of what is played: games, balls, switches, and what went wrong.

use super::anomaly::{Anomaly, AnomalyDetector};
use super::flipper_zones::FlipperZones;
use super::game_result::GameResult;
use super::message_log::{MessageLog, ShownMessage};
use crate::recording::best_score;
use crate::{Buttons, Simulation, Table};
use physics::EventKind;

/// Ticks between two looks at the display.
const DISPLAY_TICKS: u64 = 50;
/// Ticks that are played on after the game is over.
const AFTERWARDS_TICKS: u64 = 2000;
/// Ticks that a game may take to begin.
const PATIENCE_TICKS: u64 = 20_000;

/// Statistics of a run, gathered from the machine's switching on.
pub(super) struct RunStatistics {
    zones: FlipperZones,
    anomalies: AnomalyDetector,
    hits: Vec<u64>,
    messages: MessageLog,
    /// How long each ball was in play; the last one goes on.
    balls: Vec<u64>,
    /// The last one goes on; its ticks are filled in when it does not.
    games: Vec<GameResult>,
    /// When the last game's time began.
    began: u64,
    /// Player and ball that the display last showed.
    turn: (usize, u32),
    playing: bool,
    /// When the last game ended, if no other has begun.
    over_at: Option<u64>,
}

/// The summary of a run.
pub(super) struct RunSummary {
    pub games: Vec<GameResult>,
    pub balls: Vec<u64>,
    pub hits: Vec<u64>,
    pub anomalies: Vec<Anomaly>,
    pub messages: Vec<ShownMessage>,
}

impl RunStatistics {
    pub fn new(table: &Table) -> RunStatistics {
        RunStatistics {
            zones: FlipperZones::new(&table.layout),
            anomalies: AnomalyDetector::new(&table.layout),
            hits: vec![0; table.layout.parts.len()],
            messages: MessageLog::default(),
            balls: vec![0],
            games: vec![GameResult::default()],
            began: 0,
            turn: (0, 0),
            playing: false,
            over_at: None,
        }
    }

    /// When the last game ended, if no other has begun since.
    pub fn over_at(&self) -> Option<u64> {
        self.over_at
    }

    /// Whether one game is over, and a moment has passed, or none will begin.
    pub fn finished(&self, tick: u64) -> bool {
        let never_began = !self.playing && self.over_at.is_none() && tick > PATIENCE_TICKS;
        never_began || self.over_at.is_some_and(|over| tick > over + AFTERWARDS_TICKS)
    }

    /// Looks at the machine after a tick in which these buttons were down.
    pub fn look(&mut self, simulation: &Simulation, buttons: Buttons) {
        let tick = simulation.ticks();
        if tick.is_multiple_of(DISPLAY_TICKS) {
            self.look_at_display(simulation);
        }
        self.messages.look(simulation);
        for event in simulation.events().filter(|event| event.kind == EventKind::Closed) {
            if let Some(hits) = event.part.and_then(|part| self.hits.get_mut(usize::from(part.0))) {
                *hits += 1;
            }
        }
        let pose = simulation.pose();
        if self.playing
            && pose.balls.iter().any(|ball| !self.zones.in_lane(ball))
            && let Some(ticks) = self.balls.last_mut()
        {
            *ticks += 1;
        }
        let (zones, playing) = (&self.zones, self.playing);
        self.anomalies.look(tick, &pose, |ball| {
            let trapped = buttons != Buttons::NONE && zones.in_reach(ball.center).is_some();
            !playing || zones.in_lane(ball) || trapped
        });
    }

    /// All that it has seen up to now.
    pub fn finish(mut self, simulation: &Simulation) -> RunSummary {
        self.close_game(simulation);
        RunSummary {
            games: self.games,
            balls: self.balls.into_iter().filter(|ticks| *ticks > 0).collect(),
            hits: self.hits,
            anomalies: self.anomalies.anomalies(),
            messages: self.messages.shown(),
        }
    }

    fn look_at_display(&mut self, simulation: &Simulation) {
        let display = simulation.display();
        if self.turn != (display.player, display.ball) {
            self.turn = (display.player, display.ball);
            self.balls.push(0);
        }
        match (self.playing, display.playing) {
            (true, false) => self.over_at = Some(simulation.ticks()),
            (false, true) if self.over_at.take().is_some() => {
                // Its score was read when it was still shown.
                if let Some(game) = self.games.last_mut() {
                    game.ticks = simulation.ticks() - self.began;
                }
                self.began = simulation.ticks();
                self.games.push(GameResult::default());
            }
            _ => {}
        }
        self.playing = display.playing;
        self.close_game(simulation);
    }

    /// The last game, as it would be if nothing came any more.
    fn close_game(&mut self, simulation: &Simulation) {
        if let Some(game) = self.games.last_mut() {
            let ticks = simulation.ticks() - self.began;
            *game = GameResult { ticks, score: best_score(simulation), over: self.over_at.is_some() };
        }
    }
}
