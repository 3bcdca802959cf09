//! The outline of a scene agrees with what the resolver makes of it: names, places, limits, defaults, choices.

use crate::common;
use std::path::Path as File;

use crate::common::{expect_none, files, good_scenes, outcome, read, root};
use raytoy::diagnostic::Diagnostic;
use raytoy::edit::{Edit, NewValue};
use raytoy::ir::fields::{FORMS, LIGHTS, OPERATIONS};
use raytoy::ir::{Property, Scene, Value as Resolved, resolve};
use raytoy::library::{Const, Family, Library};
use raytoy::outline::{Control, Field, Node, NodeKind, Outline, Role, becoming, example, outline};
use raytoy::scene::{Path, parse};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

/// A scene with one of all that has fields which no WGSL file declares, and with next to none of them written.
const BARE: &str = r##"(
    camera: (),
    lights: [
        Point(position: (4, 6, 3)), Directional(direction: (0, -1, 0)), Spot(position: (0, 5, 0)),
        Rect(corner: (-1, 5, -1), u: (2, 0, 0), v: (0, 0, 2)),
    ],
    textures: { "ramp": Ramp(by: 0.5, stops: [(0, "#000"), (1, "#fff")]), "sides": Triplanar(of: "#123") },
    materials: { "plain": () },
    objects: [
        Sphere(name: "ball", material: (bump: (height: 0.5)), bounds: (min: (-1, -1, -1), max: (1, 1, 1))),
        Difference(parts: [Box(), Gyroid()]),
    ],
    render: (),
)"##;

fn outline_of(text: &str, folder: &str) -> Outline {
    let sources = Sources::on_disk(&root());
    let library = Library::new(&sources, &root().join(folder));
    let value = parse("scene.ron", text).unwrap_or_else(|problems| panic!("{problems:?}\n{text}"));
    outline(&value, text, &library)
}

fn resolved(text: &str) -> Result<Scene, Vec<Diagnostic>> {
    let sources = Sources::in_memory();
    let library = Library::new(&sources, File::new(""));
    let value = parse("scene.ron", text)?;
    let (mut scene, _) = resolve("scene.ron", text, &value, &library)?;
    // The author's words are not what they mean.
    scene.lights.iter_mut().for_each(|light| light.caption.clear());
    scene.primitives.iter_mut().for_each(|primitive| primitive.caption.clear());
    scene.materials.iter_mut().for_each(|material| material.caption.clear());
    scene.textures.iter_mut().for_each(|texture| texture.caption.clear());
    scene.objects.iter_mut().for_each(|object| {
        if let raytoy::ir::Solid::Csg(csg) = &mut object.solid {
            csg.caption.clear();
        }
    });
    Ok(scene)
}

/// All fields, each before those inside of it.
fn all_fields(outline: &Outline) -> Vec<&Field> {
    fn collect<'f>(field: &'f Field, all: &mut Vec<&'f Field>) {
        all.push(field);
        field.fields().into_iter().for_each(|inner| collect(inner, all));
    }
    let mut all = vec![];
    for node in outline.all_nodes() {
        node.fields.iter().for_each(|field| collect(field, &mut all));
    }
    all
}

/// What makes the control show its default.
fn default(control: &Control) -> Option<NewValue> {
    match control {
        Control::Number { default, .. } => default.map(NewValue::Number),
        Control::Vector { default, .. } => default.clone().map(NewValue::Vector),
        Control::Color { default, .. } => default.map(NewValue::Color),
        Control::Flag { default, .. } => default.map(NewValue::Flag),
        Control::Choice { words, default, .. } => default.map(|i| NewValue::Word(words[i].clone())),
        _ => None,
    }
}

fn with(text: &str, path: &Path, value: NewValue) -> String {
    let edit = Edit::Set { path: path.clone(), value };
    edit.on(text).unwrap_or_else(|refusal| panic!("{refusal}\n{text}")).apply(text)
}

#[test]
fn objects_have_the_names_and_numbers_of_the_resolved_scene() {
    for name in good_scenes() {
        let compiled = common::expect_compiled(outcome(&name, Mode::Baked));
        let folder = File::new(&name).parent().unwrap().to_string_lossy().into_owned();
        let outline = outline_of(&read(&name), &folder);
        for (i, object) in compiled.scene.primitives.iter().enumerate() {
            let node = outline.object(i).unwrap_or_else(|| panic!("{name}: no node of {}", object.name));
            assert_eq!((&node.label, node.kind), (&object.name, NodeKind::Object), "{name}");
        }
        assert_eq!(outline.object(compiled.scene.primitives.len()), None, "{name}");
        let lights = outline.all_nodes().into_iter().filter(|node| node.kind == NodeKind::Light);
        assert_eq!(lights.count(), compiled.scene.lights.len(), "{name}");
    }
}

#[test]
fn paths_and_spans_lead_to_what_was_written_and_all_of_it_is_clear() {
    for name in good_scenes() {
        let text = read(&name);
        let folder = File::new(&name).parent().unwrap().to_string_lossy().into_owned();
        let value = parse(&name, &text).unwrap();
        let outline = outline_of(&text, &folder);
        for field in all_fields(&outline) {
            let written = value.at(&field.path).map(|value| value.span.clone());
            assert_eq!(field.span, written, "{name}: {}", field.path);
            let is_clear = !matches!(field.control, Control::Unclear { .. });
            assert!(is_clear, "{name}: {}: {:?}", field.path, field.control);
        }
        for node in outline.all_nodes() {
            let found = node.span.as_ref().and_then(|span| outline.node_at(span.start));
            let starts = |other: &Node| other.span.as_ref().map(|span| span.start);
            assert_eq!(found.and_then(starts), starts(node), "{name}: {}", node.path);
        }
    }
}

#[test]
fn scenes_with_mistakes_have_an_outline_too() {
    let mut unclear = 0;
    for name in files("tests/cases/errors", "ron") {
        let text = read(&name);
        if parse(&name, &text).is_ok() {
            let outline = outline_of(&text, "tests/cases/errors");
            let fields = all_fields(&outline);
            unclear += fields.iter().filter(|f| matches!(f.control, Control::Unclear { .. })).count();
        }
    }
    assert!(unclear > 5, "only {unclear} values are told to be no values");
}

#[test]
fn leaving_a_field_out_means_its_default() {
    let bare = resolved(BARE).unwrap();
    let outline = outline_of(BARE, "");
    let needs_others: Vec<&Field> = all_fields(&outline)
        .into_iter()
        .filter(|field| field.span.is_none() && field.fields().iter().any(|inner| inner.is_required))
        .collect();
    let mut checked = 0;
    for field in all_fields(&outline) {
        let Some(value) = default(&field.control).filter(|_| field.span.is_none()) else { continue };
        // `strength` alone makes no bump.
        if needs_others.iter().any(|group| field.path.0.starts_with(&group.path.0)) {
            continue;
        }
        let text = with(BARE, &field.path, value);
        let mut scene = resolved(&text).unwrap_or_else(|problems| panic!("{}: {problems:?}", field.path));
        checked += 1;
        // A part's own material differs from that of the whole, and an object that is moved by nothing is moved.
        if field.path.to_string().contains(".material.") || field.path.to_string().starts_with("materials") {
            let sets = scene.materials.iter().flat_map(|material| &material.properties);
            let sets: Vec<_> = sets.cloned().collect();
            match sets.as_slice() {
                [] => assert!(field.path.to_string().ends_with("bump.strength"), "{}", field.path),
                [(property, set)] => assert_eq!(*set, matte(*property), "{}", field.path),
                more => panic!("{}: {more:?}", field.path),
            }
            continue;
        }
        if ["translate", "rotate_deg", "scale"].contains(&field.label.as_str()) {
            let identity = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
            let is_unmoved = |space: &mut Option<_>| *space = space.take().filter(|s| *s != identity);
            scene.primitives.iter_mut().for_each(|object| is_unmoved(&mut object.space));
            scene.objects.iter_mut().for_each(|object| is_unmoved(&mut object.space));
        }
        assert_eq!(scene, bare, "{} is not as if left out", field.path);
    }
    assert!(checked > 80, "only {checked} defaults");
}

/// What the shader holds a property to be that nobody sets.
fn matte(property: Property) -> Resolved {
    let shader = read("shaders/material.wgsl");
    let between = |from: &str, to: &str| {
        let start = shader.find(from).unwrap() + from.len();
        shader[start..start + shader[start..].find(to).unwrap()].to_owned()
    };
    let members = between("struct Material {", "}");
    let members = members.lines().filter_map(|line| Some(line.trim().split_once(": ")?.0.to_owned()));
    let members: Vec<String> = members.filter(|name| !name.starts_with("///")).collect();
    let values = between("return Material(color, ", ");").replace("vec3f(0.0)", "0.0");
    let values: Vec<&str> = ["0.8"].into_iter().chain(values.split(", ")).collect();
    let name = format!("{property:?}").to_lowercase();
    let at = members.iter().position(|member| *member == name).unwrap();
    let x = values[at].parse().unwrap();
    match property {
        Property::Color | Property::Emission => Resolved::Const(Const::Vec3(glam::Vec3::splat(x))),
        _ => Resolved::Const(Const::F32(x)),
    }
}

#[test]
fn limits_are_those_of_the_resolver() {
    let outline = outline_of(BARE, "");
    let mut checked = 0;
    for field in all_fields(&outline) {
        let Control::Number { range: Some((low, high)), .. } = field.control else { continue };
        for (x, is_within) in [(low, true), (high, true), (low.next_down(), false), (high.next_up(), false)] {
            let text = with(BARE, &field.path, NewValue::Number(x));
            let problems = resolved(&text).err().unwrap_or_default();
            let is_refused = problems.iter().any(|p| p.message.contains("out of range"));
            assert_eq!(is_refused, !is_within, "{} = {x}: {problems:?}", field.path);
            checked += 1;
        }
    }
    assert!(checked > 150, "only {checked} limits");
}

#[test]
fn all_choices_resolve_and_other_words_do_not() {
    let outline = outline_of(BARE, "");
    let mut checked = 0;
    for field in all_fields(&outline) {
        let Control::Choice { words, .. } = &field.control else { continue };
        for word in words {
            let text = with(BARE, &field.path, NewValue::Word(word.clone()));
            assert_eq!(resolved(&text).err(), None, "{} = {word}", field.path);
            let again =
                all_fields(&outline_of(&text, "")).into_iter().find(|f| f.path == field.path).cloned();
            let Control::Choice { words, current, .. } = again.unwrap().control else { panic!("{word}") };
            assert_eq!(current.map(|i| &words[i]), Some(word));
            checked += 1;
        }
        let text = with(BARE, &field.path, NewValue::Word("Nonsense".into()));
        assert!(resolved(&text).is_err(), "{} = Nonsense", field.path);
    }
    assert!(checked > 12, "only {checked} words");
}

#[test]
fn each_group_refuses_what_its_table_does_not_list() {
    let outline = outline_of(BARE, "");
    let is_group =
        |node: &&Node| node.kind == NodeKind::Camera || node.kind == NodeKind::Render || node.span.is_some();
    let nodes = outline.all_nodes().into_iter().filter(is_group);
    let groups =
        nodes.filter(|node| !node.fields.is_empty() && node.kind != NodeKind::Texture).map(|n| &n.path);
    let inner = all_fields(&outline)
        .into_iter()
        .filter(|f| matches!(f.control, Control::Group { .. } | Control::Texture { name: Some(_), .. }));
    let mut checked = 0;
    for path in groups.chain(inner.map(|field| &field.path)) {
        let edit = Edit::Set { path: path.field("nonsense"), value: NewValue::Number(1.0) };
        let Ok(change) = edit.on(BARE) else { continue };
        let problems = resolved(&change.apply(BARE)).expect_err(&path.to_string());
        let is_told = problems.iter().any(|p| p.message.ends_with("has no field `nonsense`"));
        assert!(is_told, "{path}: {problems:?}");
        checked += 1;
    }
    assert!(checked > 14, "only {checked} groups");
}

#[test]
fn an_example_of_each_name_resolves() {
    let sources = Sources::in_memory();
    let library = Library::new(&sources, File::new(""));
    let written = |role: Role, name: &str| {
        example(role, name, &library).unwrap_or_else(|| panic!("no example of {name}"))
    };
    let lights = LIGHTS
        .iter()
        .map(|(light, _)| format!("(lights: [{}], objects: [Box()])", written(Role::Light, light.name)));
    let operations = OPERATIONS.iter().map(|(group, _)| group.name.to_owned());
    let shapes = library.names(Family::Shape).into_iter().chain(operations);
    // Models and images need a file, which is not there.
    let shapes = shapes
        .filter(|name| name != "Mesh")
        .map(|name| format!("(objects: [{}])", written(Role::Solid, &name)));
    let forms = FORMS.iter().map(|(form, _)| form.name.to_owned()).filter(|name| name != "Image");
    let textures = library.names(Family::Texture).into_iter().chain(forms).map(|name| {
        let is_mapping = library.find(Family::Texture, &name).is_ok_and(|f| f.kind.noun() == "mapping");
        let call = written(Role::Texture, &name);
        let call = if is_mapping { format!("Noise(at: {call})") } else { call };
        format!("(background: {call}, objects: [Box()])")
    });
    expect_none(
        lights
            .chain(shapes)
            .chain(textures)
            .filter_map(|text| resolved(&text).err().map(|problems| format!("{text}: {problems:?}"))),
    );
    for role in [Role::Light, Role::Solid, Role::Texture] {
        assert_eq!(example(role, "Nonsense", &library), None);
    }
}

#[test]
fn the_fields_of_a_name_are_those_that_its_things_have() {
    let sources = Sources::in_memory();
    let library = Library::new(&sources, File::new(""));
    let shapes = library.names(Family::Shape).into_iter();
    let solids = shapes.chain(OPERATIONS.iter().map(|(group, _)| group.name.to_owned()));
    let solids = solids.map(|name| (Role::Solid, "objects", name));
    let lights = LIGHTS.iter().map(|(light, _)| (Role::Light, "lights", light.name.to_owned()));
    expect_none(solids.chain(lights).filter_map(|(role, list, name)| {
        let item = example(role, &name, &library).unwrap_or_else(|| panic!("no example of {name}"));
        let outline = outline_of(&format!("({list}: [{item}])"), "");
        let node = outline.all_nodes().into_iter().find(|node| node.path.to_string() == format!("{list}[0]"));
        let shown: Vec<String> = node?.fields.iter().map(|field| field.label.clone()).collect();
        let mut told = becoming(role, "Nonsense", &[], &name, &library).order;
        // For parts, there are nodes of their own.
        told.retain(|field| field != "parts");
        (shown != told).then(|| format!("{name}: {shown:?}, and not {told:?}"))
    }));
}

#[test]
fn the_outline_of_a_scene_reads_so() {
    let text = r##"(
    lights: [Spot(position: (0, 5, 0), intensity: 2)],
    textures: { "tiles": Checker(odd: "tomato") },
    objects: [
        Union(name: "both", parts: [Sphere(radius: 2), Disk()]),
        Box(material: (color: "tiles", specular: Wave(shape: Saw), fresnel: None), scale: (1, 2, 1)),
    ],
    render: (transfer: Gamma(2.2), max_bounces: "many"),
)"##;
    let outline = outline_of(text, "");
    let mut lines = String::new();
    for node in outline.all_nodes().into_iter().filter(|node| node.span.is_some()) {
        let object = node.object.map(|i| format!(" (object {i})")).unwrap_or_default();
        lines += &format!("{:?} {} at {}{object}\n", node.kind, node.label, node.path);
    }
    for field in all_fields(&outline).into_iter().filter(|field| field.span.is_some()) {
        let control = match &field.control {
            Control::Texture { name, .. } => format!("Texture {name:?}"),
            Control::Group { .. } => "Group".into(),
            Control::Choice { words, current, .. } => format!("Choice {:?}", current.map(|i| &words[i])),
            other => format!("{other:?}"),
        };
        lines += &format!("{} = {control}\n", field.path);
    }
    assert_eq!(lines, EXPECTED);
    let doc = |path: &str| {
        let field = all_fields(&outline).into_iter().find(|f| f.path.to_string() == path).unwrap();
        (field.doc.clone(), field.unit, field.is_required, field.calls.len() > 50, field.declared.len())
    };
    assert_eq!(
        doc("camera.fov_deg"),
        ("the vertical angle of view".into(), Some("degrees"), false, false, 0)
    );
    assert_eq!(doc("lights[0].position"), ("position of the light".into(), None, true, false, 0));
    assert_eq!(doc("textures[\"tiles\"].scale"), ("squares per scene unit".into(), None, false, true, 1),);
}

const EXPECTED: &str = r#"Lights lights at lights
Light Spot 0 at lights[0]
Textures textures at textures
Texture tiles at textures["tiles"]
Objects objects at objects
Csg both at objects[0]
Object both Sphere 0 at objects[0].parts[0] (object 0)
Object both Disk 1 at objects[0].parts[1] (object 1)
Object Box 1 at objects[1] (object 2)
Render render at render
lights[0].position = Vector { size: 3, value: Some([0.0, 5.0, 0.0]), default: None, range: None }
lights[0].intensity = Number { value: Some(2.0), default: Some(1.0), range: Some((0.0, 1000000.0)), is_whole: false }
textures["tiles"] = Texture Some("Checker")
textures["tiles"].odd = Color { value: Some(Vec3(1.0, 0.12477182, 0.06301002)), default: Some(Vec3(0.0409152, 0.05448028, 0.07618539)), style: Text }
objects[0].name = Text { value: "both" }
objects[0].parts[0].radius = Number { value: Some(2.0), default: Some(1.0), range: Some((1e-5, 100000.0)), is_whole: false }
objects[1].material = Group
objects[1].material.color = Reference { name: "tiles" }
objects[1].material.specular = Texture Some("Wave")
objects[1].material.specular.shape = Choice Some("Saw")
objects[1].material.fresnel = Number { value: None, default: None, range: Some((0.0, 100.0)), is_whole: false }
objects[1].scale = Vector { size: 3, value: Some([1.0, 2.0, 1.0]), default: Some([1.0, 1.0, 1.0]), range: None }
render.max_bounces = Unclear { words: "\"many\"" }
render.transfer = Choice Some("Gamma(2.0)")
render.transfer[0] = Number { value: Some(2.2), default: Some(2.0), range: Some((0.1, 10.0)), is_whole: false }
"#;
