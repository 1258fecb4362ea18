//! The examples: each runs to its end.

#[path = "../../examples/drop_a_ball.rs"]
mod drop_a_ball;
#[path = "../../examples/flip.rs"]
mod flip;

#[test]
fn a_ball_is_dropped_and_a_flipper_flips() {
    drop_a_ball::main().expect("the example's numbers can be");
    flip::main().expect("the example's numbers can be");
}
