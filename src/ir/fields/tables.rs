//! The tables themselves, in the words and with the figures of LANGUAGE.md.

use super::{
    Choice, Field, Group, Takes, color, field, flag, limits, number, texture_or_color, vector, word,
};
use crate::ir::{CsgOperation, MAX_BOUNCES};

pub const SCENE: &[Field] = &[
    field("camera", Takes::Group(CAMERA), "where the picture is taken from"),
    texture_or_color("background", 0.0, "what a ray sees that leaves the scene"),
    color("ambient", 0.1, "light from everywhere, the same at all points"),
    field("lights", Takes::Lights, ""),
    field("textures", Takes::Textures, "names for textures, colors, and other names"),
    field("materials", Takes::Materials, "names for materials"),
    field("objects", Takes::Solids, "").required(),
    field("render", Takes::Group(RENDER), "how the picture is made"),
];

pub const CAMERA: &[Field] = &[
    vector("eye", Some([6.0, 4.0, 9.0]), "where the camera stands"),
    vector("target", Some([0.0, 1.0, 0.0]), "what is in the middle of the picture"),
    vector("up", Some([0.0, 1.0, 0.0]), "not along the view"),
    number("fov_deg", 40.0, 0.1, 179.0, "the vertical angle of view").unit("degrees"),
];

pub const RENDER: &[Field] = &[
    number("max_bounces", 5.0, 0.0, MAX_BOUNCES as f32, "reflections and refractions in a row").whole(),
    flag("shadows", true, "whether lights cast shadows"),
    number("shadow_samples", 16.0, 1.0, 1024.0, "rays to each light that has a size, for each sample")
        .whole(),
    flag("texture_filter", true, "patterns that can blur themselves over a pixel do"),
    field("transfer", Takes::Choice(TRANSFERS), "the curve from light to the values of the picture"),
    number("exposure", 0.0, -40.0, 40.0, "how much brighter or darker").unit("stops"),
    field("tone_map", Takes::Choice(TONE_MAPS), "how light that is too bright is shown; `None` clamps it"),
];

const TRANSFERS: &[Choice] =
    &[word("Srgb"), Choice { word: "Gamma", carries: Some(limits(Some(2.0), 0.1, 10.0)) }, word("Linear")];
const TONE_MAPS: &[Choice] = &[word("None"), word("Reinhard"), word("Aces"), word("Agx")];

/// What every light takes.
pub const EVERY_LIGHT: &[Field] =
    &[color("color", 1.0, ""), number("intensity", 1.0, 0.0, 1e6, "a factor of the color")];

pub const LIGHTS: &[Group] = &[
    Group {
        name: "Point",
        fields: &[POSITION, LIGHT_RADIUS, FALLOFF],
        example: "Point(position: (4, 6, 3))",
        doc: "light from a point, in all directions",
    },
    Group {
        name: "Directional",
        fields: &[
            vector("direction", None, "the way the light travels"),
            number(
                "angle_deg",
                0.0,
                0.0,
                170.0,
                "the full angle under which the light is seen: softens shadows",
            )
            .unit("degrees"),
        ],
        example: "Directional(direction: (-1, -2, -1))",
        doc: "light from afar, in one direction",
    },
    Group {
        name: "Spot",
        fields: &[
            POSITION,
            vector("target", Some([0.0; 3]), "what it points at"),
            number("cone_deg", 30.0, 0.01, 179.0, "the full angle of the cone").unit("degrees"),
            number("blend", 0.1, 0.0, 1.0, "the share of the cone, from the rim, in which the light fades"),
            LIGHT_RADIUS,
            FALLOFF,
        ],
        example: "Spot(position: (0, 5, 0))",
        doc: "light in a cone",
    },
    Group {
        name: "Rect",
        fields: &[
            vector("corner", None, "").point(),
            vector("u", None, "one side, from the corner"),
            vector("v", None, "the other side, from the corner"),
            FALLOFF,
        ],
        example: "Rect(corner: (-1, 5, -1), u: (2, 0, 0), v: (0, 0, 2))",
        doc: "light from the middle of a parallelogram, with its soft shadows",
    },
];

const POSITION: Field = vector("position", None, "where it is").point();
const LIGHT_RADIUS: Field = number("radius", 0.0, 0.0, 1e6, "softens shadows");
const FALLOFF: Field = field(
    "falloff",
    Takes::Choice(&[word("None"), word("InverseSquare")]),
    "`InverseSquare`: weaker by the square of the distance, the same at 1 scene unit",
);

/// What every object and part takes.
pub const EVERY_SOLID: &[Field] = &[
    field("name", Takes::Name, "no two objects share one"),
    field("material", Takes::Material, "what the surface looks like"),
    vector("translate", Some([0.0; 3]), "where it is moved to, last"),
    vector("rotate_deg", Some([0.0; 3]), "turns it about x, then y, then z").unit("degrees"),
    field("scale", Takes::Scale, "a number or a vector; negative ones mirror"),
];

/// What objects take that are no parts.
pub const EVERY_OBJECT: &[Field] = &[
    field("bounds", Takes::Group(BOUNDS), "a box, in the object's own space, that holds all of it"),
    flag("visible", true, "`false`: no ray sees it, but it casts its shadow"),
    flag("casts_shadow", true, ""),
];

pub const BOUNDS: &[Field] =
    &[vector("min", None, "the lowest corner"), vector("max", None, "the highest corner")];

const PARTS: &[Field] = &[field("parts", Takes::Solids, "shapes, or again solids made of them").required()];

/// The solids that are made of others.
pub const OPERATIONS: &[(Group, CsgOperation)] = &[
    (
        Group {
            name: "Union",
            fields: PARTS,
            example: "Union(parts: [Box(), Sphere()])",
            doc: "what lies in any part: no surface inside",
        },
        CsgOperation::Union,
    ),
    (
        Group {
            name: "Intersection",
            fields: PARTS,
            example: "Intersection(parts: [Box(), Sphere()])",
            doc: "what lies in every part",
        },
        CsgOperation::Intersection,
    ),
    (
        Group {
            name: "Difference",
            fields: PARTS,
            example: "Difference(parts: [Box(), Sphere(radius: 1.2)])",
            doc: "what lies in the first part and in none of the others, whose surfaces show where they cut",
        },
        CsgOperation::Difference,
    ),
];

pub const MATERIAL: &[Field] = &[
    texture_or_color("color", 0.8, ""),
    number("specular", 0.0, 0.0, 1e3, "strength of the highlight").varying(),
    number("shininess", 50.0, 0.0, 1e5, "sharpness of the highlight").varying(),
    number("reflectivity", 0.0, 0.0, 1.0, "share that is mirrored").varying(),
    field(
        "fresnel",
        Takes::Number(limits(None, 0.0, 100.0)),
        "exponent by which mirrors grow towards grazing angles",
    ),
    number("transmission", 0.0, 0.0, 1.0, "share of the rest that passes through").varying(),
    number("ior", 1.5, 0.01, 100.0, "index of refraction inside"),
    texture_or_color("emission", 0.0, "light of its own; it does not light other objects"),
    field("bump", Takes::Group(BUMP), "tilts the normal by the slope of a height over the surface"),
];

pub const BUMP: &[Field] = &[
    field("height", Takes::Number(limits(None, -1e6, 1e6)), "in scene units, times the strength")
        .varying()
        .required(),
    number("strength", 0.1, -1e3, 1e3, "a factor of the height"),
];

/// What every texture and mapping takes.
pub const EVERY_TEXTURE: &[Field] = &[field("at", Takes::Mapping, "moves the point first")];

/// The textures that no signature can say.
pub const FORMS: &[Group] = &[
    Group {
        name: "Ramp",
        fields: &[
            field("by", Takes::Number(limits(None, -1e6, 1e6)), "the pattern that it goes by")
                .varying()
                .required(),
            field("stops", Takes::Stops, "two or more, from low to high").required(),
            field(
                "interpolation",
                Takes::Choice(&[word("Linear"), word("Smooth"), word("Constant")]),
                "`Smooth` is level at each stop, `Constant` each stop as it is, up to the next",
            ),
        ],
        example: r##"Ramp(by: Noise(), stops: [(0, "#000"), (1, "#fff")])"##,
        doc: "the colors of its stops, by a pattern",
    },
    Group {
        name: "Triplanar",
        fields: &[
            texture_or_color("of", 0.0, "the texture that is laid on").required(),
            number("sharpness", 4.0, 1.0, 64.0, "how soon one side gives way to the next"),
        ],
        example: "Triplanar(of: Brick())",
        doc: "a flat texture laid on from three sides, for shapes that cannot be unrolled",
    },
    Group {
        name: "Image",
        fields: &[
            field("file", Takes::File, "a PNG, JPEG, Radiance HDR or OpenEXR file beside the scene")
                .required(),
            field(
                "width",
                Takes::Number(limits(None, 1e-4, 1e6)),
                "scene units; left out, it is 1, but covers balls, the sky and models with uv once",
            ),
            flag("repeat", true, "whether it begins again beyond its edges"),
            field(
                "fit",
                Takes::Choice(&[word("Auto"), word("Units"), word("Whole")]),
                "`Units`: `width` wide, from uv = (0, 0) on; `Whole`: once over the whole surface",
            ),
            texture_or_color("under", 1.0, "what is seen where the image is clear"),
            field(
                "encoding",
                Takes::Choice(&[word("Auto"), word("Srgb"), word("Linear")]),
                "`Linear`: numbers as they are, which `Auto` takes where a number is wanted",
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
                "all but `Color` make it a pattern",
            ),
        ],
        example: r##"Image(file: "photo.png")"##,
        doc: "a picture from a file, on uv or once over a ball, the sky or a model",
    },
];
