//! What of a file a change can be about: where its expressions and arms lie, in bytes.

use std::ops::Range;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Arm, Expr, ExprBinary, ExprStruct, ExprUnary, File, Pat};

/// What an operator stands in, or a field. The first place is what a change names, the second the whole.
pub struct Node {
    pub named: Range<usize>,
    pub whole: Range<usize>,
}

/// An arm of a `match`: where it starts, where its pattern ends, and its guard.
pub struct Choice {
    pub start: usize,
    pub pattern_end: usize,
    pub guard: Option<Range<usize>>,
}

/// Operators with their operands, fields with their structs, arms.
#[derive(Default)]
pub struct Nodes {
    pub operators: Vec<Node>,
    pub fields: Vec<Node>,
    pub arms: Vec<Choice>,
}

impl Nodes {
    pub fn of(file: &File) -> Self {
        let mut nodes = Self::default();
        nodes.visit_file(file);
        nodes
    }
}

impl<'a> Visit<'a> for Nodes {
    fn visit_expr_binary(&mut self, binary: &'a ExprBinary) {
        // with a `let` on one side, an operator is no expression of its own, and only `&&` compiles
        if !binds(&binary.left) && !binds(&binary.right) {
            self.operators.push(Node { named: bytes(&binary.op), whole: bytes(binary) });
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_unary(&mut self, unary: &'a ExprUnary) {
        self.operators.push(Node { named: bytes(&unary.op), whole: bytes(unary) });
        visit::visit_expr_unary(self, unary);
    }

    fn visit_expr_struct(&mut self, made: &'a ExprStruct) {
        self.fields.extend(made.fields.iter().map(|field| Node { named: bytes(field), whole: bytes(made) }));
        visit::visit_expr_struct(self, made);
    }

    fn visit_arm(&mut self, arm: &'a Arm) {
        let guard = match &arm.pat {
            Pat::Guard(guarded) => Some(bytes(&guarded.guard)),
            _ => None,
        };
        self.arms.push(Choice { start: bytes(arm).start, pattern_end: bytes(&arm.pat).end, guard });
        visit::visit_arm(self, arm);
    }
}

fn binds(operand: &Expr) -> bool {
    match operand {
        Expr::Let(_) => true,
        Expr::Binary(binary) => binds(&binary.left) || binds(&binary.right),
        _ => false,
    }
}

fn bytes(node: &impl Spanned) -> Range<usize> {
    node.span().byte_range()
}
