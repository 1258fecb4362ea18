//! What a picture's making consists of, for somebody who has a clock: light has none.

/// The steps of [`crate::Renderer::draw`], each named when it is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RenderStage {
    /// What is new in the scene is known.
    Prepared,
    /// Shadows and surfaces are found where something has moved.
    Lit,
    /// The balls mirror the table.
    BallsRendered,
    /// The bloom is taken.
    Bloomed,
    /// All lamps are summed up, and the sums are pixels.
    ToneMapped,
}
