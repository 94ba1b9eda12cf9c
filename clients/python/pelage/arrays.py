"""Converts NumPy arrays. Only this module imports NumPy, when the first array is needed."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

from .errors import PelageError

if TYPE_CHECKING:
    import numpy
    from numpy.typing import ArrayLike, NDArray


def numpy_module() -> Any:
    """Imports NumPy. Raises PelageError if it is not installed."""
    try:
        import numpy
    except ImportError as error:
        raise PelageError("Arrays need NumPy: pip install numpy, or pip install 'pelage[numpy]'") from error
    return numpy


def decoded(content: bytes, format: str) -> NDArray[Any]:
    """Returns the array in a .npy file. Raises PelageError for other formats."""
    if format not in ("npy", "npy_linear"):
        raise PelageError(f"A picture in the format {format} has no array; ask for the format npy or npy_linear")
    array: NDArray[Any] = numpy_module().load(io.BytesIO(content), allow_pickle=False)
    return array


def encoded(array: ArrayLike) -> bytes:
    """Returns a .npy file of float32. Raises ValueError if `array` is not numeric."""
    numpy = numpy_module()
    file = io.BytesIO()
    numpy.save(file, numpy.ascontiguousarray(array, dtype="<f4"), allow_pickle=False)
    return file.getvalue()
