//! A ramp that no ball comes onto, as a sentence: where its ends are, and what they miss.

use super::named;
use crate::Table;
use crate::playtest::reach;
use geometry::DVec2;
use physics::{PartId, Ramp};

/// Ends of ramps that are no farther apart lie beside each other, m.
const BESIDE_M: f64 = 0.005;

/// Of a ramp none of whose ends lies on the playfield; none of another part.
pub fn without_entry(part: PartId, table: &Table) -> Option<String> {
    let own = usize::from(part.0);
    let ramp = reach::ramp(&table.layout.parts.get(own)?.kind).filter(|ramp| reach::low_ends(ramp).is_empty())?;
    let others = table.layout.parts.iter().enumerate().filter(|(index, _)| *index != own);
    let mut others = others.filter_map(|(index, part)| Some((index, reach::ramp(&part.kind)?)));
    let missed = others.find_map(|(index, other)| missed(ramp, other).map(|heights| (index, heights)));
    Some(match missed {
        Some((other, [own_mm, other_mm])) => format!(
            "no ball can come onto it: its end beside that of {0} is {own_mm} mm high and that of {0} {other_mm} mm, and a ball \
             falls down between the two; give both the same height there in data-heights-mm",
            named(table, other)
        ),
        None => {
            let [first, last] = ends(ramp).map(|end| millimetres(end.1));
            format!(
                "no ball can come onto it: its ends are {first} and {last} mm above the playfield, and no ramp that a \
                 ball can be on is joined to them; \
                 begin its data-heights-mm with 0, so that a ball rolls in"
            )
        }
    })
}

/// The heights of two ends that lie beside each other and are not joined, mm.
fn missed(ramp: &Ramp, other: &Ramp) -> Option<[f64; 2]> {
    let pairs = ends(ramp).into_iter().flat_map(|own| ends(other).map(|end| (own, end)));
    let mut apart = pairs.filter(|(own, end)| own.0.distance(end.0) < BESIDE_M && (own.1 - end.1).abs() >= BESIDE_M);
    apart.next().map(|(own, end)| [own.1, end.1].map(millimetres))
}

/// Where the ramp's ends are, and how high, m.
fn ends(ramp: &Ramp) -> [(DVec2, f64); 2] {
    let (first, last) = (&ramp.path[0], &ramp.path[ramp.path.len() - 1]);
    [(first.at(0.0), ramp.heights_m[0]), (last.at(last.length()), ramp.heights_m[ramp.heights_m.len() - 1])]
}

/// To a tenth.
fn millimetres(length_m: f64) -> f64 {
    (length_m * 1e4).round() / 10.0
}
