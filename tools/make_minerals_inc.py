#!/usr/bin/env python3
"""Makes scenes/include/minerals.inc from core/crystal/minerals.csv: every mineral as an interior and a material.

    python3 tools/make_minerals_inc.py

`tests/python/test_includes.py` fails when the file is older than the data.
"""

import csv
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[1]

HEAD = """\
// Minerals by name: I_Quartz is an interior, M_Quartz a material. Made by tools/make_minerals_inc.py.
// The optic axis of a uniaxial stone is its y, the table's normal; Mineral_Along("quartz", x) turns it.
#ifndef (Icespar_Minerals)
#declare Icespar_Minerals = 1;

#macro Mineral(Name) interior { crystal { mineral Name } } #end
#macro Mineral_Along(Name, Axis) interior { crystal { mineral Name axis Axis } } #end

"""


def identifier(name: str) -> str:
    """topaz_imperial is Topaz_Imperial; abbreviations such as cz are CZ."""
    if len(name) <= 3:
        return name.upper()
    if name == "srtio3":
        return "SrTiO3"
    return "_".join(part.capitalize() for part in name.split("_"))


def text() -> str:
    with (ROOT / "core/crystal/minerals.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    groups = {"isotropic": "Isotropic.", "uniaxial": "Uniaxial.", "biaxial": "Biaxial."}
    parts = [HEAD]
    for kind, title in groups.items():
        parts.append(f"// {title}\n")
        for row in rows:
            if row["optic"].startswith(kind):
                name = identifier(row["id"])
                parts.append(
                    f'#declare I_{name} = interior {{ crystal {{ mineral "{row["id"]}" }} }}  // {row["name"]}\n'
                    f"#declare M_{name} = material {{ interior {{ I_{name} }} }}\n"
                )
        parts.append("\n")
    return "".join(parts).rstrip() + "\n#end\n"


if __name__ == "__main__":
    (ROOT / "scenes/include/minerals.inc").write_text(text())
