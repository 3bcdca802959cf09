//! Parts of pages that open without a network: the page itself, pictures beside each other, diffs, numbers.

mod embed;

use self::embed::{AMPLIFIED, amplified, data_url};
use super::{Hunk, PictureDifference};
use crate::judge::{Limits, Verdict};

/// A page.
#[derive(Clone, Copy, Debug)]
pub struct Page<'a> {
    pub title: &'a str,
    /// `good`, `bad`, or nothing where it is neither.
    pub state: &'a str,
    /// What there is to say first.
    pub heading: &'a str,
    /// Where it comes from.
    pub origin: &'a str,
    /// HTML; the other fields are text.
    pub body: &'a str,
}

impl Page<'_> {
    pub fn text(&self) -> String {
        format!(
            include_str!("page.html"),
            title = escaped(self.title),
            style = include_str!("page.css"),
            state = self.state,
            heading = escaped(self.heading),
            origin = escaped(self.origin),
            version = env!("CARGO_PKG_VERSION"),
            body = self.body,
        )
    }
}

/// The first line as a headline, and the others as a list.
pub fn told(lines: &[String]) -> String {
    let (first, rest) = lines.split_first().expect("there is something to tell");
    let rest: String = rest.iter().map(|line| format!("<li>{}</li>\n", escaped(line))).collect();
    let rest = if rest.is_empty() { rest } else { format!("<ul>\n{rest}</ul>\n") };
    format!("<h3>{}</h3>\n{rest}", escaped(first))
}

/// Both pictures, called by `names`: over each other with a slider, beside each other, and what differs.
pub fn pictures(difference: &PictureDifference, names: [&str; 2]) -> String {
    let PictureDifference { expected, actual, .. } = difference;
    let [left, right] = names.map(escaped);
    let [before, after] = [data_url(expected), data_url(actual)];
    let between = data_url(&amplified(expected, actual));
    let (width, height) = expected.dimensions();
    let image = |url: &str, what: &str| {
        format!("<img src=\"{url}\" width=\"{width}\" height=\"{height}\" alt=\"{what}\">")
    };
    let figure = |url: &str, what: &str| {
        format!("<figure>{}<figcaption>{what}</figcaption></figure>\n", image(url, what))
    };
    format!(
        "<div class=\"pictures\">\n<figure class=\"slider\"><div class=\"pair\">{}{}</div>\
         <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"{left} to {right}\" \
         oninput=\"this.parentElement.style.setProperty('--at', this.value + '%')\">\
         <figcaption>{left} on the left of the line, {right} on the right: drag</figcaption></figure>\n\
         {}{}{}</div>\n",
        image(&before, &left),
        image(&after, &right),
        figure(&before, &left),
        figure(&after, &right),
        figure(&between, &format!("difference, {AMPLIFIED} times as strong")),
    )
}

/// What was measured, as a table.
pub fn numbers(verdict: &Verdict) -> String {
    let Limits { tolerance, outliers, structure, window, flip } = verdict.limits;
    let broken = verdict.broken();
    let row = |what: &str, broken_one, measured: String, limit: String| {
        let class = if broken.contains(&broken_one) { " class=\"off\"" } else { "" };
        format!("<tr{class}><td>{what}</td><td>{measured}</td><td>{limit}</td></tr>\n")
    };
    use crate::judge::Broken::{Flip, Outliers, Structure, Window};
    let percent = |share: f64| format!("{:.3} %", share * 100.0);
    let rows = [
        row(
            &format!("pixels off by more than {tolerance} of 255"),
            Outliers,
            percent(verdict.outliers.share()),
            format!("at most {}", percent(outliers)),
        ),
        row(
            "structural similarity, mean",
            Structure,
            format!("{:.5}", verdict.structure.mean),
            format!("at least {structure}"),
        ),
        row(
            "structural similarity, worst 8x8 window",
            Window,
            format!("{:.4}", verdict.structure.least),
            format!("at least {window}"),
        ),
        row("FLIP, mean", Flip, format!("{:.6}", verdict.flip), format!("at most {flip}")),
    ];
    let rows = rows.concat();
    format!(
        "<table class=\"numbers\">\n<tr><th>measure</th><th>is</th><th>may be</th></tr>\n{rows}</table>\n"
    )
}

/// As in a unified diff.
pub fn hunks(hunks: &[Hunk]) -> String {
    let mut text = String::from("<pre class=\"diff\">");
    for hunk in hunks {
        text += &format!("<span class=\"head\">{}</span>\n", escaped(&hunk.head()));
        for (sign, line) in &hunk.lines {
            let line = escaped(&format!("{sign}{line}"));
            text += &match sign {
                '-' => format!("<del>{line}</del>\n"),
                '+' => format!("<ins>{line}</ins>\n"),
                _ => format!("{line}\n"),
            };
        }
    }
    text + "</pre>\n"
}

/// For XML and HTML, in text and in attributes; what XML cannot hold becomes a space.
pub fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            c if c.is_control() && !matches!(c, '\n' | '\t') => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}
