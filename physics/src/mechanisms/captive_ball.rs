//! Captive balls: steel balls like any other, which the walls round them keep in their places, and which are not in play.
//!
//! The sweep moves them as it moves every ball. Refuses to know how.

use crate::ball::{Ball, Hold};
use crate::mechanisms::model::Model;
use crate::part::event::Event;
use crate::part::validation::{self, Checked};
use crate::part::{Numbered, PartId};
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// A steel ball that is not in play: the walls round it keep it in its place. Its switch closes when a ball in play
/// hits it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaptiveBall {
    /// Where its centre is at first, m.
    pub center: DVec2,
    /// Slowest approach of a ball in play that closes its switch, m/s.
    pub threshold_m_s: f64,
}

impl CaptiveBall {
    pub(crate) fn check(&self) -> Checked {
        validation::point("the centre", self.center)?;
        validation::not_negative("the threshold", self.threshold_m_s)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        model.mechanisms.captive_balls.push(Numbered { part, numbers: self.clone() });
    }
}

/// The captive balls of a machine, lying where they are drawn. They have the largest numbers, so that a ball in play is
/// never taken for one.
pub(crate) fn balls(captives: &[Numbered<CaptiveBall>]) -> impl Iterator<Item = Ball> {
    captives.iter().enumerate().map(|(index, own)| Ball {
        hold: Hold::Captive(index),
        ..Ball::new(u32::MAX - index as u32, own.numbers.center)
    })
}

/// Two balls have met at this speed: where one of them is captive and the other is in play, its switch closes.
pub(crate) fn hit(captives: &[Numbered<CaptiveBall>], pair: [&Ball; 2], approach: f64, events: &mut Vec<Event>) {
    for (ball, other) in [(pair[0], pair[1]), (pair[1], pair[0])] {
        let Some(index) = ball.captive() else { continue };
        let Numbered { part, numbers } = &captives[index];
        if other.captive().is_none() && approach >= numbers.threshold_m_s && approach > 0.0 {
            events.push(Event::closed(*part));
        }
    }
}
