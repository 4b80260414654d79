//! Comma-separated values: one header line, then one line for each state.

use std::io;

use super::SweepReport;

impl SweepReport<'_> {
    /// Writes the columns to 15 significant digits. A value that a state does not have is empty.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        let columns = self.columns();
        let headers = columns.iter().map(|column| column.header(self.units));
        let headers = self.cases.map(|_| "case".to_owned()).into_iter().chain(headers);
        csv.write_record(headers).map_err(of_the_writer)?;
        for row in &self.sweep.rows {
            let fields = self.values(&columns, row).into_iter();
            let fields = fields.map(|value| value.map_or_else(String::new, |v| v.to_string()));
            let fields = self.case(row).map(str::to_owned).into_iter().chain(fields);
            csv.write_record(fields).map_err(of_the_writer)?;
        }
        csv.flush()
    }
}

/// The error of the writer itself, whose kind the conversion of the csv crate would lose:
/// a closed pipe has to stay a closed pipe.
pub(super) fn of_the_writer(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
