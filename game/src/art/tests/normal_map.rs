//! What leans on the floor, and which way.

use crate::small_table::{read, table};
use crate::{Table, art};
use geometry::DVec2;
use tracer::{Floor, View};

/// The upper left corner of the small table, this many pixels a millimetre.
fn view(px_per_mm: f64) -> View {
    let side = (80.0 * px_per_mm) as usize;
    View { width: side, height: side, origin_mm: DVec2::ZERO, mm_per_px: 1.0 / px_per_mm }
}

fn floor(table: &Table, px_per_mm: f64) -> Floor {
    art::floor(table, &view(px_per_mm)).unwrap()
}

/// The mean lean of the pixels within 1 mm of a place.
fn lean(table: &Table, px_per_mm: f64, at_mm: (f64, f64)) -> DVec2 {
    mean(&floor(table, px_per_mm).normals, px_per_mm, at_mm, 1.0)
}

fn mean(normals: &[[i8; 2]], px_per_mm: f64, at_mm: (f64, f64), within_mm: f64) -> DVec2 {
    let view = view(px_per_mm);
    let near = (0..view.height).flat_map(|y| (0..view.width).map(move |x| (x, y))).filter(|&(x, y)| {
        let away = view.table_from_pixel(x, y) - DVec2::new(at_mm.0, at_mm.1);
        away.abs().max_element() <= within_mm
    });
    let leans: Vec<DVec2> =
        near.map(|(x, y)| normals[y * view.width + x]).map(|[x, y]| DVec2::new(x.into(), y.into()) / 127.0).collect();
    leans.iter().sum::<DVec2>() / leans.len() as f64
}

fn relief(drawn: &str, numbers: &str) -> Table {
    read(&format!(r#"<g class="relief">{drawn}</g>"#), numbers).unwrap()
}

const RAISED: &str = r##"<circle cx="40" cy="40" r="20" fill="#ffffff"/>"##;

#[test]
fn a_raised_disc_leans_outwards_and_an_engraved_one_inwards() {
    for (fill, sign) in [("#ffffff", 1.0), ("#000000", -1.0)] {
        let table = relief(&RAISED.replace("#ffffff", fill), "");
        for (at, way) in
            [((60.0, 40.0), DVec2::X), ((20.0, 40.0), -DVec2::X), ((40.0, 60.0), DVec2::Y), ((40.0, 20.0), -DVec2::Y)]
        {
            let lean = lean(&table, 2.0, at) * sign;
            assert!(lean.dot(way) > 0.05 && lean.perp_dot(way).abs() < 0.02, "{fill} at {at:?}: {lean}");
        }
        assert_eq!(lean(&table, 2.0, (40.0, 40.0)), DVec2::ZERO, "its top is level");
    }
}

#[test]
fn a_floor_without_relief_has_no_normals() {
    assert!(floor(&table(""), 1.0).normals.is_empty());
    let window = r##"<rect id="win" class="insert" x="20" y="20" width="40" height="20" fill="#ff0000"/>"##;
    assert!(floor(&read(window, "[relief]\ninserts = 0").unwrap(), 1.0).normals.is_empty(), "it is flush");
    assert_eq!(floor(&table(window), 1.0).normals.len(), 80 * 80, "a window has a rim without being asked");
    assert!(floor(&relief(RAISED, "relief_mm = 0"), 1.0).normals.is_empty());
    assert!(floor(&read("", "[relief]\nplanks_mm = 40").unwrap(), 1.0).normals.is_empty(), "there is no wood");
}

#[test]
fn relief_is_no_print_and_no_part_of_a_game() {
    let (plain, raised) = (table(""), relief(RAISED, "relief_mm = 2\n[relief]\nscratches = 1"));
    let (below, above) = (floor(&plain, 1.0), floor(&raised, 1.0));
    assert_eq!((below.floor, below.tops), (above.floor, above.tops));
    assert_eq!(plain.hash, raised.hash);
}

#[test]
fn grey_is_height_and_a_veil_is_half_of_it() {
    // A wall of light from left to right: the sum of the leans across it is its height.
    let climb = |fill: &str, numbers: &str| {
        let table = relief(&format!(r#"<rect x="40" y="-9" width="99" height="99" {fill}/>"#), numbers);
        let normals = floor(&table, 4.0).normals;
        let row = &normals[160 * 320..161 * 320];
        -row.iter().map(|&[x, _]| f64::from(x) / 127.0).map(|x| x / (1.0 - x * x).sqrt() * 0.25).sum::<f64>()
    };
    for (fill, numbers, mm) in [
        ("fill=\"#ffffff\"", "", 127.0 / 255.0 * 0.6),
        ("fill=\"#000000\"", "", -128.0 / 255.0 * 0.6),
        ("fill=\"#000000\"", "relief_mm = 1.2", -128.0 / 255.0 * 1.2),
        ("fill=\"#ffffff\" fill-opacity=\"0.5\"", "", 63.5 / 255.0 * 0.6),
        ("fill=\"#ff0000\"", "", -43.0 / 255.0 * 0.6),
    ] {
        let height = climb(fill, numbers);
        assert!((height - mm).abs() < 0.02, "{fill} {numbers}: {height} for {mm}");
    }
}

#[test]
fn a_soft_slope_has_no_terraces() {
    let ramp = r##"<linearGradient id="r" gradientUnits="userSpaceOnUse" x1="0" x2="400"><stop stop-color="#000"/>
        <stop offset="1" stop-color="#fff"/></linearGradient><rect width="400" height="99" fill="url(#r)"/>"##;
    // Grey changes once in 1.6 mm, which is 6 pixels here, and the lean is 1.6 of the steps that a normal has.
    let normals = floor(&relief(ramp, "relief_mm = 5"), 4.0).normals;
    let slope: f64 = 5.0 / 400.0;
    let lean = -slope / (1.0 + slope * slope).sqrt();
    for at in (8..72).map(f64::from) {
        let near = mean(&normals, 4.0, (at, 40.0), 1.5);
        assert!((near.x - lean).abs() < 0.25 / 127.0, "{} of {lean} at {at}", near.x);
    }
    // The middle of the table: towards the picture's edge there is nothing to be smooth with.
    let inside = (80..240).flat_map(|y| (80..240).map(move |x| (x, y)));
    let worst = inside.map(|(x, y): (usize, usize)| (f64::from(normals[y * 320 + x][0]) - lean * 127.0).abs());
    assert!(worst.fold(0.0, f64::max) < 1.5, "one pixel is a step off");
}

#[test]
fn relief_looks_alike_at_every_size() {
    let disc = relief(RAISED, "relief_mm = 1.2");
    let rims = [2.0, 3.0, 4.0, 6.0].map(|px_per_mm| lean(&disc, px_per_mm, (60.0, 40.0)).x);
    assert!(rims.iter().all(|rim| (rim / rims[3] - 1.0).abs() < 0.12), "{rims:?}");
    // Hatching that is much finer than a pixel is a level floor, not a moire.
    let lines: String = (0..200).map(|i| format!("M{:.1} 0V80", f64::from(i) * 0.4)).collect();
    let hatched = relief(&format!(r##"<path d="{lines}" stroke="#000" stroke-width="0.2" fill="none"/>"##), "");
    let steepest = |px_per_mm: f64| {
        let normals = floor(&hatched, px_per_mm).normals;
        let side = view(px_per_mm).width;
        let inside = normals.chunks(side).skip(4).take(side / 2).flat_map(|row| &row[4..side - 4]);
        inside.map(|[x, _]| x.unsigned_abs()).max().unwrap()
    };
    assert!(steepest(1.0) <= 3, "{}", steepest(1.0));
}

#[test]
fn a_window_has_a_groove_round_it_and_rises_inside() {
    let window = table(r##"<rect id="win" class="insert" x="20" y="20" width="40" height="40" fill="#ff0000"/>"##);
    let normals = floor(&window, 4.0).normals;
    let right = |x: f64| mean(&normals, 4.0, (x, 42.0), 0.25).x;
    assert!(right(60.5) < -0.05, "the wood falls to the groove: {}", right(60.5));
    assert!(right(59.5) > 0.05, "the window rises from it: {}", right(59.5));
    assert_eq!(right(66.0), 0.0, "the wood around it is level");
    let left = mean(&normals, 4.0, (20.5, 42.0), 0.25).x;
    assert!(left < -0.05, "and so on its other side: {left}");
    assert!(normals.iter().all(|&[x, y]| x.unsigned_abs().max(y.unsigned_abs()) < 70), "no edge is a cliff");
}

#[test]
fn wood_is_grained_in_its_boards_where_it_is_drawn() {
    let drawn = r##"<rect width="500" height="500" fill="#808080"/>
        <g class="wood"><rect x="0" y="0" width="60" height="80" fill="#804020"/></g>"##;
    let numbers = "[relief]\nplanks_mm = 20\ngrain = 1";
    let art = floor(&read(drawn, numbers).unwrap(), 4.0);
    let row = |y: usize| &art.floor[y * 320..y * 320 + 320];
    let tones: std::collections::BTreeSet<u8> = row(120)[..236].iter().map(|pixel| pixel[0]).collect();
    assert!(tones.len() > 20, "fibres have their tones: {tones:?}");
    assert!(row(120)[244..].iter().all(|pixel| *pixel == [128, 128, 128, 255]), "what is no wood stays as it is");
    // A seam at 40 mm: both boards fall to it, at every size, and dark it is.
    for px_per_mm in [2.0, 4.0] {
        let normals = floor(&read(drawn, "[relief]\nplanks_mm = 20\ngrain = 0").unwrap(), px_per_mm).normals;
        let at = |x: f64| {
            let along = (10..70).map(|y| mean(&normals, px_per_mm, (x, f64::from(y)), 0.25).x);
            along.sum::<f64>() / 60.0
        };
        assert!(at(39.75) > 0.03 && at(40.25) < -0.03, "{px_per_mm}: {} {}", at(39.75), at(40.25));
    }
    let seam = row(120)[158..162].iter().map(|pixel| pixel[0]).min().unwrap();
    assert!(f32::from(seam) < 0.7 * f32::from(row(120)[140][0]), "{seam}");
    let plain = floor(&read(drawn, "[relief]\ngrain = 0").unwrap(), 1.0);
    assert!(plain.normals.is_empty() && plain.floor[40 * 80 + 30] == [0x80, 0x40, 0x20, 255]);
}

#[test]
fn plastics_may_be_wood_too() {
    let drawn = r##"<path class="plastic wood" d="M0 0H70V70H0Z" fill="#804020"/>
        <g class="plastics"><path class="plastic" d="M75 0H80V70H75Z" fill="#804020"/></g>"##;
    let art = floor(&read(drawn, "[relief]\ngrain = 1").unwrap(), 2.0);
    assert!(art.normals.is_empty(), "the floor is not wood");
    let tones = |columns: std::ops::Range<usize>| {
        columns.map(|x| art.tops[80 * 160 + x][0]).collect::<std::collections::BTreeSet<u8>>().len()
    };
    assert!(tones(2..138) > 10 && tones(152..158) == 1);
}

#[test]
fn scratches_run_beside_what_guides_the_ball() {
    let wall = r#"<path class="wall" d="M4 40 H300" stroke-width="4"/>"#;
    let count = |numbers: &str| {
        let normals = floor(&read(wall, numbers).unwrap(), 4.0).normals;
        normals.iter().filter(|[x, y]| x.unsigned_abs().max(y.unsigned_abs()) > 1).count()
    };
    let (few, many) = (count("[relief]\nscratches = 0.2"), count("[relief]\nscratches = 1"));
    assert!(few > 20 && many > 2 * few, "{few} {many}");
    // A scratch along the wall leans up and down the table, one down the table to its sides.
    let normals = floor(&read(wall, "[relief]\nscratches = 1").unwrap(), 4.0).normals;
    let sum = |axis: usize| {
        let beside = normals[24 * 4 * 320..29 * 4 * 320].iter();
        beside.map(|normal| u32::from(normal[axis].unsigned_abs())).sum::<u32>()
    };
    assert!(sum(1) > sum(0), "{} {}", sum(0), sum(1));
}

#[test]
fn the_same_drawing_leans_the_same_on_any_number_of_threads() {
    let drawn = format!(
        r##"<g class="relief">{RAISED}</g><g class="wood"><rect width="80" height="30"/></g>
        <line class="wall" x1="70" y1="5" x2="75" y2="70"/>
        <circle id="win" class="insert" cx="60" cy="60" r="9" fill="#00ff00"/>"##
    );
    let table = read(&drawn, "[relief]\nplanks_mm = 20\nscratches = 1").unwrap();
    let once = floor(&table, 3.0);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let again = pool.install(|| floor(&table, 3.0));
    assert!(once.normals == again.normals && once.floor == again.floor);
    assert!(once.normals.iter().any(|&normal| normal != [0, 0]));
}

#[test]
fn a_relief_layer_that_cannot_be_printed_is_a_mistake() {
    let table = relief(r#"<text x="9" y="9" font-family="Comic Sans MS">a</text>"#, "");
    let mistake = art::check(&table).unwrap_err().to_string();
    assert!(mistake.contains("there is no font \"Comic Sans MS\""), "{mistake}");
}
