//! A compiled script: shared by every simulation of its table.

use super::host::{self, SharedContext};
use super::literals;
use super::names::Names;
use super::script_state::ScriptState;
use super::value::Value;
use crate::lamps::LampController;
use crate::{Failure, Table};
use rhai::{AST, CallFnOptions, Dynamic, Engine, EvalAltResult, Module, OptimizationLevel, Scope};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a script may define to be told of what happens, with the number of parameters.
const CALLS: [(&str, usize); 10] = [
    ("on_start", 0),
    ("on_switch", 1),
    ("on_open", 1),
    ("on_button", 1),
    ("on_release", 1),
    ("on_timer", 1),
    ("on_launch", 0),
    ("on_feed", 0),
    ("on_bob", 0),
    ("on_slam", 0),
];

/// Most operations in one call: about 50 ms on a slow computer.
const MAX_OPERATIONS: u64 = 200_000;
/// Deepest nesting of calls.
const MAX_CALLS: usize = 24;
/// Deepest nesting of expressions.
const MAX_EXPRESSIONS: usize = 48;
/// Longest text, bytes.
const MAX_TEXT: usize = 4096;
/// Longest array and largest map.
const MAX_ITEMS: usize = 4096;

/// A script that has been read and found good.
pub struct Program {
    engine: Engine,
    ast: AST,
    /// The script's functions and the lines on which they begin.
    functions: BTreeMap<String, usize>,
    names: Arc<Names>,
    file: String,
}

impl Program {
    /// Reads the rules of a table.
    ///
    /// # Errors
    /// Every mistake that can be seen without playing, one line each with file and line.
    pub fn new(table: &Table) -> Result<Program, Failure> {
        let file = table.file("rules.rhai");
        let names = Arc::new(Names::new(table));
        let mut engine = engine();
        let ast = compile(&mut engine, &table.rules).map_err(|error| Failure::new(sentence(&file, 1, *error)))?;
        let mut mistakes = wrong_calls(&ast, &table.rules);
        mistakes.extend(literals::unknown_names(&table.rules, &names));
        if !mistakes.is_empty() {
            mistakes.sort();
            let mistakes = mistakes.iter().map(|(line, what)| Failure::new(format!("{file}:{line}: {what}")));
            return Err(Failure::of_many(mistakes.collect()));
        }
        let function = |name: &str| (name.to_string(), line_of(name, &table.rules));
        let functions = ast.iter_functions().map(|found| function(found.name)).collect();
        Ok(Program { engine, ast, functions, names, file })
    }

    /// The parts and lamps.
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// Whether the script wants to hear of this.
    pub fn has(&self, call: &str) -> bool {
        self.functions.contains_key(call)
    }

    /// Tells the script what happened. What it did before an error stays done.
    ///
    /// # Errors
    /// A sentence with file and line.
    pub fn call(
        &self,
        call: &str,
        name: Option<&str>,
        memory: &mut Value,
        script: &mut ScriptState,
        lamps: &mut LampController,
    ) -> Result<(), String> {
        let Some(line) = self.functions.get(call).copied() else {
            return Ok(());
        };
        let mut this = memory.to_script();
        let shared = SharedContext::new(std::mem::take(script), std::mem::take(lamps), self.names.clone());
        let options =
            CallFnOptions::new().eval_ast(false).bind_this_ptr(&mut this).with_tag(Dynamic::from(shared.clone()));
        let arguments: Vec<Dynamic> = name.map(|name| name.to_string().into()).into_iter().collect();
        let answer =
            self.engine.call_fn_with_options::<Dynamic>(options, &mut Scope::new(), &self.ast, call, arguments);
        (*script, *lamps) = shared.take_parts();
        *memory = Value::from_script(this).map_err(|what| {
            format!("{}:{line}: after {call}, `this` holds {what}, which cannot be remembered", self.file)
        })?;
        answer.map(|_| ()).map_err(|error| sentence(&self.file, line, *error))
    }
}

fn engine() -> Engine {
    let mut engine = Engine::new();
    engine
        .set_max_operations(MAX_OPERATIONS)
        .set_max_call_levels(MAX_CALLS)
        .set_max_expr_depths(MAX_EXPRESSIONS, MAX_EXPRESSIONS)
        .set_max_string_size(MAX_TEXT)
        .set_max_array_size(MAX_ITEMS)
        .set_max_map_size(MAX_ITEMS)
        .set_max_variables(256)
        .set_max_functions(512)
        .set_optimization_level(OptimizationLevel::Simple)
        .disable_symbol("eval")
        .disable_symbol("print")
        .disable_symbol("debug");
    host::register(&mut engine);
    engine
}

/// Reads the script twice: once for its constants, then with them, so that every function knows them and a variable
/// that nobody has defined is a mistake.
fn compile(engine: &mut Engine, text: &str) -> Result<AST, Box<EvalAltResult>> {
    let mut scope = Scope::new();
    let first = engine.compile(text)?;
    engine.run_ast_with_scope(&mut scope, &first)?;
    let mut constants = Scope::new();
    let mut module = Module::new();
    for (name, constant, value) in scope.iter() {
        if constant {
            module.set_var(name, value.clone());
            constants.push_constant_dynamic(name, value);
        }
    }
    engine.register_global_module(module.into());
    engine.set_strict_variables(true);
    Ok(engine.compile_with_scope(&constants, text)?)
}

/// Functions that look as if they were to be called when something happens, but never will be.
fn wrong_calls(ast: &AST, text: &str) -> Vec<(usize, String)> {
    let mut mistakes = Vec::new();
    for function in ast.iter_functions().filter(|function| function.name.starts_with("on_")) {
        let what = match CALLS.iter().find(|(name, _)| *name == function.name) {
            Some((_, count)) if *count == function.params.len() => continue,
            Some((name, count)) => format!("{name} takes {count} parameters"),
            None => {
                let names: Vec<&str> = CALLS.iter().map(|(name, _)| *name).collect();
                format!("nothing calls {}; there are {}", function.name, names.join(", "))
            }
        };
        mistakes.push((line_of(function.name, text), what));
    }
    mistakes
}

/// The line on which a function begins.
fn line_of(function: &str, text: &str) -> usize {
    let begin = format!("fn {function}(");
    text.lines().position(|line| line.contains(&begin)).map_or(1, |index| index + 1)
}

/// An error of the script as one sentence with file and line; the line of the function that was called, where rhai
/// knows no better one.
fn sentence(file: &str, called: usize, mut error: EvalAltResult) -> String {
    let mut line = error.position().line().unwrap_or(called);
    while let EvalAltResult::ErrorInFunctionCall(_, _, inner, _) = error {
        error = *inner;
        line = error.position().line().unwrap_or(line);
    }
    error.clear_position();
    let what = match &error {
        EvalAltResult::ErrorTooManyOperations(_) => {
            format!("this does not come to an end (more than {MAX_OPERATIONS} operations for one event)")
        }
        EvalAltResult::ErrorRuntime(text, _) => text.to_string(),
        EvalAltResult::ErrorParsing(what, _) => what.to_string(),
        other => other.to_string(),
    };
    format!("{file}:{line}: {what}")
}
