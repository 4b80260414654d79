//! From a program to the statements of a function.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use symbolica::prelude::Symbol;

use crate::algebra::Function;
use crate::program::{Node, NodeId, Program};

/// One array that a kernel function reads or writes.
pub(crate) struct Argument {
    pub name: &'static str,
    pub size: usize,
}

/// Single uses are written inside the expression that uses them up to so many operations.
const INLINE: usize = 6;

/// How tightly an expression binds, loosest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Whole,
}

#[derive(Clone)]
struct Piece {
    tokens: TokenStream,
    binding: Binding,
    operations: usize,
}

impl Piece {
    fn whole(tokens: TokenStream) -> Self {
        Self { tokens, binding: Binding::Whole, operations: 0 }
    }

    /// The tokens, in parentheses where they bind less tightly than `least`.
    fn within(&self, least: Binding) -> TokenStream {
        let tokens = &self.tokens;
        if self.binding < least { quote!((#tokens)) } else { tokens.clone() }
    }
}

/// The statements that compute a program and write its outputs. `names` tells which
/// entry of which array an input is.
pub(crate) fn body(
    program: &Program,
    outputs: &[Argument],
    names: &HashMap<Symbol, (&'static str, usize)>,
) -> TokenStream {
    let mut uses = vec![0_usize; program.nodes.len()];
    for node in &program.nodes {
        arguments(*node).into_iter().flatten().for_each(|argument| uses[argument] += 1);
    }
    let mut written = vec![0_usize; program.nodes.len()];
    program.outputs.iter().for_each(|&output| written[output] += 1);
    let mut statements = Vec::new();
    let mut constants: Vec<(i64, i64)> = Vec::new();
    let mut pieces: Vec<Piece> = Vec::with_capacity(program.nodes.len());
    for (id, &node) in program.nodes.iter().enumerate() {
        let piece = piece(node, &pieces, names, &mut constants);
        let simple = matches!(node, Node::Input(_) | Node::Constant(..));
        let inner = uses[id] == 1 && written[id] == 0 && piece.operations <= INLINE;
        let output = uses[id] == 0 && written[id] == 1;
        if simple || inner || output {
            pieces.push(piece);
        } else {
            let name = format_ident!("t{}", statements.len());
            let tokens = piece.tokens;
            statements.push(quote!(let #name = #tokens;));
            pieces.push(Piece::whole(quote!(#name)));
        }
    }
    let places = outputs.iter().flat_map(|output| {
        let name = format_ident!("{}", output.name);
        (0..output.size).map(move |k| {
            let k = Literal::usize_unsuffixed(k);
            quote!(#name[#k])
        })
    });
    let assignments = places.zip(&program.outputs).map(|(place, &output)| {
        let tokens = &pieces[output].tokens;
        quote!(#place = #tokens;)
    });
    let constants = constants.iter().map(|&constant| {
        let name = constant_name(constant);
        let value = Literal::f64_unsuffixed(constant.0 as f64 / constant.1 as f64);
        quote!(let #name = S::from_f64(#value);)
    });
    quote! { #(#constants)* #(#statements)* #(#assignments)* }
}

fn arguments(node: Node) -> [Option<NodeId>; 2] {
    match node {
        Node::Input(_) | Node::Constant(..) => [None, None],
        Node::Add(a, b) | Node::Subtract(a, b) | Node::Multiply(a, b) => [Some(a), Some(b)],
        Node::Negate(a) => [Some(a), None],
        Node::Apply(_, a, b) => [Some(a), b],
    }
}

fn constant_name(constant: (i64, i64)) -> Ident {
    match constant {
        (0, _) => format_ident!("zero"),
        (1, 1) => format_ident!("one"),
        (-1, 1) => format_ident!("minus_one"),
        (2, 1) => format_ident!("two"),
        (1, 2) => format_ident!("half"),
        (numerator, denominator) => {
            let sign = if numerator < 0 { "minus_" } else { "" };
            let over =
                if denominator == 1 { String::new() } else { format!("_over_{denominator}") };
            format_ident!("{sign}k{}{over}", numerator.unsigned_abs())
        }
    }
}

fn piece(
    node: Node,
    pieces: &[Piece],
    names: &HashMap<Symbol, (&'static str, usize)>,
    constants: &mut Vec<(i64, i64)>,
) -> Piece {
    let mut constant = |value: (i64, i64)| {
        if !constants.contains(&value) {
            constants.push(value);
        }
        let name = constant_name(value);
        quote!(#name)
    };
    let joined = |tokens, binding, parts: &[NodeId]| Piece {
        tokens,
        binding,
        operations: 1 + parts.iter().map(|&part| pieces[part].operations).sum::<usize>(),
    };
    match node {
        Node::Input(symbol) => {
            let (array, index) = names[&symbol];
            let (array, index) = (format_ident!("{array}"), Literal::usize_unsuffixed(index));
            Piece::whole(quote!(#array[#index]))
        }
        Node::Constant(numerator, denominator) => Piece::whole(constant((numerator, denominator))),
        Node::Add(a, b) => {
            let (left, right) = (&pieces[a].tokens, pieces[b].within(Binding::Product));
            joined(quote!(#left + #right), Binding::Sum, &[a, b])
        }
        Node::Subtract(a, b) => {
            let (left, right) = (&pieces[a].tokens, pieces[b].within(Binding::Product));
            joined(quote!(#left - #right), Binding::Sum, &[a, b])
        }
        Node::Multiply(a, b) => {
            let (left, right) =
                (pieces[a].within(Binding::Product), pieces[b].within(Binding::Sign));
            joined(quote!(#left * #right), Binding::Product, &[a, b])
        }
        Node::Negate(a) => {
            let inner = pieces[a].within(Binding::Sign);
            joined(quote!(-#inner), Binding::Sign, &[a])
        }
        Node::Apply(function, a, b) => {
            let inner = pieces[a].within(Binding::Whole);
            match function {
                Function::Reciprocal => {
                    let one = constant((1, 1));
                    joined(quote!(#one / #inner), Binding::Product, &[a])
                }
                Function::Root => joined(quote!(#inner.sqrt()), Binding::Whole, &[a]),
                Function::Sine => joined(quote!(#inner.sin()), Binding::Whole, &[a]),
                Function::Cosine => joined(quote!(#inner.cos()), Binding::Whole, &[a]),
                Function::AtanRatio(order) => {
                    let order = Literal::u8_unsuffixed(order);
                    joined(quote!(#inner.atan_ratio(#order)), Binding::Whole, &[a])
                }
                Function::Angle => {
                    let b = b.unwrap_or_else(|| unreachable!("an angle has two arguments"));
                    let x = &pieces[b].tokens;
                    joined(quote!(#inner.atan2(#x)), Binding::Whole, &[a, b])
                }
            }
        }
    }
}
