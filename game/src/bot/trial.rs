//! One whole game, played without a screen, with everything that is worth knowing about it.

use super::anomaly::{Anomaly, Watch};
use super::playfield::Playfield;
use super::{Bot, Random, Tour};
use crate::recording::{Recorder, best_score};
use crate::{Buttons, Failure, Simulation, Table};
use physics::EventKind;
use std::io::Cursor;
use std::path::Path;
use std::sync::Arc;

/// Ticks between two looks at the display.
const DISPLAY_TICKS: u64 = 50;
/// Ticks that are played on after the game is over.
const AFTERWARDS_TICKS: u64 = 2000;
/// Ticks that a game may take to begin.
const PATIENCE_TICKS: u64 = 20_000;

/// Who plays.
#[derive(Clone, Debug)]
pub enum Player {
    /// Traps, aims and shoots.
    Bot(Bot),
    /// Flips at random.
    Random(Random),
    /// Uses every button.
    Tour(Tour),
}

impl Player {
    /// What the player presses in the next tick.
    pub fn buttons(&mut self, simulation: &Simulation) -> Buttons {
        match self {
            Player::Bot(bot) => bot.buttons(simulation),
            Player::Random(random) => random.buttons(simulation),
            Player::Tour(tour) => tour.buttons(simulation),
        }
    }
}

/// What came of a game.
pub struct Trial {
    /// The game's seed.
    pub seed: u64,
    /// Ticks that were played.
    pub ticks: u64,
    /// The game came to its end within its time.
    pub over: bool,
    /// The best score of the players.
    pub score: i64,
    /// How long each ball was in play, ticks.
    pub balls: Vec<u64>,
    /// How often each part's switch closed, by the part's index.
    pub hits: Vec<u64>,
    /// What went wrong.
    pub anomalies: Vec<Anomaly>,
    /// What the rules complained about.
    pub complaints: Vec<String>,
    /// The recording, finished.
    pub recording: Vec<u8>,
}

/// Plays one game of at most `longest` ticks.
///
/// # Errors
/// If the table's rules do not run.
pub fn play(table: &Arc<Table>, seed: u64, mut player: Player, longest: u64) -> Result<Trial, Failure> {
    let mut simulation = Simulation::new(table.clone(), seed)?;
    let mut recorder = Recorder::new(Cursor::new(Vec::new()), Path::new("memory"), &simulation, seed)?;
    let mut observer = Observer::new(table);
    while simulation.ticks() < longest && !observer.finished(simulation.ticks()) {
        let buttons = player.buttons(&simulation);
        simulation.tick(buttons);
        recorder.record(&simulation, buttons)?;
        observer.look(&simulation, buttons);
    }
    Ok(Trial {
        seed,
        ticks: simulation.ticks(),
        over: observer.over_at.is_some(),
        score: best_score(&simulation),
        balls: observer.balls.into_iter().filter(|ticks| *ticks > 0).collect(),
        hits: observer.hits,
        anomalies: observer.watch.anomalies(),
        complaints: simulation.complaints(),
        recording: recorder.finish(&simulation)?.into_inner(),
    })
}

/// Keeps count of a game.
struct Observer {
    playfield: Playfield,
    watch: Watch,
    hits: Vec<u64>,
    /// How long each ball was in play; the last one goes on.
    balls: Vec<u64>,
    /// Player and ball that the display last showed.
    turn: (usize, u32),
    playing: bool,
    over_at: Option<u64>,
}

impl Observer {
    fn new(table: &Table) -> Observer {
        Observer {
            playfield: Playfield::new(&table.layout),
            watch: Watch::new(&table.layout),
            hits: vec![0; table.layout.parts.len()],
            balls: vec![0],
            turn: (0, 0),
            playing: false,
            over_at: None,
        }
    }

    fn finished(&self, tick: u64) -> bool {
        let never_began = !self.playing && self.over_at.is_none() && tick > PATIENCE_TICKS;
        never_began || self.over_at.is_some_and(|over| tick > over + AFTERWARDS_TICKS)
    }

    fn look(&mut self, simulation: &Simulation, buttons: Buttons) {
        let tick = simulation.ticks();
        if tick.is_multiple_of(DISPLAY_TICKS) {
            self.look_at_display(simulation);
        }
        for event in simulation.events().iter().filter(|event| event.kind == EventKind::Closed) {
            if let Some(hits) = event.part.and_then(|part| self.hits.get_mut(usize::from(part.0))) {
                *hits += 1;
            }
        }
        let pose = simulation.pose();
        if self.playing
            && pose.balls.iter().any(|ball| !self.playfield.in_lane(ball))
            && let Some(ticks) = self.balls.last_mut()
        {
            *ticks += 1;
        }
        let (playfield, playing) = (&self.playfield, self.playing);
        self.watch.look(tick, &pose, |ball| {
            let trapped = buttons != Buttons::NONE && playfield.in_reach(ball.center).is_some();
            !playing || playfield.in_lane(ball) || trapped
        });
    }

    fn look_at_display(&mut self, simulation: &Simulation) {
        let display = simulation.display();
        if self.turn != (display.player, display.ball) {
            self.turn = (display.player, display.ball);
            self.balls.push(0);
        }
        if self.playing && !display.playing && self.over_at.is_none() {
            self.over_at = Some(simulation.ticks());
        }
        self.playing = display.playing;
    }
}
