//! From programs to Rust tokens.

use std::collections::HashMap;

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use symbolica::prelude::Symbol;

use crate::alphabet::Alphabet;
use crate::body::{Argument, body};
use crate::kernel::{Kernel, PROGRAMS, Pattern};
use crate::program::{Node, Operations};

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
