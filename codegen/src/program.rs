//! Straight-line programs: common subexpressions shared over all outputs, operations counted.

use symbolica::prelude::Symbol;

use crate::algebra::Function;

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
    /// Function of one or two arguments.
    Apply(Function, NodeId, Option<NodeId>),
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
    /// Square roots, sines, cosines and other functions.
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
    /// Counts the operations.
    pub fn operations(&self) -> Operations {
        let mut operations = Operations::default();
        for node in &self.nodes {
            match node {
                Node::Input(_) | Node::Constant(..) => {}
                Node::Add(..) | Node::Subtract(..) => operations.additions += 1,
                Node::Multiply(..) | Node::Negate(_) => operations.multiplications += 1,
                Node::Apply(Function::Reciprocal, ..) => operations.divisions += 1,
                Node::Apply(..) => operations.functions += 1,
            }
        }
        operations
    }
}
