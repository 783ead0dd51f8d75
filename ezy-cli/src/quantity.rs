//! From the word of a quantity to its unit: from `mass` to the parameters in kg.

/// Words of quantities, and the units that they are given in.
const UNITS: [(&str, &[&str]); 16] = [
    ("mass weight masses", &["kg"]),
    ("inertia moi", &["kg*m^2"]),
    ("length distance radius width height size wheelbase position", &["m"]),
    ("angle theta phi orientation heading yaw", &["rad"]),
    ("speed velocity v vel", &["m/s"]),
    ("omega rate spin angular-velocity", &["rad/s"]),
    ("acceleration gravity accel acc g", &["m/s^2"]),
    ("angular-acceleration alpha", &["rad/s^2"]),
    ("force load thrust tension reaction lambda", &["N"]),
    ("torque moment couple", &["N*m"]),
    ("stiffness spring k", &["N/m", "N*m", "N*m/rad"]),
    ("damping damper friction", &["N*s/m", "N*m*s", "N*m*s/rad"]),
    ("energy energies", &["J"]),
    ("power", &["W"]),
    ("pressure", &["Pa"]),
    ("time seconds period", &["s"]),
];

/// The names in the unit that a word means, such as `mass` or `kg`, with this unit.
pub(super) fn alike<'n>(
    word: &str,
    names: impl Iterator<Item = (&'n str, &'n str)> + Clone,
) -> Option<(String, Vec<&'n str>)> {
    let of_word = units_of(word);
    let units = of_word.iter().copied().chain([word]);
    let mut found = units
        .map(|unit| (unit.to_owned(), names.clone().filter(|known| known.1 == unit).map(|known| known.0).collect()));
    found.find(|(_, names): &(String, Vec<&str>)| !names.is_empty())
}

/// The units that a word means.
fn units_of(word: &str) -> &'static [&'static str] {
    let bare = |text: &str| text.to_lowercase().replace(['_', '-'], "");
    let means = |words: &str| words.split(' ').any(|known| bare(known) == bare(word));
    UNITS.iter().find(|(words, _)| means(words)).map_or(&[][..], |(_, units)| units)
}

/// The unit that a word means, the first of several.
pub(super) fn unit_of(word: &str) -> Option<&'static str> {
    units_of(word).first().copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_quantity_leads_to_names_in_its_unit() {
        let names = [("m1", "kg"), ("l", "m"), ("m2", "kg"), ("k", "N*m")];
        let alike = |word: &str| alike(word, names.into_iter());
        assert_eq!(alike("Mass"), Some(("kg".to_owned(), vec!["m1", "m2"])));
        assert_eq!(alike("kg"), alike("mass"));
        assert_eq!(alike("stiffness"), Some(("N*m".to_owned(), vec!["k"])));
        assert_eq!(alike("energy"), None);
        assert_eq!(alike("zzz"), None);
    }

    #[test]
    fn invariant_every_word_of_a_quantity_stands_once() {
        let words: Vec<&str> = UNITS.iter().flat_map(|(words, _)| words.split(' ')).collect();
        for (i, word) in words.iter().enumerate() {
            assert!(!words[..i].contains(word), "{word} twice");
        }
    }
}
