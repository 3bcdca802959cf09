//! Items of two lists that are the same ones, also where something was put in before them.
//!
//! In: the lists. Out: for each item of the old one its index in the new one.

use super::{Kind, Value};

/// For each of `old`, which of `new` it is: what has the same name or says the same, in the same order; then
/// what has the same name elsewhere.
pub fn found_again(old: &[Value], new: &[Value]) -> Vec<Option<usize>> {
    let names: Vec<_> = old.iter().map(Value::given_name).collect();
    let new_names: Vec<_> = new.iter().map(Value::given_name).collect();
    let is_same = |i: usize, j: usize| match (names[i], new_names[j]) {
        (None, None) => old[i].says_the_same_as(&new[j]),
        (a, b) => a == b,
    };
    let mut found = longest_common(old.len(), new.len(), is_same);
    for i in 0..old.len() {
        let is_free = |j: &usize| !found.contains(&Some(*j));
        if found[i].is_none() && names[i].is_some() {
            found[i] = (0..new.len()).find(|j| is_free(j) && new_names[*j] == names[i]);
        }
    }
    found
}

/// The longest way to pair things of two lists in order, so that pairs are the same.
pub fn longest_common(
    count: usize,
    others: usize,
    is_same: impl Fn(usize, usize) -> bool,
) -> Vec<Option<usize>> {
    let shorter = count.min(others);
    let head = (0..shorter).take_while(|i| is_same(*i, *i)).count();
    let tail = (1..=shorter - head).take_while(|i| is_same(count - i, others - i)).count();
    let mut found: Vec<Option<usize>> = vec![None; count];
    (0..head).for_each(|i| found[i] = Some(i));
    (1..=tail).for_each(|i| found[count - i] = Some(others - i));
    // lengths[i][j] is that of the rests from head + i and head + j on.
    let (rows, columns) = (count - head - tail, others - head - tail);
    let same: Vec<Vec<bool>> =
        (0..rows).map(|i| (0..columns).map(|j| is_same(head + i, head + j)).collect()).collect();
    let mut lengths = vec![vec![0_usize; columns + 1]; rows + 1];
    for i in (0..rows).rev() {
        for j in (0..columns).rev() {
            let skip = lengths[i + 1][j].max(lengths[i][j + 1]);
            lengths[i][j] = if same[i][j] { 1 + lengths[i + 1][j + 1] } else { skip };
        }
    }
    let (mut i, mut j) = (0, 0);
    while i < rows && j < columns {
        if same[i][j] {
            found[head + i] = Some(head + j);
            (i, j) = (i + 1, j + 1);
        } else if lengths[i + 1][j] >= lengths[i][j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    found
}

impl Value {
    /// The string in its field `name`.
    pub fn given_name(&self) -> Option<&str> {
        let Kind::Record(record) = &self.kind else { return None };
        let field = record.fields.iter().find(|field| field.name.text == "name")?;
        if let Kind::Text(name) = &field.value.kind { Some(name) } else { None }
    }
}
