//! Comma-separated values: one header line, then one line for each state.

use std::io;

use super::SweepReport;

impl SweepReport<'_> {
    /// Writes the columns in full precision. A factor that the suspension does not have is empty.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        csv.write_record(self.columns())?;
        for row in &self.sweep.rows {
            let fields = self.values(row).into_iter();
            csv.write_record(
                fields.map(|value| value.map_or_else(String::new, |v| v.to_string())),
            )?;
        }
        csv.flush()
    }
}
