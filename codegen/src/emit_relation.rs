//! The module of a relation.

use std::collections::HashMap;

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use symbolica::prelude::Symbol;

use crate::alphabet::Alphabet;
use crate::body::Argument;
use crate::emit::{function, module_docs, operations, parameters, pattern, type_name};
use crate::kernel::{Kernel, PROGRAMS};

/// The module of one relation.
pub fn module(kernel: &Kernel, alphabet: &Alphabet) -> TokenStream {
    let heading = &kernel.relation.heading;
    let name = format_ident!("{}", heading.name);
    let kind = format_ident!("{}", type_name(&heading.name));
    let title = format!(" {}", heading.title);
    let docs = module_docs(heading, &kernel.relation.unit.to_string());
    let parameter = (!heading.parameters.is_empty()).then(|| quote!(Parameter,));
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

fn shape(kernel: &Kernel) -> TokenStream {
    let relation = &kernel.relation;
    let heading = &relation.heading;
    let (name, title) = (&heading.name, &heading.title);
    let (equation, reference) = (&heading.equation, &heading.reference);
    let [bodies, equations] = [relation.bodies, relation.equations].map(Literal::usize_unsuffixed);
    let unit = relation.unit.to_string();
    let parameters = parameters(&heading.parameters);
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
    let operations = operations(&kernel.programs);
    quote! {
        Shape {
            name: #name,
            title: #title,
            equation: #equation,
            reference: #reference,
            bodies: #bodies,
            equations: #equations,
            unit: #unit,
            parameters: #parameters,
            jacobian: #jacobian,
            work: #work,
            curvature: #curvature,
            design: #design,
            force_design: #force_design,
            rate: #rate,
            rate_design: #rate_design,
            operations: #operations,
        }
    }
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
    let names = input_names(alphabet);
    let outputs = outputs(kernel);
    (0..PROGRAMS.len())
        .map(|k| {
            let name = format_ident!("{}", PROGRAMS[k]);
            let (program, inputs) = (&kernel.programs[k], inputs(kernel, k));
            function(&name, MEANINGS[k], program, &inputs, &outputs[k], &names)
        })
        .collect()
}

/// What the program of number `k` reads.
fn inputs(kernel: &Kernel, k: usize) -> Vec<Argument> {
    let argument = |name, size| Argument { name, size };
    let two = kernel.relation.bodies == 2;
    let mut inputs = vec![argument("q_i", 7)];
    inputs.extend(two.then_some(argument("q_j", 7)));
    inputs.push(argument("h", kernel.relation.heading.parameter_count()));
    if k == 2 || k == 3 {
        inputs.push(argument("lambda", kernel.relation.equations));
    }
    if k == 4 {
        inputs.push(argument("v_i", 7));
        inputs.extend(two.then_some(argument("v_j", 7)));
    }
    inputs
}

fn implementation(kernel: &Kernel) -> TokenStream {
    let kind = format_ident!("{}", type_name(&kernel.relation.heading.name));
    let outputs = outputs(kernel);
    let call = |k: usize| {
        let name = format_ident!("{}", PROGRAMS[k]);
        let inputs = inputs(kernel, k).into_iter().map(|input| match input.name {
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
