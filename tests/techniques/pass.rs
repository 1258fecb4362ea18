//! From one flipper to the other, and round by the inlanes.

use super::{LEFT, NONE, Play, RIGHT, longest_window};
use physics::Controls;

/// Waits on the raised right flipper for what comes over.
fn arrives(mut play: Play) -> bool {
    play.until(RIGHT, 3000, Play::is_held_right).is_some() && play.switches.is_empty()
}

#[test]
fn taps_of_several_lengths_pass_a_rolling_ball() {
    let mut lengths = Vec::new();
    for press in 2..=12 {
        let passes = |gap: usize| arrives(Play::cradled().then(&[(gap, NONE), (press, LEFT), (25, NONE)]));
        let gaps: Vec<bool> = (250..640).step_by(6).map(passes).collect();
        println!("{press} ms: {} of {} gaps pass", gaps.iter().filter(|&&passed| passed).count(), gaps.len());
        if longest_window(&gaps) >= 2 {
            lengths.push(press);
        }
        assert!(gaps.iter().any(|&passed| !passed), "{press} ms is not right everywhere");
    }
    assert!(lengths.len() >= 3, "{lengths:?} ms pass");
}

#[test]
fn a_flip_off_the_slingshots_post_passes() {
    let post = |mut play: Play| {
        let layout = play.machine.layout().clone();
        let met = play.until(LEFT, 60, |play| {
            let name = |part: physics::PartId| layout.parts[usize::from(part.0)].name.as_str();
            play.machine
                .contacts()
                .iter()
                .any(|contact| contact.part.is_some_and(|part| name(part).starts_with("post")))
        });
        met.is_some() && arrives(play)
    };
    let rolls = Play::new().then(&[(200, LEFT)]).ball((71.0, 790.0), (0.0, 0.0)).then(&[(700, LEFT)]);
    let gaps: Vec<bool> = (0..150)
        .map(|gap| {
            let mut play = rolls.clone().then(&[(gap, NONE)]);
            play.switches.clear();
            post(play)
        })
        .collect();
    let window = longest_window(&gaps);
    println!("{window} ms: {}", gaps.iter().map(|&passed| if passed { 'x' } else { '.' }).collect::<String>());
    assert!((4..=15).contains(&window), "the window is {window} ms");
}

/// A ball that rolls down the left inlane; then the left flipper is pressed for 60 ms.
fn from_inlane(speed: f64, wait: usize) -> Play {
    let mut play = Play::new().ball((71.0, 790.0), (0.0, speed)).then(&[(wait, NONE)]);
    play.switches.clear();
    play
}

#[test]
fn a_late_flip_goes_round_by_the_far_inlane_and_is_trapped() {
    let hands = |ms: usize| if ms < 60 { LEFT } else { NONE };
    let round = |wait: usize| {
        let mut play = from_inlane(0.9, wait);
        let lane = (0..2000).position(|ms| {
            play.tick(hands(ms));
            play.has_met("inlane-right")
        });
        lane.is_some().then_some(play)
    };
    let trapped = |play: &Play| {
        let catch = |wait: usize| -> bool {
            let hold: [(usize, Controls); 2] = [(wait, NONE), (5000, RIGHT)];
            play.clone().then(&hold).is_held_right()
        };
        (0..1500).step_by(20).any(catch)
    };
    let waits: Vec<Option<Play>> = (440..520).map(round).collect();
    let caught: Vec<bool> = waits.iter().map(|play| play.as_ref().is_some_and(trapped)).collect();
    let sign = |(play, &caught): (&Option<Play>, &bool)| match play {
        Some(_) if caught => 'T',
        Some(_) => 'x',
        None => '.',
    };
    println!("{}", waits.iter().zip(&caught).map(sign).collect::<String>());
    let window = longest_window(&caught);
    assert!((3..40).contains(&window), "for {window} ms it comes back to the right flipper and can be held");
}
