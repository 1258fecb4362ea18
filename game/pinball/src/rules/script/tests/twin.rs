//! The slow honest twin: Rhai's own engine runs the same text. Only the functions of the game are the project's, and
//! work on a context of the twin's own.

use crate::rules::host;
use crate::rules::host_function::{HostFunction, ScriptContext};
use crate::rules::script::data::{Data, Range};
use rhai::{AST, CallFnOptions, Dynamic, Engine, EvalAltResult, FnPtr, Module, NativeCallContext, Scope};
use std::any::TypeId;
use std::sync::{Arc, Mutex};

/// More operations than any test needs.
const PLENTY: u64 = 1_000_000;

/// A script in Rhai's engine.
pub struct Twin {
    engine: Engine,
    ast: AST,
}

/// What the game's functions work on, for the engine to hand on.
#[derive(Clone)]
struct Shared(Arc<Mutex<ScriptContext>>);

impl Twin {
    /// Reads a script twice: once for its constants, then with them, so that every function knows them.
    ///
    /// # Errors
    /// Rhai's mistake.
    pub fn read(text: &str) -> Result<Twin, Box<EvalAltResult>> {
        let mut engine = Engine::new();
        engine
            .set_max_operations(PLENTY)
            .set_max_call_levels(24)
            .set_max_expr_depths(48, 48)
            .set_max_string_size(4096)
            .set_max_array_size(4096)
            .set_max_map_size(4096);
        for function in host::all() {
            (function.least..=function.most).for_each(|count| register(&mut engine, function, count));
        }
        let mut scope = Scope::new();
        let first = engine.compile(text)?;
        engine.run_ast_with_scope(&mut scope, &first)?;
        let mut constants = Scope::new();
        let mut module = Module::new();
        for (name, _, value) in scope.iter().filter(|(_, constant, _)| *constant) {
            module.set_var(name, value.clone());
            constants.push_constant_dynamic(name, value);
        }
        engine.register_global_module(module.into());
        engine.set_strict_variables(true);
        let ast = engine.compile_with_scope(&constants, text)?;
        Ok(Twin { engine, ast })
    }

    /// Calls a function with what the script remembers as `this`.
    ///
    /// # Errors
    /// Rhai's error.
    pub fn call(
        &self,
        function: &str,
        arguments: &[&str],
        this: &mut Data,
        context: &mut ScriptContext,
    ) -> Result<(), Box<EvalAltResult>> {
        let names = context.names.clone();
        let (script, lamps) = (std::mem::take(&mut context.script), std::mem::take(&mut context.lamps));
        let shared = Shared(Arc::new(Mutex::new(ScriptContext { script, lamps, names })));
        let mut memory = dynamic(this);
        let arguments: Vec<Dynamic> = arguments.iter().map(|text| text.to_string().into()).collect();
        let tag = Dynamic::from(shared.clone());
        let options = CallFnOptions::new().eval_ast(false).bind_this_ptr(&mut memory).with_tag(tag);
        let answer =
            self.engine.call_fn_with_options::<Dynamic>(options, &mut Scope::new(), &self.ast, function, arguments);
        let mut after = shared.0.lock().expect("one thread");
        (context.script, context.lamps) = (std::mem::take(&mut after.script), std::mem::take(&mut after.lamps));
        *this = data(&memory);
        answer.map(|_| ())
    }
}

/// Makes a function of the game known, whatever the types that it is called with.
fn register(engine: &mut Engine, function: &'static HostFunction, count: usize) {
    let types = vec![TypeId::of::<Dynamic>(); count];
    let body = move |call: NativeCallContext, values: &mut [&mut Dynamic]| -> Result<Dynamic, Box<EvalAltResult>> {
        let shared = call.tag().and_then(|tag| tag.clone().try_cast::<Shared>());
        let shared = shared.ok_or("nothing has happened yet")?;
        let values: Vec<Data> = values.iter().map(|value| data(value)).collect();
        let answer = function.call(&mut shared.0.lock().expect("one thread"), &values)?;
        Ok(dynamic(&answer))
    };
    engine.register_raw_fn(function.name, types, body);
}

/// Rhai's value as one of the project's: a letter is a text.
pub fn data(value: &Dynamic) -> Data {
    if let Some(range) = value.read_lock::<std::ops::Range<i64>>() {
        return Data::Range(Range::exclusive(range.start, range.end));
    }
    if let Some(range) = value.read_lock::<std::ops::RangeInclusive<i64>>() {
        return Data::Range(Range::inclusive(*range.start(), *range.end()));
    }
    if value.is::<FnPtr>() {
        return Data::Function(0);
    }
    match value.type_name() {
        "bool" => Data::Bool(value.as_bool().expect("a bool")),
        "i64" => Data::Int(value.as_int().expect("a number")),
        "string" | "char" => Data::text(value.to_string()),
        "array" => Data::List(value.as_array_ref().expect("an array").iter().map(data).collect()),
        "map" => {
            let entries = value.as_map_ref().expect("a map");
            Data::Map(entries.iter().map(|(key, value)| (key.as_str().into(), data(value))).collect())
        }
        "()" => Data::Unit,
        other => panic!("a script of the tests has made a {other}"),
    }
}

fn dynamic(value: &Data) -> Dynamic {
    match value {
        Data::Unit => Dynamic::UNIT,
        Data::Bool(flag) => (*flag).into(),
        Data::Int(number) => (*number).into(),
        Data::Text(text) => text.to_string().into(),
        Data::List(items) => items.iter().map(dynamic).collect::<rhai::Array>().into(),
        Data::Map(entries) => {
            entries.iter().map(|(key, value)| ((&**key).into(), dynamic(value))).collect::<rhai::Map>().into()
        }
        Data::Range(range) => (range.first..range.end).into(),
        Data::Function(_) => panic!("no test remembers a function"),
    }
}
