//! From programs to Rust tokens.

use std::collections::HashMap;

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use symbolica::prelude::Symbol;

use crate::algebra::{Alphabet, Function};
use crate::kernel::{Kernel, PROGRAMS, Pattern};
use crate::program::{Node, NodeId, Operations, Program};

/// Single uses are written inside the expression that uses them up to so many operations.
const INLINE: usize = 6;

/// The name of a relation's type: `orthogonal_1` gives `Orthogonal1`.
pub fn type_name(name: &str) -> String {
    name.split('_')
        .map(|word| {
            let mut characters = word.chars();
            characters.next().map_or_else(String::new, |first| {
                first.to_ascii_uppercase().to_string() + characters.as_str()
            })
        })
        .collect()
}

/// The module of one relation.
pub fn module(kernel: &Kernel, alphabet: &Alphabet) -> TokenStream {
    let relation = &kernel.relation;
    let name = format_ident!("{}", relation.name);
    let kind = format_ident!("{}", type_name(&relation.name));
    let title = format!(" {}", relation.title);
    let docs = module_docs(kernel);
    let parameter = (!relation.parameters.is_empty()).then(|| quote!(Parameter,));
    let shape = shape(kernel);
    let functions = functions(kernel, alphabet);
    let implementation = implementation(kernel);
    quote! {
        #(#[doc = #docs])*
        pub mod #name {
            use super::{
                Coordinates, Operations, #parameter Place, Relation, Scalar, Shape, exact, exact_mut,
            };
            #[doc = " Patterns, parameters and operation counts."]
            pub const SHAPE: Shape = #shape;
            #[doc = #title]
            #[derive(Clone, Copy, Debug, Default)]
            pub struct #kind;
            #implementation
            #(#functions)*
        }
    }
}

/// The list of all relations.
pub fn index(kernels: &[Kernel]) -> TokenStream {
    let files = kernels.iter().map(|kernel| format!("{}.rs", kernel.relation.name));
    let kinds: Vec<_> = kernels
        .iter()
        .map(|kernel| format_ident!("{}", type_name(&kernel.relation.name)))
        .collect();
    let modules: Vec<_> =
        kernels.iter().map(|kernel| format_ident!("{}", kernel.relation.name)).collect();
    let names: Vec<_> = kernels.iter().map(|kernel| &kernel.relation.name).collect();
    let docs = kernels
        .iter()
        .map(|kernel| format!(" {}: {}", kernel.relation.title, kernel.relation.equation));
    quote! {
        #(include!(#files);)*
        #[doc = " The relations, one for each file of `constraints/`."]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum RelationKind {
            #(#[doc = #docs] #kinds,)*
        }
        impl RelationKind {
            #[doc = " All relations in the order of their names."]
            pub const ALL: &'static [Self] = &[#(Self::#kinds),*];
            #[doc = " The name of the file that states the relation, without its ending."]
            pub fn name(self) -> &'static str {
                self.shape().name
            }
            #[doc = " The relation that the file of this name states."]
            pub fn from_name(name: &str) -> Option<Self> {
                match name {
                    #(#names => Some(Self::#kinds),)*
                    _ => None,
                }
            }
            #[doc = " Patterns, parameters and operation counts."]
            pub fn shape(self) -> &'static Shape {
                match self {
                    #(Self::#kinds => &#modules::SHAPE,)*
                }
            }
            #[doc = " The kernels for one type of number."]
            pub fn kernels<S: Scalar>(self) -> &'static dyn Relation<S> {
                match self {
                    #(Self::#kinds => &#modules::#kinds,)*
                }
            }
        }
    }
}

fn module_docs(kernel: &Kernel) -> Vec<String> {
    let relation = &kernel.relation;
    let mut docs = vec![
        format!(" {}", relation.title),
        String::new(),
        format!(" `{}` (unit {})", relation.equation, relation.unit),
        String::new(),
        format!(" Source: {}.", relation.reference.trim_end_matches('.')),
    ];
    if !relation.parameters.is_empty() {
        docs.extend([
            String::new(),
            " | h | parameter | unit | frame | meaning |".to_owned(),
            " |---|---|---|---|---|".to_owned(),
        ]);
    }
    for parameter in &relation.parameters {
        let range = if parameter.size == 1 {
            parameter.offset.to_string()
        } else {
            format!("{}..{}", parameter.offset, parameter.offset + parameter.size)
        };
        docs.push(format!(
            " | {range} | `{}` | {} | {} | {} |",
            parameter.name, parameter.unit, parameter.frame, parameter.meaning
        ));
    }
    docs
}

fn shape(kernel: &Kernel) -> TokenStream {
    let relation = &kernel.relation;
    let (name, title) = (&relation.name, &relation.title);
    let (equation, reference) = (&relation.equation, &relation.reference);
    let [bodies, equations] = [relation.bodies, relation.equations].map(Literal::usize_unsuffixed);
    let unit = relation.unit.to_string();
    let parameters = relation.parameters.iter().map(|parameter| {
        let name = &parameter.name;
        let [size, offset] = [parameter.size, parameter.offset].map(Literal::usize_unsuffixed);
        let (unit, frame, meaning) = (&parameter.unit, &parameter.frame, &parameter.meaning);
        quote! {
            Parameter {
                name: #name, size: #size, offset: #offset, unit: #unit, frame: #frame,
                meaning: #meaning,
            }
        }
    });
    let [jacobian, work, curvature, design, force_design, rate, rate_design] = [
        &kernel.jacobian,
        &kernel.work,
        &kernel.curvature,
        &kernel.design,
        &kernel.force_design,
        &kernel.rate,
        &kernel.rate_design,
    ]
    .map(pattern);
    let operations = kernel.programs.iter().map(|program| {
        let Operations { additions, multiplications, divisions, functions } = program.operations();
        let [additions, multiplications, divisions, functions] =
            [additions, multiplications, divisions, functions].map(Literal::usize_unsuffixed);
        quote! {
            Operations {
                additions: #additions, multiplications: #multiplications, divisions: #divisions,
                functions: #functions,
            }
        }
    });
    quote! {
        Shape {
            name: #name,
            title: #title,
            equation: #equation,
            reference: #reference,
            bodies: #bodies,
            equations: #equations,
            unit: #unit,
            parameters: &[#(#parameters),*],
            jacobian: #jacobian,
            work: #work,
            curvature: #curvature,
            design: #design,
            force_design: #force_design,
            rate: #rate,
            rate_design: #rate_design,
            operations: [#(#operations),*],
        }
    }
}

fn pattern(pattern: &Pattern) -> TokenStream {
    let entries = pattern.iter().map(|&(row, column)| {
        let (row, column) = (Literal::usize_unsuffixed(row), Literal::usize_unsuffixed(column));
        quote!((#row, #column))
    });
    quote!(&[#(#entries),*])
}

/// One array that a kernel function reads or writes.
struct Argument {
    name: &'static str,
    size: usize,
}

fn outputs(kernel: &Kernel) -> [Vec<Argument>; 5] {
    let argument = |name, size| Argument { name, size };
    let residual = || argument("phi", kernel.relation.equations);
    let jacobian = || argument("phi_q", kernel.jacobian.len());
    let work = || argument("work", kernel.work.len());
    [
        vec![residual()],
        vec![residual(), jacobian(), work()],
        vec![residual(), jacobian(), work(), argument("curvature", kernel.curvature.len())],
        vec![
            argument("phi_h", kernel.design.len()),
            argument("force_h", kernel.force_design.len()),
        ],
        vec![argument("rate_q", kernel.rate.len()), argument("rate_h", kernel.rate_design.len())],
    ]
}

const MEANINGS: [&str; 5] =
    ["Φ", "Φ, Φ_q and W", "Φ, Φ_q, W and (Wᵀλ)_q", "Φ_h and (Wᵀλ)_h", "(Φ_q v)_q and (Φ_q v)_h"];

fn functions(kernel: &Kernel, alphabet: &Alphabet) -> Vec<TokenStream> {
    let parameters: usize = kernel.relation.parameters.iter().map(|p| p.size).sum();
    let names = input_names(alphabet);
    let outputs = outputs(kernel);
    (0..PROGRAMS.len())
        .map(|k| {
            let program = &kernel.programs[k];
            let name = format_ident!("{}", PROGRAMS[k]);
            let mut arguments = Vec::new();
            for (name, size) in inputs(kernel, k) {
                let size = if name == "h" { parameters } else { size };
                // A relation may be linear, so that its derivatives read nothing.
                let used = program
                    .nodes
                    .iter()
                    .any(|node| matches!(node, Node::Input(symbol) if names[symbol].0 == name));
                let ident = if used { format_ident!("{name}") } else { format_ident!("_{name}") };
                let size = Literal::usize_unsuffixed(size);
                arguments.push(quote!(#ident: &[S; #size]));
            }
            for output in &outputs[k] {
                let used = output.size > 0;
                let ident = if used {
                    format_ident!("{}", output.name)
                } else {
                    format_ident!("_{}", output.name)
                };
                let size = Literal::usize_unsuffixed(output.size);
                arguments.push(quote!(#ident: &mut [S; #size]));
            }
            let operations = program.operations();
            let docs = [
                format!(" {}.", MEANINGS[k]),
                String::new(),
                format!(
                    " {} additions, {} multiplications, {} divisions, {} functions.",
                    operations.additions,
                    operations.multiplications,
                    operations.divisions,
                    operations.functions
                ),
            ];
            let body = body(program, &outputs[k], &names);
            quote! {
                #(#[doc = #docs])*
                #[inline]
                pub fn #name<S: Scalar>(#(#arguments),*) {
                    #body
                }
            }
        })
        .collect()
}

/// What the program of number `k` reads: name and size of each array.
fn inputs(kernel: &Kernel, k: usize) -> Vec<(&'static str, usize)> {
    let two = kernel.relation.bodies == 2;
    let mut inputs = vec![("q_i", 7)];
    inputs.extend(two.then_some(("q_j", 7)));
    inputs.push(("h", 0));
    if k == 2 || k == 3 {
        inputs.push(("lambda", kernel.relation.equations));
    }
    if k == 4 {
        inputs.push(("v_i", 7));
        inputs.extend(two.then_some(("v_j", 7)));
    }
    inputs
}

fn implementation(kernel: &Kernel) -> TokenStream {
    let kind = format_ident!("{}", type_name(&kernel.relation.name));
    let outputs = outputs(kernel);
    let call = |k: usize| {
        let name = format_ident!("{}", PROGRAMS[k]);
        let inputs = inputs(kernel, k).into_iter().map(|(input, _)| match input {
            "q_i" => quote!(place.q_i),
            "q_j" => quote!(place.q_j),
            "h" => quote!(exact(place.h)),
            "lambda" => quote!(exact(lambda)),
            other => {
                let ident = format_ident!("{other}");
                quote!(#ident)
            }
        });
        let outputs = outputs[k].iter().map(|output| {
            let ident = format_ident!("{}", output.name);
            quote!(exact_mut(#ident))
        });
        // The curvature kernel has an argument of its own name.
        let path = if k == 2 { quote!(self::#name) } else { quote!(#name) };
        quote!(#path(#(#inputs,)* #(#outputs),*);)
    };
    let [residual, jacobian, curvature, design, rate] = [0, 1, 2, 3, 4].map(call);
    let v_j = if kernel.relation.bodies == 2 { quote!(v_j) } else { quote!(_v_j) };
    quote! {
        impl<S: Scalar> Relation<S> for #kind {
            fn shape(&self) -> &'static Shape {
                &SHAPE
            }
            fn residual(&self, place: Place<'_, S>, phi: &mut [S]) {
                #residual
            }
            fn jacobian(
                &self,
                place: Place<'_, S>,
                phi: &mut [S],
                phi_q: &mut [S],
                work: &mut [S],
            ) {
                #jacobian
            }
            fn curvature(
                &self,
                place: Place<'_, S>,
                lambda: &[S],
                phi: &mut [S],
                phi_q: &mut [S],
                work: &mut [S],
                curvature: &mut [S],
            ) {
                #curvature
            }
            fn design(
                &self,
                place: Place<'_, S>,
                lambda: &[S],
                phi_h: &mut [S],
                force_h: &mut [S],
            ) {
                #design
            }
            fn rate(
                &self,
                place: Place<'_, S>,
                v_i: &Coordinates<S>,
                #v_j: &Coordinates<S>,
                rate_q: &mut [S],
                rate_h: &mut [S],
            ) {
                #rate
            }
        }
    }
}

fn input_names(alphabet: &Alphabet) -> HashMap<Symbol, (&'static str, usize)> {
    let mut names = HashMap::new();
    let bodies = [(&alphabet.coordinates, ["q_i", "q_j"]), (&alphabet.velocities, ["v_i", "v_j"])];
    for (symbols, arrays) in bodies {
        for (k, &symbol) in symbols.iter().enumerate() {
            names.insert(symbol, (arrays[k / 7], k % 7));
        }
    }
    for (symbols, array) in [(&alphabet.parameters, "h"), (&alphabet.multipliers, "lambda")] {
        for (k, &symbol) in symbols.iter().enumerate() {
            names.insert(symbol, (array, k));
        }
    }
    names
}

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

fn body(
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
        Node::Negate(a) | Node::Apply(_, a) => [Some(a), None],
    }
}

fn constant_name(constant: (i64, i64)) -> proc_macro2::Ident {
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
        Node::Apply(function, a) => {
            let inner = pieces[a].within(Binding::Whole);
            match function {
                Function::Reciprocal => {
                    let one = constant((1, 1));
                    joined(quote!(#one / #inner), Binding::Product, &[a])
                }
                Function::Root => joined(quote!(#inner.sqrt()), Binding::Whole, &[a]),
                Function::Sine => joined(quote!(#inner.sin()), Binding::Whole, &[a]),
                Function::Cosine => joined(quote!(#inner.cos()), Binding::Whole, &[a]),
            }
        }
    }
}
