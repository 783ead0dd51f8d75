//! JSON text with numbers of 17 significant digits, which give back the same `f64`, in the order they were put in.

use std::{fmt, io};

use serde::{Serialize, Serializer};

/// A JSON value.
#[derive(Debug, Clone)]
pub(super) enum Json {
    /// Not a number and infinities become `null`.
    Number(f64),
    Count(u64),
    Bool(bool),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
    Null,
}

impl Json {
    pub(super) fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    pub(super) fn object<K: Into<String>>(members: impl IntoIterator<Item = (K, Json)>) -> Self {
        Self::Object(members.into_iter().map(|(key, value)| (key.into(), value)).collect())
    }

    pub(super) fn list(items: impl IntoIterator<Item = Json>) -> Self {
        Self::List(items.into_iter().collect())
    }
}

impl Serialize for Json {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(value) => serializer.serialize_f64(*value),
            Self::Count(count) => serializer.serialize_u64(*count),
            Self::Bool(value) => serializer.serialize_bool(*value),
            Self::Text(text) => serializer.serialize_str(text),
            Self::List(items) => serializer.collect_seq(items),
            Self::Object(members) => serializer.collect_map(members.iter().map(|(key, value)| (key, value))),
            Self::Null => serializer.serialize_unit(),
        }
    }
}

impl fmt::Display for Json {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = Vec::new();
        self.serialize(&mut serde_json::Serializer::with_formatter(&mut text, Digits)).map_err(|_| fmt::Error)?;
        f.write_str(&String::from_utf8_lossy(&text))
    }
}

/// Writes numbers with 17 significant digits.
struct Digits;

impl serde_json::ser::Formatter for Digits {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        write!(writer, "{value:.16e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cross_json_text_reads_back_bit_for_bit() {
        let value = Json::object([
            ("third", Json::Number(1.0 / 3.0)),
            ("odd \"key\"\n\u{1}", Json::list([Json::Null, Json::Bool(true), Json::Count(7), Json::text("λ")])),
            ("none", Json::Number(f64::NAN)),
        ]);
        let read: serde_json::Value = serde_json::from_str(&value.to_string()).unwrap();
        assert_eq!(read["third"].as_f64().unwrap().to_bits(), (1.0f64 / 3.0).to_bits());
        assert_eq!(read["odd \"key\"\n\u{1}"], serde_json::json!([null, true, 7, "λ"]));
        assert!(read["none"].is_null());
    }
}
