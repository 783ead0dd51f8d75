//! Compile errors as rustc shows them: one file a layer of faults, `TRYBUILD=overwrite` writes them anew.
//!
//! The exact text and place of every message is tested in `src/model/tests/messages`; here, that each sits on
//! the user's own words.

#[test]
fn reference_compile_errors_sit_on_the_words_to_change() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
