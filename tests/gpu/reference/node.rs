//! RON text as a tree that keeps the names of calls, which `ron::Value` drops.

use std::collections::BTreeMap;
use std::fmt;

use ron::value::RawValue;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::vector::Vec3;

#[derive(Clone, Debug)]
pub enum Node {
    Number(f64),
    Text(String),
    /// A bare name: `None`, `Srgb`, `true`.
    Word(String),
    /// `(1, 2, 3)` or `[a, b]`.
    List(Vec<Node>),
    /// `(name: value)` or `{ "name": value }`.
    Map(BTreeMap<String, Node>),
    /// `Name(...)`: the name and what stands in its parentheses, a `Map` or a `List`.
    Call(String, Box<Node>),
}

impl Node {
    pub fn parse(text: &str) -> Result<Node, String> {
        let raw = RawValue::from_ron(text).map_err(|error| error.to_string())?;
        let text = raw.trim().get_ron();
        if text.starts_with(|c: char| c.is_alphabetic() || c == '_') {
            let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
            let (name, rest) = text.split_at(end);
            return Ok(match rest {
                "" => Node::Word(name.to_string()),
                rest => Node::Call(name.to_string(), Box::new(Node::parse(rest)?)),
            });
        }
        let mut deserializer = ron::Deserializer::from_str(text).map_err(|error| error.to_string())?;
        deserializer.deserialize_any(Plain).map_err(|error| format!("{error} in {text:.60}"))
    }

    pub fn number(&self) -> Result<f64, String> {
        match self {
            Node::Number(number) if number.is_finite() => Ok(*number),
            other => Err(format!("a finite number is wanted, not {other:?}")),
        }
    }

    pub fn vector(&self) -> Result<Vec3, String> {
        match self {
            Node::List(list) if list.len() == 3 => {
                Ok(Vec3::new(list[0].number()?, list[1].number()?, list[2].number()?))
            }
            other => Err(format!("a vector (x, y, z) is wanted, not {other:?}")),
        }
    }

    pub fn flag(&self) -> Result<bool, String> {
        match self {
            Node::Word(word) if word == "true" => Ok(true),
            Node::Word(word) if word == "false" => Ok(false),
            other => Err(format!("true or false is wanted, not {other:?}")),
        }
    }

    pub fn list(self) -> Result<Vec<Node>, String> {
        match self {
            Node::List(list) => Ok(list),
            other => Err(format!("a list is wanted, not {other:?}")),
        }
    }

    pub fn map(self) -> Result<BTreeMap<String, Node>, String> {
        match self {
            Node::Map(map) => Ok(map),
            Node::List(list) if list.is_empty() => Ok(BTreeMap::new()),
            other => Err(format!("named fields are wanted, not {other:?}")),
        }
    }
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Node, D::Error> {
        let raw = Box::<RawValue>::deserialize(deserializer)?;
        Node::parse(raw.get_ron()).map_err(D::Error::custom)
    }
}

/// Reads a value that does not begin with a name.
struct Plain;

impl<'de> Visitor<'de> for Plain {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a number, a string, a vector, a list or named fields")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Node, E> {
        Ok(Node::Number(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Node, E> {
        Ok(Node::Number(number as f64))
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Node, E> {
        Ok(Node::Number(number as f64))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Node, E> {
        Ok(Node::Text(text.to_string()))
    }

    fn visit_unit<E: Error>(self) -> Result<Node, E> {
        Ok(Node::List(Vec::new()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Node, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Node::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Node, A::Error> {
        let mut map = BTreeMap::new();
        while let Some((name, value)) = entries.next_entry::<String, Node>()? {
            if map.contains_key(&name) {
                return Err(A::Error::custom(format!("`{name}` is given twice")));
            }
            map.insert(name, value);
        }
        Ok(Node::Map(map))
    }
}

/// The named fields of one thing, taken one by one; `finish` refuses what nobody took.
pub struct Fields {
    owner: String,
    map: BTreeMap<String, Node>,
}

impl Fields {
    pub fn new(owner: &str, node: Node) -> Result<Fields, String> {
        let map = node.map().map_err(|error| format!("{owner}: {error}"))?;
        Ok(Fields { owner: owner.to_string(), map })
    }

    /// The fields of `Name(...)`, owned by that name.
    pub fn of_call(node: Node) -> Result<Fields, String> {
        match node {
            Node::Call(name, body) => Fields::new(&name, *body),
            Node::Word(name) => Fields::new(&name, Node::List(Vec::new())),
            other => Err(format!("Name(...) is wanted, not {other:?}")),
        }
    }

    pub fn owner(&self) -> &str {
        &self.owner
    }

    pub fn take(&mut self, name: &str) -> Option<Node> {
        self.map.remove(name)
    }

    pub fn need(&mut self, name: &str) -> Result<Node, String> {
        self.take(name).ok_or_else(|| format!("{}: `{name}` is missing", self.owner))
    }

    /// What `read` makes of the field, or `default` where it is left out.
    pub fn read<T>(
        &mut self,
        name: &str,
        default: T,
        read: impl FnOnce(&Node) -> Result<T, String>,
    ) -> Result<T, String> {
        match self.take(name) {
            Some(node) => read(&node).map_err(|error| format!("{}: {name}: {error}", self.owner)),
            None => Ok(default),
        }
    }

    pub fn number(&mut self, name: &str, default: f64) -> Result<f64, String> {
        self.read(name, default, Node::number)
    }

    pub fn vector(&mut self, name: &str, default: Vec3) -> Result<Vec3, String> {
        self.read(name, default, Node::vector)
    }

    pub fn flag(&mut self, name: &str, default: bool) -> Result<bool, String> {
        self.read(name, default, Node::flag)
    }

    pub fn need_vector(&mut self, name: &str) -> Result<Vec3, String> {
        let node = self.need(name)?;
        node.vector().map_err(|error| format!("{}: {name}: {error}", self.owner))
    }

    pub fn finish(self) -> Result<(), String> {
        match self.map.keys().next() {
            Some(name) => Err(format!("{}: unknown field `{name}`", self.owner)),
            None => Ok(()),
        }
    }
}
