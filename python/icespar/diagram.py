"""Facet diagrams and faceting sheets, drawn by Matplotlib (`pip install "icespar[report]"`)."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ._core import Design, Stone
from .cutting import as_design, cutting_table, facet_names, index_text, proportions

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: For each view: what is up, what points to the viewer, and what is said of it.
VIEWS = {
    "crown": ((0, 1, 0), (0, 0, 1), "crown, from above"),
    "pavilion": ((0, 1, 0), (0, 0, -1), "pavilion, from below (turned over about the upright axis)"),
    "front": ((0, 0, 1), (0, -1, 0), "side, seen from the foot of the crown view"),
    "end": ((0, 0, 1), (1, 0, 0), "side, seen from the right of the crown view"),
}
_LARGEST, _SMALLEST = 8.0, 4.2  # font sizes of names
_WHEEL = 1.14  # radius of the index wheel, in radii of the stone


def facet_diagram(design: Design | str | os.PathLike[str], width: float = 9.0) -> Figure:
    """Crown, pavilion and two side views at one scale with the facets' names; `width` in inches."""
    from matplotlib.figure import Figure

    design = as_design(design)
    sheet = _Sheet(design)
    half = 1.36 * sheet.radius
    plan = width / 2
    side = plan * (sheet.tall + 0.30 * sheet.radius) / (2 * half)
    figure = Figure(figsize=(width, plan + side))
    for place, view in enumerate(VIEWS):
        upright = place >= 2
        bottom = 0.0 if upright else side / (plan + side)
        axes = figure.add_axes((0.5 * (place % 2), bottom, 0.5, (side if upright else plan) / (plan + side)))
        sheet.draw(axes, view, plan * 72 / (2 * half))
    sheet.name_the_rest()
    return figure


def faceting_sheet(design: Design | str | os.PathLike[str], width: float = 9.0) -> Figure:
    """The facet diagram with title, proportions and cutting table beneath, as one page."""
    design = as_design(design)
    figure = facet_diagram(design, width)
    rows = cutting_table(design)
    lines = [[r.name, f"{r.angle:.2f}\N{DEGREE SIGN}", r.indices, r.instructions] for r in rows]
    wrapped = [[_wrapped(cell, room) for cell, room in zip(line, (12, 8, 66, 30), strict=True)] for line in lines]
    gear = index_text(0, design.gear)
    title = next((line for line in design.headers if line.strip()), "")
    text = [title, proportions_line(design)] if title else [proportions_line(design)]
    rise = 0.17
    below = rise * (sum(max(cell.count("\n") + 1 for cell in line) for line in wrapped) + len(text) + 2.5)
    old = figure.get_figheight()
    new = old + below
    for axes in figure.axes:
        left, bottom, across, tall = axes.get_position().bounds
        axes.set_position((left, (bottom * old + below) / new, across, tall * old / new))
    figure.set_figheight(new)
    at = below - 0.05
    columns = (0.04, 0.16, 0.25, 0.72)
    for line in text:
        at -= rise
        figure.text(columns[0], at / new, line, fontsize=9, weight="bold" if line == title else "normal")
    at -= 1.5 * rise
    for where, head in zip(columns, ("name", "angle", f"index (gear {gear})", "cut to"), strict=True):
        figure.text(where, at / new, head, fontsize=8, weight="bold")
    for line in wrapped:
        at -= rise
        for where, cell in zip(columns, line, strict=True):
            for down, part in enumerate(cell.split("\n")):
                figure.text(where, (at - down * rise) / new, part, fontsize=8)
        at -= rise * (max(cell.count("\n") for cell in line))
    return figure


def proportions_line(design: Design) -> str:
    """The proportions in one line, as a faceting sheet has them."""
    p = proportions(design.stone())
    table = f"T/W {p.table:.3f}" if p.table else "no table"
    fold = f"{design.symmetry}-fold{', mirrored' if design.mirror else ''}"
    index = f", index {design.refractive_index:g}" if design.refractive_index else ""
    return (
        f"{p.facets} facets, {fold}{index}; L/W {p.length:.3f}, H/W {p.height:.3f}, C/W {p.crown:.3f}, "
        f"P/W {p.pavilion:.3f}, {table}, volume {p.volume:.3f} W\N{SUPERSCRIPT THREE}"
    )


class _Sheet:
    """One design's views, and which names they show."""

    def __init__(self, design: Design) -> None:
        self.design = design
        self.stone: Stone = design.stone()
        self.names = facet_names(design)
        corners = self.stone.vertices
        self.radius = float(np.hypot(corners[:, 0], corners[:, 1]).max())
        low, high = corners[:, 2].min(), corners[:, 2].max()
        self.tall, self.middle = float(high - low), float(high + low) / 2
        self.shown: set[str] = set()
        self.views: list[tuple[str, Axes, NDArray[np.float64], float]] = []

    def draw(self, axes: Axes, view: str, points_per_unit: float) -> None:
        """One view; a unit of the design is so many points on paper."""
        up, toward, title = VIEWS[view]
        frame = np.array([np.cross(up, toward), up, toward], dtype=float)
        self.views.append((view, axes, frame, points_per_unit))
        axes.set_axis_off()
        axes.set_aspect("equal")
        plan = view in ("crown", "pavilion")
        half = 1.36 * self.radius
        axes.set_xlim(-half, half)
        if plan:
            axes.set_ylim(-half, half)
            self._wheel(axes, frame)
        else:
            axes.set_ylim(self.middle - self.tall / 2 - 0.2 * self.radius, self.middle + self.tall / 2 + 0.1 * self.radius)
        axes.text(
            0.5, 0.005 if plan else 0.02, title, transform=axes.transAxes, ha="center", va="bottom", fontsize=8, color="0.35"
        )
        if view == "crown":
            self._girdle(axes, points_per_unit)
        for number, polygon in self._facets(frame):
            axes.fill(*polygon.T, facecolor="white", edgecolor="black", linewidth=0.6, joinstyle="round")
            where, size = _room(polygon, len(self.names[number]))
            size = min(_LARGEST, size * points_per_unit)
            if size >= _SMALLEST:
                axes.text(*where, self.names[number], ha="center", va="center_baseline", fontsize=size)
                self.shown.add(self.names[number])

    def _girdle(self, axes: Axes, points_per_unit: float) -> None:
        """The names of upright facets stand outside the edges as which they are seen from above."""
        for number, corners in enumerate(self.stone.facets):
            normal = self.stone.normals[number]
            if abs(normal[2]) > 1e-6:
                continue
            name, ends = self.names[number], self.stone.vertices[corners][:, :2]
            long = float(np.ptp(ends @ (-normal[1], normal[0]))) * points_per_unit
            size = min(6.0, long / (0.66 * max(len(name), 1)))
            if size >= _SMALLEST:
                off = (0.6 * size + 1) / points_per_unit
                at = (ends.max(axis=0) + ends.min(axis=0)) / 2 + off * normal[:2]
                axes.text(*at, name, ha="center", va="center_baseline", fontsize=size, color="0.25")
                self.shown.add(name)

    def name_the_rest(self) -> None:
        """Names that fitted nowhere stand outside, each with a line to the facet that is seen largest."""
        for missing in dict.fromkeys(name for name in self.names if name not in self.shown):
            best = None
            for _view, axes, frame, _scale in self.views:
                for number, polygon in self._facets(frame):
                    if self.names[number] == missing:
                        area = _area(polygon)
                        if best is None or area > best[0]:
                            best = (area, axes, polygon.mean(axis=0), bool(frame[2, 2]))
            if best is None:
                continue
            _, axes, at, plan = best
            middle = np.array([0.0, 0.0 if plan else self.middle])
            out, reach = at - middle, self.radius * (1.09 if plan else 1.2)
            if np.linalg.norm(out) > 0.02 * self.radius:
                end = middle + out * (reach / np.linalg.norm(out))
            else:  # a culet has no side of its own: past the other names, and not along edges
                words = [text.get_position() for text in axes.texts if text.get_transform() is axes.transData]
                turns = 2 * np.pi * (np.arange(32) + 0.5) / 32
                ends = middle + reach * np.stack([np.sin(turns), -np.cos(turns)], axis=1)
                end = max(ends, key=lambda to: round(_nearest(words, at, to) / self.radius, 6))
            axes.annotate(
                missing, at, end, fontsize=6, ha="center", va="center", arrowprops={"arrowstyle": "-", "linewidth": 0.4}
            )
            self.shown.add(missing)

    def _facets(self, frame: NDArray[np.float64]):
        """The facets that face the viewer, with their corners in the picture."""
        for number, corners in enumerate(self.stone.facets):
            if self.stone.normals[number] @ frame[2] > 1e-6:
                yield number, self.stone.vertices[corners] @ frame[:2].T

    def _wheel(self, axes: Axes, frame: NDArray[np.float64]) -> None:
        """The index gear around a plan view: a tick a tooth, some of them numbered."""
        teeth = round(abs(self.design.gear))
        if not 3 <= teeth <= 720:
            return
        spoke = next((n for n in (16, 12, 10, 8, 6, 5, 4, 3, 2) if teeth % n == 0), 1)
        for tooth in range(teeth):
            azimuth = 2 * np.pi * (tooth - self.design.gear_offset) / self.design.gear
            along = np.array([np.sin(azimuth), np.cos(azimuth), 0]) @ frame[:2].T
            numbered = tooth % (teeth // spoke) == 0
            ends = np.outer([_WHEEL, _WHEEL + (0.05 if numbered else 0.025)], along) * self.radius
            axes.plot(*ends.T, color="0.4", linewidth=0.5)
            if numbered:
                axes.text(
                    *(along * self.radius * (_WHEEL + 0.11)), tooth or teeth, ha="center", va="center", fontsize=6, color="0.3"
                )


def _nearest(points: list[tuple[float, float]], start: NDArray[np.float64], end: NDArray[np.float64]) -> float:
    """How near the line from start to end comes to one of the points."""
    to, along = np.reshape(points, (-1, 2)) - start, end - start
    part = np.clip(to @ along / (along @ along), 0, 1)
    return float(np.linalg.norm(to - part[:, None] * along, axis=1).min(initial=np.inf))


def _area(polygon: NDArray[np.float64]) -> float:
    x, y = polygon.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def _room(polygon: NDArray[np.float64], letters: int) -> tuple[NDArray[np.float64], float]:
    """Where in a convex polygon a word fits best, and the largest size of its letters there."""
    edge = np.roll(polygon, -1, axis=0) - polygon
    long = np.linalg.norm(edge, axis=1)
    keep = long > 1e-9 * long.max()
    inward = np.stack([-edge[:, 1], edge[:, 0]], axis=1)[keep] / long[keep, None]
    start = polygon[keep]
    middle = polygon.mean(axis=0)
    if ((middle - start) * inward).sum() < 0:
        inward = -inward
    needed = np.abs(inward) @ np.array([0.33 * max(letters, 1), 0.45])
    tried = [middle, *(middle + part * (corner - middle) for corner in polygon for part in (0.2, 0.4, 0.6))]
    sizes = [float((((at - start) * inward).sum(axis=1) / needed).min()) for at in tried]
    best = int(np.argmax(sizes)) if max(sizes) > 1.05 * sizes[0] else 0
    return tried[best], sizes[best]


def _wrapped(text: str, room: int) -> str:
    """Lines of at most `room` characters where it can be broken, at spaces and after hyphens."""
    lines, line = [], ""
    for word in text.replace("-", "-\0").replace(" ", " \0").split("\0"):
        if line and len(line) + len(word.rstrip()) > room:
            lines.append(line)
            line = ""
        line += word
    return "\n".join([*lines, line])
