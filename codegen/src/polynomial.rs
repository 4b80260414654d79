//! Questions about polynomials that need no table of names.

use symbolica::prelude::{Atom, AtomCore, AtomView, Symbol};

/// All symbols of an expression in the order of their registration.
pub fn symbols(atom: &Atom) -> Vec<Symbol> {
    let mut symbols: Vec<_> = atom.get_all_symbols(false).into_iter().collect();
    symbols.sort_by_key(Symbol::get_id);
    symbols
}

pub(crate) fn substitute(atom: &Atom, symbol: Symbol, value: &Atom) -> Atom {
    atom.replace_map(|view, _, out| {
        if matches!(view, AtomView::Var(variable) if variable.get_symbol() == symbol) {
            **out = value.clone();
        }
    })
}

/// Whether this is a number, a symbol, or a number times a symbol.
pub(crate) fn is_simple(view: AtomView<'_>) -> bool {
    match view {
        AtomView::Num(_) | AtomView::Var(_) => true,
        AtomView::Mul(product) => {
            product.get_nargs() == 2
                && product.iter().all(|part| matches!(part, AtomView::Num(_) | AtomView::Var(_)))
                && product.iter().any(|part| matches!(part, AtomView::Num(_)))
        }
        _ => false,
    }
}

/// The coefficient of the first term; `None` for zero.
pub(crate) fn leading_coefficient(atom: &Atom) -> Option<Atom> {
    if atom.is_zero() { None } else { atom.terms().next().map(coefficient) }
}

fn coefficient(term: AtomView<'_>) -> Atom {
    match term {
        AtomView::Num(number) => number.as_view().to_owned(),
        AtomView::Mul(product) => product
            .iter()
            .find(|part| matches!(part, AtomView::Num(_)))
            .map_or_else(Atom::one, |number| number.to_owned()),
        _ => Atom::one(),
    }
}

pub(crate) fn is_negative(number: &Atom) -> bool {
    number.to_plain_string().starts_with('-')
}

/// The size of the first coefficient, with the sign that most terms have.
pub(crate) fn common_factor(atom: &Atom) -> Atom {
    let first = leading_coefficient(atom).unwrap_or_else(Atom::one);
    let size = if is_negative(&first) { -first } else { first };
    let minus = atom.terms().filter(|term| is_negative(&coefficient(*term))).count();
    if 2 * minus > atom.terms().count() { -size } else { size }
}

/// A bound of the number of terms after expansion.
pub(crate) fn expanded_terms(view: AtomView<'_>) -> usize {
    match view {
        AtomView::Add(sum) => sum.iter().map(expanded_terms).fold(0, usize::saturating_add),
        AtomView::Mul(product) => product.iter().map(expanded_terms).fold(1, usize::saturating_mul),
        AtomView::Pow(power) => {
            let (base, exponent) = power.get_base_exp();
            let times = exponent.to_plain_string().parse().unwrap_or(1);
            expanded_terms(base).saturating_pow(times)
        }
        _ => 1,
    }
}
