//! Who imports whom inside a crate. A room is a folder or a file directly below `src`; the crate's front (`lib.rs`) and
//! its program (`main.rs`) are none.
//!
//! Test code is left out: a fast path's unit tests may hold it against its slow twin, which stands above it, and no
//! library is built from test code.

use std::collections::{BTreeMap, BTreeSet};

use super::code::{Word, is_word, words};
use super::tree::{Source, crates, module_path, production, read};

/// The room of what `lib.rs` itself defines: above all others.
const FRONT: &str = "lib.rs";

/// One room imports from another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Import {
    from: String,
    to: String,
    /// `path:line`.
    place: String,
}

/// A crate's rooms and the imports between them.
struct House {
    rooms: BTreeSet<String>,
    imports: Vec<Import>,
}

/// A path in code.
struct Path {
    /// From the crate's root on.
    names: Vec<String>,
    /// What it is called where it is imported.
    name: String,
    line: usize,
}

impl House {
    /// The rooms of the crate in `folder`.
    fn read(folder: &str) -> House {
        let source = &format!("{folder}/src");
        let files = production(source);
        let rooms: BTreeSet<_> =
            files.iter().filter_map(|file| module_path(source, &file.path).into_iter().next()).collect();
        let exports = exports(source, &files, &rooms);
        let imports = files.iter().flat_map(|file| imports(source, file, &rooms, &exports)).collect();
        House { rooms, imports }
    }

    /// A line for each room: what it imports from.
    fn drawn(&self) -> String {
        let line = |room: &String| {
            let own = self.imports.iter().filter(|import| import.from == *room);
            let above: BTreeSet<_> = own.map(|import| import.to.as_str()).collect();
            format!("\n  {room} -> {}", above.into_iter().collect::<Vec<_>>().join(", "))
        };
        self.rooms.iter().map(line).collect()
    }

    /// Every way round from a room to itself, each once, as the imports that make it.
    fn circles(&self) -> Vec<Vec<Import>> {
        let mut edges: BTreeMap<&str, BTreeMap<&str, &Import>> = BTreeMap::new();
        for import in &self.imports {
            edges.entry(&import.from).or_default().entry(&import.to).or_insert(import);
        }
        self.rooms.iter().filter_map(|room| shortest_circle(room, &edges)).collect()
    }
}

/// The shortest way from `room` back to itself over rooms that come later in the alphabet, so that each circle is told
/// once.
fn shortest_circle(room: &str, edges: &BTreeMap<&str, BTreeMap<&str, &Import>>) -> Option<Vec<Import>> {
    let mut ways: Vec<Vec<Import>> = vec![Vec::new()];
    let mut seen = BTreeSet::new();
    let mut next = 0;
    while let Some(way) = ways.get(next).cloned() {
        let at = way.last().map_or(room, |import| &import.to);
        for (&to, &import) in edges.get(at).into_iter().flatten().filter(|(to, _)| **to >= room) {
            let longer = [&way[..], std::slice::from_ref(import)].concat();
            if to == room {
                return Some(longer);
            }
            if seen.insert(to) {
                ways.push(longer);
            }
        }
        next += 1;
    }
    None
}

/// Which room each name of the crate's root comes from: exported macros, and what `lib.rs` hands on; none for what it
/// hands on from other crates.
fn exports(source: &str, files: &[Source], rooms: &BTreeSet<String>) -> BTreeMap<String, Option<String>> {
    let mut found = BTreeMap::new();
    for file in files {
        let words = words(&file.code);
        if let Some(room) = module_path(source, &file.path).first() {
            let macros = (4..words.len())
                .filter(|&at| words[at - 4].text == "macro_export" && words[at - 2].text == "macro_rules");
            found.extend(macros.map(|at| (words[at].text.to_string(), Some(room.clone()))));
        } else if file.path.ends_with("/lib.rs") {
            let uses = (0..words.len()).filter(|&at| words[at].text == "use");
            let paths = uses.flat_map(|at| tree(&words, &mut (at + 1), &[]));
            found.extend(paths.map(|path| (path.name, rooms.get(&path.names[0]).cloned())));
        }
    }
    found
}

/// The imports of one file from other rooms.
fn imports(
    source: &str,
    file: &Source,
    rooms: &BTreeSet<String>,
    exports: &BTreeMap<String, Option<String>>,
) -> Vec<Import> {
    let module = module_path(source, &file.path);
    let Some(from) = module.first() else { return Vec::new() };
    let front = FRONT.to_string();
    let import = |path: &Path| {
        let name = &path.names[0];
        let room =
            if rooms.contains(name) { Some(name) } else { exports.get(name).map_or(Some(&front), Option::as_ref) };
        let place = format!("{}:{}", file.path, path.line);
        room.map(|room| Import { from: from.clone(), to: room.clone(), place })
    };
    let found = crate_paths(&module, &file.code);
    found.iter().filter_map(import).filter(|import| import.from != import.to).collect()
}

/// Every path in blanked code that starts with `crate` or goes up with `super`, in `use` and elsewhere, from the crate's
/// root on; paths that end at the root itself are left out.
fn crate_paths(module: &[String], code: &str) -> Vec<Path> {
    let words = words(code);
    let mut found = Vec::new();
    let mut inner = InnerModules::default();
    let mut at = 0;
    while at < words.len() {
        inner.read(&words, at);
        let is_path =
            words.get(at + 1).is_some_and(|word| word.text == "::") && ["crate", "super"].contains(&words[at].text);
        let is_visibility = at > 0 && words[at - 1].text == "in";
        if is_path && !is_visibility {
            found.extend(tree(&words, &mut at, &[module, &inner.names()].concat()));
        } else {
            at += 1;
        }
    }
    found.retain(|path| !path.names.is_empty());
    found
}

/// The modules inside a file that the reading stands in.
#[derive(Default)]
struct InnerModules {
    depth: usize,
    open: Vec<(String, usize)>,
}

impl InnerModules {
    fn read(&mut self, words: &[Word], at: usize) {
        match words[at].text {
            "{" => {
                self.depth += 1;
                if at >= 2 && words[at - 2].text == "mod" {
                    self.open.push((words[at - 1].text.to_string(), self.depth));
                }
            }
            "}" => {
                self.open.retain(|(_, depth)| *depth < self.depth);
                self.depth -= 1;
            }
            _ => {}
        }
    }

    fn names(&self) -> Vec<String> {
        self.open.iter().map(|(name, _)| name.clone()).collect()
    }
}

/// The paths of a use tree, or the one path of an expression, whose words start at `at`; `at` moves past it. `here` is
/// what has been read of the path, or the module that the path stands in.
fn tree(words: &[Word], at: &mut usize, here: &[String]) -> Vec<Path> {
    let line = words[*at].line;
    let mut names = here.to_vec();
    loop {
        let word = words[*at].text;
        *at += 1;
        match word {
            "crate" => names.clear(),
            "super" => drop(names.pop()),
            "self" | "*" | "::" => {}
            "{" => return group(words, at, &names),
            name if name.starts_with(is_word) => names.push(name.to_string()),
            // The generics of an expression.
            _ => break,
        }
        let next = words.get(*at).map_or("", |word| word.text);
        if word != "::" && next != "::" {
            break;
        }
    }
    let alias = words.get(*at).filter(|word| word.text == "as").map(|_| words[*at + 1].text.to_string());
    let name = alias.or_else(|| names.last().cloned()).unwrap_or_default();
    vec![Path { names, name, line }]
}

/// The paths of a use tree's braces; `at` stands past the opening one and moves past the closing one.
fn group(words: &[Word], at: &mut usize, here: &[String]) -> Vec<Path> {
    let mut found = Vec::new();
    while words[*at].text != "}" {
        found.extend(tree(words, at, here));
        while !["}", ","].contains(&words[*at].text) {
            // `as Name`.
            *at += 1;
        }
        if words[*at].text == "," {
            *at += 1;
        }
    }
    *at += 1;
    found
}

fn told<'a>(imports: impl IntoIterator<Item = &'a Import>) -> String {
    imports.into_iter().map(|import| format!("\n  {} -> {} at {}", import.from, import.to, import.place)).collect()
}

/// Each crate's rooms in their order: a room imports from those before it only.
const ORDER: [(&str, &[&str]); 4] = [
    (
        "tracer",
        &[
            "simd",
            "scene",
            "tile",
            "film",
            "transport",
            "visibility",
            "shading",
            "cache",
            "realtime",
            "scenes",
            "reference",
            "integrator",
            "renderer",
        ],
    ),
    ("physics", &["constants", "part", "ball", "collision", "mechanisms", "layout", "solver", "machine"]),
    (
        "game/pinball",
        &[
            "buttons",
            "failure",
            "spelling",
            "table",
            "lamps",
            "rules",
            "simulation",
            "timeline",
            "recording",
            "bot",
            "playtest",
        ],
    ),
    (
        "game",
        &[
            "fonts",
            "screen",
            "terminal",
            "standard_error",
            "interrupt",
            "input",
            "optics",
            "art",
            "storage",
            "drawn_scene",
            "rendering",
            "hud",
            "scene_builder",
            "session",
            "frame_composer",
            "desktop",
            "scene_viewer",
            "cli",
            "game_app",
            "commands",
        ],
    ),
];

#[test]
fn no_circle_between_rooms() {
    let mut found = String::new();
    for folder in crates() {
        let house = House::read(&folder);
        println!("{folder}:{}", house.drawn());
        let fronts = house.imports.iter().filter(|import| import.to == FRONT).map(|import| vec![import.clone()]);
        for circle in house.circles().into_iter().chain(fronts) {
            found += &format!("\n{folder}:{}", told(&circle));
        }
    }
    assert!(found.is_empty(), "rooms import each other in circles:{found}");
}

#[test]
fn no_room_imports_back_up() {
    for (folder, order) in ORDER {
        let house = House::read(folder);
        let known: BTreeSet<_> = order.iter().map(|room| room.to_string()).collect();
        assert_eq!(house.rooms, known, "the rooms of {folder}, and those whose order is known");
        let place = |room: &str| order.iter().position(|known| *known == room);
        let is_upwards = |import: &&Import| import.to == FRONT || place(&import.from) <= place(&import.to);
        let upwards: Vec<_> = house.imports.iter().filter(is_upwards).collect();
        assert!(upwards.is_empty(), "{folder} imports upwards:{}", told(upwards));
    }
}

/// The rooms of a crate as the tables of the map list them.
fn listed_rooms(map: &str, folder: &str) -> Vec<String> {
    let source = format!("{folder}/src/");
    let cells = map.lines().filter_map(|line| line.strip_prefix("| `")?.split(" | ").next());
    let paths = cells.flat_map(|cell| cell.split('`')).filter_map(|path| path.strip_prefix(source.as_str()));
    let rooms = paths.map(|path| path.trim_end_matches('/').trim_end_matches(".rs").to_string());
    rooms.filter(|room| !room.is_empty()).collect()
}

#[test]
fn the_map_lists_the_rooms_in_their_order() {
    let map = read("ARCHITECTURE.md");
    for (folder, order) in ORDER {
        assert_eq!(listed_rooms(&map, folder), order, "the table of {folder} in ARCHITECTURE.md");
    }
}

#[test]
fn paths_are_read_as_the_compiler_does() {
    let code = "use crate::{a::{self, b}, c as d};\nuse super::x;\nfn f() { crate::e::<u8>(); self::g(); std::h::i() }\n\
                pub(in crate::j) fn k() {}\nmod inner {\n use super::super::l::*;\n}\nuse super::{m, super::n};";
    let module = ["room", "file"].map(str::to_string);
    let found: Vec<_> = crate_paths(&module, code).iter().map(|path| (path.names.join("::"), path.line)).collect();
    let expected =
        [("a", 1), ("a::b", 1), ("c", 1), ("room::x", 2), ("e", 3), ("room::l", 6), ("room::m", 8), ("n", 8)];
    assert_eq!(found, expected.map(|(path, line)| (path.to_string(), line)));
}
