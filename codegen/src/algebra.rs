//! Symbols, named intermediates and their total derivatives.
//!
//! An expression is never expanded down to the coordinates as a whole: its parts
//! have names, and derivatives follow the chain rule over the names. Every
//! derivative is divided by its leading coefficient and looked up among the
//! names that exist, so that, for example, the twelve entries of ∂(A s)/∂p are
//! found to be ±2 times the four intermediates that A s itself needs.

use std::collections::HashMap;

use symbolica::prelude::{Atom, AtomCore, AtomView, Symbol};
use symbolica::symbol;

use crate::alphabet::Alphabet;
use crate::polynomial::{
    common_factor, expanded_terms, is_negative, is_simple, leading_coefficient, substitute, symbols,
};

/// A polynomial of so many terms is still compared in its expanded form.
const SMALL: usize = 32;
/// Products that may give more terms than this are not expanded for comparison.
const LARGE: usize = 2_000;

/// Smooth functions that an intermediate may stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// 1/x
    Reciprocal,
    /// √x
    Root,
    /// sin x
    Sine,
    /// cos x
    Cosine,
    /// The angle of the point (x, y), from y and x in this order.
    Angle,
    /// The derivative of this order of atan(√x)/√x, which is smooth at 0.
    AtanRatio(u8),
}

/// What an intermediate stands for.
#[derive(Clone, Debug)]
pub enum Meaning {
    /// A polynomial in inputs and earlier intermediates.
    Polynomial(Atom),
    /// A function of such polynomials.
    Function(Function, Vec<Atom>),
}

impl Meaning {
    /// The polynomials that it is made of.
    pub fn polynomials(&self) -> &[Atom] {
        match self {
            Self::Polynomial(polynomial) => std::slice::from_ref(polynomial),
            Self::Function(_, arguments) => arguments,
        }
    }
}

struct Name {
    meaning: Meaning,
    /// The expanded polynomial in inputs and opaque intermediates, where it is
    /// small; otherwise the intermediate itself, which then is opaque.
    flat: Atom,
}

/// What a derivative is taken with respect to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// One input.
    Input(Symbol),
    /// Time: all coordinates at once, along the velocities v, and these along the accelerations.
    Motion,
}

/// The named intermediates of one relation.
pub struct Algebra {
    /// The symbols in use.
    pub alphabet: Alphabet,
    names: Vec<Name>,
    /// From an expanded polynomial with leading coefficient 1 to the
    /// intermediate that is the given multiple of it.
    by_flat: HashMap<Atom, (Symbol, Atom)>,
    by_function: HashMap<(Function, Vec<Atom>), Symbol>,
    index: HashMap<Symbol, usize>,
    derivatives: HashMap<(Symbol, Variable), Atom>,
}

impl Algebra {
    /// No intermediates yet.
    pub fn new(alphabet: Alphabet) -> Self {
        Self {
            alphabet,
            names: Vec::new(),
            by_flat: HashMap::new(),
            by_function: HashMap::new(),
            index: HashMap::new(),
            derivatives: HashMap::new(),
        }
    }

    /// The intermediates in the order of their making: symbol and meaning.
    pub fn intermediates(&self) -> impl Iterator<Item = (Symbol, &Meaning)> {
        self.names.iter().enumerate().map(|(k, name)| (self.symbol(k), &name.meaning))
    }

    fn symbol(&self, k: usize) -> Symbol {
        self.alphabet
            .intermediates
            .get(k)
            .copied()
            .unwrap_or_else(|| symbol!(format!("hardpoint::t{k}")))
    }

    /// Gives a polynomial a name, unless it is a number times a symbol; returns
    /// a number times a symbol.
    pub fn name(&mut self, atom: &Atom) -> Atom {
        if is_simple(atom.as_view()) {
            return atom.clone();
        }
        let flat = self.flatten(atom);
        let Some(scale) = leading_coefficient(&flat) else {
            return flat;
        };
        let key = (&flat / &scale).expand();
        if key.get_symbol().is_some() {
            return scale * key;
        }
        if let Some((symbol, known)) = self.by_flat.get(&key) {
            return scale / known * Atom::var(*symbol);
        }
        // The intermediate keeps the form that it is written in; only a factor
        // that its terms share is taken out.
        let factor = common_factor(atom);
        let symbol = self.symbol(self.names.len());
        let meaning = Meaning::Polynomial((atom / &factor).expand_num());
        let small = flat.nterms() <= SMALL;
        let flat = if small { (&flat / &factor).expand() } else { Atom::var(symbol) };
        self.by_flat.insert(key, (symbol, scale / &factor));
        self.push(symbol, meaning, flat);
        factor * Atom::var(symbol)
    }

    /// The name of a function of polynomials.
    pub fn apply(&mut self, function: Function, arguments: &[Atom]) -> Atom {
        let arguments: Vec<Atom> = arguments.iter().map(|argument| self.name(argument)).collect();
        let key = (function, arguments.clone());
        if let Some(symbol) = self.by_function.get(&key) {
            return Atom::var(*symbol);
        }
        let symbol = self.symbol(self.names.len());
        self.by_function.insert(key, symbol);
        self.push(symbol, Meaning::Function(function, arguments), Atom::var(symbol));
        Atom::var(symbol)
    }

    fn push(&mut self, symbol: Symbol, meaning: Meaning, flat: Atom) {
        self.index.insert(symbol, self.names.len());
        self.names.push(Name { meaning, flat });
    }

    /// `atom` expanded over inputs and opaque intermediates, or, where that
    /// would be too large, over the intermediates it is written in.
    fn flatten(&self, atom: &Atom) -> Atom {
        let mut flat = atom.clone();
        for symbol in symbols(atom) {
            if let Some(&k) = self.index.get(&symbol) {
                flat = substitute(&flat, symbol, &self.names[k].flat);
            }
        }
        if expanded_terms(flat.as_view()) > LARGE { atom.expand() } else { flat.expand() }
    }

    /// The total derivative of a polynomial in inputs and intermediates.
    pub fn derivative(&mut self, atom: &Atom, variable: Variable) -> Atom {
        let mut terms = Vec::new();
        for symbol in symbols(atom) {
            let inner = self.symbol_derivative(symbol, variable);
            if !inner.is_zero() {
                terms.push(atom.derivative(symbol) * inner);
            }
        }
        Atom::add_many(terms)
    }

    /// The derivative of an input or intermediate: a number times a symbol.
    pub fn symbol_derivative(&mut self, symbol: Symbol, variable: Variable) -> Atom {
        let Some(&k) = self.index.get(&symbol) else {
            return self.of_input(symbol, variable);
        };
        if let Some(known) = self.derivatives.get(&(symbol, variable)) {
            return known.clone();
        }
        let derivative = match self.names[k].meaning.clone() {
            Meaning::Polynomial(polynomial) => match self.known_derivative(k, variable) {
                Some(known) => known,
                None => {
                    let atom = self.derivative(&polynomial, variable);
                    self.name(&atom)
                }
            },
            Meaning::Function(function, arguments) => {
                let inner: Vec<Atom> =
                    arguments.iter().map(|argument| self.derivative(argument, variable)).collect();
                if inner.iter().all(Atom::is_zero) {
                    Atom::zero()
                } else {
                    let outer = self.function_derivatives(function, &arguments, symbol);
                    let terms = outer.iter().zip(&inner).map(|(outer, inner)| outer * inner);
                    let atom = Atom::add_many(terms.collect::<Vec<_>>());
                    self.name(&atom)
                }
            }
        };
        self.derivatives.insert((symbol, variable), derivative.clone());
        derivative
    }

    fn of_input(&self, symbol: Symbol, variable: Variable) -> Atom {
        match variable {
            Variable::Input(input) if input == symbol => Atom::one(),
            Variable::Input(_) => Atom::zero(),
            Variable::Motion => {
                let Alphabet { coordinates, velocities, accelerations, .. } = &self.alphabet;
                let rates = coordinates.iter().zip(velocities);
                let mut rates = rates.chain(velocities.iter().zip(accelerations));
                rates
                    .find(|(known, _)| **known == symbol)
                    .map_or_else(Atom::zero, |(_, &rate)| Atom::var(rate))
            }
        }
    }

    /// The derivative of a small polynomial, if it is a number times something that has a name.
    fn known_derivative(&self, k: usize, variable: Variable) -> Option<Atom> {
        let Variable::Input(input) = variable else {
            return None;
        };
        let flat = &self.names[k].flat;
        // An opaque intermediate inside depends on the input in its own way.
        if symbols(flat).iter().any(|symbol| self.index.contains_key(symbol)) {
            return None;
        }
        let derivative = flat.derivative(input).expand();
        if is_simple(derivative.as_view()) {
            return Some(derivative);
        }
        let scale = leading_coefficient(&derivative)?;
        let key = (&derivative / &scale).expand();
        self.by_flat.get(&key).map(|(symbol, known)| scale / known * Atom::var(*symbol))
    }

    /// The derivative of a function by each of its arguments, in terms of its
    /// value, which is an intermediate, and of others.
    fn function_derivatives(
        &mut self,
        function: Function,
        arguments: &[Atom],
        value: Symbol,
    ) -> Vec<Atom> {
        let value = Atom::var(value);
        match function {
            Function::Reciprocal => vec![-(&value * &value)],
            Function::Root => vec![self.apply(Function::Reciprocal, &[value]) / Atom::num(2)],
            Function::Sine => vec![self.apply(Function::Cosine, arguments)],
            Function::Cosine => vec![-self.apply(Function::Sine, arguments)],
            Function::AtanRatio(order) => {
                vec![self.apply(Function::AtanRatio(order + 1), arguments)]
            }
            Function::Angle => {
                let (y, x) = (&arguments[0], &arguments[1]);
                let square = self.apply(Function::Reciprocal, &[x * x + y * y]);
                vec![self.name(&(x * &square)), self.name(&-(y * &square))]
            }
        }
    }

    /// The contribution of each input and small intermediate to `atom`:
    /// reverse accumulation through the opaque intermediates, so that what
    /// multiplies them is contracted before their parts are differentiated.
    pub fn adjoints(&mut self, atom: &Atom) -> Vec<(Symbol, Atom)> {
        let mut adjoints: HashMap<Symbol, Atom> = HashMap::new();
        for symbol in symbols(atom) {
            adjoints.insert(symbol, atom.derivative(symbol));
        }
        for k in (0..self.names.len()).rev() {
            let symbol = self.symbol(k);
            let opaque = self.names[k].flat.get_symbol() == Some(symbol);
            if !opaque {
                continue;
            }
            let Some(adjoint) = adjoints.remove(&symbol) else {
                continue;
            };
            let adjoint = self.name(&adjoint);
            let parts = match self.names[k].meaning.clone() {
                Meaning::Polynomial(polynomial) => symbols(&polynomial)
                    .into_iter()
                    .map(|part| (part, polynomial.derivative(part)))
                    .collect::<Vec<_>>(),
                Meaning::Function(function, arguments) => {
                    let outer = self.function_derivatives(function, &arguments, symbol);
                    arguments
                        .iter()
                        .zip(&outer)
                        .flat_map(|(argument, outer)| {
                            symbols(argument)
                                .into_iter()
                                .map(move |part| (part, argument.derivative(part) * outer))
                        })
                        .collect()
                }
            };
            for (part, factor) in parts {
                let sum = adjoints.entry(part).or_insert_with(Atom::zero);
                *sum = &*sum + factor * &adjoint;
            }
        }
        let mut adjoints: Vec<_> = adjoints.into_iter().collect();
        adjoints.sort_by_key(|(symbol, _)| symbol.get_id());
        adjoints.into_iter().map(|(symbol, adjoint)| (symbol, self.name(&adjoint))).collect()
    }

    /// Whether `atom` is zero for all values of the inputs.
    pub fn vanishes(&self, atom: &Atom) -> bool {
        atom.is_zero() || self.flatten(atom).is_zero()
    }

    /// Whether `atom` is the number zero or a negative number for all values of the inputs.
    pub fn is_not_positive(&self, atom: &Atom) -> bool {
        let flat = self.flatten(atom);
        let number = matches!(flat.as_view(), AtomView::Num(_));
        number && (flat.is_zero() || is_negative(&flat))
    }

    /// Whether `atom` is written with one of these inputs, however deep inside.
    pub fn depends_on(&self, atom: &Atom, inputs: &[Symbol]) -> bool {
        symbols(atom).into_iter().any(|symbol| match self.index.get(&symbol) {
            None => inputs.contains(&symbol),
            Some(&k) => {
                let mut parts = self.names[k].meaning.polynomials().iter();
                parts.any(|part| self.depends_on(part, inputs))
            }
        })
    }

    /// The derivative of `atom` by each variable, from what [`Self::adjoints`] contracts.
    pub fn gradient(&mut self, atom: &Atom, variables: &[Variable]) -> Vec<Atom> {
        let adjoints = self.adjoints(atom);
        let mut entry = |variable| {
            let terms: Vec<_> = adjoints
                .iter()
                .map(|(symbol, adjoint)| adjoint * self.symbol_derivative(*symbol, variable))
                .collect();
            Atom::add_many(terms)
        };
        variables.iter().map(|&variable| entry(variable)).collect()
    }
}
