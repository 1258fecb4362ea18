//! What a tick costs where many balls lie on each other.

use super::Row;
use super::clock::time_ms;
use crate::Failure;
use geometry::{DVec2, Shape};
use physics::{BALL_RADIUS_M, CaptiveBall, Controls, Kind, Layout, Machine, Material, Part, Wall};
use std::sync::Arc;

/// Balls in each heap.
const HEAPS: [usize; 5] = [1, 10, 50, 150, 500];
/// Balls in a row of a heap.
const ACROSS: usize = 17;
/// How long each heap is watched after it was laid, ticks for all its balls together.
const BALL_TICKS: usize = 10_000;

/// Lays heaps of captive balls, and lets each lie.
///
/// # Errors
/// If the physics refuses one.
pub fn rows() -> Result<Vec<Row>, Failure> {
    HEAPS.into_iter().map(row).collect()
}

fn row(balls: usize) -> Result<Row, Failure> {
    let refused = |error| Failure::new(format!("the physics refuses a heap of {balls} balls: {error:?}"));
    let mut machine = Machine::new(Arc::new(heap(balls))).map_err(refused)?;
    let ticks = BALL_TICKS / balls;
    let (mut solves, mut most) = (0, 0);
    let ms = time_ms(|| {
        for _ in 0..ticks {
            machine.tick(Controls::NONE, &[]);
            solves += machine.contact_solves();
            most = most.max(machine.contact_solves());
        }
    });
    let (tick_ms, a_tick) = (ms / ticks as f64, solves as f64 / ticks as f64);
    let a_ball_us = tick_ms * 1e3 / balls as f64;
    Ok(Row {
        bench: "physics",
        variant: format!("{balls} balls in a heap, {a_ball_us:.2} us each, {a_tick:.0} contact solves, most {most}"),
        threads: 1,
        ms: tick_ms,
        times_real_time: Some(1.0 / tick_ms),
        ..Row::default()
    })
}

/// So many balls on the lower wall of an empty playfield, in rows that touch each other.
fn heap(balls: usize) -> Layout {
    let wood = Material { restitution: 0.4, falloff_s_per_m: 0.0, friction: 0.25 };
    let (left, right, top, bottom) = (0.01, 0.504, 0.01, 1.057);
    let corners = [(left, top), (right, top), (right, bottom), (left, bottom)].map(|(x, y)| DVec2::new(x, y));
    let side = |corner: usize| Shape::capsule(corners[corner], corners[(corner + 1) % 4], 0.003);
    let frame = Wall { shapes: (0..4).map(side).collect(), material: wood };
    let captive = |ball: usize| {
        let (row, place) = (ball / ACROSS, ball % ACROSS);
        let shift = if row.is_multiple_of(2) { 0.0 } else { BALL_RADIUS_M };
        let x = left + 0.0031 + BALL_RADIUS_M + shift + 2.0 * BALL_RADIUS_M * place as f64;
        let y = bottom - 0.0031 - BALL_RADIUS_M - 3.0_f64.sqrt() * BALL_RADIUS_M * row as f64;
        let kind = Kind::CaptiveBall(CaptiveBall { center: DVec2::new(x, y), threshold_m_s: 0.1 });
        Part { name: format!("ball-{ball}"), kind }
    };
    let frame = Part { name: "frame".to_string(), kind: Kind::Wall(frame) };
    Layout {
        size_m: DVec2::new(0.514, 1.067),
        slope_rad: 6.5_f64.to_radians(),
        playfield_friction: 0.09,
        parts: std::iter::once(frame).chain((0..balls).map(captive)).collect(),
    }
}
