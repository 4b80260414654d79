//! From programs to Rust tokens: what all modules have, and the list of them.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use symbolica::prelude::Symbol;

use crate::body::{Argument, body};
use crate::kernel::Pattern;
use crate::program::{Node, Operations, Program};
use crate::validate::{Heading, Parameter};

/// The name of the type of a file: `orthogonal_1` gives `Orthogonal1`.
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

/// The list of all relations and energies.
pub fn index(relations: &[&Heading], energies: &[&Heading]) -> TokenStream {
    let files = relations.iter().chain(energies).map(|heading| format!("{}.rs", heading.name));
    let relations = kinds(
        relations,
        "RelationKind",
        " The relations, one for each file of `constraints/` that states a residual.",
        &quote!(Shape),
        &quote!(Relation),
    );
    let energies = (!energies.is_empty()).then(|| {
        kinds(
            energies,
            "EnergyKind",
            " The kinetic energies, one for each file of `constraints/` that states one.",
            &quote!(EnergyShape),
            &quote!(KineticEnergy),
        )
    });
    quote! {
        #(include!(#files);)*
        #relations
        #energies
    }
}

fn kinds(
    headings: &[&Heading],
    kind: &str,
    doc: &str,
    shape: &TokenStream,
    kernels: &TokenStream,
) -> TokenStream {
    let kind = format_ident!("{kind}");
    let kinds: Vec<_> =
        headings.iter().map(|heading| format_ident!("{}", type_name(&heading.name))).collect();
    let modules: Vec<_> =
        headings.iter().map(|heading| format_ident!("{}", heading.name)).collect();
    let names: Vec<_> = headings.iter().map(|heading| &heading.name).collect();
    let docs = headings.iter().map(|heading| format!(" {}: {}", heading.title, heading.equation));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum #kind {
            #(#[doc = #docs] #kinds,)*
        }
        impl #kind {
            #[doc = " All of them in the order of their names."]
            pub const ALL: &'static [Self] = &[#(Self::#kinds),*];
            #[doc = " The name of the file, without its ending."]
            pub fn name(self) -> &'static str {
                self.shape().name
            }
            #[doc = " What the file of this name states."]
            pub fn from_name(name: &str) -> Option<Self> {
                match name {
                    #(#names => Some(Self::#kinds),)*
                    _ => None,
                }
            }
            #[doc = " Patterns, parameters and operation counts."]
            pub fn shape(self) -> &'static #shape {
                match self {
                    #(Self::#kinds => &#modules::SHAPE,)*
                }
            }
            #[doc = " The kernels for one type of number."]
            pub fn kernels<S: Scalar>(self) -> &'static dyn #kernels<S> {
                match self {
                    #(Self::#kinds => &#modules::#kinds,)*
                }
            }
        }
    }
}

/// The documentation of a module; `unit` is that of what the file states.
pub(crate) fn module_docs(heading: &Heading, unit: &str) -> Vec<String> {
    let mut docs = vec![
        format!(" {}", heading.title),
        String::new(),
        format!(" `{}` (unit {})", heading.equation, unit),
        String::new(),
        format!(" Source: {}.", heading.reference.trim_end_matches('.')),
    ];
    if !heading.parameters.is_empty() {
        docs.extend([
            String::new(),
            " | h | parameter | unit | frame | meaning |".to_owned(),
            " |---|---|---|---|---|".to_owned(),
        ]);
    }
    for parameter in &heading.parameters {
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

/// The parameters as constants.
pub(crate) fn parameters(parameters: &[Parameter]) -> TokenStream {
    let parameters = parameters.iter().map(|parameter| {
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
    quote!(&[#(#parameters),*])
}

/// The operations of programs as constants.
pub(crate) fn operations(programs: &[Program]) -> TokenStream {
    let operations = programs.iter().map(|program| {
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
    quote!([#(#operations),*])
}

/// A pattern as a constant.
pub(crate) fn pattern(pattern: &Pattern) -> TokenStream {
    let entries = pattern.iter().map(|&(row, column)| {
        let (row, column) = (Literal::usize_unsuffixed(row), Literal::usize_unsuffixed(column));
        quote!((#row, #column))
    });
    quote!(&[#(#entries),*])
}

/// One program as a function. `inputs` are all arrays that programs of its kind read.
pub(crate) fn function(
    name: &Ident,
    meaning: &str,
    program: &Program,
    inputs: &[Argument],
    outputs: &[Argument],
    names: &HashMap<Symbol, (&'static str, usize)>,
) -> TokenStream {
    let argument = |argument: &Argument, used: bool, reference: TokenStream| {
        let mark = if used { "" } else { "_" };
        let ident = format_ident!("{mark}{}", argument.name);
        let size = Literal::usize_unsuffixed(argument.size);
        quote!(#ident: #reference [S; #size])
    };
    let inputs = inputs.iter().map(|input| {
        // What is differentiated may be linear, so that its derivatives read nothing.
        let used = program
            .nodes
            .iter()
            .any(|node| matches!(node, Node::Input(symbol) if names[symbol].0 == input.name));
        argument(input, used, quote!(&))
    });
    let written = outputs.iter().map(|output| argument(output, output.size > 0, quote!(&mut)));
    let operations = program.operations();
    let docs = [
        format!(" {meaning}."),
        String::new(),
        format!(
            " {} additions, {} multiplications, {} divisions, {} functions.",
            operations.additions,
            operations.multiplications,
            operations.divisions,
            operations.functions
        ),
    ];
    let body = body(program, outputs, names);
    quote! {
        #(#[doc = #docs])*
        #[inline]
        pub fn #name<S: Scalar>(#(#inputs,)* #(#written),*) {
            #body
        }
    }
}
