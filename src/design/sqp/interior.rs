//! Quadratic and linear programs by the interior-point solver clarabel.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolution, DefaultSolver, IPSolver, NonnegativeConeT,
    SolverStatus, ZeroConeT,
};
use faer::{Col, Mat};

use super::active_set::{Limits, Place, Places, Step};

/// A quadratic program: minimise ½ pᵀ H p + gᵀ p within limits, with violations of the limits of rows
/// penalised, or forbidden without a penalty.
pub(super) struct Program<'a> {
    /// None for a linear program.
    pub hessian: Option<&'a Mat<f64>>,
    pub gradient: &'a Col<f64>,
    pub rows: &'a Mat<f64>,
    pub limits: &'a Limits,
    pub penalty: Option<f64>,
}

/// What clarabel finds.
pub(super) enum Answer {
    /// A solution, exact to about 1e-8, and the working set that it suggests.
    Solved(Box<Step>),
    /// The limits contradict each other.
    Infeasible,
    /// No answer.
    Failed,
}

/// Which limit a row of clarabel's matrix is: a component of the step or a constraint, the
/// side of it, and the slack variable if it is penalised.
struct Line {
    row: Option<usize>,
    component: usize,
    /// 1 for an upper limit or an equation, −1 for a lower limit.
    sign: f64,
    value: f64,
    slack: Option<usize>,
}

/// The units in which clarabel sees a program.
struct Units {
    step: f64,
    objective: f64,
}

impl Units {
    /// A multiplier or gradient as clarabel sees it.
    fn dual(&self, value: f64) -> f64 {
        value * self.step / self.objective
    }
}

impl Program<'_> {
    pub fn solve(&self) -> Answer {
        let (lines, equations, slacks) = self.lines();
        let n = self.gradient.nrows();
        let columns = n + slacks;
        let units = self.units();
        let objective = self.objective_matrix(columns, units.step * units.step / units.objective);
        let mut linear = vec![units.dual(self.penalty.unwrap_or(0.0)); columns];
        for j in 0..n {
            linear[j] = units.dual(self.gradient[j]);
        }
        let matrix = self.matrix(&lines, columns);
        let right_side: Vec<f64> =
            lines.iter().map(|line| line.sign * line.value / units.step).collect();
        let cones = [ZeroConeT(equations), NonnegativeConeT(lines.len() - equations)];
        let settings = DefaultSettingsBuilder::default()
            .verbose(false)
            .max_iter(100)
            .tol_gap_abs(1e-10)
            .tol_gap_rel(1e-10)
            .tol_feas(1e-10)
            .build();
        let Ok(settings) = settings else { return Answer::Failed };
        let solver =
            DefaultSolver::new(&objective, &linear, &matrix, &right_side, &cones, settings);
        let Ok(mut solver) = solver else { return Answer::Failed };
        solver.solve();
        let solution = &solver.solution;
        match solution.status {
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                Answer::Infeasible
            }
            // Where progress ends early the point is still a good guess.
            _ if solution.x.iter().chain(&solution.z).all(|value| value.is_finite())
                && !matches!(
                    solution.status,
                    SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible
                ) =>
            {
                let usable =
                    matches!(solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved);
                if usable || self.penalty.is_some() {
                    let step = self.read(&lines, solution, &units);
                    Answer::Solved(Box::new(step))
                } else {
                    Answer::Failed
                }
            }
            _ => Answer::Failed,
        }
    }

    /// Tolerances of clarabel are absolute, so steps are measured by the size of their box, and the
    /// objective so that gradient and penalty are at most 1.
    fn units(&self) -> Units {
        let sides = self.limits.lower.iter().chain(&self.limits.upper);
        let step = sides.fold(0.0f64, |max, side| max.max(side.abs())).clamp(1e-8, 1e8);
        let steepest = self.gradient.norm_max().max(self.penalty.unwrap_or(0.0));
        Units { step, objective: if steepest > 0.0 { step * steepest } else { step } }
    }

    /// Lines of the matrix, equations first; how many equations and slack variables there are.
    /// Constraints that the box of the step keeps within their limits are left out.
    fn lines(&self) -> (Vec<Line>, usize, usize) {
        let n = self.gradient.nrows();
        let (mut equations, mut inequalities, mut slacks) = (vec![], vec![], 0);
        let limits = self.limits;
        for i in 0..self.rows.nrows() {
            let (lower, upper) = (limits.row_lower[i], limits.row_upper[i]);
            let line = |sign, value, slack| Line { row: Some(i), component: i, sign, value, slack };
            if lower == upper && self.penalty.is_none() {
                equations.push(line(1.0, lower, None));
                continue;
            }
            let (least, most) = self.range(i);
            for (sign, value, reached) in [(-1.0, lower, least < lower), (1.0, upper, most > upper)]
            {
                if value.is_finite() && reached {
                    let slack = self.penalty.map(|_| n + slacks);
                    slacks += usize::from(slack.is_some());
                    inequalities.push(line(sign, value, slack));
                }
            }
        }
        for j in 0..n {
            let (lower, upper) = (limits.lower[j], limits.upper[j]);
            let line = |sign, value| Line { row: None, component: j, sign, value, slack: None };
            if lower == upper {
                equations.push(line(1.0, lower));
                continue;
            }
            inequalities.push(line(-1.0, lower));
            inequalities.push(line(1.0, upper));
        }
        inequalities.extend((n..n + slacks).map(|slack| Line {
            row: None,
            component: slack,
            sign: -1.0,
            value: 0.0,
            slack: None,
        }));
        let count = equations.len();
        equations.extend(inequalities);
        (equations, count, slacks)
    }

    /// The least and largest value of a row in the box.
    fn range(&self, row: usize) -> (f64, f64) {
        (0..self.gradient.nrows()).fold((0.0, 0.0), |(least, most), j| {
            let a = self.rows[(row, j)] * self.limits.lower[j];
            let b = self.rows[(row, j)] * self.limits.upper[j];
            (least + a.min(b), most + a.max(b))
        })
    }

    /// The upper triangle of the Hessian, with empty columns for slack variables.
    fn objective_matrix(&self, columns: usize, scale: f64) -> CscMatrix<f64> {
        let (mut starts, mut rows, mut values) = (vec![0], vec![], vec![]);
        for column in 0..columns {
            if let Some(hessian) = self.hessian.filter(|hessian| column < hessian.ncols()) {
                for row in 0..=column {
                    rows.push(row);
                    values.push(scale * hessian[(row, column)]);
                }
            }
            starts.push(rows.len());
        }
        CscMatrix::new(columns, columns, starts, rows, values)
    }

    fn matrix(&self, lines: &[Line], columns: usize) -> CscMatrix<f64> {
        let mut entries: Vec<Vec<(usize, f64)>> = vec![vec![]; columns];
        for (index, line) in lines.iter().enumerate() {
            match line.row {
                Some(row) => {
                    for j in 0..self.gradient.nrows() {
                        let value = self.rows[(row, j)];
                        if value != 0.0 {
                            entries[j].push((index, line.sign * value));
                        }
                    }
                    if let Some(slack) = line.slack {
                        entries[slack].push((index, -1.0));
                    }
                }
                None => entries[line.component].push((index, line.sign)),
            }
        }
        let (mut starts, mut rows, mut values) = (vec![0], vec![], vec![]);
        for column in entries {
            for (row, value) in column {
                rows.push(row);
                values.push(value);
            }
            starts.push(rows.len());
        }
        CscMatrix::new(lines.len(), columns, starts, rows, values)
    }

    /// Reads the step, its multipliers and the working set: a limit whose multiplier is larger than its
    /// slack is active.
    fn read(&self, lines: &[Line], solution: &DefaultSolution<f64>, units: &Units) -> Step {
        let n = self.gradient.nrows();
        let (x, s, z) = (&solution.x, &solution.s, &solution.z);
        let penalty = self.penalty.map(|penalty| units.dual(penalty));
        let mut places = Places::between(n, self.rows.nrows());
        let mut step = Col::from_fn(n, |j| x[j] * units.step);
        let (mut y_all, mut z_all) = (Col::zeros(self.rows.nrows()), Col::zeros(n));
        for (index, line) in lines.iter().enumerate() {
            if line.component >= n && line.row.is_none() {
                continue;
            }
            let place = match () {
                () if line.sign < 0.0 => (Place::Lower, Place::Below),
                () => (Place::Upper, Place::Above),
            };
            let equation = line.value == self.other_limit(line);
            let active = equation && line.slack.is_none() || z[index] > s[index].max(0.0);
            match line.row {
                Some(row) => {
                    y_all[row] -= line.sign * z[index] * units.objective / units.step;
                    if active {
                        let violated = line.slack.is_some_and(|slack| {
                            penalty.is_some_and(|penalty| x[slack] > penalty - z[index])
                        });
                        places.rows[row] = if violated { place.1 } else { place.0 };
                    }
                }
                None => {
                    z_all[line.component] -= line.sign * z[index] * units.objective / units.step;
                    if active {
                        places.bounds[line.component] = place.0;
                    }
                }
            }
        }
        for j in 0..n {
            step[j] = step[j].clamp(self.limits.lower[j], self.limits.upper[j]);
        }
        Step { step, y: y_all, z: z_all, places }
    }

    fn other_limit(&self, line: &Line) -> f64 {
        let limits = self.limits;
        let (lower, upper) = match line.row {
            Some(row) => (limits.row_lower[row], limits.row_upper[row]),
            None => (limits.lower[line.component], limits.upper[line.component]),
        };
        if line.value == lower { upper } else { lower }
    }
}
