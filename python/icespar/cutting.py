"""What a cutter reads off a design: its proportions, its weight, and its cutting table."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ._core import Design, Error, Stone, Tier

_LEVEL = 1e-9  # a facet whose normal leans less from a direction has that direction


@dataclass(frozen=True)
class Proportions:
    """Measures of a stone whose dop axis is z, in units of its width W: the lesser of its extents along x and y.

    The girdle's upper line is where facets that face up meet those that do not, its lower line likewise; each
    is taken at its mean height, so that crown + girdle + pavilion = height, also where the girdle waves.
    """

    facets: int
    volume: float  #: in W^3
    length: float  #: the greater extent, L/W
    height: float
    crown: float  #: from the girdle's upper line to the highest point
    girdle: float  #: between the girdle's lines
    pavilion: float  #: from the lowest point to the girdle's lower line
    table: float  #: the table's extent along the direction in which the stone is W wide; 0 without a table

    @property
    def block_yield(self) -> float:
        """The part of the smallest upright block around the stone, L W H, that the stone is."""
        return self.volume / (self.length * self.height)

    def carats(self, width_mm: float, density: float) -> float:
        """Weight of the stone cut to this width, of a mineral of this density in g/cm^3; a carat is 0.2 g."""
        for name, value in (("width_mm", width_mm), ("density", density)):
            if not (np.isfinite(value) and value > 0):
                raise ValueError(f"{name}: {value!r} is not a positive number")
        return self.volume * width_mm**3 * density / 200


def proportions(stone: Stone) -> Proportions:
    """The measures of a stone with its table up along z, as `Design.stone` and `Stone.from_design` make it."""
    corners = stone.vertices
    extent = np.ptp(corners, axis=0)
    narrow = 0 if extent[0] <= extent[1] else 1
    width, length = extent[narrow], extent[1 - narrow]
    low, high = corners[:, 2].min(), corners[:, 2].max()
    upper = _line(stone, stone.normals[:, 2] > _LEVEL, high)
    lower = _line(stone, stone.normals[:, 2] >= -_LEVEL, low)
    top = int(np.argmax(stone.normals[:, 2]))
    table = np.ptp(corners[stone.facets[top]][:, narrow]) if stone.normals[top, 2] > 1 - 1e-12 else 0.0
    return Proportions(
        facets=len(stone.facets),
        volume=float(stone.volume / width**3),
        length=float(length / width),
        height=float((high - low) / width),
        crown=float((high - upper) / width),
        girdle=float((upper - lower) / width),
        pavilion=float((lower - low) / width),
        table=float(table / width),
    )


def _line(stone: Stone, above: NDArray[np.bool_], nowhere: float) -> float:
    """Mean height of the edges between the facets that are `above` and the others, by their length seen from above."""
    edges = {}
    for number, polygon in enumerate(stone.facets):
        for edge in zip(polygon.tolist(), np.roll(polygon, -1).tolist(), strict=True):
            edges[edge] = bool(above[number])
    line = [(a, b) for (a, b), up in edges.items() if up and not edges.get((b, a), True)]
    if not line:
        return nowhere
    ends = stone.vertices[np.array(line)]
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0])[:, :2].T)
    return float(np.average(ends[:, :, 2].mean(axis=1), weights=lengths if lengths.any() else None))


@dataclass(frozen=True)
class Row:
    """One line of a cutting table: a tier."""

    name: str  #: the facets' names; made up where the file gives none
    side: str  #: "crown", "girdle" or "pavilion"
    angle: float  #: degrees from the dop axis, 0 .. 90
    indices: str  #: "3-9-15", the places on the gear in the file's order
    count: int  #: facets that are cut
    reached: int  #: of these, facets that are on the finished stone
    distance: float  #: from the stone's centre, in units of the stone's width
    instructions: str


def cutting_table(design: Design) -> list[Row]:
    """The tiers in the file's order, which is the order of cutting."""
    width = min(np.ptp(design.stone().vertices, axis=0)[:2])
    reached = np.split(design.facet_of >= 0, np.cumsum([len(tier.indices) for tier in design.tiers])[:-1])
    return [
        Row(
            name=name,
            side=_side(tier),
            angle=abs(tier.angle),
            indices="-".join(index_text(index, design.gear) for index in tier.indices),
            count=len(tier.indices),
            reached=int(found.sum()),
            distance=float(abs(tier.distance) / width),
            instructions=tier.instructions,
        )
        for tier, name, found in zip(design.tiers, tier_names(design), reached, strict=True)
    ]


def index_text(index: float, gear: float) -> str:
    """An index as a cutting table has it: above 0, at most the gear's teeth, whole where it is whole."""
    teeth = abs(gear)
    index = round(index % teeth, 4) or teeth
    return f"{index:.4f}".rstrip("0").rstrip(".")


def tier_names(design: Design) -> list[str]:
    """A name for each tier: its facets' own, or P1, G1, C1 ..., T (table) and K (culet) where they have none."""
    given = [", ".join(_once(name for name in tier.names if name)) for tier in design.tiers]
    taken, count, names = set(given), dict.fromkeys("PGC", 0), []
    for tier, name in zip(design.tiers, given, strict=True):
        flat = abs(tier.angle) < 1e-9
        letter = {"crown": "T" if flat else "C", "pavilion": "K" if flat else "P", "girdle": "G"}[_side(tier)]
        while not name:
            count[letter] = count.get(letter, 0) + 1
            made = letter if flat and count[letter] == 1 else f"{letter}{count[letter]}"
            name = "" if made in taken else made
        names.append(name)
    return names


def facet_names(design: Design) -> list[str]:
    """A name for each facet of `design.stone()`."""
    names = [""] * len(design.stone().facets)
    cut = 0
    facet_of = design.facet_of
    for tier, made in zip(design.tiers, tier_names(design), strict=True):
        for name in tier.names:
            facet = facet_of[cut]
            if facet >= 0 and not names[facet]:
                names[facet] = name or made
            cut += 1
    return names


def _side(tier: Tier) -> str:
    if abs(tier.angle) > 90 - 1e-5:
        return "girdle"
    down = np.signbit(tier.angle) or (tier.angle == 0 and tier.distance < 0)
    return "pavilion" if down else "crown"


def _once(names: Iterable[str]) -> list[str]:
    return list(dict.fromkeys(names))


def as_design(source) -> Design:
    """A Design from one, or from the path of its file."""
    if isinstance(source, Design):
        return source
    if isinstance(source, Stone):
        raise Error("a stone has no tiers: give a Design, or the path of a design's file")
    return Design.read(source)
