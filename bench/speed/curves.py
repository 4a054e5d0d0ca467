"""Error against time: rows of one program on one scene, their slope, and the time to an error."""

import dataclasses
import math

import numpy as np


@dataclasses.dataclass
class Curve:
    scene: str
    program: str
    rows: list = dataclasses.field(default_factory=list)  #: (level: samples, or samples a side; CPU seconds; relative RMSE)

    def slope(self):
        """By least squares over the rows with an error: error ~ seconds^slope."""
        points = [(math.log(s), math.log(e)) for _, s, e in self.rows if e > 0]
        if len(points) < 2:
            return math.nan
        return float(np.polyfit(*zip(*points, strict=True), 1)[0])

    def seconds_to(self, error):
        """(seconds, measured): between rows, or beyond the last one by the slope of the last two."""
        rows = [(math.log(s), math.log(e)) for _, s, e in self.rows if e > 0]
        if len(rows) < 2:
            return math.nan, False
        wanted = math.log(error)
        if wanted >= rows[0][1]:
            return math.exp(rows[0][0]), True
        for (s0, e0), (s1, e1) in zip(rows, rows[1:], strict=False):
            if e1 <= wanted < e0:
                return math.exp(s0 + (s1 - s0) * (wanted - e0) / (e1 - e0)), True
        (s0, e0), (s1, e1) = rows[-2:]
        if e1 >= e0:
            return math.nan, False
        return math.exp(s1 + (s1 - s0) * (wanted - e1) / (e1 - e0)), False


def error_of(picture, a, b):
    """Relative RMSE against two independent references, whose noise drops out of mean((x - a)(x - b))."""
    square = np.mean((picture - a) * (picture - b))
    return float(max(square, 0) ** 0.5 / np.mean(0.5 * (a + b)))
