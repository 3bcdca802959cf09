//! What an accessor of a glTF file names, with nothing taken on trust.
//!
//! In: an accessor and the file's bytes. Out: numbers, one element at a time.

use std::array::from_fn;

use super::buffers::{Buffer, viewed};
use super::document::{Accessor, Document, Sparse, at};
use super::extensions;

/// The elements of an accessor, all of which lie in the file.
pub struct Elements<'a> {
    /// None where all are zeros.
    all: Option<Strided<'a>>,
    /// Those that stand in place of others: the sorted indices of these, and what counts.
    replaced: Option<(Vec<usize>, Strided<'a>)>,
    is_normalized: bool,
    pub count: usize,
}

/// What elements may be, with how many numbers they have.
#[derive(Clone, Copy)]
pub enum Kind {
    Scalar = 1,
    Vec2 = 2,
    Vec3 = 3,
    Vec4 = 4,
    Mat4 = 16,
}

/// Elements side by side.
struct Strided<'a> {
    /// From the first element on.
    bytes: &'a [u8],
    stride: usize,
    number: Number,
}

#[derive(Clone, Copy)]
enum Number {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl<'a> Elements<'a> {
    /// Of accessor `index`.
    ///
    /// # Errors
    /// Why they cannot be read, in words that follow the file's name.
    pub fn of(
        document: &Document,
        buffers: &'a [Buffer<'_>],
        index: usize,
        kind: Kind,
    ) -> Result<Self, String> {
        let accessor = at(&document.accessors, index, "accessor")?;
        if accessor.kind != kind.name() {
            return Err("is damaged: its corners have data of the wrong type".into());
        }
        let number = Number::of(accessor.component_type)?;
        let strided = |view: usize, offset: usize, count: usize, kind: Kind, number: Number| {
            Strided::of(document, buffers, [view, offset, count], kind, number)
        };
        let all = accessor
            .buffer_view
            .map(|view| strided(view, accessor.byte_offset, accessor.count, kind, number));
        if let (None, None, Some(why)) = (&all, &accessor.sparse, extensions::draco(document)) {
            return Err(why);
        }
        let replaced = accessor.sparse.as_ref().map(|sparse: &Sparse| {
            let [indices, values] = [&sparse.indices.buffer_view, &sparse.values.buffer_view];
            let width = Number::of(sparse.indices.component_type)?;
            let indices = strided(*indices, sparse.indices.byte_offset, sparse.count, Kind::Scalar, width)?;
            let values = strided(*values, sparse.values.byte_offset, sparse.count, kind, number)?;
            let indices: Vec<usize> = (0..sparse.count).map(|i| indices.index(i)).collect();
            let is_sorted = indices.is_sorted();
            is_sorted
                .then_some((indices, values))
                .ok_or("is damaged: a sparse accessor is out of order".to_owned())
        });
        let Accessor { normalized, count, .. } = *accessor;
        Ok(Self { all: all.transpose()?, replaced: replaced.transpose()?, is_normalized: normalized, count })
    }

    /// Element `i`, which is below the count.
    pub fn vector<const N: usize>(&self, i: usize) -> [f32; N] {
        match self.place(i) {
            Some((elements, i)) => from_fn(|part| elements.number(i, part, self.is_normalized)),
            None => [0.0; N],
        }
    }

    /// The same of whole numbers.
    pub fn index(&self, i: usize) -> usize {
        self.place(i).map_or(0, |(elements, i)| elements.index(i))
    }

    fn place(&self, i: usize) -> Option<(&Strided<'a>, usize)> {
        if let Some((indices, values)) = &self.replaced
            && let Ok(place) = indices.binary_search(&i)
        {
            return Some((values, place));
        }
        self.all.as_ref().map(|all| (all, i))
    }
}

impl<'a> Strided<'a> {
    fn of(
        document: &Document,
        buffers: &'a [Buffer<'_>],
        [view, offset, count]: [usize; 3],
        kind: Kind,
        number: Number,
    ) -> Result<Self, String> {
        let view = at(&document.buffer_views, view, "view")?;
        let size = number.size() * kind as usize;
        // Some programs write 0 where they mean none.
        let stride = view.byte_stride.filter(|stride| *stride != 0).unwrap_or(size);
        let bytes = viewed(buffers, view)?.get(offset..);
        let taken = count.checked_sub(1).and_then(|last| last.checked_mul(stride)?.checked_add(size));
        let is_there = |bytes: &&[u8]| count == 0 || taken.is_some_and(|taken| taken <= bytes.len());
        let bytes = bytes.filter(is_there).filter(|_| stride >= size);
        let bytes = bytes.ok_or("is damaged: the data of its corners is outside of its buffers")?;
        Ok(Self { bytes, stride, number })
    }

    /// Whole numbers stand for shares of the largest, if they are normalized (glTF 2.0, 3.11).
    fn number(&self, i: usize, part: usize, is_normalized: bool) -> f32 {
        let at = i * self.stride + part * self.number.size();
        let (number, largest) = match self.number {
            Number::I8 => (f32::from(self.bytes[at].cast_signed()), 127.0),
            Number::U8 => (f32::from(self.bytes[at]), 255.0),
            Number::I16 => (f32::from(i16::from_le_bytes(self.take(at))), 32767.0),
            Number::U16 => (f32::from(u16::from_le_bytes(self.take(at))), 65535.0),
            Number::U32 => (u32::from_le_bytes(self.take(at)) as f32, 4_294_967_295.0),
            Number::F32 => return f32::from_le_bytes(self.take(at)),
        };
        if is_normalized { (number / largest).max(-1.0) } else { number }
    }

    fn index(&self, i: usize) -> usize {
        let at = i * self.stride;
        match self.number {
            Number::I8 | Number::U8 => usize::from(self.bytes[at]),
            Number::I16 | Number::U16 => usize::from(u16::from_le_bytes(self.take(at))),
            Number::U32 | Number::F32 => u32::from_le_bytes(self.take(at)) as usize,
        }
    }

    fn take<const N: usize>(&self, at: usize) -> [u8; N] {
        *self.bytes[at..].first_chunk().expect("all elements lie in the file")
    }
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Kind::Scalar => "SCALAR",
            Kind::Vec2 => "VEC2",
            Kind::Vec3 => "VEC3",
            Kind::Vec4 => "VEC4",
            Kind::Mat4 => "MAT4",
        }
    }
}

impl Number {
    fn of(component_type: u32) -> Result<Self, String> {
        Ok(match component_type {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            other => return Err(format!("is damaged: the number type {other} does not exist")),
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }
}
