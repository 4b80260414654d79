//! The text of function expressions.

use super::expression::Expression;
use super::statement;

/// Deeper brackets than these are a mistake.
const DEEPEST: usize = 40;

/// More numbers and functions than these are no force that somebody has written.
const LONGEST: usize = 5000;

/// Reads an expression.
///
/// # Errors
/// What is wrong.
pub(super) fn parse(text: &str) -> Result<Expression, String> {
    let mut parser = Parser { text, at: 0, depth: 0, atoms: 0 };
    let expression = parser.sum()?;
    match parser.peek() {
        None => Ok(expression),
        Some(c) => Err(format!("nothing is expected before `{c}`")),
    }
}

struct Parser<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
    /// Numbers, functions and brackets so far.
    atoms: usize,
}

impl Parser<'_> {
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    /// Takes a sign if it comes next.
    fn take(&mut self, sign: &str) -> bool {
        self.peek();
        let found = self.text[self.at..].starts_with(sign);
        if found {
            self.at += sign.len();
        }
        found
    }

    fn sum(&mut self) -> Result<Expression, String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("there are more than {DEEPEST} brackets inside each other"));
        }
        let mut terms = vec![];
        // A sign may stand before the first term.
        let mut minus = self.take("-");
        if !minus {
            self.take("+");
        }
        loop {
            terms.push((minus, self.product()?));
            minus = self.take("-");
            if !minus && !self.take("+") {
                break;
            }
        }
        self.depth -= 1;
        Ok(match terms.len() {
            1 if !terms[0].0 => terms.remove(0).1,
            _ => Expression::Sum(terms),
        })
    }

    fn product(&mut self) -> Result<Expression, String> {
        let mut factors = vec![];
        let mut divides = false;
        loop {
            factors.push((divides, self.power()?));
            divides = self.take("/");
            if !divides && !self.take("*") {
                break;
            }
        }
        Ok(if factors.len() == 1 { factors.remove(0).1 } else { Expression::Product(factors) })
    }

    fn power(&mut self) -> Result<Expression, String> {
        let base = self.atom()?;
        if !self.take("**") {
            return Ok(base);
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err("there are too many powers of powers".into());
        }
        let minus = self.take("-");
        let exponent = self.power()?;
        self.depth -= 1;
        let exponent = if minus { Expression::Sum(vec![(true, exponent)]) } else { exponent };
        Ok(Expression::Power(Box::new(base), Box::new(exponent)))
    }

    fn atom(&mut self) -> Result<Expression, String> {
        self.atoms += 1;
        if self.atoms > LONGEST {
            return Err(format!("it has more than {LONGEST} numbers and functions"));
        }
        match self.peek() {
            None => Err("the expression ends where a number or a function is expected".into()),
            Some('(') => {
                self.at += 1;
                let inner = self.sum()?;
                if !self.take(")") {
                    return Err("a bracket is not closed".into());
                }
                Ok(inner)
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_ascii_alphabetic() => self.call(),
            // A sign of its own, as in `2*-3`.
            Some('-') => {
                self.at += 1;
                self.depth += 1;
                if self.depth > DEEPEST {
                    return Err("there are too many signs".into());
                }
                let inner = self.power()?;
                self.depth -= 1;
                Ok(Expression::Sum(vec![(true, inner)]))
            }
            Some(c) => Err(format!("`{c}` stands where a number or a function is expected")),
        }
    }

    fn number(&mut self) -> Result<Expression, String> {
        let rest = &self.text[self.at..];
        let bytes = rest.as_bytes();
        let digits =
            |from: usize| from + bytes[from..].iter().take_while(|c| c.is_ascii_digit()).count();
        let mut end = digits(0);
        if bytes.get(end) == Some(&b'.') {
            end = digits(end + 1);
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let exponent = digits(end + 1 + sign);
            if exponent > end + 1 + sign {
                end = exponent;
            }
        }
        if matches!(bytes.get(end), Some(b'd' | b'D')) {
            end += 1;
        }
        let text = &rest[..end];
        self.at += end;
        let number = statement::number(text);
        number.map(Expression::Number).ok_or_else(|| format!("`{text}` is no number"))
    }

    fn call(&mut self) -> Result<Expression, String> {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
        let name = rest[..end.unwrap_or(rest.len())].to_ascii_uppercase();
        self.at += name.len();
        let mut arguments = vec![];
        if self.take("(") {
            loop {
                arguments.push(self.sum()?);
                // IF has a colon behind its condition.
                if !self.take(",") && !self.take(":") {
                    break;
                }
            }
            if !self.take(")") {
                return Err(format!("the bracket of {name} is not closed"));
            }
        }
        Ok(Expression::Call(name, arguments))
    }
}
