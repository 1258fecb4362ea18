//! Frame times: what the stages of a frame cost.

/// What the parts of a frame cost, ms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameTimes {
    /// From the snapshot to the scene.
    pub scene_ms: f64,
    /// Finding what is new in the scene.
    pub prepare_ms: f64,
    /// Shadows and surfaces, where something has moved.
    pub shadows_ms: f64,
    /// The chrome balls.
    pub balls_ms: f64,
    /// Bloom.
    pub bloom_ms: f64,
    /// The sum of all lamps, and the tone map.
    pub tone_map_ms: f64,
    /// The head-up display.
    pub hud_ms: f64,
    /// Handing the frame to the window.
    pub present_ms: f64,
    /// From one frame in the window to the next.
    pub between_ms: f64,
}

impl FrameTimes {
    /// What drawing the frame cost, all in all, ms.
    pub fn drawn_ms(&self) -> f64 {
        let light_ms = self.prepare_ms + self.shadows_ms + self.balls_ms + self.bloom_ms + self.tone_map_ms;
        self.scene_ms + light_ms + self.hud_ms
    }
}
