//! The tables themselves, in the words and with the figures of LANGUAGE.md.

use super::{
    Choice, Field, Form, Group, LightForm, Takes, color, field, flag, limits, number, texture_or_color,
    vector, word,
};
use crate::ir::{CsgOperation, MAX_BOUNCES};

pub const SCENE: &[Field] = &[
    field("camera", Takes::Group(CAMERA), "position and direction of the camera"),
    texture_or_color("background", 0.0, "color of rays that leave the scene"),
    color("ambient", 0.1, "light from all directions, equal at all points"),
    field("lights", Takes::Lights, ""),
    field("textures", Takes::Textures, "names for textures, colors, and other names"),
    field("materials", Takes::Materials, "names for materials"),
    field("objects", Takes::Solids, "").required(),
    field("render", Takes::Group(RENDER), "settings of the picture"),
];

pub const CAMERA: &[Field] = &[
    vector("eye", Some([6.0, 4.0, 9.0]), "position of the camera"),
    vector("target", Some([0.0, 1.0, 0.0]), "point in the middle of the picture"),
    vector(
        "up",
        Some([0.0, 1.0, 0.0]),
        "direction that is up in the picture; must not be parallel to the view",
    ),
    number("fov_deg", 40.0, 0.1, 179.0, "the vertical angle of view").unit("degrees"),
];

pub const RENDER: &[Field] = &[
    number("max_bounces", 5.0, 0.0, MAX_BOUNCES as f32, "reflections and refractions in a row").whole(),
    flag("shadows", true, "`true`: lights cast shadows"),
    number("shadow_samples", 16.0, 1.0, 1024.0, "rays to each light that has a size, for each sample")
        .whole(),
    flag("texture_filter", true, "`true`: patterns blur details smaller than a pixel"),
    field("transfer", Takes::Choice(TRANSFERS), "the curve from light to the values of the picture"),
    number("exposure", 0.0, -40.0, 40.0, "makes the picture brighter or darker").unit("stops"),
    field("tone_map", Takes::Choice(TONE_MAPS), "shows light brighter than white; `None` clamps it"),
];

const TRANSFERS: &[Choice] =
    &[word("Srgb"), Choice { word: "Gamma", carries: Some(limits(Some(2.0), 0.1, 10.0)) }, word("Linear")];
const TONE_MAPS: &[Choice] = &[word("None"), word("Reinhard"), word("Aces"), word("Agx")];

/// What every light takes.
pub const EVERY_LIGHT: &[Field] =
    &[color("color", 1.0, ""), number("intensity", 1.0, 0.0, 1e6, "a factor of the color")];

pub const LIGHTS: &[(Group, LightForm)] = &[
    (
        Group {
            name: "Point",
            fields: &[POSITION, LIGHT_RADIUS, FALLOFF],
            example: "Point(position: (4, 6, 3))",
            doc: "light from a point, in all directions",
        },
        LightForm::Point,
    ),
    (
        Group {
            name: "Directional",
            fields: &[
                vector("direction", None, "direction in which the light travels"),
                number(
                    "angle_deg",
                    0.0,
                    0.0,
                    170.0,
                    "the full angle of the light in the sky: softens shadows",
                )
                .unit("degrees"),
            ],
            example: "Directional(direction: (-1, -2, -1))",
            doc: "light in one direction, as from the sun",
        },
        LightForm::Directional,
    ),
    (
        Group {
            name: "Spot",
            fields: &[
                POSITION,
                vector("target", Some([0.0; 3]), "point in the middle of the cone"),
                number("cone_deg", 30.0, 0.01, 179.0, "the full angle of the cone").unit("degrees"),
                number("blend", 0.1, 0.0, 1.0, "outer share of the cone in which the light fades"),
                LIGHT_RADIUS,
                FALLOFF,
            ],
            example: "Spot(position: (0, 5, 0))",
            doc: "light in a cone",
        },
        LightForm::Spot,
    ),
    (
        Group {
            name: "Rect",
            fields: &[
                vector("corner", None, "").point(),
                vector("u", None, "one side, from the corner"),
                vector("v", None, "the other side, from the corner"),
                FALLOFF,
            ],
            example: "Rect(corner: (-1, 5, -1), u: (2, 0, 0), v: (0, 0, 2))",
            doc: "light of a parallelogram, with soft shadows",
        },
        LightForm::Rect,
    ),
];

const POSITION: Field = vector("position", None, "position of the light").point();
const LIGHT_RADIUS: Field = number("radius", 0.0, 0.0, 1e6, "softens shadows");
const FALLOFF: Field = field(
    "falloff",
    Takes::Choice(&[word("None"), word("InverseSquare")]),
    "`InverseSquare`: weaker with the square of the distance, unchanged at 1 scene unit",
);

/// What every object and part takes.
pub const EVERY_SOLID: &[Field] = &[
    field("name", Takes::Name, "name of the object; no two objects have the same name"),
    field("material", Takes::Material, "material of the surface"),
    vector("translate", Some([0.0; 3]), "moves the object, after `scale` and `rotate_deg`"),
    vector("rotate_deg", Some([0.0; 3]), "turns it about x, then y, then z").unit("degrees"),
    field("scale", Takes::Scale, "a number or a vector; negative numbers mirror"),
];

/// What objects take that are no parts.
pub const EVERY_OBJECT: &[Field] = &[
    field("bounds", Takes::Group(BOUNDS), "a box around the object, in the object's own space"),
    flag("visible", true, "`false`: invisible, but it still casts a shadow"),
    flag("casts_shadow", true, ""),
];

pub const BOUNDS: &[Field] =
    &[vector("min", None, "the lowest corner"), vector("max", None, "the highest corner")];

const PARTS: &[Field] = &[field("parts", Takes::Solids, "shapes, or solids made of shapes").required()];

/// The solids that are made of others.
pub const OPERATIONS: &[(Group, CsgOperation)] = &[
    (
        Group {
            name: "Union",
            fields: PARTS,
            example: "Union(parts: [Box(), Sphere()])",
            doc: "everything inside any part, without inner surfaces",
        },
        CsgOperation::Union,
    ),
    (
        Group {
            name: "Intersection",
            fields: PARTS,
            example: "Intersection(parts: [Box(), Sphere()])",
            doc: "everything inside all parts",
        },
        CsgOperation::Intersection,
    ),
    (
        Group {
            name: "Difference",
            fields: PARTS,
            example: "Difference(parts: [Box(), Sphere(radius: 1.2)])",
            doc: "the first part without the others; cut surfaces have the material of the part that cuts",
        },
        CsgOperation::Difference,
    ),
];

pub const MATERIAL: &[Field] = &[
    texture_or_color("color", 0.8, ""),
    number("specular", 0.0, 0.0, 1e3, "strength of the highlight").varying(),
    number("shininess", 50.0, 0.0, 1e5, "sharpness of the highlight").varying(),
    number("reflectivity", 0.0, 0.0, 1.0, "share of light that is mirrored").varying(),
    field(
        "fresnel",
        Takes::Number(limits(None, 0.0, 100.0)),
        "exponent by which mirrors grow towards grazing angles",
    ),
    number("transmission", 0.0, 0.0, 1.0, "share of the rest that passes through").varying(),
    number("ior", 1.5, 0.01, 100.0, "index of refraction inside"),
    texture_or_color("emission", 0.0, "light that the surface emits; it does not light other objects"),
    field("bump", Takes::Group(BUMP), "tilts the normal by the slope of a height map"),
];

pub const BUMP: &[Field] = &[
    field("height", Takes::Number(limits(None, -1e6, 1e6)), "height in scene units, times `strength`")
        .varying()
        .required(),
    number("strength", 0.1, -1e3, 1e3, "a factor of the height"),
];

/// What every texture and mapping takes.
pub const EVERY_TEXTURE: &[Field] = &[field("at", Takes::Mapping, "mapping that moves the point first")];

/// The textures that no signature can say.
pub const FORMS: &[(Group, Form)] = &[
    (
        Group {
            name: "Ramp",
            fields: &[
                field("by", Takes::Number(limits(None, -1e6, 1e6)), "pattern that selects the color")
                    .varying()
                    .required(),
                field("stops", Takes::Stops, "at least two, from low to high").required(),
                field(
                    "interpolation",
                    Takes::Choice(&[word("Linear"), word("Smooth"), word("Constant")]),
                    "`Smooth` has no kinks at the stops, `Constant` keeps each color up to the next stop",
                ),
            ],
            example: r##"Ramp(by: Noise(), stops: [(0, "#000"), (1, "#fff")])"##,
            doc: "maps a pattern to the colors of its stops",
        },
        Form::Ramp,
    ),
    (
        Group {
            name: "Triplanar",
            fields: &[
                texture_or_color("of", 0.0, "texture to lay on").required(),
                number(
                    "sharpness",
                    4.0,
                    1.0,
                    64.0,
                    "larger numbers make the sides blend over a shorter distance",
                ),
            ],
            example: "Triplanar(of: Brick())",
            doc: "lays on a flat texture from three sides, for shapes without good uv",
        },
        Form::Triplanar,
    ),
    (
        Group {
            name: "Image",
            fields: &[
                field("file", Takes::File, "a PNG, JPEG, Radiance HDR or OpenEXR file beside the scene")
                    .required(),
                field(
                    "width",
                    Takes::Number(limits(None, 1e-4, 1e6)),
                    "in scene units; default 1, but balls, the sky and models with uv are covered once",
                ),
                flag("repeat", true, "`true`: repeats beyond its edges"),
                field(
                    "fit",
                    Takes::Choice(&[word("Auto"), word("Units"), word("Whole")]),
                    "`Units`: `width` wide, from uv = (0, 0) on; `Whole`: once over the whole surface",
                ),
                texture_or_color("under", 1.0, "color where the image is transparent"),
                field(
                    "encoding",
                    Takes::Choice(&[word("Auto"), word("Srgb"), word("Linear")]),
                    "`Linear`: unchanged numbers; `Auto` uses it for numbers, not for colors",
                ),
                field(
                    "channel",
                    Takes::Choice(&[
                        word("Color"),
                        word("Luminance"),
                        word("Red"),
                        word("Green"),
                        word("Blue"),
                        word("Alpha"),
                    ]),
                    "all choices except `Color` make it a pattern",
                ),
            ],
            example: r##"Image(file: "photo.png")"##,
            doc: "a picture from a file, placed by uv, or once around a ball, the sky or a model",
        },
        Form::Image,
    ),
];
