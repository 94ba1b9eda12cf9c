"""Strokes from positions."""

from __future__ import annotations

from typing import Any, Iterable, List, Optional

from .schemas import Sample, Stroke


def stroke(
    positions: Iterable[Any],
    *,
    pressures: Optional[Iterable[float]] = None,
    times: Optional[Iterable[float]] = None,
) -> Stroke:
    """A whole stroke through positions in the model's own coordinates, such as an array [count, 3].

    pressures: 0 to 1, one for each position; 1 unless given.
    times: Seconds, not falling, one for each position; 0 unless given.
    Raises ValueError where the counts differ.
    """
    samples: List[Sample] = [{"position": [float(number) for number in position]} for position in positions]
    for sample, pressure in paired(samples, pressures):
        sample["pressure"] = float(pressure)
    for sample, time in paired(samples, times):
        sample["time"] = float(time)
    return {"samples": samples}


def paired(samples: List[Sample], values: Optional[Iterable[float]]) -> Any:
    """Pairs of a sample and its value; none where there are no values."""
    given = [] if values is None else list(values)
    if values is not None and len(given) != len(samples):
        raise ValueError(f"{len(given)} values for {len(samples)} positions")
    return zip(samples, given)
