//! What a layout comes to once it is known that it will be played: every surface at the ball's centre, sorted into
//! grids. Made once, shared by every clone of a machine, changed by none.

use crate::BALL_RADIUS_M;
use crate::ball::Floor;
use crate::collision::grid::Grid;
use crate::layout::{CaptiveBall, Gate, Kind, Layout, Magnet, Material, Plunger, Saucer, Spinner};
use crate::mechanisms::flipper::Blade;
use crate::mechanisms::ramp_path::Track;
use crate::mechanisms::rod::Slide;
use geometry::{DVec2, Segment, Shape, trig};

/// Standard gravity, m/s^2.
const GRAVITY_M_S2: f64 = 9.81;
/// Closer than this a slow ball touches, m.
pub(crate) const SKIN_M: f64 = 25e-6;
/// What the tip of a rod does to the ball.
const ROD_MATERIAL: Material = Material { restitution: 0.3, falloff_s_per_m: 0.1, friction: 0.2 };

/// Something that the ball bounces off and that does not turn.
#[derive(Clone, Debug)]
pub(crate) struct Obstacle {
    pub part: u16,
    /// The places of the ball's centre where it touches.
    pub shape: Shape,
    pub material: Material,
    pub role: Role,
}

/// What an obstacle does beside being there; the index counts the parts of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Still,
    Kicker(usize),
    Target(usize),
    Drop(usize),
    Gate(usize),
}

/// A region that the ball's centre may be in.
#[derive(Clone, Debug)]
pub(crate) struct Zone {
    pub part: u16,
    pub shape: Shape,
    pub what: Place,
}

/// What a zone is for; the index counts the parts of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Rollover(usize),
    Drain,
    Saucer(usize),
    /// Near the flap of this gate.
    Gate(usize),
    /// Near the plate of this spinner.
    Spinner(usize),
}

/// A coil that throws the ball off a surface.
#[derive(Clone, Debug)]
pub(crate) struct Kicker {
    pub part: u16,
    pub kick: f64,
    pub threshold: f64,
    /// A slingshot's rubber; a bumper kicks alike all round.
    pub rubber: Option<Segment>,
}

/// A target's part and threshold.
#[derive(Clone, Debug)]
pub(crate) struct Switch {
    pub part: u16,
    pub threshold: f64,
}

/// A part's index with its numbers.
pub(crate) type Numbered<T> = (u16, T);

#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub size: DVec2,
    pub floor: Floor,
    pub obstacles: Vec<Obstacle>,
    pub obstacle_grid: Grid,
    pub zones: Vec<Zone>,
    pub zone_grid: Grid,
    pub blades: Vec<Blade>,
    pub kickers: Vec<Kicker>,
    pub targets: Vec<Switch>,
    pub drops: Vec<Switch>,
    /// Where the drop targets are among the obstacles.
    pub drop_obstacles: Vec<usize>,
    pub rollovers: Vec<u16>,
    pub gates: Vec<Numbered<Gate>>,
    pub spinners: Vec<Numbered<Spinner>>,
    pub saucers: Vec<Numbered<Saucer>>,
    pub plungers: Vec<Numbered<Plunger>>,
    /// The rods of plungers and kickbacks.
    pub slides: Vec<Slide>,
    pub rod_material: Material,
    pub magnets: Vec<Numbered<Magnet>>,
    pub captives: Vec<Numbered<CaptiveBall>>,
    pub tracks: Vec<Track>,
}

/// How far from its axle's line a plate or flap can still meet the ball: a little over 30 mm, where it stands out at 62
/// degrees and its edge touches the ball below its middle.
const PLATE_REACH_M: f64 = 0.031;

impl Plan {
    pub fn new(layout: &Layout) -> Plan {
        let (sin, cos) = trig::sin_cos(layout.slope_rad);
        let (gravity, press) = (GRAVITY_M_S2 * sin, GRAVITY_M_S2 * cos);
        let floor = Floor { gravity, press, friction: layout.playfield_friction, drag: 0.0 };
        let empty = Grid::new(layout.size_m, std::iter::empty(), 0.0);
        let mut plan = Plan {
            size: layout.size_m,
            floor,
            obstacles: Vec::new(),
            obstacle_grid: empty.clone(),
            zones: Vec::new(),
            zone_grid: empty,
            blades: Vec::new(),
            kickers: Vec::new(),
            targets: Vec::new(),
            drops: Vec::new(),
            drop_obstacles: Vec::new(),
            rollovers: Vec::new(),
            gates: Vec::new(),
            spinners: Vec::new(),
            saucers: Vec::new(),
            plungers: Vec::new(),
            slides: Vec::new(),
            rod_material: ROD_MATERIAL,
            magnets: Vec::new(),
            captives: Vec::new(),
            tracks: Vec::new(),
        };
        layout.parts.iter().enumerate().for_each(|(index, part)| plan.add(index as u16, &part.kind));
        plan.obstacle_grid = Grid::new(layout.size_m, plan.obstacles.iter().map(|o| &o.shape), SKIN_M);
        plan.add_tracks(layout);
        plan.zone_grid = Grid::new(layout.size_m, plan.zones.iter().map(|z| &z.shape), 0.0);
        plan
    }

    /// The sides of the tracks: behind all that stands on the playfield, and in no grid.
    fn add_tracks(&mut self, layout: &Layout) {
        Track::join(&mut self.tracks);
        for index in 0..self.tracks.len() {
            let track = &self.tracks[index];
            let Kind::Ramp(ramp) = &layout.parts[usize::from(track.part)].kind else { continue };
            let first = self.obstacles.len();
            self.obstacles.extend(track.sides(ramp));
            self.obstacles.extend(track.funnels(ramp, &self.tracks));
            self.obstacles.extend(track.overlaps(ramp, &self.tracks));
            self.tracks[index].sides = first..self.obstacles.len();
        }
    }

    /// Calls `visit` with every obstacle that may be near the straight way of a ball on this track, or on the playfield,
    /// perhaps more than once.
    pub fn near(&self, track: Option<u16>, from: DVec2, to: DVec2, mut visit: impl FnMut(usize)) {
        match track {
            None => self.obstacle_grid.visit(from, to, visit),
            Some(track) => self.tracks[usize::from(track)].sides.clone().for_each(&mut visit),
        }
    }

    fn obstacle(&mut self, part: u16, shape: Shape, material: Material, role: Role) {
        self.obstacles.push(Obstacle { part, shape: shape.inflated(BALL_RADIUS_M), material, role });
    }

    fn zone(&mut self, part: u16, shape: Shape, what: Place) {
        self.zones.push(Zone { part, shape, what });
    }

    fn add(&mut self, part: u16, kind: &Kind) {
        let thin = |segment: Segment, radius| Shape::capsule(segment.a, segment.b, radius);
        match kind {
            Kind::Wall(wall) => {
                wall.shapes.iter().for_each(|&shape| self.obstacle(part, shape, wall.material, Role::Still));
            }
            Kind::Flipper(flipper) => self.blades.push(Blade::new(part, flipper)),
            Kind::Bumper(b) => {
                let shape = Shape::disc(b.circle.center, b.circle.radius);
                self.obstacle(part, shape, b.material, Role::Kicker(self.kickers.len()));
                self.kickers.push(Kicker { part, kick: b.kick_m_s, threshold: b.threshold_m_s, rubber: None });
            }
            Kind::Slingshot(s) => {
                self.obstacle(part, thin(s.segment, s.radius_m), s.material, Role::Kicker(self.kickers.len()));
                let rubber = Some(s.segment);
                self.kickers.push(Kicker { part, kick: s.kick_m_s, threshold: s.threshold_m_s, rubber });
            }
            Kind::Target(t) => {
                self.obstacle(part, t.shape, t.material, Role::Target(self.targets.len()));
                self.targets.push(Switch { part, threshold: t.threshold_m_s });
            }
            Kind::DropTarget(t) => {
                self.drop_obstacles.push(self.obstacles.len());
                self.obstacle(part, t.shape, t.material, Role::Drop(self.drops.len()));
                self.drops.push(Switch { part, threshold: t.threshold_m_s });
            }
            Kind::Rollover(r) => {
                self.zone(part, r.shape, Place::Rollover(self.rollovers.len()));
                self.rollovers.push(part);
            }
            Kind::Gate(g) => {
                self.obstacle(part, thin(g.segment, 0.0), g.material, Role::Gate(self.gates.len()));
                self.zone(part, thin(g.segment, PLATE_REACH_M), Place::Gate(self.gates.len()));
                self.gates.push((part, g.clone()));
            }
            Kind::Spinner(s) => {
                self.zone(part, thin(s.segment, PLATE_REACH_M), Place::Spinner(self.spinners.len()));
                self.spinners.push((part, s.clone()));
            }
            Kind::Saucer(s) => {
                let shape = Shape::disc(s.circle.center, s.circle.radius);
                self.zone(part, shape, Place::Saucer(self.saucers.len()));
                self.saucers.push((part, s.clone()));
            }
            Kind::Ramp(ramp) => {
                let track = Track::new(part, ramp);
                self.obstacles.extend(track.underside(ramp));
                self.tracks.push(track);
            }
            Kind::Drain(d) => self.zone(part, d.shape, Place::Drain),
            Kind::Plunger(p) => {
                self.slides.push(Slide::of_plunger(part, p));
                self.plungers.push((part, p.clone()));
            }
            Kind::Kickback(k) => self.slides.push(Slide::of_kickback(part, k)),
            Kind::Magnet(m) => self.magnets.push((part, m.clone())),
            Kind::CaptiveBall(c) => self.captives.push((part, c.clone())),
        }
    }
}

impl Kicker {
    /// Speed that it adds to a ball at `center`: a slingshot's falls to its ends.
    pub fn speed_at(&self, center: DVec2) -> f64 {
        let offset = self.rubber.map_or(0.0, |rubber| 2.0 * rubber.parameter(center) - 1.0);
        self.kick * (1.0 - offset * offset)
    }
}
