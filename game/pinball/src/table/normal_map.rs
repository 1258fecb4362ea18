//! Inputs of the floor's normal map: what is raised, engraved, grained and scratched on a table, as numbers, and as art
//! whose grey is height.

/// Inputs of a table's normal map, as its folder says them: a height map, wood masks, and numbers.
#[derive(Clone, Debug)]
pub struct NormalMapInputs {
    /// Grey art whose grey is height: mid grey is the floor's level, white is raised, black is engraved.
    pub height_svg: Option<String>,
    /// The floor's art that is wood.
    pub wood_svg: Option<String>,
    /// The plastics' art that is wood.
    pub tops_wood_svg: Option<String>,
    /// How much higher white is than black, mm, 0 to 5.
    pub height_mm: f64,
    /// The width of a board, mm, 0 for wood in one piece.
    pub planks_mm: f64,
    /// How deep and how dark the wood's grain is, 0 to 1.
    pub grain: f64,
    /// How scratched the lacquer is, 0 to 1.
    pub scratches: f64,
    /// How deep the inserts' rims and facets are, 0 to 1.
    pub inserts: f64,
    /// How strongly the floor's lacquer shines, 0 to 1.
    pub gloss: f32,
}

impl Default for NormalMapInputs {
    /// What holds when the folder says nothing.
    fn default() -> NormalMapInputs {
        NormalMapInputs {
            height_svg: None,
            wood_svg: None,
            tops_wood_svg: None,
            height_mm: 0.6,
            planks_mm: 0.0,
            grain: 0.5,
            scratches: 0.0,
            inserts: 1.0,
            gloss: 0.3,
        }
    }
}
