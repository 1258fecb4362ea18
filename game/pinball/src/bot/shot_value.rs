//! Shot value: what each part is worth to the bot: a first guess from what it is, then what the score has shown.

use physics::{EventKind, Kind, Layout, PartId, TickEvent};

/// Ticks after which a part that has just been hit is as interesting as before.
const FORGET_TICKS: f64 = 30_000.0;

/// The bot's opinion of each part of a table.
#[derive(Clone, Debug, Default)]
pub(super) struct ShotValues {
    parts: Vec<ShotValue>,
    /// Points that a hit has brought on the average.
    typical: f64,
}

#[derive(Clone, Debug)]
struct ShotValue {
    /// By kind and place.
    guess: f64,
    /// Points that it has brought on the average, once it has been hit.
    points: Option<f64>,
    /// How often it was hit lately, at the tick `hit`.
    lately: f64,
    hit: u64,
}

impl ShotValues {
    /// First guesses for a table; what lies below `line_m` is worth nothing.
    pub fn new(layout: &Layout, line_m: f64) -> ShotValues {
        let guess = |kind: &Kind| match kind {
            Kind::Saucer(_) => 14.0,
            Kind::DropTarget(_) => 12.0,
            Kind::Target(_) => 10.0,
            Kind::Spinner(_) => 8.0,
            Kind::Rollover(rollover) if rollover.shape.bounds().min.y < line_m - 0.25 => 8.0,
            Kind::Bumper(_) => 5.0,
            Kind::Gate(_) => 2.0,
            _ => 0.0,
        };
        let shot_value = |kind| ShotValue { guess: guess(kind), points: None, lately: 0.0, hit: 0 };
        ShotValues { parts: layout.parts.iter().map(|part| shot_value(&part.kind)).collect(), typical: 0.0 }
    }

    /// What a hit at `tick` is worth; about 10, never below 0.
    pub fn of(&self, part: PartId, tick: u64) -> f64 {
        let Some(shot_value) = self.parts.get(usize::from(part.0)) else { return 0.0 };
        let known = match shot_value.points {
            Some(points) if self.typical > 0.0 => (points / self.typical).clamp(0.4, 3.0),
            _ => 1.0,
        };
        shot_value.guess * known / (1.0 + shot_value.lately_at(tick))
    }

    /// Learns from a tick in which these events brought `points`.
    pub fn learn(&mut self, events: &[TickEvent], points: i64, tick: u64) {
        let events = || events.iter().filter_map(TickEvent::event);
        let closed = || events().filter(|event| event.kind == EventKind::Closed).filter_map(|event| event.part);
        let share = points as f64 / closed().count().max(1) as f64;
        for part in closed() {
            self.typical += (share - self.typical) * 0.05;
            let Some(shot_value) = self.parts.get_mut(usize::from(part.0)) else { continue };
            let before = shot_value.points.unwrap_or(share);
            shot_value.points = Some(before + (share - before) * 0.25);
            shot_value.lately = shot_value.lately_at(tick) + 1.0;
            shot_value.hit = tick;
        }
    }
}

impl ShotValue {
    fn lately_at(&self, tick: u64) -> f64 {
        (self.lately - tick.saturating_sub(self.hit) as f64 / FORGET_TICKS).max(0.0)
    }
}
