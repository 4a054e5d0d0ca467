"""Reports of analysed gems: pages that a cutter prints, JSON, CSV and a table for the terminal."""

import base64
import csv
import io
import json
import math
import pathlib
from collections.abc import Iterable

from ._core import __version__
from .analysis import Analysis
from .cutting import cutting_table
from .gem import Gem
from .performance import HEAD, MEANING, SCOPE_HEAD, Number

#: How a report names each number, and by which it is set out.
TITLES = {
    "iso": "Light return ISO",
    "cosine": "Light return COS",
    "sc2": "Light return SC2",
    "table_iso": "Table ISO",
    "table_cosine": "Table COS",
    "table_sc2": "Table SC2",
    "leakage": "Leakage",
    "window": "Window",
    "extinction": "Extinction",
    "aset_red": "ASET red",
    "aset_green": "ASET green",
    "aset_blue": "ASET blue",
    "aset_black": "ASET black",
    "idealscope_red": "Ideal-Scope red",
    "idealscope_black": "Ideal-Scope black",
    "idealscope_white": "Ideal-Scope white",
    "absorbed": "Absorbed",
    "fire": "Fire",
    "scintillation": "Scintillation",
}
#: Of each picture, relative to its mean: less cannot be seen on a page.
PICTURE_ERROR = 0.05
PICTURES = (
    ("lamps", (0, 0), "face-up, under a ring of lamps"),
    ("lamps", (20, 0), "the upper edge raised by 20\N{DEGREE SIGN}"),
    ("lamps", (0, 20), "the right edge lowered by 20\N{DEGREE SIGN}"),
    ("sc2", (0, 0), "face-up, light as for SC2"),
    ("aset", (0, 0), "ASET"),
    ("idealscope", (0, 0), "Ideal-Scope"),
)


def facts(gem: Gem) -> list[tuple[str, str]]:
    """What is known of a gem before any light falls on it."""
    p, w = gem.proportions, gem.width_mm
    rows = [
        ("Facets", str(p.facets)),
        ("L/W", f"{p.length:.4f}"),
        ("H/W", f"{p.height:.4f}"),
        ("Crown C/W", f"{p.crown:.4f}"),
        ("Girdle G/W", f"{p.girdle:.4f}"),
        ("Pavilion P/W", f"{p.pavilion:.4f}"),
        ("Table T/W", f"{100 * p.table:.1f} %" if p.table else "no table"),
        ("Volume", f"{p.volume:.4f} W\N{SUPERSCRIPT THREE}"),
        ("Yield", f"{100 * p.block_yield:.1f} % of the block L W H"),
        ("Size", f"{w * p.length:.2f} x {w:.2f} x {w * p.height:.2f} mm"),
    ]
    if gem.mineral is None:
        return [*rows, ("Index", f"{gem.design.refractive_index:g} (the design's)")]
    indices = ", ".join(f"{n:.4f}" for n in gem.mineral.indices(589.3))
    rows += [
        ("Weight", f"{gem.carats:.2f} ct at {w:g} mm"),
        ("Mineral", f"{gem.mineral.name}{', ' + gem.colour if gem.colour else ''}; {gem.mineral.optic}"),
        ("Indices at 589.3 nm", indices),
        ("Density", f"{gem.mineral.density:g} g/cm\N{SUPERSCRIPT THREE}"),
    ]
    if gem.birefringent:
        name = "Optic axis" if gem.mineral.optic.startswith("uniaxial") else "Axis of n_gamma"
        rows.append((name, "<" + ", ".join(f"{x:.3g}" for x in gem.axis) + "> (z: the dop axis)"))
    return rows


def _names(found: Analysis) -> set[str]:
    return set(found.face_up) | set(found.coloured.luminous if found.coloured else ())


def as_dict(found: Analysis) -> dict:
    """Everything as plain numbers, for JSON; percent, millimetres, degrees."""
    gem, p = found.gem, found.gem.proportions

    def pairs(numbers):
        return {name: number._asdict() for name, number in numbers.items()}

    def clean(x):
        return None if isinstance(x, float) and math.isnan(x) else x

    return {
        "icespar": __version__,
        "design": gem.name,
        "mineral": gem.mineral.id if gem.mineral else None,
        "colour": gem.colour,
        "index": gem.mean_index(),
        "axis": list(gem.axis) if gem.birefringent else None,
        "width_mm": gem.width_mm,
        "carats": gem.carats,
        "proportions": {
            **{k: getattr(p, k) for k in ("facets", "volume", "length", "height", "crown", "girdle", "pavilion", "table")},
            "block_yield": p.block_yield,
        },
        "face_up": pairs(found.face_up),
        "without_birefringence": pairs(found.without) if found.without else None,
        "effect_of_birefringence": pairs(found.effect) if found.without else None,
        "coloured": None
        if found.coloured is None
        else {
            "face_up": pairs(found.coloured.luminous),
            "by_wavelength": [
                {"nm": nm, "weight": weight, **pairs(numbers)}
                for nm, weight, numbers in zip(
                    found.coloured.wavelengths_nm, found.coloured.weights, found.coloured.by_wavelength, strict=True
                )
            ],
            "curves": {axis: [pairs(n) for n in curve] for axis, curve in found.coloured_curves.items()},
        },
        "tilts": found.tilts,
        "curves": {axis: [pairs(n) for n in curve] for axis, curve in found.curves.items()},
        "curves_without_birefringence": {axis: [pairs(n) for n in curve] for axis, curve in found.plain_curves.items()},
        "doubling": {
            axis: [{"separation_mm": clean(d.separation_mm), "arc_minutes": clean(d.arc_minutes)} for d in curve]
            for axis, curve in found.doubled.items()
        },
        "meaning": {name: words for name, words in MEANING.items() if name in _names(found)},
    }


def json_text(analyses: Iterable[Analysis]) -> str:
    """One object for one gem, a list for more."""
    dicts = [as_dict(found) for found in analyses]
    return json.dumps(dicts[0] if len(dicts) == 1 else dicts, indent=1, allow_nan=False) + "\n"


def csv_text(analyses: Iterable[Analysis]) -> str:
    """One number a line: design, mineral, its colour if that is traced, quantity, tilt about x and y in degrees, value, bound,
    standard error, unit."""
    out = io.StringIO()
    table = csv.writer(out, lineterminator="\n")
    table.writerow(["design", "mineral", "colour", "birefringence", "quantity", "tilt_x", "tilt_y", "value", "bound", "error", "unit"])
    for found in analyses:
        gem = found.gem
        subject, split = [gem.name, gem.mineral.id if gem.mineral else ""], "yes" if gem.birefringent else "no"
        head, plain, tinted = [*subject, "", split], [*subject, "", "no"], [*subject, gem.colour, split]
        p = gem.proportions
        for name in ("length", "height", "crown", "girdle", "pavilion", "table", "volume", "block_yield"):
            table.writerow([*head, name, 0, 0, f"{getattr(p, name):.6f}", 0, 0, "W^3" if name == "volume" else "W"])
        if gem.carats is not None:
            table.writerow([*head, "weight", 0, 0, f"{gem.carats:.6f}", 0, 0, "ct"])
        colours = found.coloured.luminous if found.coloured else {}
        for who, numbers in ((head, found.face_up), (plain, found.without or {}), (tinted, colours)):
            for name, number in numbers.items():
                table.writerow([*who, name, 0, 0, *(f"{x:.5f}" for x in number), "%"])
        for who, curves in ((head, found.curves), (plain, found.plain_curves), (tinted, found.coloured_curves)):
            for axis, curve in curves.items():
                for tilt, numbers in zip(found.tilts, curve, strict=True):
                    at = [tilt, 0] if axis == "x" else [0, tilt]
                    for name, number in numbers.items():
                        table.writerow([*who, name, *at, *(f"{x:.5f}" for x in number), "%"])
        for axis, curve in found.doubled.items():
            for tilt, d in zip(found.tilts, curve, strict=True):
                if not math.isnan(d.separation_mm):
                    at = [tilt, 0] if axis == "x" else [0, tilt]
                    table.writerow([*head, "doubling", *at, f"{d.separation_mm:.6f}", 0, 0, "mm"])
    return out.getvalue()


def label(gem: Gem) -> str:
    """A gem in few words."""
    return f"{gem.name}, {gem.mineral.id if gem.mineral else f'n = {gem.design.refractive_index:g}'}"


def table_text(analyses: list[Analysis]) -> str:
    """The numbers side by side, for a terminal."""
    heads = [label(found.gem) for found in analyses]
    rows = [
        (title, [_number(found.face_up.get(name)) for found in analyses])
        for name, title in TITLES.items()
        if any(name in found.face_up for found in analyses)
    ]
    rows += [
        (f"{title}, coloured", [_number(found.coloured.luminous.get(name)) if found.coloured else "-" for found in analyses])
        for name, title in TITLES.items()
        if any(found.coloured and name in found.coloured.luminous for found in analyses)
    ]
    measures = [dict(facts(found.gem)) for found in analyses]
    rows += [
        (name, [m.get(name, "-") for m in measures])
        for name in ("L/W", "H/W", "Crown C/W", "Pavilion P/W", "Table T/W", "Volume", "Weight")
        if any(name in m for m in measures)
    ]
    first = max(len(title) for title, _ in rows)
    wide = [max(len(heads[i]), *(len(cells[i]) for _, cells in rows)) for i in range(len(heads))]
    lines = [[" " * first, *heads], *([title.ljust(first), *cells] for title, cells in rows)]
    return "\n".join("  ".join([line[0], *(c.rjust(w) for c, w in zip(line[1:], wide, strict=True))]) for line in lines) + "\n"


def _number(number: Number | None) -> str:
    """ "45.29 % ± 0.02", its bound; or, without a sample, what may be missing, "45.29 % (+0.30)"."""
    if number is None:
        return "-"
    if number.error < number.bound:
        return f"{number.value:.2f} % \N{PLUS-MINUS SIGN} {number.bound:.2f}"
    return f"{number.value:.2f} % (+{number.bound:.2f})"


def html(analyses: list[Analysis], size: int = 280, spp: int = 24) -> str:
    """A page that stands by itself, pictures and all; several gems stand side by side."""
    from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

    pages = Environment(
        loader=PackageLoader("icespar", "."),
        autoescape=select_autoescape(default=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    gems = [
        {
            "label": label(found.gem),
            "title": next((line for line in found.gem.design.headers if line.strip()), found.gem.name),
            "found": found,
            "facts": facts(found.gem),
            "rows": cutting_table(found.gem.design),
            "pictures": [(_png(found.gem, light, tilt, size, spp), words) for light, tilt, words in PICTURES],
            "diagram": _diagram(found.gem),
            "curves": _curves(found) if len(found.tilts) > 1 else "",
        }
        for found in analyses
    ]
    return pages.get_template("report.html").render(
        gems=gems,
        titles=TITLES,
        meaning={name: words for name, words in MEANING.items() if any(name in _names(found) for found in analyses)},
        number=_number,
        version=__version__,
        head=HEAD,
        scope_head=SCOPE_HEAD,
        doubled=_doubled,
        size=size,
        coloured=any(found.coloured for found in analyses),
    )


def _png(gem: Gem, light: str, tilt: tuple[float, float], size: int, spp: int) -> str:
    """A picture as a data URI. The instruments' colours are a code, so those show the clear stone without dispersion."""
    picture = gem.picture(light, tilt, size=size, error=PICTURE_ERROR, spp=spp, clear=light != "lamps")
    return _uri("image/png", picture._repr_png_())


def _uri(kind: str, content: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def _svg(figure) -> str:
    from matplotlib import rc_context

    out = io.BytesIO()
    with rc_context({"svg.fonttype": "path", "svg.hashsalt": "icespar"}):
        figure.savefig(out, format="svg", metadata={"Date": None})
    return _uri("image/svg+xml", out.getvalue())


def _diagram(gem: Gem) -> str:
    from .diagram import facet_diagram

    return _svg(facet_diagram(gem.design))


def _curves(found: Analysis) -> str:
    """Light return, leakage and extinction over the tilt, about both axes; dotted without birefringence, dashed with the stone's colour."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.6), layout="constrained")
    colours = {"iso": "C0", "cosine": "C1", "sc2": "C2", "leakage": "0.35", "extinction": "C4"}
    titles = {"x": "about picture-right (+: upper edge raised)", "y": "about picture-up (+: right edge lowered)"}
    for axes, axis in zip(figure.subplots(1, 2, sharey=True), "xy", strict=True):
        for name, colour in colours.items():
            values = [numbers[name] for numbers in found.curves[axis]]
            middle = [n.value for n in values]
            low, high = [n.value - 2 * n.error for n in values], [n.value + 2 * n.error for n in values]
            axes.fill_between(found.tilts, low, high, color=colour, alpha=0.35, linewidth=0)
            axes.plot(found.tilts, middle, color=colour, linewidth=1.4, label=TITLES[name])
            if found.coloured_curves:
                tinted = [numbers[name].value for numbers in found.coloured_curves[axis]]
                axes.plot(found.tilts, tinted, color=colour, linewidth=1.0, linestyle="--")
            if found.plain_curves:
                plain = [numbers[name][0] for numbers in found.plain_curves[axis]]
                axes.plot(found.tilts, plain, color=colour, linewidth=0.7, linestyle=":")
        axes.set_title(titles[axis], fontsize=9)
        axes.set_xlabel("tilt, degrees", fontsize=9)
        axes.set_xlim(min(found.tilts), max(found.tilts))
        axes.set_ylim(0, 100)
        axes.tick_params(labelsize=8)
        axes.grid(alpha=0.25)
    figure.axes[0].set_ylabel("% of the stone's face", fontsize=9)
    figure.legend(*figure.axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=8, frameon=False)
    return _svg(figure)


def _doubled(found: Analysis) -> str:
    """Where the culet's two images are apart, in words."""
    seen = [
        (d.arc_minutes, d.separation_mm, axis, tilt)
        for axis, curve in found.doubled.items()
        for tilt, d in zip(found.tilts, curve, strict=True)
        if not math.isnan(d.arc_minutes)
    ]
    if not seen:
        return "The culet is not seen through the table at any of these tilts."
    most, apart, axis, tilt = max(seen)
    text = (
        f"Through the table the two images of the culet are farthest apart at a tilt of {tilt:g}\N{DEGREE SIGN} about picture-"
        f"{'right' if axis == 'x' else 'up'}: {apart:.4f} mm, or {most:.2f}' for an eye at 250 mm. "
    )
    straight = next((s[0] for s in seen if s[3] == 0), None)
    if straight is not None:
        text += f"Face-up they are {straight:.2f}' apart. "
    for least, how in ((1.0, "with the naked eye (1')"), (0.1, "through a tenfold loupe (0.1')")):
        tilts = sorted({abs(s[3]) for s in seen if s[0] >= least})
        text += f"They are seen apart {how} " + (f"from a tilt of {tilts[0]:g}\N{DEGREE SIGN} on. " if tilts else "at no such tilt. ")
    return text


def write(path: pathlib.Path, text: str) -> None:
    """The whole file or none of it."""
    part = path.with_name(path.name + ".part")
    try:
        part.write_text(text, encoding="utf-8")
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
