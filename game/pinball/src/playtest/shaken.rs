//! The shaken machine: what the rules complain about when its player presses every button and pushes the cabinet, until
//! its slam switch closes. In a game that nobody plays the tilt bob never swings.

use crate::{Buttons, Simulation};

/// How many pushes, and from one to the next, ticks: the bob swings, it swings often, the slam switch closes.
const PUSHES: [(u64, u64); 3] = [(12, 500), (20, 160), (80, 40)];
/// A button is down for this part of the time between two.
const DOWN: u64 = 2;
/// Each button in turn, ticks.
const EACH_TICKS: u64 = 400;
/// What waits for a timer has come by then, ticks.
const AFTER_TICKS: u64 = 2000;
/// Contact solves that it may take.
const MOST_CONTACT_SOLVES: u64 = 400_000;

/// What the rules complain about, in a game whose ball waits at the plunger.
pub fn complaints(begun: &Simulation) -> Vec<String> {
    let mut machine = Shaken { simulation: begun.clone(), contact_solves: 0 };
    let buttons = [Buttons::LEFT, Buttons::RIGHT, Buttons::NUDGE_LEFT, Buttons::NUDGE_UP, Buttons::NUDGE_DOWN];
    buttons.into_iter().for_each(|button| machine.press(button, EACH_TICKS));
    for (count, period) in PUSHES {
        for push in 0..count {
            let way = if push % 2 == 0 { Buttons::NUDGE_LEFT } else { Buttons::NUDGE_RIGHT };
            machine.press(way, period);
        }
    }
    machine.press(Buttons::NONE, AFTER_TICKS);
    machine.simulation.complaints()
}

struct Shaken {
    simulation: Simulation,
    contact_solves: u64,
}

impl Shaken {
    fn press(&mut self, button: Buttons, period: u64) {
        for tick in 0..period {
            // It takes too long to see.
            if self.contact_solves > MOST_CONTACT_SOLVES {
                return;
            }
            self.simulation.tick(if tick < period / DOWN { button } else { Buttons::NONE });
            self.contact_solves += self.simulation.machine().contact_solves();
        }
    }
}
