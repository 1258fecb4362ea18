//! The documents agree with the tree.

use std::collections::BTreeSet;
use std::path::Path;

use super::members::members;
use super::tree::{crates, files, module_path, production, read, root};

/// The documents whose paths must exist.
fn documents() -> Vec<String> {
    let top = ["ARCHITECTURE.md", "README.md", "CONTRIBUTING.md"].map(str::to_string);
    let docs = files("docs", |path| path.extension().is_some_and(|extension| extension == "md"));
    top.into_iter().chain(docs).collect()
}

/// What stands between backticks in a document's running text.
fn quoted(text: &str) -> Vec<&str> {
    text.split("```").step_by(2).flat_map(|prose| prose.split('`').skip(1).step_by(2)).collect()
}

/// The path that a quoted text names, if it names one of the tree: its first word, where that has a slash or ends like
/// a file. Build output and the player's own folders are not of the tree.
fn named_path(quoted: &str) -> Option<&str> {
    let word = quoted.split(' ').next().unwrap_or("");
    let foreign = ["target/", "~", "/", "-", "<"].iter().any(|start| word.starts_with(start)) || word.contains("::");
    let is_file = [".rs", ".md", ".toml", ".rhai", ".svg", ".caustic", ".png"].iter().any(|end| word.ends_with(end));
    let plain = word.chars().all(|c| c.is_ascii_alphanumeric() || "/._-".contains(c));
    (plain && !foreign && (word.contains('/') || is_file)).then_some(word)
}

/// The left column of the table from old names to new names what is no more.
fn without_old_names(text: &str) -> String {
    let (before, map) = text.split_once("## From old names to new").unwrap_or((text, ""));
    let new_names = map.lines().map(|line| line.trim_end_matches(['|', ' ']).rsplit('|').next().unwrap_or(""));
    [before, &new_names.collect::<Vec<_>>().join("\n")].concat()
}

/// Where the paths that a document writes in Markdown links lead, from the root.
fn linked<'a>(document: &str, text: &'a str) -> Vec<(&'a str, std::path::PathBuf)> {
    let folder = Path::new(document).parent().expect("a folder");
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
    let inside = targets.filter(|target| !target.is_empty() && !target.contains("://"));
    inside.map(|target| (target, root().join(folder).join(target))).collect()
}

#[test]
fn every_path_in_the_documents_exists() {
    let all = files("", |_| true);
    let names: BTreeSet<_> = all.iter().filter_map(|path| path.rsplit('/').next()).collect();
    let mut lost = Vec::new();
    for document in documents() {
        let text = without_old_names(&read(&document));
        let paths: Vec<_> = quoted(&text).into_iter().filter_map(named_path).collect();
        let exists = |path: &str| root().join(path).exists() || !path.contains('/') && names.contains(path);
        lost.extend(paths.iter().filter(|path| !exists(path)).map(|path| format!("{document}: {path}")));
        let links = linked(&document, &text);
        lost.extend(links.iter().filter(|(_, path)| !path.exists()).map(|(link, _)| format!("{document}: {link}")));
        assert!(document != "ARCHITECTURE.md" || paths.len() > 10, "the map names {} paths only", paths.len());
    }
    assert!(lost.is_empty(), "these documents name what is not there: {lost:#?}");
}

/// The type and the member of a quoted path like `room::Type::name` or `Type::name(argument)`.
fn quoted_member(quoted: &str) -> Option<(String, String)> {
    let path = quoted.split(['(', ' ', '<']).next().unwrap_or("");
    let mut names = path.rsplit("::");
    let (name, owner) = (names.next()?, names.next()?);
    let is_type = owner.starts_with(char::is_uppercase) && owner.chars().all(|c| c.is_alphanumeric());
    is_type.then(|| (owner.to_string(), name.to_string()))
}

#[test]
fn every_member_in_the_map_and_the_pages_is_defined() {
    let sources = crates().into_iter().flat_map(|folder| production(&format!("{folder}/src")));
    let defined: BTreeSet<_> = sources.flat_map(|source| members(&source.code)).collect();
    let papers = documents().into_iter().filter(|path| path == "ARCHITECTURE.md" || path.starts_with("docs/"));
    let texts: Vec<_> = papers.map(|path| (read(&path), path)).collect();
    let named = texts.iter().flat_map(|(text, path)| quoted(text).into_iter().map(move |quoted| (path, quoted)));
    let named: Vec<_> = named.filter_map(|(path, quoted)| Some((path, quoted_member(quoted)?))).collect();
    assert!(named.len() > 20, "the documents name {} members only", named.len());
    let lost: Vec<_> = named.into_iter().filter(|(_, member)| !defined.contains(member)).collect();
    assert!(lost.is_empty(), "these documents name members that are not there: {lost:#?}");
}

/// The folders and files directly below a crate's `src`, or `src` itself where that holds files only.
fn rooms(folder: &str) -> BTreeSet<String> {
    let source = format!("{folder}/src");
    let paths: Vec<_> = production(&source).into_iter().map(|file| file.path).collect();
    let first = |path: &String| module_path(&source, path).into_iter().next();
    let is_flat = paths.iter().all(|path| Path::new(path).parent() == Some(Path::new(&source)));
    if is_flat {
        [source].into()
    } else {
        paths.iter().filter_map(first).map(|room| format!("{source}/{room}")).collect()
    }
}

#[test]
fn the_map_names_every_room() {
    let map = read("ARCHITECTURE.md");
    let named: BTreeSet<_> =
        quoted(&map).into_iter().map(|path| path.trim_end_matches('/').trim_end_matches(".rs")).collect();
    let missing: Vec<_> =
        crates().iter().flat_map(|folder| rooms(folder)).filter(|room| !named.contains(room.as_str())).collect();
    assert!(missing.is_empty(), "ARCHITECTURE.md does not name {missing:#?}");
}

/// Lower-case letters and digits, everything else as single blanks: `TileRect`, `tile_rect`, `tile-rect` and "tile
/// rect" read the same.
fn spelled(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut previous = ' ';
    for c in text.chars() {
        if !c.is_alphanumeric() || c.is_uppercase() && previous.is_lowercase() {
            out.push(' ');
        }
        out.extend(c.to_lowercase().filter(|c| c.is_alphanumeric()));
        previous = c;
    }
    format!(" {} ", out.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// The glossary's entries: the word, its sentence, its file.
fn glossary() -> Vec<[String; 3]> {
    let text = read("docs/glossary.md");
    let rows = text.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| word |"));
    let cells = rows.map(|row| row.trim_matches(['|', ' ']).split('|').map(|cell| cell.trim().to_string()).collect());
    cells
        .map(|cells: Vec<_>| cells.try_into().unwrap_or_else(|row| panic!("not word | sentence | file: {row:?}")))
        .collect()
}

/// What is wrong with an entry of the glossary.
fn mistake([word, sentence, file]: &[String; 3]) -> Option<String> {
    let path = file.trim_matches('`');
    if !root().join(path).is_file() {
        return Some(format!("{word}: {path} is no file"));
    }
    if !sentence.ends_with('.') {
        return Some(format!("{word} has no sentence"));
    }
    let name = word.split('(').next().unwrap_or(word);
    let is_said = spelled(&read(path)).contains(spelled(name).trim_end());
    (!is_said).then(|| format!("{path} never says {name}"))
}

#[test]
fn every_word_of_the_glossary_is_used_in_its_file() {
    let entries = glossary();
    assert!(entries.len() > 20, "{} entries only", entries.len());
    let words: BTreeSet<_> = entries.iter().map(|[word, ..]| word).collect();
    assert_eq!(words.len(), entries.len(), "a word has two entries");
    let mistakes: Vec<_> = entries.iter().filter_map(mistake).collect();
    assert!(mistakes.is_empty(), "docs/glossary.md: {mistakes:#?}");
}

/// The paths that a `clippy.toml` forbids under `list`.
fn forbidden(file: &str, list: &str) -> BTreeSet<String> {
    let settings: toml::Table = toml::from_str(&read(file)).expect("TOML");
    let entries = settings[list].as_array().expect("a list");
    entries.iter().map(|entry| entry["path"].as_str().expect("a path").to_string()).collect()
}

#[test]
fn every_clippy_file_repeats_the_bans_of_the_root() {
    let others = files("", |path| path.ends_with("clippy.toml"));
    for file in others.iter().filter(|file| *file != "clippy.toml") {
        for list in ["disallowed-methods", "disallowed-types"] {
            let missing: Vec<_> = forbidden("clippy.toml", list).difference(&forbidden(file, list)).cloned().collect();
            assert!(missing.is_empty(), "{file}, {list}: the root forbids {missing:?} too");
        }
    }
}

/// What decides a game may use none of these, anywhere.
const UNDECIDED: [&str; 4] =
    ["std::time::Instant::now", "std::thread::spawn", "std::fs::read_to_string", "std::env::var"];

#[test]
fn what_decides_a_game_has_bans_of_its_own() {
    for folder in ["physics", "game/pinball"] {
        let bans = forbidden(&format!("{folder}/clippy.toml"), "disallowed-methods");
        let missing: Vec<_> = UNDECIDED.iter().filter(|path| !bans.contains(**path)).collect();
        assert!(missing.is_empty(), "{folder}/clippy.toml does not forbid {missing:?}");
    }
}

/// The example of `docs/add_a_part.md`.
const EXAMPLE_PART: &str = "magnet";

#[test]
fn the_page_about_parts_lists_every_file_that_names_its_example() {
    let page = read("docs/add_a_part.md");
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let listed: BTreeSet<String> = rows.map(str::to_string).collect();
    let naming: BTreeSet<String> = crates()
        .iter()
        .flat_map(|folder| production(&format!("{folder}/src")))
        .filter(|source| source.text.to_lowercase().contains(EXAMPLE_PART))
        .map(|source| source.path)
        .collect();
    assert_eq!(listed, naming, "docs/add_a_part.md lists other files than those that name a {EXAMPLE_PART}");
    assert!(naming.len() <= 8, "a part touches {} files", naming.len());
}
