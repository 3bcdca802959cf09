//! Whole numbers for GLSL, which leaves open what WGSL defines: remainders of negative numbers, quotients by
//! zero, shifts by more than there are bits, and conversions of numbers that are too large.
//!
//! In: a module with shaders/integers.wgsl in it. Out: the same, where functions of that file are called for
//! all that GLSL leaves open. naga's writers of other languages write such functions by themselves.

use std::collections::HashMap;

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{
    Arena, BinaryOperator, Block, Expression, Function, Handle, Literal, Module, Range, ScalarKind, Span,
    Statement, TypeInner,
};

/// How the functions of shaders/integers.wgsl and shaders/integer_vectors.wgsl begin.
const STEMS: [&str; 5] = ["quotient", "remainder", "shiftLeft", "shiftRight", "whole"];
/// How they end: by the type that they return.
const TYPES: [&str; 8] = ["I32", "Vec2i", "Vec3i", "Vec4i", "U32", "Vec2u", "Vec3u", "Vec4u"];

/// A function to call, and what with.
type Call = (Handle<Function>, Vec<Handle<Expression>>);

/// Rewrites `module`, of which `info` is known.
pub fn define(module: &mut Module, info: &ModuleInfo) {
    let (ours, others): (Vec<_>, Vec<_>) = module
        .functions
        .iter()
        .map(|(handle, _)| handle)
        .partition(|handle| is_ours(&module.functions[*handle]));
    // naga wants a function before those that call it.
    let mut functions = Arena::new();
    let mut moved = HashMap::new();
    for old in ours.iter().chain(&others) {
        let span = module.functions.get_span(*old);
        moved.insert(*old, functions.append(module.functions[*old].clone(), span));
    }
    let named = ours.iter().filter_map(|old| Some((module.functions[*old].name.clone()?, moved[old])));
    let named = named.collect();
    for old in ours.iter().chain(&others) {
        let calls = match is_ours(&module.functions[*old]) {
            true => HashMap::new(),
            false => calls(module, &info[*old], &module.functions[*old], &named),
        };
        rewrite(&mut functions[moved[old]], &Changes { calls, moved: &moved });
    }
    for entry in &mut module.entry_points {
        rewrite(&mut entry.function, &Changes { calls: HashMap::new(), moved: &moved });
    }
    module.functions = functions;
}

fn is_ours(function: &Function) -> bool {
    let is_one =
        |name: &str| STEMS.iter().any(|stem| name.strip_prefix(stem).is_some_and(|ty| TYPES.contains(&ty)));
    function.name.as_deref().is_some_and(is_one)
}

/// Replaces the expressions of `function` that GLSL leaves open.
fn calls(
    module: &Module,
    info: &FunctionInfo,
    function: &Function,
    named: &HashMap<String, Handle<Function>>,
) -> HashMap<Handle<Expression>, Call> {
    let inner = |expression: Handle<Expression>| info[expression].ty.inner_with(&module.types);
    let call = |(handle, expression): (Handle<Expression>, &Expression)| {
        let is_signed = match inner(handle).scalar_kind()? {
            ScalarKind::Sint => true,
            ScalarKind::Uint => false,
            _ => return None,
        };
        let (stem, arguments) = match *expression {
            Expression::Binary { op, left, right } => {
                let literal = literal(function, right);
                let (stem, is_defined) = match op {
                    BinaryOperator::Divide => ("quotient", literal.is_some_and(|by| by > 0)),
                    BinaryOperator::Modulo => ("remainder", !is_signed && literal.is_some_and(|by| by > 0)),
                    BinaryOperator::ShiftLeft => ("shiftLeft", literal.is_some_and(|by| by < 32)),
                    BinaryOperator::ShiftRight => ("shiftRight", literal.is_some_and(|by| by < 32)),
                    _ => return None,
                };
                (stem, (!is_defined).then(|| vec![left, right])?)
            }
            Expression::As { expr, convert: Some(_), .. } => {
                ("whole", (inner(expr).scalar_kind() == Some(ScalarKind::Float)).then(|| vec![expr])?)
            }
            _ => return None,
        };
        let at = match *inner(handle) {
            TypeInner::Vector { size, .. } => size as usize - 1,
            _ => 0,
        };
        let ty = TYPES[at + if is_signed { 0 } else { 4 }];
        Some((handle, (named[&format!("{stem}{ty}")], arguments)))
    };
    function.expressions.iter().filter_map(call).collect()
}

/// The number that is written there, for each component.
fn literal(function: &Function, expression: Handle<Expression>) -> Option<i64> {
    match function.expressions[expression] {
        Expression::Literal(Literal::I32(n)) => Some(n.into()),
        Expression::Literal(Literal::U32(n)) => Some(n.into()),
        Expression::Splat { value, .. } => literal(function, value),
        _ => None,
    }
}

/// The changes to make to a function.
struct Changes<'a> {
    calls: HashMap<Handle<Expression>, Call>,
    /// The handles of functions, which its text has as they were.
    moved: &'a HashMap<Handle<Function>, Handle<Function>>,
}

fn rewrite(function: &mut Function, changes: &Changes<'_>) {
    for (handle, expression) in function.expressions.iter_mut() {
        if let Some((called, _)) = changes.calls.get(&handle) {
            *expression = Expression::CallResult(*called);
        } else if let Expression::CallResult(called) = expression {
            *called = changes.moved[called];
        }
    }
    function.body = changes.block(&function.body);
}

impl Changes<'_> {
    fn block(&self, block: &Block) -> Block {
        let mut written = Block::with_capacity(block.len());
        for (statement, span) in block.span_iter() {
            let mut statement = statement.clone();
            match &mut statement {
                Statement::Emit(range) => {
                    self.emit(range, *span, &mut written);
                    continue;
                }
                Statement::Block(inner) => *inner = self.block(inner),
                Statement::If { accept, reject, .. } => {
                    *accept = self.block(accept);
                    *reject = self.block(reject);
                }
                Statement::Switch { cases, .. } => {
                    cases.iter_mut().for_each(|case| case.body = self.block(&case.body));
                }
                Statement::Loop { body, continuing, .. } => {
                    *body = self.block(body);
                    *continuing = self.block(continuing);
                }
                Statement::Call { function, .. } => *function = self.moved[function],
                _ => (),
            }
            written.push(statement, *span);
        }
        written
    }

    /// Calls are statements, so they part what comes before them from what comes after.
    fn emit(&self, range: &Range<Expression>, span: Span, written: &mut Block) {
        let handles: Vec<_> = range.clone().collect();
        for piece in handles.chunk_by(|a, b| !self.calls.contains_key(a) && !self.calls.contains_key(b)) {
            let statement = match self.calls.get(&piece[0]) {
                Some((function, arguments)) => Statement::Call {
                    function: *function,
                    arguments: arguments.clone(),
                    result: Some(piece[0]),
                },
                None => Statement::Emit(Range::new_from_bounds(piece[0], piece[piece.len() - 1])),
            };
            written.push(statement, span);
        }
    }
}
