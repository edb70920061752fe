//! numpy arrays <-> the core's vectors and quaternions.

use glam::{DQuat, DVec3};
use numpy::ndarray::{Array2, Dimension};
use numpy::{Element, PyArray2, PyReadonlyArray, PyReadonlyArray2, PyUntypedArrayMethods, ToPyArray};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Rows of three.
pub fn vectors<'py>(py: Python<'py>, values: &[DVec3]) -> Bound<'py, PyArray2<f64>> {
    rows(py, values.iter().map(DVec3::to_array).collect())
}

/// Rows of w, x, y, z.
pub fn quaternions<'py>(py: Python<'py>, values: &[DQuat]) -> Bound<'py, PyArray2<f64>> {
    rows(py, values.iter().map(|value| [value.w, value.x, value.y, value.z]).collect())
}

/// Rows of N numbers, which are handed over as they lie.
pub fn rows<const N: usize>(py: Python<'_>, rows: Vec<[f64; N]>) -> Bound<'_, PyArray2<f64>> {
    let shape = (rows.len(), N);
    match Array2::from_shape_vec(shape, rows.into_flattened()) {
        Ok(array) => numpy::IntoPyArray::into_pyarray(array, py),
        // The vector holds exactly `rows * N` numbers, so this does not happen; an empty array is still an answer.
        Err(_) => Array2::<f64>::zeros((0, N)).to_pyarray(py),
    }
}

/// Reads (n, 4) w, x, y, z.
pub fn read_quaternions(name: &str, array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<DQuat>> {
    let values = read_rows::<4>(name, array)?;
    Ok(values.into_iter().map(|[w, x, y, z]| DQuat::from_xyzw(x, y, z, w)).collect())
}

/// Reads (n, 3).
pub fn read_vectors(name: &str, array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<DVec3>> {
    Ok(read_rows::<3>(name, array)?.into_iter().map(DVec3::from_array).collect())
}

fn read_rows<const N: usize>(name: &str, array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<[f64; N]>> {
    if array.shape()[1] != N {
        return Err(PyValueError::new_err(format!("{name}: expected {N} columns, found {}", array.shape()[1])));
    }
    let slice = row_first(name, array)?;
    Ok(slice.as_chunks::<N>().0.to_vec())
}

/// Borrows an array's numbers in the order of its indices, the last one fastest.
///
/// `as_slice` alone would also lend out an array that runs the other way (columns first), and its numbers would be
/// taken for others.
pub fn row_first<'a, T: Element, D: Dimension>(name: &str, array: &'a PyReadonlyArray<'_, T, D>) -> PyResult<&'a [T]> {
    if array.is_c_contiguous() {
        Ok(array.as_slice()?)
    } else {
        Err(PyValueError::new_err(format!("{name}: expected a C-contiguous array (numpy.ascontiguousarray)")))
    }
}

/// Checks that a list has one item per bone.
pub fn one_per_bone(name: &str, found: usize, bones: usize) -> PyResult<()> {
    if found == bones {
        Ok(())
    } else {
        Err(PyValueError::new_err(format!("{name}: expected one per bone ({bones}), found {found}")))
    }
}
