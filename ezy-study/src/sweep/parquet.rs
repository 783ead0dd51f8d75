//! Tables as Parquet.

use super::manifest::Manifest;
use super::row::{Column, Pieces, Row};
use std::io;
use std::path::Path;

#[cfg(not(feature = "parquet"))]
mod without {
    use super::*;

    fn unsupported<T>() -> io::Result<T> {
        Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "this program was built without Parquet; add \"parquet\" to the features of ezy-cli, or of ezy-study, in Cargo.toml, or write CSV",
        ))
    }

    pub(in super::super) fn write(_: impl io::Write, _: &[Column], _: &Manifest, _: &mut Pieces<'_>) -> io::Result<()> {
        unsupported()
    }

    pub(in super::super) fn read(_: &Path, _: &[Column]) -> io::Result<Vec<Row>> {
        unsupported()
    }
}

#[cfg(not(feature = "parquet"))]
pub(super) use without::{read, write};

#[cfg(feature = "parquet")]
pub(super) use with::{read, write};

#[cfg(feature = "parquet")]
mod with {
    use super::*;
    use crate::sweep::row::{Cell, Kind};
    use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
    use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
    use parquet::errors::ParquetError;
    use parquet::file::metadata::KeyValue;
    use parquet::file::properties::WriterProperties;
    use parquet::file::reader::{FileReader as _, SerializedFileReader};
    use parquet::file::writer::SerializedFileWriter;
    use parquet::record::Field;
    use parquet::schema::types::Type;
    use std::fs::File;
    use std::sync::Arc;

    /// Writes rows; each piece is a row group. Numbers that are not there are null.
    ///
    /// # Errors
    /// The error of the system or of the rows.
    pub(in super::super) fn write(
        file: impl io::Write + Send,
        columns: &[Column],
        manifest: &Manifest,
        rows: &mut Pieces<'_>,
    ) -> io::Result<()> {
        let of = |error: ParquetError| io::Error::other(error);
        let fields =
            columns.iter().map(|column| field(column).map(Arc::new)).collect::<Result<Vec<_>, _>>().map_err(of)?;
        let schema = Type::group_type_builder("sweep").with_fields(fields).build().map_err(of)?;
        let entry = |name: String, value: String| KeyValue::new(name, value);
        let units = columns.iter().filter(|column| !column.unit.is_empty());
        let mut entries: Vec<KeyValue> =
            units.map(|column| entry(format!("unit.{}", column.name), column.unit.clone())).collect();
        entries.push(entry("ezy.sweep".to_owned(), serde_json::Value::Object(manifest.0.clone()).to_string()));
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(Some(entries))
            .build();
        let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties)).map_err(of)?;
        for piece in rows {
            let piece = piece?;
            let mut group = writer.next_row_group().map_err(of)?;
            for (i, column) in columns.iter().enumerate() {
                let Some(mut cells) = group.next_column().map_err(of)? else { break };
                write_column(&mut cells, &piece, i, column.kind).map_err(of)?;
                cells.close().map_err(of)?;
            }
            group.close().map_err(of)?;
        }
        writer.close().map_err(of)?;
        Ok(())
    }

    fn field(column: &Column) -> Result<Type, ParquetError> {
        let (physical, repetition, logical) = match column.kind {
            Kind::Number => (Physical::DOUBLE, Repetition::OPTIONAL, None),
            Kind::Count => (Physical::INT64, Repetition::REQUIRED, None),
            Kind::Text => (Physical::BYTE_ARRAY, Repetition::REQUIRED, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(&column.name, physical);
        field.with_repetition(repetition).with_logical_type(logical).build()
    }

    fn write_column(
        column: &mut parquet::file::writer::SerializedColumnWriter<'_>,
        rows: &[Row],
        i: usize,
        kind: Kind,
    ) -> Result<(), ParquetError> {
        // the number of the case stands before the cells
        let cells = || rows.iter().map(move |row| i.checked_sub(1).map(|i| &row.cells[i]));
        match kind {
            Kind::Number => {
                let numbers = || cells().map(|cell| if let Some(Cell::Number(x)) = cell { *x } else { f64::NAN });
                let there: Vec<f64> = numbers().filter(|x| !x.is_nan()).collect();
                let levels: Vec<i16> = numbers().map(|x| i16::from(!x.is_nan())).collect();
                column.typed::<DoubleType>().write_batch(&there, Some(&levels), None)?;
            }
            Kind::Count => {
                let count = |(row, cell): (&Row, Option<&Cell>)| match cell {
                    None => row.index as i64,
                    Some(Cell::Count(n)) => *n as i64,
                    Some(_) => 0,
                };
                let counts: Vec<i64> = rows.iter().zip(cells()).map(count).collect();
                column.typed::<Int64Type>().write_batch(&counts, None, None)?;
            }
            Kind::Text => {
                let text = |cell: Option<&Cell>| match cell {
                    Some(Cell::Text(text)) => ByteArray::from(text.as_str()),
                    _ => ByteArray::new(),
                };
                let texts: Vec<ByteArray> = cells().map(text).collect();
                column.typed::<ByteArrayType>().write_batch(&texts, None, None)?;
            }
        }
        Ok(())
    }

    /// Reads all rows.
    ///
    /// # Errors
    /// The error of the system; [`io::ErrorKind::InvalidData`] when the file is not of these columns.
    pub(in super::super) fn read(path: &Path, columns: &[Column]) -> io::Result<Vec<Row>> {
        let wrong = |what: String| io::Error::new(io::ErrorKind::InvalidData, what);
        let of = |error: ParquetError| wrong(error.to_string());
        let reader = SerializedFileReader::new(File::open(path)?).map_err(of)?;
        let mut rows = Vec::new();
        for row in reader.get_row_iter(None).map_err(of)? {
            let row = row.map_err(of)?;
            let fields: Vec<(&String, &Field)> = row.get_column_iter().collect();
            let is_ours =
                fields.iter().map(|(name, _)| name.as_str()).eq(columns.iter().map(|column| column.name.as_str()));
            let Some(((_, Field::Long(index)), rest)) = fields.split_first().filter(|_| is_ours) else {
                return Err(wrong("it is not of this sweep".to_owned()));
            };
            let cell = |(_, field): &(&String, &Field)| match field {
                Field::Double(x) => Cell::Number(*x),
                Field::Long(n) => Cell::Count(*n as u64),
                Field::Str(text) => Cell::Text(text.clone()),
                _ => Cell::Number(f64::NAN),
            };
            rows.push(Row { index: *index as u64, cells: rest.iter().map(cell).collect() });
        }
        Ok(rows)
    }
}
