//! Names of types and modules from the names of the model text.

/// `driven_on_tarmac` → `DrivenOnTarmac`
pub fn camel_case(name: &str) -> String {
    let capital = |word: &str| {
        let mut signs = word.chars();
        signs.next().map(|first| first.to_uppercase().chain(signs).collect::<String>())
    };
    name.split('_').filter_map(capital).collect()
}

/// `EzyRoller` → `ezy_roller`
pub fn snake_case(name: &str) -> String {
    let signs: Vec<char> = name.chars().collect();
    let mut snake = String::new();
    for (i, sign) in signs.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| signs[i]);
        let word_ends = before.is_some_and(|c| c.is_lowercase() || c.is_numeric());
        let acronym_ends = before.is_some_and(char::is_uppercase) && signs.get(i + 1).is_some_and(|c| c.is_lowercase());
        if sign.is_uppercase() && (word_ends || acronym_ends) {
            snake.push('_');
        }
        snake.extend(sign.to_lowercase());
    }
    snake
}
