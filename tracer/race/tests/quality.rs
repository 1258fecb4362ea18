//! The race as a scene of the table's light, against 16,384 stratified shadow rays to every lamp from every point.

use shadow_race::tracer_scene;
use tracer::quality::judge;
use tracer::scenes::white;

#[test]
fn the_exact_light_of_the_race_is_exact() {
    let (floor, small) = (white(200, 200), white(20, 20));
    let quality = judge(&tracer_scene(1.3, &floor), Some(&tracer_scene(1.3, &small)), 120, 2);
    assert!(quality.points > 0 && quality.passes(), "{quality:?}");
}
