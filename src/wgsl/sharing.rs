//! Which named textures a function evaluates once, as drivers inline all calls and would evaluate each again.
//!
//! In: a point of the function. Out: the textures that become locals of it, and those whose text it holds so
//! that they can use these locals.

use std::collections::{BTreeMap, BTreeSet};

use crate::ir::points::Point;
use crate::ir::{Scene, Value};

/// What becomes of the textures that are evaluated at one point.
#[derive(Debug, Default)]
pub struct Sharing {
    /// Named more than once, so that the value is a local.
    pub locals: BTreeSet<usize>,
    /// Written out in place of a call: something in it is a local for others, too.
    pub opened: BTreeSet<usize>,
}

impl Sharing {
    pub fn at(point: &Point, scene: &Scene) -> Self {
        let uses = uses(point, scene);
        let locals: BTreeSet<usize> = uses
            .iter()
            .filter(|(index, users)| users.len() > 1 && !is_plain(&scene.textures[**index].value))
            .map(|(index, _)| *index)
            .collect();
        if locals.is_empty() {
            return Self::default();
        }
        // A texture stays a call where all that is shared below it is used below it alone, that is where it
        // dominates all that it reaches. A texture has a higher index than all that it names.
        let mut dominators: BTreeMap<usize, (usize, Option<usize>)> = BTreeMap::new();
        for (index, users) in uses.iter().rev() {
            let nearest = users.iter().copied().reduce(|a, b| common(a, b, &dominators)).flatten();
            let depth = nearest.map_or(0, |user| dominators[&user].0 + 1);
            dominators.insert(*index, (depth, nearest));
        }
        // How near to the function the nearest dominator of all below it is.
        let mut lowest: BTreeMap<usize, usize> = BTreeMap::new();
        for (index, users) in &uses {
            let (depth, _) = dominators[index];
            let below = lowest.get(index).copied().unwrap_or(usize::MAX);
            // What is a number or color has nothing to share.
            let own = if is_plain(&scene.textures[*index].value) { usize::MAX } else { depth };
            for user in users.iter().flatten() {
                let known = lowest.entry(*user).or_insert(usize::MAX);
                *known = (*known).min(own).min(below);
            }
        }
        let opens = |index: &usize| lowest.get(index).is_some_and(|low| *low <= dominators[index].0);
        Self { opened: uses.keys().copied().filter(opens).collect(), locals }
    }
}

/// Adds the textures whose functions are called for `point`.
pub fn called(point: &Point, scene: &Scene, found: &mut BTreeSet<usize>) {
    let sharing = Sharing::at(point, scene);
    let mut opened = BTreeSet::new();
    let mut open = point.named.clone();
    point.others.iter().for_each(|(_, other)| called(other, scene, found));
    while let Some(index) = open.pop() {
        let within = || Point::of([&scene.textures[index].value]);
        if !sharing.opened.contains(&index) {
            if found.insert(index) {
                called(&within(), scene, found);
            }
        } else if opened.insert(index) {
            let within = within();
            within.others.iter().for_each(|(_, other)| called(other, scene, found));
            open.extend(within.named);
        }
    }
}

/// The textures that are evaluated at `point`, and who names each: another of them or, None, the function
/// itself; once for each time.
fn uses(point: &Point, scene: &Scene) -> BTreeMap<usize, Vec<Option<usize>>> {
    let mut uses: BTreeMap<usize, Vec<Option<usize>>> = BTreeMap::new();
    let mut open: Vec<(Option<usize>, usize)> = point.named.iter().map(|index| (None, *index)).collect();
    while let Some((user, index)) = open.pop() {
        let users = uses.entry(index).or_default();
        users.push(user);
        if users.len() == 1 {
            let named = Point::of([&scene.textures[index].value]).named;
            open.extend(named.into_iter().map(|inner| (Some(index), inner)));
        }
    }
    uses
}

/// The nearest texture that dominates both, or None: the function itself.
fn common(
    a: Option<usize>,
    b: Option<usize>,
    dominators: &BTreeMap<usize, (usize, Option<usize>)>,
) -> Option<usize> {
    let (mut a, mut b) = (a, b);
    while a != b {
        let depth = |x: Option<usize>| x.map_or(0, |x| dominators[&x].0 + 1);
        if depth(a) >= depth(b) {
            a = a.and_then(|x| dominators[&x].1);
        } else {
            b = b.and_then(|x| dominators[&x].1);
        }
    }
    a
}

/// Whether there is nothing to evaluate.
fn is_plain(value: &Value) -> bool {
    match value {
        Value::Const(_) => true,
        Value::Grey(inner) | Value::Luminance(inner) => is_plain(inner),
        _ => false,
    }
}
