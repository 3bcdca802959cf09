//! Items of two lists that are the same ones, also where they were changed, renamed or moved.

use crate::scene::order::{found_again, longest_common};
use crate::scene::{Field, Kind, Record, Value};

/// Beyond so many comparisons of two items their fields are not looked at.
const MAX_COMPARED: usize = 1 << 18;

/// How alike two values are that are of one kind and share nothing; 1 is the same.
const OF_ONE_KIND: f64 = 0.25;
/// The share of their other fields that must say the same in what has another name than before.
const RENAMED: f64 = 0.5;

/// For each of `old`, which of `new` it is.
///
/// Names decide first, or what an item without one says. What is left is paired between neighbours that are
/// paired, in order, so that pairs are as alike as can be.
pub fn pairs(old: &[Value], new: &[Value]) -> Vec<Option<usize>> {
    let mut found = found_again(old, new);
    for i in 0..old.len() {
        if found[i].is_none() {
            let is_free = |j: &usize| !found.contains(&Some(*j));
            found[i] = (0..new.len()).find(|j| is_free(j) && old[i].says_the_same_as(&new[*j]));
        }
    }
    let in_order = in_order(&found, new.len());
    let (mut i, mut j) = (0, 0);
    while i <= old.len() {
        let end = (i..old.len()).find(|k| in_order[*k]).unwrap_or(old.len());
        let new_end = found.get(end).copied().flatten().unwrap_or(new.len());
        let olds: Vec<usize> = (i..end).filter(|k| found[*k].is_none()).collect();
        let news: Vec<usize> = (j..new_end).filter(|k| !found.contains(&Some(*k))).collect();
        for (k, other) in most_alike(old, &olds, new, &news) {
            found[k] = Some(other);
        }
        (i, j) = (end + 1, new_end + 1);
    }
    found
}

/// Which of the pairs stay, if as few as possible are said to have moved past others.
pub fn in_order(found: &[Option<usize>], others: usize) -> Vec<bool> {
    let staying = longest_common(found.len(), others, |i, j| found[i] == Some(j));
    staying.iter().map(Option::is_some).collect()
}

/// Pairs of the chosen items, in order.
fn most_alike(old: &[Value], olds: &[usize], new: &[Value], news: &[usize]) -> Vec<(usize, usize)> {
    let (rows, columns) = (olds.len(), news.len());
    if rows * columns > MAX_COMPARED {
        let is_same = |i: usize, j: usize| shape(&old[olds[i]]) == shape(&new[news[j]]);
        let found = longest_common(rows, columns, is_same).into_iter().enumerate();
        return found.filter_map(|(i, j)| Some((olds[i], news[j?]))).collect();
    }
    let likeness = |i: usize, j: usize| likeness(&old[olds[i]], &new[news[j]]);
    let alike: Vec<Vec<f64>> = (0..rows).map(|i| (0..columns).map(|j| likeness(i, j)).collect()).collect();
    // sums[i][j] is the most of the rests from i and j on.
    let mut sums = vec![vec![0.0_f64; columns + 1]; rows + 1];
    for i in (0..rows).rev() {
        for j in (0..columns).rev() {
            let pair = alike[i][j] + sums[i + 1][j + 1];
            sums[i][j] = pair.max(sums[i + 1][j]).max(sums[i][j + 1]);
        }
    }
    let (mut i, mut j) = (0, 0);
    let mut found = vec![];
    while i < rows && j < columns {
        if alike[i][j] > 0.0 && alike[i][j] + sums[i + 1][j + 1] >= sums[i][j] {
            found.push((olds[i], news[j]));
            (i, j) = (i + 1, j + 1);
        } else if sums[i + 1][j] >= sums[i][j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    found
}

/// How alike two values are: 1 where they say the same, 0 where one is not the other changed.
fn likeness(old: &Value, new: &Value) -> f64 {
    let share = match (&old.kind, &new.kind) {
        (Kind::Record(a), Kind::Record(b)) if shape(old) == shape(new) => {
            let share = alike_fields(&a.fields, &b.fields);
            let is_renamed = matches!((old.given_name(), new.given_name()), (Some(a), Some(b)) if a != b);
            if is_renamed && share < RENAMED {
                return 0.0;
            }
            share
        }
        // Another shape in the place of one: what they share has to speak for it.
        (Kind::Record(a), Kind::Record(b)) => return OF_ONE_KIND * shared(a, b),
        (Kind::Tuple(a), Kind::Tuple(b)) if a.len() == b.len() => {
            let same = a.iter().zip(b).filter(|(a, b)| a.says_the_same_as(b)).count();
            same as f64 / a.len().max(1) as f64
        }
        (a, b) if std::mem::discriminant(a) == std::mem::discriminant(b) => 0.0,
        _ => return 0.0,
    };
    OF_ONE_KIND + (1.0 - OF_ONE_KIND) * share
}

/// `Sphere` of `Sphere(radius: 1)`.
fn shape(value: &Value) -> Option<&str> {
    let Kind::Record(Record { name, .. }) = &value.kind else { return None };
    name.as_ref().map(|name| name.text.as_str())
}

/// The share of fields that both have and that say the same; names aside, which are no likeness.
fn alike_fields(old: &[Field], new: &[Field]) -> f64 {
    let counts = |field: &&Field| field.name.text != "name";
    let same = old.iter().filter(counts).filter(|field| {
        let other = new.iter().find(|other| other.name.text == field.name.text);
        other.is_some_and(|other| other.value.says_the_same_as(&field.value))
    });
    let same = same.count();
    let of = old.iter().filter(counts).count() + new.iter().filter(counts).count() - same;
    if of == 0 { 1.0 } else { same as f64 / of as f64 }
}

fn shared(old: &Record, new: &Record) -> f64 {
    let has_fields = !old.fields.is_empty() && !new.fields.is_empty();
    if has_fields { alike_fields(&old.fields, &new.fields) } else { 0.0 }
}
