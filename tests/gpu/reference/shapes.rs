//! The closed-form shapes of the scene language, with their fields and defaults.

use super::node::{Fields, Node};
use super::vector::Vec3;

#[derive(Clone, Debug)]
pub enum Shape {
    Sphere { center: Vec3, radius: f64 },
    Plane { normal: Vec3, offset: f64 },
    Box { min: Vec3, max: Vec3 },
    RoundedBox { min: Vec3, max: Vec3, radius: f64 },
    Cylinder { base: Vec3, top: Vec3, radius: f64 },
    Cone { base: Vec3, top: Vec3, base_radius: f64, top_radius: f64 },
    Capsule { base: Vec3, top: Vec3, radius: f64 },
    Torus { center: Vec3, axis: Vec3, major_radius: f64, minor_radius: f64 },
    Ellipsoid { center: Vec3, radii: Vec3 },
    Disk { center: Vec3, normal: Vec3, radius: f64, inner_radius: f64 },
    Triangle { a: Vec3, b: Vec3, c: Vec3 },
    Quad { corner: Vec3, u: Vec3, v: Vec3 },
    RoundedCone { base: Vec3, top: Vec3, base_radius: f64, top_radius: f64 },
    HexPrism { center: Vec3, axis: Vec3, radius: f64, height: f64 },
    RoundedCylinder { base: Vec3, top: Vec3, radius: f64, rounding: f64 },
    Wedge { min: Vec3, max: Vec3 },
    Pyramid { base: Vec3, top: Vec3, base_size: f64, top_size: f64 },
    Paraboloid { base: Vec3, top: Vec3, radius: f64 },
    Hyperboloid { base: Vec3, top: Vec3, end_radius: f64, waist_radius: f64 },
    Superellipsoid { center: Vec3, radii: Vec3, exponents: [f64; 2] },
}

impl Shape {
    /// Reads one shape without an object around it: `Torus(center: (0, 1, 0), major_radius: 1.0)`.
    pub fn parse(text: &str) -> Result<Shape, String> {
        let mut fields = Fields::of_call(Node::parse(text)?)?;
        let shape = Shape::read(&mut fields)?
            .ok_or_else(|| format!("the reference has no shape `{}`", fields.owner()))?;
        fields.finish()?;
        Ok(shape)
    }

    /// Takes the shape's own fields; nothing where the reference does not know its name.
    pub fn read(fields: &mut Fields) -> Result<Option<Shape>, String> {
        let (zero, one, y) = (Vec3::ZERO, Vec3::ONE, Vec3::Y);
        Ok(Some(match fields.owner() {
            "Sphere" => Shape::Sphere {
                center: fields.vector("center", zero)?,
                radius: fields.number("radius", 1.0)?,
            },
            "Plane" => {
                Shape::Plane { normal: fields.vector("normal", y)?, offset: fields.number("offset", 0.0)? }
            }
            "Box" => Shape::Box { min: fields.vector("min", -one)?, max: fields.vector("max", one)? },
            "RoundedBox" => Shape::RoundedBox {
                min: fields.vector("min", -one)?,
                max: fields.vector("max", one)?,
                radius: fields.number("radius", 0.1)?,
            },
            "Cylinder" => Shape::Cylinder {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                radius: fields.number("radius", 1.0)?,
            },
            "Cone" => Shape::Cone {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                base_radius: fields.number("base_radius", 1.0)?,
                top_radius: fields.number("top_radius", 0.0)?,
            },
            "Capsule" => Shape::Capsule {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                radius: fields.number("radius", 0.5)?,
            },
            "Torus" => Shape::Torus {
                center: fields.vector("center", zero)?,
                axis: fields.vector("axis", y)?.unit(),
                major_radius: fields.number("major_radius", 1.0)?,
                minor_radius: fields.number("minor_radius", 0.25)?,
            },
            "Ellipsoid" => Shape::Ellipsoid {
                center: fields.vector("center", zero)?,
                radii: fields.vector("radii", one)?,
            },
            "Disk" => Shape::Disk {
                center: fields.vector("center", zero)?,
                normal: fields.vector("normal", y)?.unit(),
                radius: fields.number("radius", 1.0)?,
                inner_radius: fields.number("inner_radius", 0.0)?,
            },
            "Triangle" => Shape::Triangle {
                a: fields.need_vector("a")?,
                b: fields.need_vector("b")?,
                c: fields.need_vector("c")?,
            },
            "Quad" => Shape::Quad {
                corner: fields.need_vector("corner")?,
                u: fields.need_vector("u")?,
                v: fields.need_vector("v")?,
            },
            "RoundedCone" => Shape::RoundedCone {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                base_radius: fields.number("base_radius", 0.5)?,
                top_radius: fields.number("top_radius", 0.25)?,
            },
            "HexPrism" => Shape::HexPrism {
                center: fields.vector("center", zero)?,
                axis: fields.vector("axis", y)?.unit(),
                radius: fields.number("radius", 1.0)?,
                height: fields.number("height", 1.0)?,
            },
            "RoundedCylinder" => Shape::RoundedCylinder {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                radius: fields.number("radius", 1.0)?,
                rounding: fields.number("rounding", 0.1)?,
            },
            "Wedge" => Shape::Wedge { min: fields.vector("min", -one)?, max: fields.vector("max", one)? },
            "Pyramid" => Shape::Pyramid {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                base_size: fields.number("base_size", 2.0)?,
                top_size: fields.number("top_size", 0.0)?,
            },
            "Paraboloid" => Shape::Paraboloid {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                radius: fields.number("radius", 1.0)?,
            },
            "Hyperboloid" => Shape::Hyperboloid {
                base: fields.vector("base", zero)?,
                top: fields.vector("top", y)?,
                end_radius: fields.number("end_radius", 1.0)?,
                waist_radius: fields.number("waist_radius", 0.5)?,
            },
            "Superellipsoid" => Shape::Superellipsoid {
                center: fields.vector("center", zero)?,
                radii: fields.vector("radii", one)?,
                exponents: [fields.number("east_west", 0.4)?, fields.number("north_south", 0.4)?],
            },
            _ => return Ok(None),
        }))
    }

    /// A point near the shape, about which intersections are computed.
    pub fn center(&self) -> Vec3 {
        match *self {
            Shape::Sphere { center, .. }
            | Shape::Torus { center, .. }
            | Shape::Ellipsoid { center, .. }
            | Shape::Disk { center, .. }
            | Shape::HexPrism { center, .. }
            | Shape::Superellipsoid { center, .. } => center,
            Shape::Plane { normal, offset } => normal * (offset / normal.dot(normal)),
            Shape::Box { min, max } | Shape::RoundedBox { min, max, .. } | Shape::Wedge { min, max } => {
                (min + max) * 0.5
            }
            Shape::Cylinder { base, top, .. }
            | Shape::Cone { base, top, .. }
            | Shape::Capsule { base, top, .. }
            | Shape::RoundedCone { base, top, .. }
            | Shape::RoundedCylinder { base, top, .. }
            | Shape::Pyramid { base, top, .. }
            | Shape::Paraboloid { base, top, .. }
            | Shape::Hyperboloid { base, top, .. } => (base + top) * 0.5,
            Shape::Triangle { a, b, c } => (a + b + c) * (1.0 / 3.0),
            Shape::Quad { corner, u, v } => corner + (u + v) * 0.5,
        }
    }
}
