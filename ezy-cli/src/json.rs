//! JSON text, with numbers as short as gives back the same `f64`.

use serde_json::Value;

use super::failure::{Failure, print};

/// Prints a value on one line; not a number and infinities become `null`.
pub(super) fn print_json(value: &Value) -> Result<(), Failure> {
    print(&format!("{value}\n"))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn cross_json_text_reads_back_bit_for_bit() {
        let text = json!({ "third": 1.0 / 3.0, "a": 7, "short": 0.02, "none": f64::NAN }).to_string();
        assert_eq!(text, r#"{"third":0.3333333333333333,"a":7,"short":0.02,"none":null}"#);
        let read: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(read["third"].as_f64().unwrap().to_bits(), (1.0f64 / 3.0).to_bits());
    }
}
