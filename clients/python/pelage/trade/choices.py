"""Weighs error against cost: means over scenes, the Pareto front and the best choice."""

from __future__ import annotations

import statistics
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from .table import Row

Point = Tuple[float, float]


class Mean(NamedTuple):
    """A setting averaged over scenes. cost: Milliseconds, geometric mean. flip, silhouette: Arithmetic means."""

    name: str
    cost: float
    flip: float
    silhouette: float


def means_over(rows: Sequence[Row], scenes: Sequence[str]) -> List[Mean]:
    """Returns the means of the settings that all these scenes have, in the order of the rows."""
    of_knobs: Dict[str, Dict[str, Row]] = {}
    for row in rows:
        if row.scene in scenes:
            of_knobs.setdefault(row.knobs, {}).setdefault(row.scene, row)
    return [mean_of(list(group.values())) for group in of_knobs.values() if len(group) == len(scenes)]


def mean_of(rows: Sequence[Row]) -> Mean:
    return Mean(
        rows[0].name,
        statistics.geometric_mean(max(row.cost, 1e-3) for row in rows),
        statistics.fmean(row.flip for row in rows),
        statistics.fmean(row.silhouette for row in rows),
    )


def best_within(settings: Sequence[Mean], milliseconds: float) -> Optional[Mean]:
    """The setting with the least error that costs at most so much."""
    affordable = [mean for mean in settings if mean.cost <= milliseconds]
    return min(affordable, key=lambda mean: mean.flip) if affordable else None


def cheapest_at(settings: Sequence[Mean], error: float) -> Optional[Mean]:
    """The cheapest setting with at most this error."""
    good = [mean for mean in settings if mean.flip <= error]
    return min(good, key=lambda mean: mean.cost) if good else None


def pareto_front(points: Sequence[Point]) -> List[Point]:
    """The points of cost and error that no other point beats in both, by rising cost."""
    front: List[Point] = []
    for point in sorted(points):
        if not front or point[1] < front[-1][1]:
            front.append(point)
    return front
