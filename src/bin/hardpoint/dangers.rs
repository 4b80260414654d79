//! Dead centres that an event came near to, in words.

use hardpoint::model::{Quantity, Units};
use hardpoint::rig::{Danger, Place, Sweep, Warning};

/// More lines than this say nothing more.
const MOST: usize = 6;

/// What a sweep was warned of, a line each; `quantity` is that of its values, `None` of cases, which have names.
pub fn dangers(sweep: &Sweep, quantity: Option<Quantity>, units: Units) -> Vec<String> {
    let value = |place: &Place| {
        let quantity = quantity?;
        // Nine digits hide the change of units.
        let shown = (quantity.show(units, place.value) * 1e9).round() / 1e9;
        Some(format!("{} {}", shown + 0.0, quantity.symbol(units)))
    };
    let words = |Warning { danger, side, from, to }: &Warning<Place>| {
        let plan = from.plan.as_ref().map_or(String::new(), |plan| format!("{plan}: "));
        let [first, last] = [from, to].map(|place| value(place).unwrap_or_default());
        let stretch = match danger {
            _ if first.is_empty() => String::new(),
            _ if first == last => format!(" at {first}"),
            Danger::Turns { .. } => format!(" between {first} and {last}"),
            Danger::Fast { .. } | Danger::Dead => format!(" from {first} to {last}"),
        };
        format!("{plan}{} wheel{stretch}: {danger}", side.name())
    };
    let mut lines: Vec<String> = sweep.warnings.iter().take(MOST).map(words).collect();
    if sweep.warnings.len() > MOST {
        let more = sweep.warnings.len() - MOST;
        lines.push(format!(
            "{more} more stretches near dead centres; see `hardpoint check --range`"
        ));
    }
    lines
}
