//! The numbers of a PLY file, one after the other, in text or binary.
use super::header::Scalar;
use crate::{ImportError, Result};

/// A stream of numbers.
pub(super) trait Numbers {
    /// The next number; all kinds fit.
    fn number(&mut self, scalar: Scalar) -> Result<f64>;
    /// How many bytes are left.
    fn left(&self) -> usize;
    /// The next so many bytes, where numbers are in binary and so many are left.
    fn bytes(&self, _count: usize) -> Option<&[u8]> {
        None
    }
    /// Leaves out so many of those bytes.
    fn skip(&mut self, _bytes: usize) {}
    /// The number at a place among those bytes; not a number where there is none.
    fn at(_bytes: &[u8], _place: usize, _scalar: Scalar) -> f64 {
        f64::NAN
    }
    /// An error at the number read last.
    fn error<T>(&self, what: &str) -> Result<T>;
}

/// Numbers in binary.
pub(super) struct Binary<'a, const BIG_ENDIAN: bool> {
    pub bytes: &'a [u8],
    pub at: usize,
}

impl<const BIG_ENDIAN: bool> Binary<'_, BIG_ENDIAN> {
    #[inline(always)]
    fn take<const N: usize>(&mut self) -> Result<[u8; N]> {
        let Some(&chunk) = self.bytes[self.at..].first_chunk::<N>() else {
            return Err(ImportError::Byte { offset: self.bytes.len(), what: "the file is cut short".into() });
        };
        self.at += N;
        if !BIG_ENDIAN {
            return Ok(chunk);
        }
        let mut turned = chunk;
        turned.reverse();
        Ok(turned)
    }
}

impl<const BIG_ENDIAN: bool> Numbers for Binary<'_, BIG_ENDIAN> {
    #[inline(always)]
    fn number(&mut self, scalar: Scalar) -> Result<f64> {
        Ok(match scalar {
            Scalar::I8 => i8::from_le_bytes(self.take()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.take()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.take()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.take()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.take()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.take()?).into(),
            Scalar::F32 => f32::from_le_bytes(self.take()?).into(),
            Scalar::F64 => f64::from_le_bytes(self.take()?),
        })
    }

    fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn bytes(&self, count: usize) -> Option<&[u8]> {
        self.bytes[self.at..].get(..count)
    }

    fn skip(&mut self, bytes: usize) {
        self.at += bytes;
    }

    #[inline(always)]
    fn at(bytes: &[u8], place: usize, scalar: Scalar) -> f64 {
        Binary::<BIG_ENDIAN> { bytes, at: place }.number(scalar).unwrap_or(f64::NAN)
    }

    fn error<T>(&self, what: &str) -> Result<T> {
        Err(ImportError::Byte { offset: self.at, what: what.to_owned() })
    }
}

/// Numbers in text; rows need not be lines.
pub(super) struct Text<'a> {
    pub rest: &'a [u8],
    pub line: usize,
}

impl Numbers for Text<'_> {
    #[inline]
    fn number(&mut self, _: Scalar) -> Result<f64> {
        let mut start = 0;
        while let Some(b) = self.rest.get(start).filter(|b| b.is_ascii_whitespace()) {
            self.line += usize::from(*b == b'\n');
            start += 1;
        }
        let rest = &self.rest[start..];
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.rest = &rest[end..];
        match std::str::from_utf8(&rest[..end]).ok().and_then(|word| word.parse().ok()) {
            Some(value) => Ok(value),
            None if end == 0 => self.error("the file is cut short"),
            None => self.error("this is no number"),
        }
    }

    fn left(&self) -> usize {
        // The last number needs no space behind it.
        self.rest.len() + 1
    }

    fn error<T>(&self, what: &str) -> Result<T> {
        Err(ImportError::Line { line: self.line, what: what.to_owned() })
    }
}
