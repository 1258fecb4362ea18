//! A finding: one thing that only play shows, as a sentence with the part's name and line.

mod kind;
mod ramp;

pub use kind::FindingKind;

use super::{nearest, rules_finding};
use crate::table::FILES;
use crate::{Failure, Table};
use geometry::{DVec2, trig};
use physics::{BALL_RADIUS_M, Kind, Layout, PartId};
use std::cmp::Reverse;

/// One thing that only play shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finding {
    /// What.
    pub kind: FindingKind,
    /// The part that it is about, or that is nearest.
    pub part: Option<PartId>,
    /// Where the ball was, mm.
    pub place_mm: DVec2,
    /// How often it was found.
    pub count: usize,
}

impl Finding {
    /// What was found about this part, once.
    pub(super) fn of_part(kind: FindingKind, part: PartId, place_m: DVec2) -> Finding {
        Finding { kind, part: Some(part), place_mm: place_m * 1000.0, count: 1 }
    }

    /// What was found of a ball there, about the part that is nearest: of a ball above the playfield the nearest ramp.
    pub(super) fn near(kind: FindingKind, layout: &Layout, place_m: DVec2, is_above: bool) -> Finding {
        // A ball that has left the table is told where it has left it.
        let place_m = if place_m.is_finite() { place_m.clamp(DVec2::ZERO, layout.size_m) } else { place_m };
        let ramp = nearest::ramp(layout, place_m).filter(|_| is_above);
        let part = ramp.or_else(|| nearest::part(layout, place_m, None));
        Finding { kind, part, place_mm: place_m * 1000.0, count: 1 }
    }

    /// Whether the table can be played all the same.
    pub fn is_warning(&self) -> bool {
        matches!(
            self.kind,
            FindingKind::FreedBySearch
                | FindingKind::SwitchNeverCloses
                | FindingKind::Unreachable
                | FindingKind::NoStart
                | FindingKind::GameWithoutEnd
                | FindingKind::EndsEarly
                | FindingKind::NoNextGame
                | FindingKind::OverEarly
                | FindingKind::TurnsInPlay
                | FindingKind::BeginsAnew
                | FindingKind::DeadKickers
                | FindingKind::DoesNotFlip
                | FindingKind::FlippersCross
                | FindingKind::NeverRaised
        )
    }

    /// The same as a sentence for a person: a warning, or a failure.
    pub fn failure(&self, table: &Table) -> Failure {
        let of_part = || (self.place(table), self.sentence(table));
        let (place, what) = rules_finding::told(self, table).unwrap_or_else(of_part);
        let sentence = format!("{place}: {what}");
        if self.is_warning() { Failure::warning(sentence) } else { Failure::new(sentence) }
    }

    /// File, line and name of the part; the rules' file where there is none.
    fn place(&self, table: &Table) -> String {
        let Some(part) = self.part.map(|part| usize::from(part.0)) else { return table.file(FILES[2]) };
        let name = table.layout.parts.get(part).map_or("", |part| &part.name);
        let file = table.file(FILES[0]);
        let line = table.part_lines.get(part).map_or_else(String::new, |line| format!(":{line}"));
        format!("{file}{line}: {name}")
    }

    /// What was found, and what to do.
    fn sentence(&self, table: &Table) -> String {
        let DVec2 { x, y } = self.place_mm;
        let at = format!("{x:.0}, {y:.0} mm");
        match self.kind {
            FindingKind::Stuck => format!(
                "a ball lies still beside it at {at}, and the ball search does not free it{}: close the pocket, or turn \
                 its floor so that a ball rolls out{}",
                self.times(),
                self.touches_too(table)
            ),
            FindingKind::FreedBySearch => format!(
                "a ball lies still beside it at {at} until the ball search fires every coil{}; let it roll out",
                self.times()
            ),
            FindingKind::Escaped => {
                format!("a ball has left the playfield near it, at {at}{}: close the way with a wall", self.times())
            }
            FindingKind::ComesOut => {
                "the captive ball comes out of its place: draw walls round it whose gap is narrower than 27 mm"
                    .to_string()
            }
            FindingKind::OpenEdge => {
                format!("a ball can leave the playfield beside it, at {at}: close the way with a wall or a drain")
            }
            FindingKind::Overlap => {
                format!("a ball at {at} is inside it{}: leave a ball, 27 mm wide, more room", self.times())
            }
            FindingKind::NotANumber => format!("the physics loses a ball near it{}: move it a little", self.times()),
            FindingKind::FeedBlocked => {
                format!(
                    "new balls arrive before it at {at}, which is inside {}: draw it from the tip at rest, x1 y1, to the \
                     tip when fully pulled, x2 y2, and leave 27 mm before it",
                    self.beside(table)
                )
            }
            FindingKind::Unlaunched => self.slow_plunger(table).unwrap_or_else(|| {
                format!(
                    "the ball comes back to it however far it is pulled, and no farther than to {at}, beside {}: see that \
                     nothing bars the lane, and that it leads round a bend",
                    self.beside(table)
                )
            }),
            _ => self.sentence_of_part(table),
        }
    }

    /// Of a plunger whose ball comes about as far up as its speed carries it.
    fn slow_plunger(&self, table: &Table) -> Option<String> {
        let part = self.part.and_then(|part| table.layout.parts.get(usize::from(part.0)))?;
        let Kind::Plunger(plunger) = &part.kind else { return None };
        let risen_m = plunger.feed.y - self.place_mm.y * 0.001;
        let rolling_m_s = plunger.full_speed_m_s * ROLLING_SPEED;
        let carried_m = rolling_m_s * rolling_m_s
            / (2.0 * ROLLING_SPEED * GRAVITY_M_S2 * trig::direction(table.layout.slope_rad).y);
        (risen_m > CARRIED * carried_m).then(|| {
            format!(
                "the ball comes back to it however far it is pulled: its full_speed_m_s, {}, carries a ball up to {:.0}, \
                 {:.0} mm and no farther; give it more in table.toml",
                plunger.full_speed_m_s, self.place_mm.x, self.place_mm.y
            )
        })
    }

    /// The same of what is said of a part itself, not of a ball beside it.
    fn sentence_of_part(&self, table: &Table) -> String {
        match self.kind {
            FindingKind::PointsDown => {
                "it is drawn upside down and shoots down the table: draw it from the tip at rest, x1 y1, down to the tip when \
                 fully pulled, x2 y2"
                    .to_string()
            }
            FindingKind::FallsBack => self.falls_back(table),
            FindingKind::KeepsItsBall => {
                "the ball that it throws out falls back into it: throw it faster, or to where the way is free".to_string()
            }
            FindingKind::DoesNotKick => {
                "its rod does not throw the ball that lies on it: see that the way before it is free, and that it is drawn from \
                 the tip at rest, x1 y1, to the tip when fully out, x2 y2"
                    .to_string()
            }
            FindingKind::DoesNotFlip => {
                "its stroke does not throw the ball that lies on it; see its data-side and its angle, and that the way is \
                 free"
                .to_string()
            }
            FindingKind::DoesNotRise => "it does not stand up again when it is raised: leave it more room".to_string(),
            FindingKind::FlippersCross => format!(
                "its stroke crosses that of {} at {:.0}, {:.0} mm: move them apart, or let them turn less",
                self.crossed(table),
                self.place_mm.x,
                self.place_mm.y
            ),
            FindingKind::SwitchNeverCloses => self.never_closes(table),
            FindingKind::Unreachable => {
                let without_entry = self.part.and_then(|part| ramp::without_entry(part, table));
                without_entry.unwrap_or_else(|| {
                    "no ball can come to it from the plunger; a ball needs a way that is wider than 27 mm".to_string()
                })
            }
            FindingKind::NeverEjected => "the rules do not throw its ball out within 20 s; call `eject` with its name, from a \
                                          timer that `on_switch` starts"
                .to_string(),
            FindingKind::NeverRaised => {
                "in a trial every drop target was hit, and no rule raised it, neither in that game nor when the next one began; \
                 call `raise` with its name where a ball begins, or from a timer when all of them are down"
                    .to_string()
            }
            // All others are told above, or by `rules_finding`.
            _ => String::new(),
        }
    }

    /// Of a kickback that is too slow.
    fn falls_back(&self, table: &Table) -> String {
        let part = self.part.and_then(|part| table.layout.parts.get(usize::from(part.0)));
        let speed = part.and_then(|part| match &part.kind {
            Kind::Kickback(kickback) => Some(format!(" than its speed_m_s, {},", kickback.speed_m_s)),
            _ => None,
        });
        let speed = speed.unwrap_or_default();
        format!("the ball that it throws falls back on it: throw it faster{speed} or to where the way is free")
    }

    /// What no ball does, by the kind of the part.
    fn never_closes(&self, table: &Table) -> String {
        let DVec2 { x, y } = self.place_mm;
        let balls = format!("of {} balls, the first from {x:.0}, {y:.0} mm,", self.count);
        let kind = self.part.and_then(|part| table.layout.parts.get(usize::from(part.0))).map(|part| &part.kind);
        match kind {
            Some(Kind::Saucer(saucer)) => format!(
                "{balls} that roll over it at 0.1 to 0.8 m/s it catches none; see its radius ({:.1} mm), its capture_m_s \
                 ({}) and that its middle is free",
                saucer.circle.radius * 1000.0,
                saucer.capture_m_s
            ),
            Some(Kind::Spinner(_)) => {
                format!("{balls} that are shot through below it none turns it half-way round; leave its ways free")
            }
            Some(Kind::Gate(_)) => format!(
                "{balls} that are shot through it none passes it the way that is free; see its data-way, and leave that way free"
            ),
            Some(Kind::Ramp(_)) => {
                format!(
                    "{balls} that are shot into it none comes onto it; leave its entry free, wider than a ball's 27 mm"
                )
            }
            Some(Kind::CaptiveBall(_)) => {
                format!(
                    "{balls} that are shot at it none closes its switch; leave the way to it free, wider than 27 mm"
                )
            }
            Some(Kind::Rollover(_)) => {
                format!("{balls} that are shot over it none closes its switch: a ball's centre must come over it")
            }
            _ => format!(
                "{balls} that are shot at it none closes its switch; turn it so that a ball comes straight at its face, and \
                 leave that free"
            ),
        }
    }

    /// Name and line of the flipper that is the nearest to the place on its stroke, but for the part itself.
    fn crossed(&self, table: &Table) -> String {
        let place = self.place_mm * 0.001;
        let others = table.layout.parts.iter().enumerate().filter_map(|(index, part)| match &part.kind {
            Kind::Flipper(own) if self.part != Some(PartId(index as u16)) => {
                let reach = own.length_m + own.tip_radius_m;
                Some((index, own.base.center.distance(place) - reach))
            }
            _ => None,
        });
        let nearest = others.min_by(|one, other| one.1.total_cmp(&other.1));
        nearest.map_or_else(String::new, |(part, _)| named(table, part))
    }

    /// Name and line of what is nearest to the ball, but for the part itself.
    fn beside(&self, table: &Table) -> String {
        let near = nearest::part(&table.layout, self.place_mm * 0.001, self.part).map(|part| usize::from(part.0));
        near.map_or_else(|| "nothing".to_string(), |part| named(table, part))
    }

    /// Of a pocket its other wall: the post beside a wall may be what is too near.
    fn touches_too(&self, table: &Table) -> String {
        let other = nearest::touching(&table.layout, self.place_mm * 0.001, self.part);
        other.map_or_else(String::new, |part| format!("; it touches {} too", named(table, usize::from(part.0))))
    }

    fn times(&self) -> String {
        if self.count > 1 { format!(" ({} times)", self.count) } else { String::new() }
    }
}

/// Name and line of a part.
fn named(table: &Table, part: usize) -> String {
    format!("{} (line {})", table.layout.parts[part].name, table.part_lines[part])
}

/// Of the speed of a ball that is shot, and of its acceleration down the slope, what rolling leaves: a ball is 2/5 m r2.
const ROLLING_SPEED: f64 = 5.0 / 7.0;
const GRAVITY_M_S2: f64 = 9.81;
/// A ball that comes so far of where its speed would carry it has run out of it, and nothing bars its way.
const CARRIED: f64 = 0.8;

/// Balls that lie no farther from each other lie in the same pocket, mm.
const POCKET_MM: f64 = 2000.0 * BALL_RADIUS_M;

/// Findings of the same kind in the same pocket or about the same part as one, the worst first.
pub(super) fn merged(findings: Vec<Finding>) -> Vec<Finding> {
    let mut findings = in_pockets(findings);
    let key = |finding: &Finding| (finding.is_warning(), finding.kind, finding.part);
    findings.sort_by_key(key);
    findings.dedup_by(|next, first| {
        let same = key(next) == key(first);
        first.count += usize::from(same) * next.count;
        same
    });
    findings
}

/// Balls that lie in one pocket are told of one of its walls, that which most of them lie beside.
fn in_pockets(findings: Vec<Finding>) -> Vec<Finding> {
    let is_at_rest = |finding: &Finding| matches!(finding.kind, FindingKind::Stuck | FindingKind::FreedBySearch);
    let (at_rest, mut told): (Vec<Finding>, Vec<Finding>) = findings.into_iter().partition(is_at_rest);
    let mut left = at_rest;
    while let Some(first) = left.pop() {
        let mut pocket = vec![first];
        let mut looked_at = 0;
        while let Some(ball) = pocket.get(looked_at).copied() {
            let is_beside = |other: &Finding| other.place_mm.distance(ball.place_mm) < POCKET_MM;
            let (beside, others): (Vec<Finding>, Vec<Finding>) = left.into_iter().partition(is_beside);
            pocket.extend(beside);
            left = others;
            looked_at += 1;
        }
        let balls_beside = |part| pocket.iter().filter(|ball| ball.part == part).map(|ball| ball.count).sum::<usize>();
        let part = pocket.iter().map(|ball| ball.part).max_by_key(|&part| (balls_beside(part), Reverse(part)));
        let first = pocket.iter().rev().find(|ball| Some(ball.part) == part).copied();
        let count = pocket.iter().map(|ball| ball.count).sum();
        // Where one ball stays that another is freed from, the pocket keeps balls.
        let kind = pocket.iter().map(|ball| ball.kind).min();
        told.extend(first.zip(kind).map(|(first, kind)| Finding { kind, count, ..first }));
    }
    told
}
