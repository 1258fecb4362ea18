//! How much of its speed each material of the table gives back to a ball.

use super::panel::{Axis, Panel, log};
use super::sheet::{self, Sheet, Words};
use super::{Drawn, fixture, ink};
use crate::screen::Size;
use crate::{Failure, Table};
use geometry::{DVec2, Shape};
use physics::{BALL_RADIUS_M, Controls, Kind, Layout, Material, Part, Wall};

/// The slowest and the fastest impact, m/s.
pub const SPEEDS_M_S: (f64, f64) = (0.05, 5.0);
/// How far in front of the wall the ball starts, m.
const RUN_M: f64 = 0.4e-3;
/// It has come back by then, ms.
const BACK_MS: u32 = 25;

/// How one material throws a ball back.
#[derive(Clone, Debug)]
pub struct Bounces {
    /// Its name in the table's numbers; two of the same numbers share a line.
    pub name: String,
    /// What it should do.
    pub material: Material,
    /// What it does: the speed of the impact, m/s, and the share of it that the ball comes back with.
    pub measured: Vec<(f64, f64)>,
}

impl Bounces {
    /// The largest error, in parts of the target.
    pub fn worst(&self) -> f64 {
        let error = |(speed, share): &(f64, f64)| (share / self.material.restitution_at(*speed) - 1.0).abs();
        self.measured.iter().map(error).fold(0.0, f64::max)
    }
}

/// Throws a ball straight at a wall of each material that the table's parts are made of, at `count` speeds in equal
/// ratios. The playfield is level and smooth, so that nothing but the wall changes the ball's speed.
///
/// # Errors
/// If the physics refuses a material.
pub fn measure(table: &Table, count: u32) -> Result<Vec<Bounces>, Failure> {
    let (slowest, fastest) = SPEEDS_M_S;
    let share = |step: u32| f64::from(step) / f64::from(count.saturating_sub(1).max(1));
    let speeds: Vec<f64> = (0..count).map(|step| slowest * libm::pow(fastest / slowest, share(step))).collect();
    let mut all = Vec::new();
    for (name, material) in materials(table) {
        let measured = speeds.iter().map(|speed| bounce(material, *speed)).collect::<Result<_, _>>()?;
        all.push(Bounces { name, material, measured });
    }
    Ok(all)
}

/// What the table's parts are made of, each once, by name.
fn materials(table: &Table) -> Vec<(String, Material)> {
    let mut used: Vec<Material> = Vec::new();
    for material in table.layout.parts.iter().filter_map(material) {
        if !used.contains(material) {
            used.push(*material);
        }
    }
    let name = |material: &Material| {
        let names = table.materials.iter().filter(|(_, named)| named == material).map(|(name, _)| name.as_str());
        names.collect::<Vec<_>>().join(", ")
    };
    used.into_iter().map(|material| (name(&material), material)).collect()
}

fn material(part: &Part) -> Option<&Material> {
    match &part.kind {
        Kind::Wall(Wall { material, .. }) => Some(material),
        Kind::Flipper(flipper) => Some(&flipper.material),
        Kind::Bumper(bumper) => Some(&bumper.material),
        Kind::Slingshot(slingshot) => Some(&slingshot.material),
        Kind::Target(target) => Some(&target.material),
        Kind::DropTarget(target) => Some(&target.material),
        Kind::Gate(gate) => Some(&gate.material),
        _ => None,
    }
}

/// The speed of one impact and the share of it that the ball comes back with.
fn bounce(material: Material, speed_m_s: f64) -> Result<(f64, f64), Failure> {
    let (thickness, middle) = (3e-3, DVec2::new(0.25, 0.5));
    let ends = [middle - DVec2::Y * 0.4, middle + DVec2::Y * 0.4];
    let wall = Wall { shapes: vec![Shape::capsule(ends[0], ends[1], thickness)], material };
    let parts = vec![Part { name: "wall".into(), kind: Kind::Wall(wall) }];
    let size_m = DVec2::new(0.5, 1.0);
    let mut machine = fixture::machine(Layout { size_m, slope_rad: 0.0, playfield_friction: 0.0, parts })?;
    let start = middle - DVec2::X * (thickness + BALL_RADIUS_M + RUN_M);
    machine.put_ball(start, DVec2::X * speed_m_s, [0.0; 3]);
    let mut hit_m_s = speed_m_s;
    for _ in 0..BACK_MS {
        machine.tick(Controls::default(), &[]);
        if let Some(contact) = machine.contacts().first() {
            hit_m_s = contact.speed_m_s;
            break;
        }
    }
    Ok((hit_m_s, -machine.pose().balls[0].velocity.x / hit_m_s))
}

/// The bounces as a picture: what each material should do as lines, what it does as dots.
///
/// # Errors
/// If it cannot be drawn.
pub fn draw(bounces: &[Bounces], table: &Table, size: Size) -> Result<Drawn, Failure> {
    let impacts: usize = bounces.iter().map(|material| material.measured.len()).sum();
    let worst = bounces.iter().map(Bounces::worst).fold(0.0, f64::max);
    let words = Words {
        title: "What bounces, and how much".into(),
        experiment: format!("A ball thrown straight at a wall of each material of {}", table.title),
        finding: format!(
            "Dots: {impacts} measured impacts. Lines: e / (1 + k v), as the table says. Largest difference {:.3} %.",
            100.0 * worst
        ),
    };
    let frame = sheet::picture(size, &words, |sheet| curves(bounces, sheet))?;
    Ok(Drawn { frame, finding: words.finding })
}

fn curves(bounces: &[Bounces], sheet: &Sheet) -> Result<(), Failure> {
    let (slowest, fastest) = SPEEDS_M_S;
    let x =
        Axis::ratios("speed of the impact, m/s", slowest / 1.1..fastest * 1.1, &[0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0]);
    let y = Axis::new("part of the speed that it comes back with", 0.0..1.0, 6);
    let panel = Panel::new(sheet, sheet.curves(), &x, &y)?;
    let mut entries = Vec::new();
    let mut sorted: Vec<&Bounces> = bounces.iter().collect();
    sorted.sort_by(|one, other| other.material.restitution.total_cmp(&one.material.restitution));
    for (bounces, color) in sorted.into_iter().zip(ink::KINDS.into_iter().cycle()) {
        let speed = |step: u32| slowest * libm::pow(fastest / slowest, f64::from(step) / 200.0);
        let target = (0..=200).map(speed).map(|speed| (log(speed), bounces.material.restitution_at(speed)));
        panel.line(target, 2.0, color)?;
        panel.dots(bounces.measured.iter().map(|(speed, share)| (log(*speed), *share)), 4.5, color)?;
        entries.push((color, bounces.name.clone()));
    }
    sheet.legend("made of", &entries)
}
