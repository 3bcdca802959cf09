//! A page that opens without a network: both pictures, the values, and the diff of the shaders.

use super::{count, lines, sight};
use crate::difference::SceneDifference;
use crate::difference::html::{Page, escaped, hunks, numbers, pictures, told};
use crate::scene::{Change, ChangeKind, Side};

/// The page of what differs.
pub fn page(difference: &SceneDifference) -> String {
    let [old, new] = &difference.names;
    let heading = format!("{old} → {new}");
    let adapter = difference.adapter.as_ref().map(|name| format!("Drawn by {name}."));
    let body = [picture(difference), values(difference), shader(difference)].concat();
    let page = Page {
        title: &format!("raytoy diff: {heading}"),
        state: "",
        heading: &heading,
        origin: &adapter.unwrap_or_default(),
        body: &body,
    };
    page.text()
}

fn picture(difference: &SceneDifference) -> String {
    let Some(picture) = &difference.picture else { return String::new() };
    let [old, new] = &difference.names;
    let parts = [told(&sight(picture)), pictures(picture, [old, new]), numbers(&picture.verdict)];
    section("Picture", &parts.concat())
}

fn values(difference: &SceneDifference) -> String {
    let head = told(&[count(difference.values.len())]);
    if difference.values.is_empty() {
        return section("Values", &head);
    }
    let rows: String = difference.values.iter().map(|change| row(change, &difference.names)).collect();
    let heads = "<tr><th>where</th><th>was</th><th>is</th><th>lines</th></tr>\n";
    section("Values", &format!("{head}<table>\n{heads}{rows}</table>\n"))
}

fn row(change: &Change, names: &[String; 2]) -> String {
    let cell = |side: &Option<Side>, mark: &str| {
        let Some(side) = side else { return "<td></td>".into() };
        let words = match change.kind {
            ChangeKind::Moved => side.path.to_string(),
            _ => side.words.clone(),
        };
        format!("<td><{mark}>{}</{mark}></td>", escaped(&words))
    };
    let [path, lines] = [change.path.to_string(), lines(change, names)].map(|text| escaped(&text));
    let (was, is) = (cell(&change.old, "del"), cell(&change.new, "ins"));
    format!("<tr><td><code>{path}</code></td>{was}{is}<td>{lines}</td></tr>\n")
}

fn shader(difference: &SceneDifference) -> String {
    let text = difference.shader.text.as_ref();
    let diff = text.map_or(String::new(), |text| hunks(&text.hunks));
    section("Shader", &(told(&difference.shader.told()) + &diff))
}

fn section(title: &str, body: &str) -> String {
    format!("<section>\n<h2>{title}</h2>\n{body}</section>\n")
}
