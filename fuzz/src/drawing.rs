//! A drawing: it is a table or sentences, and a table's art is printed or refused.

use super::sample::{self, TOML};
use game::art;
use tracer::View;

/// The art is printed this wide and high, pixels.
const PICTURE: (usize, usize) = (54, 108);

/// Reads `bytes` as a drawing.
pub fn run(bytes: &[u8]) {
    let toml = if bytes.first().is_some_and(|byte| byte % 2 == 0) { TOML.as_bytes() } else { b"" };
    match sample::table(bytes, toml, b"") {
        Err(failures) => sample::assert_told(&failures),
        Ok(table) => {
            assert!(table.size_mm.is_finite());
            let view = View::fit(PICTURE.0, PICTURE.1, table.size_mm);
            if let Err(failure) = art::check(&table).and_then(|_| art::floor(&table, &view).map(|_| ())) {
                sample::assert_told(&[failure]);
            }
        }
    }
}
