//! From the evaluator of the computer algebra system to nodes of a program.

use std::collections::{HashMap, HashSet};

use symbolica::evaluate::{ExportedInstructions, Instruction, Slot};
use symbolica::prelude::{Atom, AtomCore, Symbol};

use crate::algebra::{Algebra, Meaning};
use crate::polynomial::symbols;
use crate::program::{Node, NodeId, Program, ProgramError};

/// The shortest program found for the outputs.
///
/// The scheme that evaluates a polynomial best differs from relation to
/// relation, so a few are tried and the one with the fewest operations stays.
///
/// # Errors
/// [`ProgramError`] where an output has no straight-line program.
pub fn shortest_program(algebra: &Algebra, outputs: &[Atom]) -> Result<Program, ProgramError> {
    let needed = needed_intermediates(algebra, outputs);
    let mut best: Option<Program> = None;
    for direct in [true, false] {
        for iterations in [0, 1] {
            let program = translate(&needed, outputs, direct, iterations)?;
            let count = |program: &Program| {
                let operations = program.operations();
                (operations.total(), operations.multiplications)
            };
            if best.as_ref().is_none_or(|best| count(&program) < count(best)) {
                best = Some(program);
            }
        }
    }
    Ok(best.unwrap_or(Program { nodes: Vec::new(), outputs: Vec::new() }))
}

/// The intermediates that the outputs depend on, in the order of their making.
fn needed_intermediates(algebra: &Algebra, outputs: &[Atom]) -> Vec<(Symbol, Meaning)> {
    let meanings: HashMap<Symbol, &Meaning> = algebra.intermediates().collect();
    let mut open: Vec<Symbol> = outputs.iter().flat_map(symbols).collect();
    let mut needed = HashSet::new();
    while let Some(symbol) = open.pop() {
        if let Some(meaning) = meanings.get(&symbol)
            && needed.insert(symbol)
        {
            open.extend(meaning.polynomials().iter().flat_map(symbols));
        }
    }
    algebra
        .intermediates()
        .filter(|(symbol, _)| needed.contains(symbol))
        .map(|(symbol, meaning)| (symbol, meaning.clone()))
        .collect()
}

/// The program that one setting of the evaluator gives for the outputs.
fn translate(
    intermediates: &[(Symbol, Meaning)],
    outputs: &[Atom],
    direct: bool,
    iterations: usize,
) -> Result<Program, ProgramError> {
    let mut expressions: Vec<Atom> = Vec::new();
    let mut place = HashMap::new();
    for (symbol, meaning) in intermediates {
        place.insert(*symbol, (meaning, expressions.len()));
        expressions.extend_from_slice(meaning.polynomials());
    }
    let first_output = expressions.len();
    expressions.extend_from_slice(outputs);
    if expressions.is_empty() {
        return Ok(Program { nodes: Vec::new(), outputs: Vec::new() });
    }
    let mut arguments: Vec<Symbol> = expressions.iter().flat_map(symbols).collect();
    arguments.sort_by_key(Symbol::get_id);
    arguments.dedup();
    let parameters: Vec<Atom> = arguments.iter().map(|&symbol| Atom::var(symbol)).collect();
    let exported = Atom::evaluator_multiple(&expressions, &parameters)
        .horner_iterations(iterations)
        .direct_translation(direct)
        .cores(1)
        .build()
        .map_err(|error| ProgramError::Evaluator(format!("{error:?}")))?
        .export_instructions();
    let constants = exported
        .constants
        .iter()
        .map(|constant| match constant.im.to_string().as_str() {
            "0" => rational(&constant.re.to_string()),
            _ => Err(ProgramError::Constant(constant.to_string())),
        })
        .collect::<Result<Vec<_>, _>>()?;
    let (steps, results) = single_assignment(&exported)?;
    let mut builder = Builder {
        arguments: &arguments,
        constants: &constants,
        steps: &steps,
        results: &results,
        place,
        memo: vec![None; steps.len()],
        nodes: Vec::new(),
        known: HashMap::new(),
    };
    let roots: Vec<NodeId> =
        results[first_output..].iter().map(|&operand| builder.operand(operand)).collect();
    Ok(schedule(&builder.nodes, &roots))
}

/// A rational constant from its decimal or fractional form.
fn rational(text: &str) -> Result<(i64, i64), ProgramError> {
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    match (numerator.parse(), denominator.parse()) {
        (Ok(numerator), Ok(denominator)) => Ok((numerator, denominator)),
        _ => Err(ProgramError::Constant(text.to_owned())),
    }
}

/// An argument of a step.
#[derive(Clone, Copy, Debug)]
enum Operand {
    Argument(usize),
    Constant(usize),
    Step(usize),
}

/// One instruction whose result is never overwritten.
#[derive(Clone, Debug)]
enum Step {
    Sum(Vec<Operand>),
    Product(Vec<Operand>),
    Power(Operand, u32),
}

/// Renames slots: temporaries and outputs are reused as scratch by the evaluator.
fn single_assignment<T>(
    exported: &ExportedInstructions<T>,
) -> Result<(Vec<Step>, Vec<Operand>), ProgramError> {
    let mut temporaries: Vec<Option<Operand>> = vec![None; exported.temporary_count];
    let mut outputs: Vec<Option<Operand>> = vec![None; exported.output_count];
    let mut steps = Vec::new();
    let refuse = |instruction: &Instruction| ProgramError::Instruction(format!("{instruction:?}"));
    for instruction in &exported.instructions {
        let read = |slot: &Slot, temporaries: &[Option<Operand>], outputs: &[Option<Operand>]| {
            match *slot {
                Slot::Param(k) => Some(Operand::Argument(k)),
                Slot::Const(k) => Some(Operand::Constant(k)),
                Slot::Temp(k) => temporaries.get(k).copied().flatten(),
                Slot::Out(k) => outputs.get(k).copied().flatten(),
            }
            .ok_or_else(|| refuse(instruction))
        };
        let all = |slots: &[Slot], temporaries: &[_], outputs: &[_]| {
            slots.iter().map(|slot| read(slot, temporaries, outputs)).collect::<Result<Vec<_>, _>>()
        };
        let (target, value) = match instruction {
            Instruction::Add(target, slots, _) => {
                steps.push(Step::Sum(all(slots, &temporaries, &outputs)?));
                (target, Operand::Step(steps.len() - 1))
            }
            Instruction::Mul(target, slots, _) => {
                steps.push(Step::Product(all(slots, &temporaries, &outputs)?));
                (target, Operand::Step(steps.len() - 1))
            }
            Instruction::Pow(target, base, power, _) if *power > 0 => {
                let power = u32::try_from(*power).map_err(|_| refuse(instruction))?;
                steps.push(Step::Power(read(base, &temporaries, &outputs)?, power));
                (target, Operand::Step(steps.len() - 1))
            }
            Instruction::Assign(target, slot) => (target, read(slot, &temporaries, &outputs)?),
            _ => return Err(refuse(instruction)),
        };
        match *target {
            Slot::Temp(k) if k < temporaries.len() => temporaries[k] = Some(value),
            Slot::Out(k) if k < outputs.len() => outputs[k] = Some(value),
            _ => return Err(refuse(instruction)),
        }
    }
    let results = outputs
        .into_iter()
        .collect::<Option<Vec<_>>>()
        .ok_or_else(|| ProgramError::Evaluator("an output is never written".to_owned()))?;
    Ok((steps, results))
}

struct Builder<'a> {
    arguments: &'a [Symbol],
    constants: &'a [(i64, i64)],
    steps: &'a [Step],
    results: &'a [Operand],
    /// What each intermediate is, and which result is the first of its polynomials.
    place: HashMap<Symbol, (&'a Meaning, usize)>,
    memo: Vec<Option<NodeId>>,
    nodes: Vec<Node>,
    known: HashMap<Node, NodeId>,
}

impl Builder<'_> {
    fn operand(&mut self, operand: Operand) -> NodeId {
        match operand {
            Operand::Constant(k) => {
                let (numerator, denominator) = self.constants[k];
                self.push(Node::Constant(numerator, denominator))
            }
            Operand::Argument(k) => {
                let symbol = self.arguments[k];
                match self.place.get(&symbol) {
                    None => self.push(Node::Input(symbol)),
                    Some(&(meaning, place)) => {
                        let inner = self.operand(self.results[place]);
                        match meaning {
                            Meaning::Polynomial(_) => inner,
                            Meaning::Function(function, arguments) => {
                                let second = (arguments.len() > 1)
                                    .then(|| self.operand(self.results[place + 1]));
                                self.push(Node::Apply(*function, inner, second))
                            }
                        }
                    }
                }
            }
            Operand::Step(k) => {
                if let Some(node) = self.memo[k] {
                    return node;
                }
                let steps = self.steps;
                let node = match &steps[k] {
                    Step::Sum(operands) => self.sum(operands),
                    Step::Product(operands) => self.product(operands),
                    Step::Power(base, power) => {
                        let base = self.operand(*base);
                        self.power(base, *power)
                    }
                };
                self.memo[k] = Some(node);
                node
            }
        }
    }

    fn sum(&mut self, operands: &[Operand]) -> NodeId {
        let terms: Vec<NodeId> = operands.iter().map(|&operand| self.operand(operand)).collect();
        // Starting with a term that is not negated saves a negation.
        let first = terms
            .iter()
            .position(|&term| !matches!(self.nodes[term], Node::Negate(_)))
            .unwrap_or(0);
        let mut sum = terms[first];
        for (k, &term) in terms.iter().enumerate() {
            if k != first {
                sum = self.add(sum, term);
            }
        }
        sum
    }

    fn product(&mut self, operands: &[Operand]) -> NodeId {
        // Constants last, so that the same product with another factor is shared.
        let mut factors: Vec<NodeId> =
            operands.iter().map(|&operand| self.operand(operand)).collect();
        factors.sort_by_key(|&factor| matches!(self.nodes[factor], Node::Constant(..)));
        let mut product = factors[0];
        for &factor in &factors[1..] {
            product = self.multiply(product, factor);
        }
        product
    }

    fn power(&mut self, base: NodeId, power: u32) -> NodeId {
        if power == 1 {
            return base;
        }
        let half = self.power(base, power / 2);
        let square = self.multiply(half, half);
        if power.is_multiple_of(2) { square } else { self.multiply(square, base) }
    }

    fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.nodes[a], self.nodes[b]) {
            (Node::Constant(0, _), _) => b,
            (_, Node::Constant(0, _)) => a,
            (_, Node::Negate(b)) => self.subtract(a, b),
            (Node::Negate(a), _) => self.subtract(b, a),
            _ => self.push(Node::Add(a.min(b), a.max(b))),
        }
    }

    fn subtract(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.nodes[a], self.nodes[b]) {
            (_, Node::Constant(0, _)) => a,
            (Node::Constant(0, _), _) => self.negate(b),
            (_, Node::Negate(b)) => self.add(a, b),
            // b − a with its sign changed is what an earlier output may hold already.
            _ => match self.known.get(&Node::Subtract(b, a)) {
                Some(&known) => self.negate(known),
                None => self.push(Node::Subtract(a, b)),
            },
        }
    }

    fn negate(&mut self, a: NodeId) -> NodeId {
        match self.nodes[a] {
            Node::Negate(inner) => inner,
            Node::Constant(numerator, denominator) => {
                self.push(Node::Constant(-numerator, denominator))
            }
            _ => self.push(Node::Negate(a)),
        }
    }

    fn multiply(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.nodes[a], self.nodes[b]) {
            (Node::Constant(..), Node::Constant(..)) => self.push(Node::Multiply(a, b)),
            (Node::Constant(..), _) => self.multiply(b, a),
            (_, Node::Constant(1, 1)) => a,
            (_, Node::Constant(-1, 1)) => self.negate(a),
            // Signs move outwards, where they are shared or absorbed by a sum.
            (Node::Negate(a), _) => {
                let product = self.multiply(a, b);
                self.negate(product)
            }
            (_, Node::Negate(b)) => {
                let product = self.multiply(a, b);
                self.negate(product)
            }
            (_, Node::Constant(numerator, denominator)) if numerator < 0 => {
                let positive = self.push(Node::Constant(-numerator, denominator));
                let product = self.multiply(a, positive);
                self.negate(product)
            }
            (_, Node::Constant(..)) => self.push(Node::Multiply(a, b)),
            _ => self.push(Node::Multiply(a.min(b), a.max(b))),
        }
    }

    fn push(&mut self, node: Node) -> NodeId {
        *self.known.entry(node).or_insert_with(|| {
            self.nodes.push(node);
            self.nodes.len() - 1
        })
    }
}

/// Keeps the nodes that outputs need, each as late as its first use allows.
fn schedule(nodes: &[Node], roots: &[NodeId]) -> Program {
    let mut place: Vec<Option<NodeId>> = vec![None; nodes.len()];
    let mut ordered = Vec::new();
    let outputs = roots.iter().map(|&root| visit(nodes, root, &mut place, &mut ordered)).collect();
    Program { nodes: ordered, outputs }
}

fn visit(
    nodes: &[Node],
    id: NodeId,
    place: &mut [Option<NodeId>],
    ordered: &mut Vec<Node>,
) -> NodeId {
    if let Some(done) = place[id] {
        return done;
    }
    let mut argument = |id| visit(nodes, id, place, ordered);
    let node = match nodes[id] {
        node @ (Node::Input(_) | Node::Constant(..)) => node,
        Node::Add(a, b) => Node::Add(argument(a), argument(b)),
        Node::Subtract(a, b) => Node::Subtract(argument(a), argument(b)),
        Node::Multiply(a, b) => Node::Multiply(argument(a), argument(b)),
        Node::Negate(a) => Node::Negate(argument(a)),
        Node::Apply(function, a, b) => Node::Apply(function, argument(a), b.map(argument)),
    };
    ordered.push(node);
    place[id] = Some(ordered.len() - 1);
    ordered.len() - 1
}
