//! The module of a kinetic energy.

use std::collections::HashMap;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use symbolica::prelude::Symbol;

use crate::alphabet::Alphabet;
use crate::body::Argument;
use crate::emit::{function, module_docs, operations, parameters, pattern, type_name};
use crate::energy::{EnergyKernel, PROGRAMS};
use crate::unit::Unit;

/// The module of one kinetic energy.
pub fn module(kernel: &EnergyKernel, alphabet: &Alphabet) -> TokenStream {
    let heading = &kernel.energy.heading;
    let name = format_ident!("{}", heading.name);
    let kind = format_ident!("{}", type_name(&heading.name));
    let title = format!(" {}", heading.title);
    let docs = module_docs(heading, &Unit::JOULE.to_string());
    let parameter = (!heading.parameters.is_empty()).then(|| quote!(Parameter,));
    let shape = shape(kernel);
    let functions = functions(kernel, alphabet);
    let implementation = implementation(kernel);
    quote! {
        #(#[doc = #docs])*
        pub mod #name {
            use super::{
                EnergyShape, KineticEnergy, Motion, Operations, #parameter Scalar, exact, exact_mut,
            };
            #[doc = " Patterns, parameters and operation counts."]
            pub const SHAPE: EnergyShape = #shape;
            #[doc = #title]
            #[derive(Clone, Copy, Debug, Default)]
            pub struct #kind;
            #implementation
            #(#functions)*
        }
    }
}

fn shape(kernel: &EnergyKernel) -> TokenStream {
    let heading = &kernel.energy.heading;
    let (name, title) = (&heading.name, &heading.title);
    let (equation, reference) = (&heading.equation, &heading.reference);
    let parameters = parameters(&heading.parameters);
    let [force_q, force_v, mass] = [&kernel.force_q, &kernel.force_v, &kernel.mass].map(pattern);
    let operations = operations(&kernel.programs);
    quote! {
        EnergyShape {
            name: #name,
            title: #title,
            equation: #equation,
            reference: #reference,
            parameters: #parameters,
            force_q: #force_q,
            force_v: #force_v,
            mass: #mass,
            operations: #operations,
        }
    }
}

const MEANINGS: [&str; 3] = ["T", "F", "F, F_q, F_q̇ and F_q̈"];

fn outputs(kernel: &EnergyKernel) -> [Vec<Argument>; 3] {
    let argument = |name, size| Argument { name, size };
    let force = || argument("force", 7);
    [
        vec![argument("energy", 1)],
        vec![force()],
        vec![
            force(),
            argument("force_q", kernel.force_q.len()),
            argument("force_v", kernel.force_v.len()),
            argument("mass", kernel.mass.len()),
        ],
    ]
}

fn functions(kernel: &EnergyKernel, alphabet: &Alphabet) -> Vec<TokenStream> {
    let names = input_names(alphabet);
    let argument = |name, size| Argument { name, size };
    let outputs = outputs(kernel);
    (0..PROGRAMS.len())
        .map(|k| {
            let name = format_ident!("{}", PROGRAMS[k]);
            let mut inputs = vec![argument("q", 7), argument("v", 7)];
            inputs.extend((k > 0).then(|| argument("a", 7)));
            inputs.push(argument("h", kernel.energy.heading.parameter_count()));
            function(&name, MEANINGS[k], &kernel.programs[k], &inputs, &outputs[k], &names)
        })
        .collect()
}

fn implementation(kernel: &EnergyKernel) -> TokenStream {
    let kind = format_ident!("{}", type_name(&kernel.energy.heading.name));
    quote! {
        impl<S: Scalar> KineticEnergy<S> for #kind {
            fn shape(&self) -> &'static EnergyShape {
                &SHAPE
            }
            fn energy(&self, motion: Motion<'_, S>) -> S {
                let mut value = [S::from_f64(0.0)];
                energy(motion.q, motion.v, exact(motion.h), &mut value);
                value[0]
            }
            fn force(&self, motion: Motion<'_, S>, force: &mut [S]) {
                self::force(motion.q, motion.v, motion.a, exact(motion.h), exact_mut(force));
            }
            fn tangent(
                &self,
                motion: Motion<'_, S>,
                force: &mut [S],
                force_q: &mut [S],
                force_v: &mut [S],
                mass: &mut [S],
            ) {
                tangent(
                    motion.q, motion.v, motion.a, exact(motion.h), exact_mut(force),
                    exact_mut(force_q), exact_mut(force_v), exact_mut(mass),
                );
            }
        }
    }
}

fn input_names(alphabet: &Alphabet) -> HashMap<Symbol, (&'static str, usize)> {
    let Alphabet { coordinates, velocities, accelerations, parameters, .. } = alphabet;
    let arrays = [
        (&coordinates[..7], "q"),
        (&velocities[..7], "v"),
        (&accelerations[..7], "a"),
        (&parameters[..], "h"),
    ];
    let mut names = HashMap::new();
    for (symbols, array) in arrays {
        names.extend(symbols.iter().enumerate().map(|(k, &symbol)| (symbol, (array, k))));
    }
    names
}
