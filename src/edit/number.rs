//! Numbers in the author's style.

/// From here on, and below one over it, a number is written with an exponent.
const LONG: f32 = 1e9;

/// `x` as a person writes it: the shortest decimal that reads back as the same f32, `2.0` for 2 where
/// `dotted`.
pub fn write(x: f32, dotted: bool) -> String {
    // Of the two zeros, one is enough.
    let x = if x == 0.0 { 0.0 } else { x };
    let is_long = x.abs() > LONG || (x != 0.0 && x.abs() < 1.0 / LONG);
    let shortest = if is_long { format!("{x:e}") } else { x.to_string() };
    // The scene is read as f64 and rounded from there, which can end next to x.
    let exact = if is_long { format!("{:e}", f64::from(x)) } else { f64::from(x).to_string() };
    let reads_back = shortest.parse::<f64>().is_ok_and(|read| read as f32 == x);
    let text = if reads_back { shortest } else { exact };
    if dotted && !is_long && !text.contains('.') { format!("{text}.0") } else { text }
}

/// `x` in place of `old`: with a fraction `.0` where `old` has one.
pub fn rewrite(old: &str, x: f32) -> String {
    write(x, old.contains('.'))
}
