//! Every example prints a path.

#![expect(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "an example is a program: it is found and started as a person would"
)]

use std::path::Path;
use std::process::Command;

/// The names of the files in `examples`.
fn examples() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    files.map(|file| file.file_stem().expect("a name").to_string_lossy().into_owned()).collect()
}

/// What the example prints, which cargo has built next to this program.
fn printed(name: &str) -> String {
    let own = std::env::current_exe().expect("a path");
    let built = own.parent().and_then(Path::parent).expect("target/PROFILE/deps").join("examples").join(name);
    let output = Command::new(&built).output();
    let output =
        output.unwrap_or_else(|error| panic!("{}: {error}; `cargo test -p physics` builds it", built.display()));
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[test]
fn every_example_prints_a_path() {
    let examples = examples();
    assert!(examples.len() >= 2, "{examples:?}");
    for name in examples {
        let text = printed(&name);
        let mut lines = text.lines();
        let head: Vec<_> = lines.next().expect("a head").split(',').collect();
        assert_eq!(head[..3], ["time_ms", "x_mm", "y_mm"], "{name}");
        let rows: Vec<Vec<f64>> =
            lines.map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect();
        assert!(rows.len() >= 20 && rows.iter().all(|row| row.len() == head.len()), "{name}:\n{text}");
        assert!(rows.windows(2).all(|pair| pair[0][0] < pair[1][0]), "{name}: time stands still\n{text}");
        let moved = |column: usize| rows.iter().any(|row| (row[column] - rows[0][column]).abs() > 1.0);
        assert!(moved(1) && moved(2), "{name}: the ball does not move\n{text}");
    }
}
