//! What an accessor of a glTF file names, with nothing taken on trust.
//!
//! In: an accessor and the file's bytes. Out: numbers, one element at a time.

use std::array::from_fn;

use gltf::accessor::{DataType, Dimensions};

/// The elements of an accessor, all of which lie in the file.
pub struct Elements<'a> {
    /// From the first element on.
    bytes: &'a [u8],
    stride: usize,
    kind: DataType,
    is_normalized: bool,
    pub count: usize,
}

impl<'a> Elements<'a> {
    /// # Errors
    /// Why they cannot be read, in words that follow the file's name.
    pub fn of(accessor: &gltf::Accessor<'_>, dimensions: Dimensions, blob: &'a [u8]) -> Result<Self, String> {
        if accessor.sparse().is_some() {
            return Err("has a sparse accessor: export it without".into());
        }
        if accessor.dimensions() != dimensions {
            return Err("is damaged: corners are not made of the numbers that they should be made of".into());
        }
        let (kind, size, count) = (accessor.data_type(), accessor.size(), accessor.count());
        let (bytes, stride) = accessor
            .view()
            .and_then(|view| {
                let stride = view.stride().unwrap_or(size);
                let end = view.offset().checked_add(view.length())?;
                let bytes = blob.get(view.offset()..end)?.get(accessor.offset()..)?;
                let taken = count.checked_sub(1)?.checked_mul(stride)?.checked_add(size)?;
                let is_there = view.buffer().index() == 0 && taken <= bytes.len() && stride >= size;
                is_there.then_some((bytes, stride))
            })
            .ok_or("is damaged: corners are not where the file says that they are")?;
        Ok(Self { bytes, stride, kind, is_normalized: accessor.normalized(), count })
    }

    /// Element `i`, which is below the count.
    pub fn vector<const N: usize>(&self, i: usize) -> [f32; N] {
        from_fn(|part| self.number(i * self.stride + part * self.kind.size()))
    }

    /// The same of whole numbers.
    pub fn index(&self, i: usize) -> usize {
        let at = i * self.stride;
        match self.kind {
            DataType::I8 | DataType::U8 => usize::from(self.bytes[at]),
            DataType::I16 | DataType::U16 => usize::from(u16::from_le_bytes(self.take(at))),
            DataType::U32 | DataType::F32 => u32::from_le_bytes(self.take(at)) as usize,
        }
    }

    /// Whole numbers stand for shares of the largest, if they are normalized (glTF 2.0, 3.11).
    fn number(&self, at: usize) -> f32 {
        let (number, largest) = match self.kind {
            DataType::I8 => (f32::from(self.bytes[at].cast_signed()), 127.0),
            DataType::U8 => (f32::from(self.bytes[at]), 255.0),
            DataType::I16 => (f32::from(i16::from_le_bytes(self.take(at))), 32767.0),
            DataType::U16 => (f32::from(u16::from_le_bytes(self.take(at))), 65535.0),
            DataType::U32 => (u32::from_le_bytes(self.take(at)) as f32, 4_294_967_295.0),
            DataType::F32 => return f32::from_le_bytes(self.take(at)),
        };
        if self.is_normalized { (number / largest).max(-1.0) } else { number }
    }

    fn take<const N: usize>(&self, at: usize) -> [u8; N] {
        *self.bytes[at..].first_chunk().expect("all elements lie in the file")
    }
}
