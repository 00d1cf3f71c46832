//! Tables whose rows are all equally long, as those of binary triangle meshes: read by all threads at once.
//!
//! What is unusual in such a table is left to the reader of single numbers, which also knows what to say about it.
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::data::Numbers;
use super::header::{Property, Scalar};
use crate::draft;

/// Rows that a thread takes at least.
const CHUNK: usize = 1 << 14;

/// Where a row has a number.
#[derive(Clone, Copy)]
pub(super) struct Column {
    at: usize,
    scalar: Scalar,
}

/// The columns of a row.
#[derive(Default)]
pub(super) struct Layout {
    columns: Vec<Column>,
    /// Bytes of a row.
    length: usize,
}

impl Layout {
    /// That of rows without lists.
    pub(super) fn of(properties: &[Property]) -> Option<Layout> {
        let mut layout = Layout::default();
        for property in properties {
            if property.length.is_some() {
                return None;
            }
            layout.add(property.scalar);
        }
        Some(layout)
    }

    /// That of rows in which all lists at this place hold three numbers, and no other property is a list; and the place
    /// of the list's length, behind which are the three.
    pub(super) fn of_triangles(properties: &[Property], list: usize) -> Option<(Layout, usize)> {
        let mut layout = Layout::of(&properties[..list])?;
        layout.add(properties[list].length?);
        (0..3).for_each(|_| layout.add(properties[list].scalar));
        for property in Layout::of(&properties[list + 1..])?.columns {
            layout.add(property.scalar);
        }
        Some((layout, list))
    }

    fn add(&mut self, scalar: Scalar) {
        self.columns.push(Column { at: self.length, scalar });
        self.length += scalar.bytes();
    }

    fn pick<const K: usize>(&self, places: &[usize]) -> [Column; K] {
        std::array::from_fn(|k| self.columns[places[k]])
    }

    /// Points, texture coordinates and the like from all rows; `None` unless all are finite.
    pub(super) fn points<const K: usize, N: Numbers>(
        &self,
        rows: &[u8],
        places: &[usize],
    ) -> Option<Vec<[f32; K]>> {
        let columns = self.pick::<K>(places);
        self.each(rows, |row| draft::point(values::<K, N>(row, &columns)))
    }

    /// The corners of triangles from all rows; `None` where a row is no triangle.
    pub(super) fn triangles<N: Numbers>(&self, rows: &[u8], list: usize) -> Option<Vec<[u32; 3]>> {
        let columns = self.pick::<4>(&[list, list + 1, list + 2, list + 3]);
        self.each(rows, |row| {
            let [count, corners @ ..] = values::<4, N>(row, &columns);
            let known = corners.iter().all(|i| (0.0..draft::MOST as f64).contains(i));
            (count == 3.0 && known).then_some([corners[0] as u32, corners[1] as u32, corners[2] as u32])
        })
    }

    /// The bytes of so many rows that come next, if they are there.
    pub(super) fn rows<'a, N: Numbers>(&self, count: usize, numbers: &'a N) -> Option<&'a [u8]> {
        numbers.bytes(count.checked_mul(self.length)?)
    }

    /// What `read` makes of each row; `None` unless it makes something of all.
    fn each<T: Copy + Send + Sync>(
        &self,
        rows: &[u8],
        read: impl Fn(&[u8]) -> Option<T> + Sync,
    ) -> Option<Vec<T>> {
        // Most tables of another kind show it in their first row.
        let first = read(rows.get(..self.length)?)?;
        let broken = AtomicBool::new(false);
        let read = |row: &[u8]| {
            read(row).unwrap_or_else(|| {
                broken.store(true, Ordering::Relaxed);
                first
            })
        };
        let mut all = Vec::new();
        rows.par_chunks_exact(self.length).with_min_len(CHUNK).map(read).collect_into_vec(&mut all);
        (!broken.into_inner()).then_some(all)
    }
}

#[inline(always)]
fn values<const K: usize, N: Numbers>(row: &[u8], columns: &[Column; K]) -> [f64; K] {
    let mut values = [0.0; K];
    for (value, column) in values.iter_mut().zip(columns) {
        *value = N::at(row, column.at, column.scalar);
    }
    values
}
