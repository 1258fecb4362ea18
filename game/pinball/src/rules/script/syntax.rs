//! What Rhai's parser gives: nothing of it is run by Rhai.

use super::read::Mistake;
use super::syntax_error;
use rhai::{AST, ASTNode, Engine, OptimizationLevel, Stmt};

/// Deepest nesting of expressions.
const MAX_EXPRESSIONS: usize = 48;
/// Most functions of a script.
const MAX_FUNCTIONS: usize = 512;
/// Most parts of a script that are come by on the way to its statements.
const MAX_WALK: usize = 1_000_000;

/// Statements: of a whole script outside of its functions, or of one function.
pub struct SyntaxTree(AST);

impl SyntaxTree {
    /// Parses a script.
    ///
    /// # Errors
    /// The first mistake.
    pub fn parse(text: &str) -> Result<SyntaxTree, Mistake> {
        let mut engine = Engine::new_raw();
        engine
            .set_max_expr_depths(MAX_EXPRESSIONS, MAX_EXPRESSIONS)
            .set_max_functions(MAX_FUNCTIONS)
            .set_max_string_size(super::meter::MAX_TEXT)
            .set_max_array_size(super::meter::MAX_ITEMS)
            .set_max_map_size(super::meter::MAX_ITEMS)
            .set_optimization_level(OptimizationLevel::None);
        engine.compile(text).map(SyntaxTree).map_err(|error| syntax_error::told(&error, text))
    }

    /// The functions by name: names and parameters.
    pub fn functions(&self) -> Vec<(String, Vec<String>)> {
        let strings = |names: &[&str]| names.iter().map(ToString::to_string).collect();
        let functions = self.0.iter_functions().map(|function| (function.name.to_string(), strings(&function.params)));
        let mut all: Vec<_> = functions.collect();
        // The parser keeps them in an order of its own, which is another in another build.
        all.sort();
        all
    }

    /// The statements of one function.
    pub fn function(&self, name: &str, parameters: usize) -> SyntaxTree {
        // Rhai's clone by a filter keeps every function; what is dropped from a clone is gone.
        let mut tree = self.0.clone_functions_only();
        tree.retain_functions(|_, _, other, count| other == name && count == parameters);
        SyntaxTree(tree)
    }

    /// What stands outside of functions.
    pub fn statements(&self) -> &[Stmt] {
        self.0.statements()
    }

    /// Goes through the statements, of a whole script also through those of its functions.
    ///
    /// # Errors
    /// If that takes too long.
    pub fn for_each_statement(&self, mut each: impl FnMut(&Stmt)) -> Result<(), Mistake> {
        // The walk comes by every part of a statement too, with all that it is a part of before it; by what a `switch`
        // does as often as there are cases that lead to it, and that again in what stands in them.
        let (mut parts, mut line) = (0, 1);
        let ends = self.0.walk(&mut |path: &[ASTNode]| {
            if let [ASTNode::Stmt(statement)] = path {
                line = statement.position().line().unwrap_or(line);
                each(statement);
            }
            parts += 1;
            parts <= MAX_WALK
        });
        let what = "too many cases of a `switch` stand in cases of another: put them into functions of their own";
        if ends { Ok(()) } else { Err((line, what.to_string())) }
    }
}
