//! The coverage player uses every button that there is: for demonstrations, and to find what nobody presses.

use super::Bot;
use super::flipper_zones::FlipperZones;
use crate::{Buttons, Simulation};

/// After so many ticks of a game the machine is shaken, whoever plays.
const LATEST_SHAKE_TICKS: u64 = 75_000;

/// A party of three: adds two players, plunges at many strengths, pushes the cabinet from every side, and shakes it in
/// the third player's first ball until it tilts; earlier if the others keep theirs for long. In between the bot plays.
#[derive(Clone, Debug)]
pub struct CoveragePlayer {
    bot: Bot,
    zones: Option<FlipperZones>,
    plunges: u64,
    /// The plunger is held from the first to the second tick.
    pull: (u64, u64),
    /// Since when a game has been on.
    playing_since: Option<u64>,
    player: usize,
    /// Since when a ball has been out of the lane.
    in_play_since: Option<u64>,
    shaken: bool,
}

impl CoveragePlayer {
    /// The player that this seed gives.
    pub fn new(seed: u64) -> CoveragePlayer {
        CoveragePlayer {
            bot: Bot::new(seed),
            zones: None,
            plunges: 0,
            pull: (0, 0),
            playing_since: None,
            player: 0,
            in_play_since: None,
            shaken: false,
        }
    }

    /// What it presses in the next tick.
    pub fn buttons(&mut self, simulation: &Simulation) -> Buttons {
        let tick = simulation.ticks();
        if tick.is_multiple_of(20) {
            let display = simulation.display();
            self.player = display.player;
            self.playing_since = display.playing.then(|| self.playing_since.unwrap_or(tick));
            self.shaken |= display.tilted;
        }
        let bot = self.bot.buttons(simulation).with(Buttons::PLUNGER, false);
        bot.with(Buttons::PLUNGER, self.plunges(simulation)) | self.joins(tick) | self.pushes(simulation)
    }

    /// Two more players join, a second and two after the game began.
    fn joins(&self, tick: u64) -> Buttons {
        let since = self.playing_since.map_or(0, |began| tick - began);
        if [1000..1080, 2000..2080].iter().any(|press| press.contains(&since)) { Buttons::START } else { Buttons::NONE }
    }

    /// Pulls a ball that waits by 30, 55, 80 and 100 % in turn: weak ones come back and are shot again.
    fn plunges(&mut self, simulation: &Simulation) -> bool {
        let tick = simulation.ticks();
        let zones = self.zones.get_or_insert_with(|| FlipperZones::new(&simulation.table().layout));
        // The first ball waits until everybody has joined.
        let joined = self.playing_since.is_some_and(|began| tick > began + 2500);
        if joined && tick > self.pull.1 + 600 && simulation.pose().balls.iter().any(|ball| zones.waits(ball)) {
            let percent = [30, 55, 80, 100][(self.plunges % 4) as usize];
            self.plunges += 1;
            self.pull = (tick + 200, tick + 200 + zones.pull_ticks * percent / 100);
        }
        (self.pull.0..self.pull.1).contains(&tick)
    }

    /// A gentle push now and then; hard shaking in the third player's ball.
    fn pushes(&mut self, simulation: &Simulation) -> Buttons {
        let tick = simulation.ticks();
        let Some(zones) = &self.zones else { return Buttons::NONE };
        let free = simulation.pose().balls.iter().any(|ball| !ball.held && !zones.in_lane(ball));
        self.in_play_since = free.then(|| self.in_play_since.unwrap_or(tick));
        let Some(since) = self.in_play_since.map(|began| tick - began) else { return Buttons::NONE };
        let late = self.playing_since.is_some_and(|began| tick > began + LATEST_SHAKE_TICKS);
        let shakes = (self.player == 2 || late) && !self.shaken && since > 4000;
        // In haste, but not so much that it is a slam, which would end the game.
        let pause = if shakes { 260 } else { 7000 };
        if since < 3000 || since % pause >= 60 {
            return Buttons::NONE;
        }
        let pushes = [Buttons::NUDGE_LEFT, Buttons::NUDGE_RIGHT, Buttons::NUDGE_UP, Buttons::NUDGE_DOWN];
        pushes[(since / pause % 4) as usize]
    }
}
