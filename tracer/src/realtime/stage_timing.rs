//! Stage timing: the stages of a frame, for somebody who has a clock. Light has none.

/// The stages of [`crate::Renderer::draw`], each named when it is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RenderStage {
    /// What is new in the scene is known.
    Prepared,
    /// The tile caches are valid: shadows and surfaces are found where something has moved.
    Shaded,
    /// The balls mirror the table.
    BallsRendered,
    /// The bloom is there.
    Bloomed,
    /// The layers are summed up, and the sums are pixels.
    ToneMapped,
}
