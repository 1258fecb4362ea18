//! Energy: what becomes of the energy of balls that nothing drives.

use super::panel::{Axis, Panel};
use super::sheet::{self, Sheet, Words};
use super::{Drawn, fixture, ink};
use crate::screen::Size;
use crate::{Failure, Table};
use geometry::{DVec2, trig};
use physics::{BALL_MASS_KG, BALL_RADIUS_M, BallPose, Controls, Kind, Layout, Machine};

/// Acceleration of free fall, m/s^2.
const GRAVITY_M_S2: f64 = 9.81;
/// How fast the balls are thrown, m/s.
const THROWN_M_S: f64 = 1.5;
/// Turning by this angle again and again never comes back to the same way: the golden angle, rad.
const GOLDEN_RAD: f64 = 2.399_963_229_728_653;

/// The energy of all balls together, J, and of what it consists.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// What they would gain by rolling down to the playfield's lower edge.
    pub height_j: f64,
    /// Of their motion.
    pub motion_j: f64,
    /// Of their spin.
    pub spin_j: f64,
}

impl Energy {
    /// All of it, J.
    pub fn total_j(&self) -> f64 {
        self.height_j + self.motion_j + self.spin_j
    }
}

/// What happened to the balls.
#[derive(Clone, Debug)]
pub struct Fall {
    /// How many there were.
    pub balls: usize,
    /// At 0, 1, 2... ms.
    pub energy: Vec<Energy>,
    /// When a ball left the playfield and took its energy with it, ms.
    pub drained_ms: Vec<usize>,
}

impl Fall {
    /// The largest rise in a tick, in parts of what there was.
    pub fn largest_rise(&self) -> f64 {
        let total = |energy: &Energy| energy.total_j();
        let rise = |pair: &[Energy]| (total(&pair[1]) - total(&pair[0])) / total(&pair[0]).max(f64::MIN_POSITIVE);
        self.energy.windows(2).map(rise).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Throws `balls` balls onto the table with every coil dead and watches them for `duration_ms`.
///
/// The plunger and the saucers are taken off, for they hold balls. What a ball gives to something that moves (a gate, a
/// spinner, another part) is lost, and so is the energy of a ball that drains.
///
/// # Errors
/// If there is no room for them.
pub fn measure(table: &Table, balls: usize, duration_ms: usize) -> Result<Fall, Failure> {
    let layout = fixture::bare(table, |part| !matches!(part.kind, Kind::Plunger(_) | Kind::Saucer(_)));
    let mut machine = fixture::machine(layout)?;
    throw(&mut machine, balls);
    if machine.pose().balls.is_empty() {
        return Err(Failure::new(format!("there is no room for a ball on {}; plot another table", table.name)));
    }
    let now = |machine: &Machine| energy(machine.layout(), &machine.pose().balls);
    let mut fall = Fall { balls: machine.pose().balls.len(), energy: vec![now(&machine)], drained_ms: Vec::new() };
    for tick in 1..=duration_ms {
        let before = machine.pose().balls.len();
        machine.tick(Controls::default(), &[]);
        fall.drained_ms.extend(std::iter::repeat_n(tick, before - machine.pose().balls.len()));
        fall.energy.push(now(&machine));
    }
    Ok(fall)
}

/// Puts balls where there is room for them, in the upper two thirds of the playfield; fewer where there is none.
fn throw(machine: &mut Machine, balls: usize) {
    let size = machine.layout().size_m;
    let mut step = 0.0;
    while machine.pose().balls.len() < balls && step < 1000.0 {
        step += 1.0;
        // Additive recurrence: evenly spread points (R2 sequence, M. Roberts 2018).
        let share = DVec2::new((0.754_877_666 * step) % 1.0, (0.569_840_291 * step) % 1.0);
        let place = size * (DVec2::new(0.15, 0.1) + share * DVec2::new(0.65, 0.5));
        let mut tried = machine.clone();
        tried.put_ball(place, trig::direction(GOLDEN_RAD * step) * THROWN_M_S, [0.0; 3]);
        if tried.penetration_m() <= 0.0 {
            *machine = tried;
        }
    }
}

fn energy(layout: &Layout, balls: &[BallPose]) -> Energy {
    let inertia = 0.4 * BALL_MASS_KG * BALL_RADIUS_M * BALL_RADIUS_M;
    let pull_n = BALL_MASS_KG * GRAVITY_M_S2 * libm::sin(layout.slope_rad);
    let spin = |ball: &BallPose| ball.spin.iter().map(|spin| spin * spin).sum::<f64>();
    Energy {
        height_j: balls.iter().map(|ball| pull_n * (layout.size_m.y - ball.center.y)).sum(),
        motion_j: balls.iter().map(|ball| 0.5 * BALL_MASS_KG * ball.velocity.length_squared()).sum(),
        spin_j: balls.iter().map(|ball| 0.5 * inertia * spin(ball)).sum(),
    }
}

/// The energy as a picture.
///
/// # Errors
/// If it cannot be drawn.
pub fn draw(fall: &Fall, table: &Table, size: Size) -> Result<Drawn, Failure> {
    let words = Words {
        title: "Where the energy goes".into(),
        experiment: format!("{} balls thrown onto {} with every coil dead", fall.balls, table.title),
        finding: finding(fall),
    };
    let frame = sheet::picture(size, &words, |sheet| curves(fall, sheet))?;
    Ok(Drawn { frame, finding: words.finding })
}

fn finding(fall: &Fall) -> String {
    let first_j = fall.energy[0].total_j();
    let half = fall.energy.iter().position(|energy| energy.total_j() < 0.5 * first_j);
    let half = half.map_or("not halved yet".to_string(), |ms| format!("halved after {ms} ms"));
    let rise = match fall.largest_rise() {
        rise if rise > 0.0 => format!("its largest rise in a tick is {rise:.1e} of itself"),
        _ => format!("it rises in none of {} ticks", fall.energy.len() - 1),
    };
    format!("{:.0} mJ at first, {half}; {rise}.", 1000.0 * first_j)
}

fn curves(fall: &Fall, sheet: &Sheet) -> Result<(), Failure> {
    let duration_s = (fall.energy.len() - 1) as f64 / 1000.0;
    let most_mj = 1000.0 * fall.energy[0].total_j();
    let x = Axis::new("after the throw, s", 0.0..duration_s, 10);
    let y = Axis::new("energy of all balls on the table, mJ", 0.0..most_mj * 1.05, 8);
    let panel = Panel::new(sheet, sheet.curves(), &x, &y)?;
    let series = |part: fn(&Energy) -> f64| {
        fall.energy.iter().enumerate().map(move |(ms, energy)| (ms as f64 / 1000.0, 1000.0 * part(energy)))
    };
    let [height, spin, motion] = [ink::RAMP[0], ink::RAMP[2], ink::RAMP[5]];
    panel.fill(series(Energy::total_j), motion)?;
    panel.fill(series(|energy| energy.height_j + energy.spin_j), spin)?;
    panel.fill(series(|energy| energy.height_j), height)?;
    panel.line(series(Energy::total_j), 3.0, ink::IVORY)?;
    for ms in &fall.drained_ms {
        panel.moment(*ms as f64 / 1000.0, "")?;
    }
    let entries = [
        (ink::IVORY, "all together"),
        (motion, "motion"),
        (spin, "spin"),
        (height, "height"),
        (ink::BRASS, "a ball drains"),
    ];
    sheet.legend("energy of", &entries.map(|(color, name)| (color, name.to_string())))
}
