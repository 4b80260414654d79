//! Numbers beside points, where they cover neither each other nor lines.

/// A box on the sheet (pixels): its upper left and its lower right corner.
type Area = [[f64; 2]; 2];

/// Height of digits of the sheet's letters (pixels).
const HEIGHT: f64 = 9.0;
/// Width of one character (pixels), rather too much than too little.
pub(super) const CHARACTER: f64 = 6.8;
/// A label this far from its point is joined to it by a line.
const NEAR: f64 = 10.0;

/// What labels have to keep clear of.
pub(super) struct Obstacles {
    /// Marks of points.
    pub(super) marks: Vec<[f64; 2]>,
    /// Straight lines.
    pub(super) lines: Vec<[[f64; 2]; 2]>,
    /// The part of the sheet that labels stay in.
    pub(super) inside: Area,
    taken: Vec<Area>,
}

/// Where a label stands.
pub(super) struct Placed {
    /// The lower left corner of its first character.
    pub(super) at: [f64; 2],
    /// The end of a line to the point, where it stands far from it.
    pub(super) leader: Option<[f64; 2]>,
}

impl Obstacles {
    pub(super) fn new(marks: Vec<[f64; 2]>, lines: Vec<[[f64; 2]; 2]>, inside: Area) -> Self {
        Self { marks, lines, inside, taken: vec![] }
    }

    /// The best of the places around a point; it is taken from then on.
    pub(super) fn place(&mut self, [x, y]: [f64; 2], text: &str) -> Placed {
        #[allow(clippy::cast_precision_loss)] // A label has a handful of characters.
        let half = [text.chars().count() as f64 * CHARACTER / 2.0, HEIGHT / 2.0];
        let mut best: Option<(f64, [f64; 2], f64)> = None;
        for distance in [5.0, 8.0, 14.0, 20.0, 28.0] {
            for turn in [-2, 2, -6, 6, 0, -4, 4, 8, -1, 1, -3, 3, -5, 5, -7, 7] {
                let (sin, cos) = (f64::from(turn) * std::f64::consts::FRAC_PI_8).sin_cos();
                let middle = [x + cos * (distance + half[0]), y + sin * (distance + half[1])];
                let cost = 0.6 * distance + self.cost(around(middle, half));
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, middle, distance));
                }
            }
        }
        let (_, middle, distance) = best.unwrap_or((0.0, [x, y], 0.0));
        let area = around(middle, half);
        self.taken.push(area);
        let end = [
            x.clamp(area[0][0] - 1.0, area[1][0] + 1.0),
            y.clamp(area[0][1] - 1.0, area[1][1] + 1.0),
        ];
        let leader = (distance > NEAR).then_some(end);
        Placed { at: [area[0][0], area[1][1]], leader }
    }

    /// How much of labels, marks and lines an area covers.
    fn cost(&self, area: Area) -> f64 {
        let labels: f64 = self.taken.iter().map(|taken| shared(area, *taken)).sum();
        let mark = |mark: &[f64; 2]| shared(area, around(*mark, [4.5; 2]));
        let marks: f64 = self.marks.iter().map(mark).sum();
        let lines: f64 = self.lines.iter().map(|line| inside(*line, area)).sum();
        let [low, high] = self.inside;
        let out: f64 =
            (0..2).map(|k| (low[k] - area[0][k]).max(0.0) + (area[1][k] - high[k]).max(0.0)).sum();
        20.0 * labels + 5.0 * marks + lines + 50.0 * out
    }
}

fn around(middle: [f64; 2], half: [f64; 2]) -> Area {
    let corner = |sign: f64| std::array::from_fn(|k| middle[k] + sign * half[k]);
    [corner(-1.0), corner(1.0)]
}

/// The area that two boxes share.
fn shared(a: Area, b: Area) -> f64 {
    let side = |k: usize| (a[1][k].min(b[1][k]) - a[0][k].max(b[0][k])).max(0.0);
    side(0) * side(1)
}

/// The length of a line inside a box (Liang and Barsky).
fn inside([from, to]: [[f64; 2]; 2], area: Area) -> f64 {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let way = to[k] - from[k];
        let [low, high] = [area[0][k] - from[k], area[1][k] - from[k]];
        if way == 0.0 {
            if low > 0.0 || high < 0.0 {
                return 0.0;
            }
        } else {
            let [first, last] = [low / way, high / way];
            enter = enter.max(first.min(last));
            leave = leave.min(first.max(last));
        }
    }
    (leave - enter).max(0.0) * (to[0] - from[0]).hypot(to[1] - from[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_keep_clear_of_each_other_and_of_lines() {
        let lines = vec![[[-50.0, 0.0], [50.0, 0.0]], [[0.0, -50.0], [0.0, 50.0]]];
        let marks = vec![[0.0, 0.0], [7.0, 0.0], [0.0, 7.0]];
        let mut obstacles = Obstacles::new(marks.clone(), lines, [[-60.0; 2], [60.0; 2]]);
        for (number, mark) in marks.iter().enumerate() {
            obstacles.place(*mark, &format!("{}", 10 + number));
        }
        let taken = &obstacles.taken;
        for (k, area) in taken.iter().enumerate() {
            assert!(obstacles.lines.iter().all(|line| inside(*line, *area) == 0.0), "{area:?}");
            assert!(taken[..k].iter().all(|other| shared(*area, *other) == 0.0), "{area:?}");
        }
    }

    #[test]
    fn a_line_is_cut_at_the_box() {
        let area = [[0.0, 0.0], [10.0, 4.0]];
        assert_eq!(inside([[-5.0, 2.0], [20.0, 2.0]], area), 10.0);
        assert_eq!(inside([[-5.0, 5.0], [20.0, 5.0]], area), 0.0);
        assert_eq!(inside([[2.0, 1.0], [2.0, 3.0]], area), 2.0);
    }
}
