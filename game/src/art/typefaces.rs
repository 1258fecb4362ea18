//! The typefaces that art may use: those that are built in.

use crate::fonts::FONTS;
use resvg::usvg;
use std::sync::Arc;

/// The built-in typefaces, found by the names that art calls them.
pub(super) fn fonts() -> Arc<usvg::fontdb::Database> {
    let mut fonts = usvg::fontdb::Database::new();
    for (_, data) in FONTS {
        fonts.load_font_source(usvg::fontdb::Source::Binary(Arc::new(data)));
    }
    fonts.set_serif_family("Marcellus");
    fonts.set_sans_serif_family("Oxanium");
    fonts.set_monospace_family("Oxanium");
    fonts.set_cursive_family("Marcellus");
    fonts.set_fantasy_family("Cinzel");
    Arc::new(fonts)
}

/// The names of all typefaces.
pub(super) fn families(fonts: &usvg::fontdb::Database) -> impl Iterator<Item = &str> {
    fonts.faces().flat_map(|face| face.families.iter().map(|(name, _)| name.as_str()))
}

/// What a typeface is called; nothing if any of a kind is meant.
pub(super) fn name_of(family: &usvg::FontFamily) -> Option<&str> {
    match family {
        usvg::FontFamily::Named(name) => Some(name),
        _ => None,
    }
}

/// Whether a typeface is there, or is any of a kind.
pub(super) fn is_known(family: &usvg::FontFamily, fonts: &usvg::fontdb::Database) -> bool {
    name_of(family).is_none_or(|name| families(fonts).any(|known| known == name))
}
