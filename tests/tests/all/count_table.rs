//! Counts that a page records.

use ezy_tests::count_table::CountTable;

fn table(surroundings: &str, count: u64) -> CountTable {
    let mut table = CountTable::new(surroundings.to_owned(), &["right side", "step"]);
    table.push("`coast`, EzyRoller", vec![Some(count), None]);
    table
}

#[test]
fn invariant_count_table_reads_back() {
    let table = table("one compiler", 1000);
    assert_eq!(CountTable::read(&table.to_string()), Some(table));
}

#[test]
fn invariant_counts_are_compared_where_they_can_be() {
    let recorded = table("one compiler", 1000);
    assert!(table("one compiler", 1009).compare(&recorded).is_ok());
    assert_eq!(
        table("one compiler", 1011).compare(&recorded),
        Err("`coast`, EzyRoller, right side: 1000 recorded, 1011 counted\n".to_owned())
    );
    assert!(table("another compiler", 2000).compare(&recorded).is_ok());
}
