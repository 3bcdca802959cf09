//! Real roots of what a ray makes of a surface.

/// The roots of a·t² + 2·b·t + c, with the cancellation-free form for the smaller one
/// (Numerical Recipes 5.6).
pub fn quadratic(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - a * c;
    if discriminant.is_nan() || discriminant < 0.0 {
        return Vec::new();
    }
    let q = -(b + discriminant.sqrt().copysign(b));
    vec![q / a, c / q]
}

/// The roots of a polynomial (lowest power first) in (low, high) where it changes sign: between two
/// neighbouring roots of its derivative it is monotonic, so bisection finds the only one there.
pub fn polynomial(coefficients: &[f64], low: f64, high: f64) -> Vec<f64> {
    if coefficients.len() < 2 {
        return Vec::new();
    }
    let derivative: Vec<f64> =
        coefficients.iter().enumerate().skip(1).map(|(power, c)| power as f64 * c).collect();
    let mut marks = vec![low];
    marks.extend(polynomial(&derivative, low, high));
    marks.push(high);
    let value = |t: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c);
    marks.windows(2).filter_map(|span| sign_change(value, span[0], span[1])).collect()
}

/// The two crossings of a convex function in [low, high], around its minimum.
pub fn convex(f: impl Fn(f64) -> f64, low: f64, high: f64) -> Vec<f64> {
    let (mut a, mut b) = (low, high);
    for _ in 0..120 {
        let (left, right) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
        if f(left) < f(right) { b = right } else { a = left }
    }
    let lowest = 0.5 * (a + b);
    let spans = [(low, lowest), (lowest, high)];
    spans.into_iter().filter_map(|(a, b)| sign_change(&f, a, b)).collect()
}

/// Bisects to the last bit where f changes sign between a and b; a zero counts as positive.
fn sign_change(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> Option<f64> {
    let positive = f(a) >= 0.0;
    if positive == (f(b) >= 0.0) {
        return None;
    }
    loop {
        let middle = 0.5 * (a + b);
        if middle <= a || middle >= b {
            return Some(middle);
        }
        if (f(middle) >= 0.0) == positive { a = middle } else { b = middle }
    }
}
