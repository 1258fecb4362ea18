//! The language of the rules: Rhai's syntax, run by an interpreter that counts all that it does.
//!
//! Rhai's parser reads the text. Its evaluator is left out: it copies, compares and searches values without counting,
//! so that one operation can take milliseconds. Here a value cannot be copied, compared or printed without a [`Meter`].

mod brackets;
mod chain;
mod data;
mod foreign;
mod interpreter;
mod library;
mod meter;
mod node;
mod operators;
mod place;
mod position;
mod read;
mod read_expression;
mod stop;
mod syntax;
mod syntax_error;
mod text;
mod tokens;
mod told;

#[cfg(test)]
mod tests;

pub use data::Data;
pub use foreign::unknown_name;
pub use interpreter::Interpreter;
pub use meter::{Meter, text_steps};
pub use node::{Chain, Kind, Node, Operator, Pattern, Root, Step, StepKind, Switch};
pub use read::Mistake;
pub use stop::{Failed, Stop, fail};
pub use syntax_error::UNCLOSED_COMMENT;
pub use tokens::{open_comment, too_many};

use crate::rules::host_function::ScriptContext;
use interpreter::Frame;
use read::Reader;
use rhai::{ASTFlags, Stmt};
use std::collections::BTreeMap;
use syntax::SyntaxTree;
use tokens::MAX_CONSTANTS;

/// Most steps that evaluating the constants may take.
const READING_STEPS: u64 = 1_000_000;

/// A script that has been read and found good.
#[derive(Debug, Default)]
pub struct Script {
    functions: Vec<Function>,
    /// `None` until it is evaluated, while the script is read.
    constants: Vec<Option<Data>>,
}

/// A function of a script.
#[derive(Debug)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// How many values it takes.
    pub parameters: usize,
    /// How many variables it has, its parameters among them.
    pub locals: usize,
    /// What it does.
    pub body: Node,
}

impl Script {
    /// Reads a script: what of it is good, and every mistake with its line.
    pub fn read(text: &str) -> (Script, Vec<Mistake>) {
        let tree = match SyntaxTree::parse(text) {
            Ok(tree) => tree,
            Err(mistake) => return (Script::default(), vec![mistake]),
        };
        let found = tree.functions();
        let names = found.iter().map(|(name, parameters)| (name.clone(), parameters.len()));
        let numbers: BTreeMap<(String, usize), u16> = names.zip(0..u16::MAX).collect();
        let mut top = Reader::new(&numbers, &[], &[]);
        let statements = read_top(&mut top, &tree);
        let outside = top.known();
        let Reader { constants, locals, mut mistakes, .. } = top;
        let mut script = Script::default();
        for (name, parameters) in &found {
            let mut reader = Reader::new(&numbers, &constants, parameters);
            reader.outside = outside.clone();
            let body = reader.body(&tree.function(name, parameters.len()));
            mistakes.append(&mut reader.mistakes);
            let (name, parameters) = (name.clone(), parameters.len());
            script.functions.push(Function { name, parameters, locals: reader.locals, body });
        }
        if mistakes.is_empty() {
            mistakes.extend(script.evaluate(&statements, constants.len(), locals).err());
        }
        mistakes.sort();
        (script, mistakes)
    }

    /// Runs what stands outside of functions.
    fn evaluate(&mut self, statements: &[Top], constants: usize, locals: usize) -> Result<(), Mistake> {
        self.constants.resize_with(constants, || None);
        let mut meter = Meter::new(READING_STEPS);
        let mut frame = Frame::new(locals);
        for Top { constant, node } in statements {
            let mut interpreter = Interpreter { script: self, meter: &mut meter, context: None, calls: 0 };
            let value = match interpreter.eval(node, &mut frame) {
                Ok(value) => value,
                Err(Stop::Failed(failed)) => {
                    let spent = format!("the script takes more than {READING_STEPS} steps before it begins");
                    return Err((failed.line as usize, failed.sentence(&spent)));
                }
                Err(Stop::Return(_) | Stop::Break(_) | Stop::Continue) => return Ok(()),
            };
            if let Some(number) = constant {
                self.constants[usize::from(*number)] = Some(value);
            }
        }
        Ok(())
    }

    /// Calls a function with the values that the script remembers as `this`.
    ///
    /// # Errors
    /// What went wrong.
    pub fn call(
        &self,
        function: u16,
        arguments: Vec<Data>,
        this: &mut Data,
        context: &mut ScriptContext,
        meter: &mut Meter,
    ) -> Result<(), Box<Failed>> {
        let mut interpreter = Interpreter { script: self, meter, context: Some(context), calls: 0 };
        match interpreter.call(function, arguments, Some(this)) {
            Err(Stop::Failed(failed)) => Err(failed),
            _ => Ok(()),
        }
    }

    /// The functions by number.
    pub fn functions(&self) -> impl Iterator<Item = &Function> {
        self.functions.iter()
    }

    /// The value of a constant, if it has one.
    pub fn constant_value(&self, number: u16) -> Option<&Data> {
        self.constants.get(usize::from(number))?.as_ref()
    }

    fn function(&self, number: u16) -> &Function {
        &self.functions[usize::from(number)]
    }

    fn constant(&self, number: u16) -> Result<&Data, Stop> {
        let constant = self.constants[usize::from(number)].as_ref();
        constant.ok_or_else(|| fail("this constant has no value yet"))
    }
}

/// A statement outside of functions, and the constant that its value is for.
struct Top {
    constant: Option<u16>,
    node: Node,
}

fn read_top(reader: &mut Reader, tree: &SyntaxTree) -> Vec<Top> {
    let mut all = Vec::new();
    for statement in tree.statements() {
        match statement {
            Stmt::Var(parts, flags, _) if flags.contains(ASTFlags::CONSTANT) => {
                let node = reader.expression(&parts.1).map_err(|mistake| reader.mistakes.push(mistake)).ok();
                let number =
                    u16::try_from(reader.constants.len()).ok().filter(|number| usize::from(*number) < MAX_CONSTANTS);
                if number.is_none() {
                    let line = parts.0.pos.line().unwrap_or(1);
                    reader.mistakes.push((line, format!("a script has at most {MAX_CONSTANTS} constants")));
                    return all;
                }
                reader.constants.push(parts.0.name.to_string());
                all.extend(node.map(|node| Top { constant: number, node }));
            }
            other => all.extend(reader.statement_or_mistake(other).map(|node| Top { constant: None, node })),
        }
    }
    all
}
