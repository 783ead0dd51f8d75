//! JSON text with numbers of 17 significant digits, which give back the same `f64`.

use std::io;

use serde::Serialize as _;
use serde_json::ser::Formatter;
use serde_json::{Serializer, Value};

use super::failure::{Failure, print};

/// Prints a value on one line; not a number and infinities become `null`.
pub(super) fn print_json(value: &Value) -> Result<(), Failure> {
    print(&(text(value) + "\n"))
}

fn text(value: &Value) -> String {
    let mut bytes = Vec::new();
    // writing into memory does not fail
    _ = value.serialize(&mut Serializer::with_formatter(&mut bytes, Digits));
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Writes numbers with 17 significant digits.
struct Digits;

impl Formatter for Digits {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        write!(writer, "{value:.16e}")
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn cross_json_text_reads_back_bit_for_bit() {
        let text = text(&json!({ "third": 1.0 / 3.0, "a": 7, "none": f64::NAN }));
        assert!(text.find("third") < text.find("\"a\""), "keys stay in the order in which they were put in: {text}");
        let read: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(read["third"].as_f64().unwrap().to_bits(), (1.0f64 / 3.0).to_bits());
        assert_eq!((&read["a"], &read["none"]), (&json!(7), &Value::Null));
    }
}
