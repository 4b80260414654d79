//! Straight-line programs: common subexpressions shared over all outputs, operations counted.

use std::collections::HashMap;

use symbolica::prelude::{Atom, Symbol};

use crate::algebra::{Algebra, Function, Meaning, symbols};
use crate::translate::translate;

/// Number of a node of a program.
pub type NodeId = usize;

/// One operation on earlier nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A kernel argument.
    Input(Symbol),
    /// A rational constant: numerator and denominator.
    Constant(i64, i64),
    /// Sum.
    Add(NodeId, NodeId),
    /// Difference.
    Subtract(NodeId, NodeId),
    /// Product.
    Multiply(NodeId, NodeId),
    /// Negation.
    Negate(NodeId),
    /// Function of one argument.
    Apply(Function, NodeId),
}

/// Operations of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications and negations.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots, sines, cosines.
    pub functions: usize,
}

impl Operations {
    /// Additions and multiplications together.
    pub fn total(self) -> usize {
        self.additions + self.multiplications
    }
}

/// A straight-line program: every node is used, arguments stand before their uses.
#[derive(Clone, Debug)]
pub struct Program {
    /// The nodes in the order of evaluation.
    pub nodes: Vec<Node>,
    /// The node of each output.
    pub outputs: Vec<NodeId>,
}

/// What a program cannot be made of.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProgramError {
    /// The evaluator refused the expressions.
    #[error("the computer algebra system cannot evaluate the expressions: {0}")]
    Evaluator(String),
    /// An instruction that a kernel may not have.
    #[error("the computer algebra system made an instruction that kernels cannot have: {0}")]
    Instruction(String),
    /// A constant that is complex or has more than 63 bits.
    #[error("the constant {0} does not fit a kernel")]
    Constant(String),
}

impl Program {
    /// The shortest program found for the outputs.
    ///
    /// The scheme that evaluates a polynomial best differs from relation to
    /// relation, so a few are tried and the one with the fewest operations stays.
    ///
    /// # Errors
    /// [`ProgramError`] where an output has no straight-line program.
    pub fn new(algebra: &Algebra, outputs: &[Atom]) -> Result<Self, ProgramError> {
        let needed = needed_intermediates(algebra, outputs);
        let mut best: Option<Self> = None;
        for direct in [true, false] {
            for iterations in [0, 1] {
                let program = translate(&needed, outputs, direct, iterations)?;
                let count = |program: &Self| {
                    let operations = program.operations();
                    (operations.total(), operations.multiplications)
                };
                if best.as_ref().is_none_or(|best| count(&program) < count(best)) {
                    best = Some(program);
                }
            }
        }
        Ok(best.unwrap_or(Self { nodes: Vec::new(), outputs: Vec::new() }))
    }

    /// Counts the operations.
    pub fn operations(&self) -> Operations {
        let mut operations = Operations::default();
        for node in &self.nodes {
            match node {
                Node::Input(_) | Node::Constant(..) => {}
                Node::Add(..) | Node::Subtract(..) => operations.additions += 1,
                Node::Multiply(..) | Node::Negate(_) => operations.multiplications += 1,
                Node::Apply(Function::Reciprocal, _) => operations.divisions += 1,
                Node::Apply(..) => operations.functions += 1,
            }
        }
        operations
    }

    /// Runs the program in `f64`.
    pub fn evaluate(&self, input: impl Fn(Symbol) -> f64) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            values.push(match *node {
                Node::Input(symbol) => input(symbol),
                Node::Constant(numerator, denominator) => numerator as f64 / denominator as f64,
                Node::Add(a, b) => values[a] + values[b],
                Node::Subtract(a, b) => values[a] - values[b],
                Node::Multiply(a, b) => values[a] * values[b],
                Node::Negate(a) => -values[a],
                Node::Apply(Function::Reciprocal, a) => 1.0 / values[a],
                Node::Apply(Function::Root, a) => values[a].sqrt(),
                Node::Apply(Function::Sine, a) => values[a].sin(),
                Node::Apply(Function::Cosine, a) => values[a].cos(),
            });
        }
        self.outputs.iter().map(|&output| values[output]).collect()
    }
}

/// The intermediates that the outputs depend on, in the order of their making.
fn needed_intermediates(algebra: &Algebra, outputs: &[Atom]) -> Vec<(Symbol, Meaning)> {
    let meanings: HashMap<Symbol, &Meaning> = algebra.intermediates().collect();
    let mut open: Vec<Symbol> = outputs.iter().flat_map(symbols).collect();
    let mut needed = std::collections::HashSet::new();
    while let Some(symbol) = open.pop() {
        if let Some(Meaning::Polynomial(inner) | Meaning::Function(_, inner)) =
            meanings.get(&symbol)
            && needed.insert(symbol)
        {
            open.extend(symbols(inner));
        }
    }
    algebra
        .intermediates()
        .filter(|(symbol, _)| needed.contains(symbol))
        .map(|(symbol, meaning)| (symbol, meaning.clone()))
        .collect()
}
