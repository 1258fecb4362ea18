//! What a shape of a scene is made of.

use super::attributes::Attributes;
use pinball::table::DrawnShape;
use tracer::srgb;
use tracer::transport::spectrum::{self, Dispersion, GLASSES, METALS};
use tracer::transport::{Band, Dielectric, Material};

/// The glass that is meant where none is named.
const USUAL_GLASS: &str = "N-BK7";
/// Wavelengths of the lines F, d and C, um: between F and C a glass's Abbe number is measured.
const LINES_UM: [f64; 3] = [0.486_134, 0.587_562, 0.656_281];
/// Focal lengths, mm.
const FOCAL_MM: f64 = 1e6;

/// What a wall is made of: its colour is what it reflects; black reflects nothing.
pub fn wall(shape: &DrawnShape) -> Result<Material, String> {
    let painted = if shape.is_filled { shape.fill } else { shape.stroke };
    let color = painted.ok_or("its colour says how much of each colour it reflects, so it must be a plain colour")?;
    let reflectance = linear(color);
    Ok(if reflectance == [0.0; 3] { Material::Absorber } else { Material::Diffuse { reflectance } })
}

/// What a mirror is made of, and on which wavelengths it acts.
pub fn mirror(attributes: &Attributes) -> Result<(Material, Option<Band>), String> {
    let reflectance = attributes.number("reflectance", 0.0..=1.0)?;
    let roughness = attributes.number("roughness", 0.0..=1.0)?.unwrap_or(0.0);
    let metal = attributes.text("metal").map(metal_named).transpose()?;
    let focal = attributes.number("focal-mm", -FOCAL_MM..=FOCAL_MM)?;
    let transmittance = attributes.number("transmittance", 0.0..=1.0)?;
    let band = attributes.interval("band-nm", spectrum::SHORTEST_NM..=spectrum::LONGEST_NM)?;
    let kinds = [metal.is_some(), focal.is_some(), transmittance.is_some(), reflectance.is_some()];
    if kinds.into_iter().filter(|is| *is).count() > 1 {
        return Err(
            "it has more than one of `data-metal`, `data-focal-mm`, `data-transmittance` and `data-reflectance`; \
                    a mirror is of one kind"
                .to_string(),
        );
    }
    for (is, kind) in [(focal.is_some(), "focal-mm"), (transmittance.is_some(), "transmittance")] {
        if is && roughness > 0.0 {
            return Err(format!("a mirror with `data-{kind}` is smooth; leave `data-roughness` away"));
        }
    }
    let material = match (metal, focal, transmittance) {
        (Some(metal), ..) => Material::Metal { metal, roughness },
        (_, Some(focal_length), _) => Material::IdealMirror { focal_length: not_zero(focal_length)? },
        (_, _, Some(transmittance)) => Material::BeamSplitter { transmittance },
        _ => Material::Mirror { reflectance: [reflectance.unwrap_or(1.0); 3], roughness },
    };
    let band =
        band.map(|[from, to]| Band { middle_nm: 0.5 * (from + to), half_nm: 0.5 * (to - from), inverted: false });
    Ok((material, band))
}

/// A lens without thickness.
pub fn ideal_lens(attributes: &Attributes) -> Result<Material, String> {
    let focal = attributes.number("focal-mm", -FOCAL_MM..=FOCAL_MM)?;
    let focal = focal.ok_or("a lens that is a line needs `data-focal-mm`; a lens of glass is a closed outline")?;
    Ok(Material::IdealLens { focal_length: not_zero(focal)? })
}

fn not_zero(focal_length: f64) -> Result<f64, String> {
    if focal_length == 0.0 {
        Err("its `data-focal-mm` is 0; write the focal length".to_string())
    } else {
        Ok(focal_length)
    }
}

/// What glass is made of.
pub fn glass(shape: &DrawnShape, attributes: &Attributes) -> Result<Material, String> {
    let index = attributes.number("index", 1.0..=5.0)?;
    let abbe = attributes.number("abbe", 5.0..=200.0)?;
    let dispersion = match (attributes.text("glass"), index, abbe) {
        (Some(_), Some(_), _) => return Err("it has both `data-glass` and `data-index`; give one of them".to_string()),
        (Some(name), ..) => glass_named(name)?,
        (None, Some(index), None) => Dispersion::Constant(index),
        (None, Some(index), Some(abbe)) => by_abbe(index, abbe),
        (None, None, Some(_)) => return Err("`data-abbe` needs `data-index` beside it".to_string()),
        (None, None, None) => glass_named(USUAL_GLASS)?,
    };
    let transmittance_per_mm = match attributes.number("tint-mm", 1e-3..=1e6)? {
        None => [1.0; 3],
        Some(way) => {
            let color = shape
                .fill
                .ok_or("with `data-tint-mm` its fill must be a plain colour: that of white light behind it")?;
            linear(color).map(|left| libm::pow(left, 1.0 / way))
        }
    };
    let roughness = attributes.number("roughness", 0.0..=1.0)?.unwrap_or(0.0);
    let reflects = !attributes.flag("coated")?;
    Ok(Material::Dielectric(Dielectric { dispersion, transmittance_per_mm, roughness, reflects }))
}

/// Cauchy's formula with the index at the line d and `V = (n_d - 1) / (n_F - n_C)`.
fn by_abbe(index: f64, abbe: f64) -> Dispersion {
    let [blue, yellow, red] = LINES_UM.map(|um| 1.0 / (um * um));
    let b = (index - 1.0) / abbe / (blue - red);
    Dispersion::Cauchy { a: index - b * yellow, b }
}

fn glass_named(name: &str) -> Result<Dispersion, String> {
    spectrum::glass_named(name).ok_or_else(|| {
        let known: Vec<&str> = GLASSES.iter().map(|(known, _)| *known).collect();
        format!("there is no glass `{name}`; known are {}; any other by `data-index` and `data-abbe`", known.join(", "))
    })
}

fn metal_named(name: &str) -> Result<spectrum::Metal, String> {
    spectrum::metal_named(name).ok_or_else(|| {
        let known: Vec<&str> = METALS.iter().map(|(known, _)| *known).collect();
        format!("there is no metal `{name}`; known are {}", known.join(", "))
    })
}

/// A colour as it is drawn, as linear light.
pub fn linear(color: [u8; 3]) -> [f64; 3] {
    color.map(|code| srgb::decode_f64(f64::from(code) / 255.0))
}
