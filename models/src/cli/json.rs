//! JSON text with numbers of 17 significant digits, which give back the same `f64`, in the order they were put in.

use std::fmt;

/// A JSON value.
#[derive(Debug, Clone)]
pub enum Json {
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
    pub fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    pub fn object<K: Into<String>>(members: impl IntoIterator<Item = (K, Json)>) -> Self {
        Self::Object(members.into_iter().map(|(key, value)| (key.into(), value)).collect())
    }

    pub fn list(items: impl IntoIterator<Item = Json>) -> Self {
        Self::List(items.into_iter().collect())
    }

    /// Numbers by name.
    pub fn numbers<'n>(names: impl IntoIterator<Item = &'n str>, values: &[f64]) -> Self {
        Self::object(names.into_iter().zip(values.iter().map(|v| Self::Number(*v))))
    }
}

impl fmt::Display for Json {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) if value.is_finite() => write!(f, "{value:.16e}"),
            Self::Number(_) | Self::Null => f.write_str("null"),
            Self::Count(count) => write!(f, "{count}"),
            Self::Bool(value) => write!(f, "{value}"),
            Self::Text(text) => write_text(f, text),
            Self::List(items) => {
                f.write_str("[")?;
                for (i, item) in items.iter().enumerate() {
                    write!(f, "{}{item}", if i > 0 { "," } else { "" })?;
                }
                f.write_str("]")
            }
            Self::Object(members) => {
                f.write_str("{")?;
                for (i, (key, value)) in members.iter().enumerate() {
                    f.write_str(if i > 0 { "," } else { "" })?;
                    write_text(f, key)?;
                    write!(f, ":{value}")?;
                }
                f.write_str("}")
            }
        }
    }
}

fn write_text(f: &mut fmt::Formatter<'_>, text: &str) -> fmt::Result {
    f.write_str("\"")?;
    for c in text.chars() {
        match c {
            '"' | '\\' => write!(f, "\\{c}")?,
            '\n' => f.write_str("\\n")?,
            c if c.is_control() => write!(f, "\\u{:04x}", c as u32)?,
            c => write!(f, "{c}")?,
        }
    }
    f.write_str("\"")
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
