//! Kinds of findings.

/// What only play shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FindingKind {
    /// A ball lies still beside the part, whatever the coils do.
    Stuck,
    /// A ball lies still beside the part until the ball search fires every coil.
    FreedBySearch,
    /// A ball has left the playfield near the part.
    Escaped,
    /// A captive ball comes out of its place.
    ComesOut,
    /// A ball can come to the playfield's edge beside the part.
    OpenEdge,
    /// A ball is inside the part.
    Overlap,
    /// Where a ball is cannot be told: a number is not finite.
    NotANumber,
    /// New balls arrive inside the part.
    FeedBlocked,
    /// No pull of the plunger brings the ball away from it.
    Unlaunched,
    /// The plunger is drawn upside down.
    PointsDown,
    /// A kickback's ball falls back on it.
    FallsBack,
    /// A saucer throws its ball back into itself.
    KeepsItsBall,
    /// A kickback does not throw the ball that lies on it.
    DoesNotKick,
    /// A flipper's stroke does not throw the ball that lies on it.
    DoesNotFlip,
    /// A drop target that was raised does not stand.
    DoesNotRise,
    /// Two flippers are in each other's way.
    FlippersCross,
    /// No ball that is shot at the part closes its switch.
    SwitchNeverCloses,
    /// No ball can come to the part from the plunger.
    Unreachable,
    /// No game begins when start is pressed, though the rules mean one to.
    NoGame,
    /// No game begins, and the rules speak of none.
    NoStart,
    /// A game has begun, and no ball comes.
    NoBall,
    /// The ball is lost, and neither another comes nor does the game end.
    BallWithoutEnd,
    /// The ball is lost, the next turn begins, and no ball comes.
    NoNextBall,
    /// The last ball is lost, and the game is not over.
    NoGameOver,
    /// Balls are lost, others come, and the game is never over.
    GameWithoutEnd,
    /// A lost ball ends the turn while another is in play.
    EndsEarly,
    /// The game is over, and the player has not had all balls.
    OverEarly,
    /// The same, for turns have ended while the ball was in play.
    TurnsInPlay,
    /// A game begins while a ball of another is in play.
    BeginsAnew,
    /// The game is over, and no other begins.
    NoNextGame,
    /// The flippers do not obey their buttons while a ball is in play.
    DeadFlippers,
    /// Bumpers, slingshots and their like do nothing while a ball is in play.
    DeadKickers,
    /// The flippers obey their buttons until the ball is shot, and then no more.
    FlippersDieAtLaunch,
    /// The machine is tilted as long as a ball is in play, though nobody has pushed it.
    AlwaysTilted,
    /// The rules never throw a saucer's ball out.
    NeverEjected,
    /// The rules never raise a drop target that was hit.
    NeverRaised,
}

impl FindingKind {
    /// Whether rules that end in a mistake when a ball is lost leave this undone.
    pub fn follows_mistakes(self) -> bool {
        matches!(
            self,
            FindingKind::BallWithoutEnd
                | FindingKind::NoNextBall
                | FindingKind::NoGameOver
                | FindingKind::GameWithoutEnd
        )
    }
}
