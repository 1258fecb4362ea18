//! Frame times: what the stages of a frame cost, how often there is one, and how late.

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
    /// What the last frames were like together.
    pub rates: FrameRates,
}

/// How often there are frames, and how late.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameRates {
    /// Frames in the window in the last second.
    pub frames_per_s: f64,
    /// The longest time from one to the next in the last seconds, ms.
    pub longest_ms: f64,
    /// From a key's arrival to the first frame in the window that contains its tick, ms: as many are faster as slower.
    pub latency_median_ms: Option<f64>,
    /// The same, ms: 99 of a hundred are no slower.
    pub latency_99th_ms: Option<f64>,
}

impl FrameTimes {
    /// What drawing the frame cost, all in all, ms.
    pub fn drawn_ms(&self) -> f64 {
        let light_ms = self.prepare_ms + self.shadows_ms + self.balls_ms + self.bloom_ms + self.tone_map_ms;
        self.scene_ms + light_ms + self.hud_ms
    }
}
