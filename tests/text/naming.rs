//! Names in WGSL: one casing for each kind of thing, and none that the author's files have, too.

use std::collections::BTreeSet;

use naga::{Block, Function, Handle, Module, Statement};

use crate::common::{expect_compiled, expect_none, good_scenes, outcome, outcome_of};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

fn is_camel(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase()) && name.chars().all(|c| c.is_ascii_alphanumeric())
}

fn is_snake(name: &str) -> bool {
    let is_fit = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    // A matrix of the field is called by one capital.
    (name.starts_with(|c: char| c.is_ascii_lowercase()) && name.chars().all(is_fit)) || name.len() == 1
}

fn is_upper(name: &str) -> bool {
    name.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_')
}

fn is_pascal(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_uppercase()) && name.chars().all(|c| c.is_ascii_alphanumeric())
}

/// The names of a module that are written otherwise than its kind is.
fn odd(module: &Module) -> Vec<String> {
    let mut odd = vec![];
    let mut expect = |kind: &str, name: Option<&String>, is_fit: fn(&str) -> bool| {
        odd.extend(name.filter(|name| !is_fit(name)).map(|name| format!("the {kind} {name}")));
    };
    for (_, ty) in module.types.iter() {
        expect("type", ty.name.as_ref(), is_pascal);
        if let naga::TypeInner::Struct { members, .. } = &ty.inner {
            members.iter().for_each(|member| expect("field", member.name.as_ref(), is_snake));
        }
    }
    module.constants.iter().for_each(|(_, constant)| expect("constant", constant.name.as_ref(), is_upper));
    module.global_variables.iter().for_each(|(_, own)| expect("variable", own.name.as_ref(), is_snake));
    let entries = module.entry_points.iter().map(|entry| &entry.function);
    for function in module.functions.iter().map(|(_, function)| function).chain(entries) {
        expect("function", function.name.as_ref(), is_camel);
        function.arguments.iter().for_each(|own| expect("parameter", own.name.as_ref(), is_snake));
        function.local_variables.iter().for_each(|(_, own)| expect("variable", own.name.as_ref(), is_snake));
        function.named_expressions.values().for_each(|own| expect("variable", Some(own), is_snake));
    }
    odd.sort();
    odd.dedup();
    odd
}

#[test]
fn each_kind_of_thing_has_one_casing() {
    let mut all: Vec<String> = good_scenes()
        .iter()
        .flat_map(|scene| odd(expect_compiled(outcome(scene, Mode::Live)).module.naga()))
        .collect();
    all.sort();
    all.dedup();
    expect_none(all);
}

#[test]
fn objects_may_have_the_names_of_functions() {
    for name in ["sphere", "nearer", "surfaceAt", "hit", "fn", "sphere crossing", "noise"] {
        let scene = format!(
            "(materials: {{ \"{name}\": (color: Noise()) }}, objects: [Sphere(name: \"{name}\", rotate_deg: (9, 0, 0), \
             material: \"{name}\"), Union(name: \"{name} 2\", parts: [Plane(name: \"{name} 3\"), Sphere(name: \"x{name}\")])])"
        );
        expect_compiled(outcome_of("a.ron", &scene, Mode::Baked));
    }
}

#[test]
fn files_may_have_the_names_that_objects_get() {
    let scene = "(materials: { \"rust\": (color: RustMaterial(), specular: BallCrossing()) }, \
                 objects: [Sphere(name: \"ball\", material: \"rust\")])";
    let texture =
        |name: &str| format!("/// A test.\nfn {name}(at: Surface) -> f32 {{\n    return at.uv.x;\n}}\n");
    let sources = Sources::in_memory()
        .with("a.ron", scene)
        .with("textures/rust_material.wgsl", &texture("rustMaterial"))
        .with("textures/ball_crossing.wgsl", &texture("ballCrossing"));
    let text = expect_compiled(raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None)).source;
    assert!(text.generated().contains("fn rustMaterial2(at: Surface)"), "{}", text.generated());
    assert!(text.generated().contains("fn ballCrossing2(ray: Ray)"), "{}", text.generated());
}

#[test]
fn a_scene_of_one_sphere_has_nothing_that_it_does_not_use() {
    let full = expect_compiled(outcome_of("a.ron", "(objects: [Sphere()])", Mode::Baked));
    let plain = full.plain().expect("it is the same scene");
    for module in [full.module.naga(), plain.module.naga()] {
        let mut called = vec![];
        module.entry_points.iter().for_each(|entry| calls(&entry.function.body, &mut called));
        let mut reached = BTreeSet::new();
        while let Some(function) = called.pop() {
            if reached.insert(function) {
                calls(&module.functions[function].body, &mut called);
            }
        }
        let unused = module.functions.iter().filter(|(function, _)| !reached.contains(function));
        expect_none(unused.map(|(_, function)| function.name.clone().unwrap_or_default()));
    }
}

/// Adds the functions that `block` calls.
fn calls(block: &Block, found: &mut Vec<Handle<Function>>) {
    for statement in block {
        match statement {
            Statement::Call { function, .. } => found.push(*function),
            Statement::Block(inner) => calls(inner, found),
            Statement::If { accept, reject, .. } => {
                [accept, reject].iter().for_each(|inner| calls(inner, found));
            }
            Statement::Switch { cases, .. } => cases.iter().for_each(|case| calls(&case.body, found)),
            Statement::Loop { body, continuing, .. } => {
                [body, continuing].iter().for_each(|inner| calls(inner, found));
            }
            _ => {}
        }
    }
}
