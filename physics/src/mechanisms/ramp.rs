//! Ramp: a ramp or a wire-form, its numbers and what stands beside its path.
//!
//! Where its floor is is in `crate::mechanisms::ramp_path`; how balls go up and down is in
//! `crate::mechanisms::elevation`.

use crate::BALL_RADIUS_M;
use crate::mechanisms::model::Model;
use crate::mechanisms::ramp_leg::Leg;
use crate::mechanisms::ramp_path::RampPath;
use crate::part::PartId;
use crate::part::material::Material;
use crate::part::validation::{self, Checked};
use serde::{Deserialize, Serialize};

/// How far the end of a leg may be from the start of the next, m.
const LEG_GAP_M: f64 = 1e-4;
/// The highest that a floor may be, m.
const MAX_HEIGHT_M: f64 = 0.5;

/// A path above the playfield, with sides. Its switch closes when a ball leaves it at its end. A ball that rolls in at an end that lies on the playfield is on it, and meets
/// its sides and what else is on it, and nothing that stands below. It leaves at the ends: onto the playfield, onto another
/// ramp that begins there, or falling. Where the floor is too low for a ball to pass below, its sides stand on the
/// playfield.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ramp {
    /// The middle of its floor, from one end to the other: each leg begins where the last one ends.
    pub path: Vec<Leg>,
    /// Height of the floor above the playfield at the start of each leg and at the end of the last, m: one more than
    /// legs. In between it bends smoothly.
    pub heights_m: Vec<f64>,
    /// Half of the width between its sides, m: more than the ball's radius.
    pub half_width_m: f64,
    /// What its sides are made of.
    pub material: Material,
}

impl Ramp {
    pub(crate) fn check(&self) -> Checked {
        validation::material(&self.material)?;
        validation::finite("half the width", self.half_width_m)?;
        if self.half_width_m <= BALL_RADIUS_M {
            return Err("its sides must be farther apart than a ball is wide".into());
        }
        self.path.iter().try_for_each(|leg| self.check_leg(leg))?;
        if self.path.is_empty() {
            return Err("its path has no length".into());
        }
        if self.path.windows(2).any(|pair| pair[0].at(pair[0].length()).distance(pair[1].at(0.0)) > LEG_GAP_M) {
            return Err("each leg of its path must begin where the last one ends".into());
        }
        self.check_heights()
    }

    fn check_leg(&self, leg: &Leg) -> Checked {
        match leg {
            Leg::Line(line) => validation::segment(line),
            Leg::Turn { arc: turn, .. } => {
                validation::arc(turn)?;
                validation::positive("the angle of a turn", turn.half_angle())?;
                if turn.circle().radius <= self.half_width_m + BALL_RADIUS_M {
                    return Err("a turn must be wider than half its width and a ball's radius".into());
                }
                Ok(())
            }
        }
    }

    fn check_heights(&self) -> Checked {
        let corners = self.path.len() + 1;
        let given = self.heights_m.len();
        if given != corners {
            return Err(format!("its path has {corners} corners and ends, so it needs as many heights, not {given}"));
        }
        for &height in &self.heights_m {
            validation::not_negative("a height", height)?;
            validation::at_most("a height", height, MAX_HEIGHT_M)?;
        }
        Ok(())
    }

    /// The path, and what a ball on the playfield meets of it.
    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let path = RampPath::new(part, self);
        model.collision.obstacles.extend(path.underside());
        model.mechanisms.ramps.push(path);
    }
}

/// Joins the ramps of a model, and adds what balls on them meet: behind all that stands on the playfield, and in no grid.
pub(crate) fn add_sides(model: &mut Model) {
    let (ramps, obstacles) = (&mut model.mechanisms.ramps, &mut model.collision.obstacles);
    RampPath::join(ramps);
    for ramp in ramps.iter() {
        let first = obstacles.len();
        obstacles.extend(ramp.sides());
        obstacles.extend(ramp.funnels(ramps));
        obstacles.extend(ramp.overlaps(ramps));
        model.collision.ramp_sides.push(first..obstacles.len());
    }
}
