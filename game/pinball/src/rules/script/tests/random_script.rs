//! Random scripts, of everything that the language has: most of them run, some fail on the way.

use geometry::rng::SplitMix64;

/// Writes a script.
struct Writer {
    chance: SplitMix64,
    /// How deep expressions and statements may still nest.
    depth: usize,
    /// Names that only closures and loops have, of numbers.
    inner: Vec<&'static str>,
    in_loop: bool,
}

/// The script of a seed: `main`, functions that it calls, and constants.
pub fn random_script(seed: u64) -> String {
    let mut writer =
        Writer { chance: SplitMix64::new(seed), depth: 1 + seed as usize % 4, inner: Vec::new(), in_loop: false };
    let body = writer.statements(seed % 9);
    writer.depth = 2;
    writer.inner = vec!["x"];
    let result = writer.number();
    format!(
        "const LIMIT = 7;\nconst NAMES = [\"red\", \"green\"];\nconst POINTS = #{{ a: 1, b: [2, 3] }};\n\
         fn twice(x) {{ x * 2 }}\nfn other(x) {{ let i = x; let j = 1; let k = 2; let t = \"f\"; let u = \"g\";\n\
         let l = [x]; let p = [1]; let m = #{{ a: x }};\n return {result}; }}\nfn count() {{ this.n += 1; this.n }}\n\
         fn main() {{\n this.n = 0;\n let i = 3; let j = -2; let k = 10; let t = \"abc\"; let u = \"\";\n \
         let l = [3, 1, 2]; let p = []; let m = #{{ a: 1, b: 5 }};\n{body}\n \
         this.out = [i, j, k, t, u, l, p, m];\n}}\n"
    )
}

impl Writer {
    fn below(&mut self, count: u64) -> u64 {
        self.chance.below(count)
    }

    fn one_of(&mut self, choices: &[&str]) -> String {
        choices[self.below(choices.len() as u64) as usize].to_string()
    }

    /// Something one level deeper, or the leaf where there are no more levels.
    fn deeper(&mut self, leaf: fn(&mut Writer) -> String, node: fn(&mut Writer) -> String) -> String {
        if self.depth == 0 || self.below(4) == 0 {
            return leaf(self);
        }
        self.depth -= 1;
        let text = node(self);
        self.depth += 1;
        text
    }

    /// Something in which `x` is a number.
    fn with_x(&mut self, inside: fn(&mut Writer) -> String) -> String {
        // A closure sees nothing of what is around it.
        let outer = std::mem::replace(&mut self.inner, vec!["x"]);
        let (depth, in_loop) = (self.depth, self.in_loop);
        (self.depth, self.in_loop) = (0, false);
        let text = inside(self);
        (self.inner, self.depth, self.in_loop) = (outer, depth, in_loop);
        text
    }

    fn number(&mut self) -> String {
        self.deeper(
            |writer| match writer.below(8) {
                0 => "this.n".into(),
                1 => "LIMIT".into(),
                2 | 3 => (writer.below(14) as i64 - 4).to_string(),
                4 if !writer.inner.is_empty() => writer.inner[writer.inner.len() - 1].into(),
                _ => writer.one_of(&["i", "j", "k"]),
            },
            Writer::number_node,
        )
    }

    fn number_node(&mut self) -> String {
        match self.below(21) {
            0..4 => {
                let sign = self.one_of(&["+", "-", "*", "+", "-", "/", "%", "&", "|", "^", "<<", ">>", "**"]);
                format!("({} {sign} {})", self.number(), self.number())
            }
            4 => format!("-({})", self.number()),
            5 => format!("({}).{}()", self.number(), ["abs", "sign"][self.below(2) as usize]),
            6 => format!("{}({}, {})", ["min", "max"][self.below(2) as usize], self.number(), self.number()),
            7 => format!("{}.len()", self.list()),
            8 => format!("{}.len()", self.text()),
            9 => format!("{}[{}]", self.list_name(), self.number()),
            10 => format!("(m.{} ?? {})", self.one_of(&["a", "b", "c"]), self.number()),
            11 => format!("if {} {{ {} }} else {{ {} }}", self.flag(), self.number(), self.number()),
            12 => format!(
                "switch {} {{ 1 | 2 => {}, 3 if {} => {}, -4..0 => {}, 5..=9 => {}, _ => {} }}",
                self.number(),
                self.number(),
                self.flag(),
                self.number(),
                self.number(),
                self.number(),
                self.number()
            ),
            13 => format!("twice({})", self.number()),
            14 if self.below(2) == 0 => format!("{}.index_of({}, {})", self.text(), self.text(), self.number()),
            14 => format!("{}.index_of({})", self.text(), self.text()),
            15 if self.below(2) == 0 => format!("{}.index_of({}, {})", self.list(), self.number(), self.number()),
            15 => format!("{}.index_of({})", self.list(), self.number()),
            16 => format!("{}.reduce(|s, x| s + x, {})", self.list(), self.number()),
            17 => "this.count()".into(),
            18 => format!("random({})", self.number()),
            19 => format!("{{ let i = {}; i + {} }}", self.number(), self.number()),
            _ => self.one_of(&["POINTS.b[1]", "POINTS.a", "m?.q?.r ?? 4", "parse_int(\"12\")", "now()", "score()"]),
        }
    }

    fn flag(&mut self) -> String {
        self.deeper(|writer| writer.one_of(&["true", "false"]), Writer::flag_node)
    }

    fn flag_node(&mut self) -> String {
        match self.below(14) {
            0..4 => format!("({} {} {})", self.number(), self.comparison(), self.number()),
            4 => format!("({} {} {})", self.text(), self.comparison(), self.text()),
            5 => format!("({} {} {})", self.list(), ["==", "!="][self.below(2) as usize], self.list()),
            6 => format!("({} && {})", self.flag(), self.flag()),
            7 => format!("({} || {})", self.flag(), self.flag()),
            8 => format!("!({})", self.flag()),
            9 => format!("({} {} {})", self.number(), self.one_of(&["in", "!in"]), self.list()),
            10 => format!("({} in {})", self.text(), self.one_of(&["t", "m", "NAMES", "\"abc\""])),
            11 => format!("({} in {}..{})", self.number(), self.number(), self.number()),
            12 => {
                let condition = self.with_x(Writer::simple_flag);
                format!("{}.{}(|x| {condition})", self.list(), self.one_of(&["some", "all"]))
            }
            _ => format!("{}.{}", self.text(), self.one_of(&["is_empty()", "starts_with(\"a\")", "contains(\"b\")"])),
        }
    }

    fn simple_flag(&mut self) -> String {
        self.one_of(&["x > 1", "x % 2 == 0", "x.is_odd()", "x == LIMIT", "true", "x < 3 && x > -2"])
    }

    fn simple_number(&mut self) -> String {
        self.one_of(&["x", "x + 1", "x * LIMIT", "-x", "x.abs()", "twice(x)", "max(x, 2)", "if x > 1 { 5 } else { x }"])
    }

    fn comparison(&mut self) -> String {
        self.one_of(&["==", "!=", "<", "<=", ">", ">="])
    }

    fn text(&mut self) -> String {
        self.deeper(
            |writer| writer.one_of(&["t", "u", "t", "\"xy\"", "\"a,b\"", "\"grün\"", "\"\"", "NAMES[0]"]),
            Writer::text_node,
        )
    }

    fn text_node(&mut self) -> String {
        match self.below(9) {
            0 => format!("({} + {})", self.text(), self.value()),
            1 => format!("({} + {})", self.number(), self.text()),
            2 | 3 => format!("`{}${{{}}}-${{{}}}`", self.one_of(&["", "n ", "a"]), self.value(), self.value()),
            4 => format!("{}.{}()", self.text(), self.one_of(&["to_upper", "to_lower"])),
            5 => format!("{}.sub_string({}, {})", self.text(), self.number(), self.number()),
            6 => format!("{}.sub_string({})", self.text(), self.number()),
            7 => format!("to_string({})", self.value()),
            _ => format!("(if {} {{ {} }} else {{ {} }})", self.flag(), self.text(), self.text()),
        }
    }

    fn list_name(&mut self) -> String {
        self.one_of(&["l", "p", "l", "l"])
    }

    fn list(&mut self) -> String {
        self.deeper(Writer::list_name, Writer::list_node)
    }

    fn list_node(&mut self) -> String {
        match self.below(7) {
            0 | 1 => format!("[{}, {}]", self.number(), self.number()),
            2 => format!("({} + {})", self.list(), self.list()),
            3 => {
                let result = self.with_x(Writer::simple_number);
                format!("{}.map(|x| {result})", self.list())
            }
            4 => {
                let condition = self.with_x(Writer::simple_flag);
                format!("{}.filter(|x| {condition})", self.list())
            }
            5 => format!("{}.extract({}, {})", self.list(), self.number(), self.number()),
            _ => format!("m.{}().{}", self.one_of(&["values", "values"]), self.one_of(&["extract(0)", "extract(1)"])),
        }
    }

    fn value(&mut self) -> String {
        match self.below(8) {
            0 | 1 => self.number(),
            2 => self.flag(),
            3 | 4 => self.text(),
            5 if self.below(2) == 0 => {
                format!("{}.{}({})", self.list(), self.one_of(&["get", "contains"]), self.number())
            }
            5 => self.list(),
            6 if self.below(2) == 0 => {
                let condition = self.with_x(Writer::simple_flag);
                format!("{}.find(|x| {condition})", self.list())
            }
            6 => self.one_of(&[
                "()",
                "m",
                "m.c",
                "#{ z: 1, y: [true, ()] }",
                "m.keys()",
                "POINTS",
                "l.zip(p, |a, b| a + b)",
                "t.split(\"b\")",
                "[\"q\", 1]",
            ]),
            _ => format!("type_of({})", self.number()),
        }
    }

    fn statements(&mut self, most: u64) -> String {
        (0..=self.below(most)).map(|_| format!("{}\n", self.statement())).collect()
    }

    fn block(&mut self) -> String {
        self.depth = self.depth.saturating_sub(1);
        let text = self.statements(3);
        self.depth += 1;
        format!("{{\n{text}}}")
    }

    /// A block with `break` and `continue`, or one without.
    fn loop_block(&mut self, in_loop: bool) -> String {
        let before = std::mem::replace(&mut self.in_loop, in_loop);
        let text = self.block();
        self.in_loop = before;
        text
    }

    fn looped(&mut self) -> String {
        self.loop_block(true)
    }

    fn statement(&mut self) -> String {
        if self.depth < 2 {
            return self.change();
        }
        match self.below(16) {
            0 => format!("if {} {} else {}", self.flag(), self.block(), self.block()),
            1 => format!("if {} {} else if {} {}", self.flag(), self.block(), self.flag(), self.block()),
            2 => {
                let subject = self.list();
                self.for_each("x", &subject)
            }
            3 => {
                let subject = format!("{}..{}", self.below(3), self.below(6));
                self.for_each("x", &subject)
            }
            4 => format!("for c in {} {}", self.text(), self.looped()),
            5 => format!("for (v, x) in {} {}", self.list(), self.looped()),
            6 => format!("{{ let w = 0; while w < {} {{ w += 1; {} }} }}", self.below(5), self.looped()),
            // Not `continue` in here: in Rhai it passes the condition by, and the loop has no end.
            7 => format!("{{ let w = 0; do {{ w += 1; {} }} until w > {}; }}", self.loop_block(false), self.below(4)),
            8 => format!("try {} catch (e) {}", self.block(), self.block()),
            9 => format!(
                "switch {} {{ \"abc\" => {}, \"xy\" | \"\" if {} => {}, _ => {} }}",
                self.text(),
                self.block(),
                self.flag(),
                self.block(),
                self.block()
            ),
            _ => self.change(),
        }
    }

    fn for_each(&mut self, name: &'static str, subject: &str) -> String {
        self.inner.push(name);
        let body = self.looped();
        self.inner.pop();
        format!("for {name} in {subject} {body}")
    }

    /// A statement that changes something, or leaves.
    fn change(&mut self) -> String {
        let text = match self.below(30) {
            0..4 => format!("{} = {}", self.one_of(&["i", "j", "k"]), self.number()),
            4 | 5 => {
                let sign = self.one_of(&["+=", "-=", "*=", "%=", "/=", "&=", "|=", "^=", "<<=", ">>="]);
                format!("{} {sign} {}", self.one_of(&["i", "j", "this.n", "m.a", "l[0]", "l[-1]"]), self.number())
            }
            6 | 7 => format!("{} {} {}", self.one_of(&["t", "u"]), self.one_of(&["=", "+="]), self.text()),
            8 => format!("{} = {}", self.list_name(), self.list()),
            9 => format!("l[{}] = {}", self.number(), self.number()),
            10 => format!("m{} = {}", self.one_of(&[".a", ".c", "[\"b\"]", "[t]"]), self.number()),
            11 | 12 => format!(
                "{}.{}({})",
                self.list_name(),
                self.one_of(&["push", "remove", "truncate", "chop"]),
                self.number()
            ),
            13 => format!(
                "{}.{}({}, {})",
                self.list_name(),
                self.one_of(&["insert", "set"]),
                self.number(),
                self.number()
            ),
            14 => format!(
                "{}.{}()",
                self.list_name(),
                self.one_of(&["pop", "shift", "reverse", "sort", "dedup", "clear"])
            ),
            15 => {
                let condition = self.with_x(Writer::simple_flag);
                format!("{}.retain(|x| {condition})", self.list_name())
            }
            16 => format!(
                "l.{}",
                self.one_of(&[
                    "for_each(|| this += 1)",
                    "for_each(|n| this *= n)",
                    "sort(|a, b| b - a)",
                    "append(p)",
                    "append([8])",
                    "pad(5, 0)"
                ])
            ),
            17 => format!("{} += {}", self.list_name(), self.one_of(&["4", "[4, 5]", "i", "p"])),
            18 => format!(
                "m.{}",
                self.one_of(&["remove(\"a\")", "mixin(#{ a: 3, d: 4 })", "fill_with(#{ a: 3, e: 4 })", "clear()"])
            ),
            19 => format!("t.{}", self.one_of(&["trim()", "replace(\"b\", \"zz\")", "pad(6, \"-\")", "clear()"])),
            20 => format!("this.{} = {}", self.one_of(&["a", "b", "n"]), self.value()),
            21 => format!("score({})", self.number()),
            22 => format!("after({}, {})", self.number(), self.text()),
            23 => format!("message({}, {})", self.text(), self.number()),
            24 => format!("progress({}, {}, {})", self.text(), self.number(), self.number()),
            25 => self.one_of(&[
                "lamp(\"red\", \"blink\")",
                "start_game(3)",
                "flippers(true)",
                "cancel(t)",
                "this.count()",
            ]),
            26 if self.in_loop => format!("if {} {{ {}; }}", self.flag(), self.one_of(&["break", "continue"])),
            27 if self.below(3) == 0 => format!("if {} {{ return; }}", self.flag()),
            28 if self.below(3) == 0 => format!("throw {}", self.text()),
            29 => format!("let {} = {}", self.one_of(&["i", "y"]), self.number()),
            _ => format!("l[0] = other({})", self.number()),
        };
        text + ";"
    }
}
