"""What our includes share with POV-Ray's has POV-Ray's values: colours, indices, macros, functions."""

import re
import warnings

import pytest

import icespar
from .conftest import HERE

LINE = re.compile(r"^(?:.*the scene says: )?value (\S+) (.*)$", re.M)
OURS = {"Icespar_Colors", "Icespar_Consts", "Icespar_Ior"}


def said_by_us(scene):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        icespar.load(scene)
    return "\n".join(str(warning.message) for warning in caught)


def values(text):
    """The last of what was said of each name: numbers as floats, the rest as words."""
    found = {}
    for name, rest in LINE.findall(text):
        words = rest.replace(",", " ").replace("<", " ").replace(">", " ").split()
        found[name] = [float(w) if re.fullmatch(r"-?\d+\.?\d*", w) else w for w in words]
    return found


def assert_alike(ours, theirs, tolerance):
    assert ours.keys() == theirs.keys() and ours
    for name in ours:
        assert len(ours[name]) == len(theirs[name]), name
        for a, b in zip(ours[name], theirs[name], strict=True):
            assert a == b if isinstance(a, str) else abs(a - b) <= tolerance * max(1, abs(b)), name


@pytest.mark.parametrize(("file", "as_text"), [
    ("colors", 'vstr(5, {0}, " ", 0, 6)'),
    ("ior", "str({0}, 0, 6)"),
    ("consts", "str(vlength({0} + <0, 0, 0>), 0, 6)"),
])  # fmt: skip
def test_every_name_has_povrays_value(file, as_text, root, povray, tmp_path):
    text = (root / "scenes" / "include" / f"{file}.inc").read_text()
    names = sorted(set(re.findall(r"#declare (\w+) =", text)) - OURS)
    assert len(names) > 40
    scene = tmp_path / f"{file}.pov"
    lines = [f'#debug concat("value {name} ", {as_text.format(name)}, "\\n")' for name in names]
    # Ours tells at most 200 messages in a run.
    for start in range(0, len(lines), 150):
        head = ["#version 3.7;", f'#include "{file}.inc"']
        scene.write_text("\n".join(head + lines[start : start + 150]) + "\n")
        _, said = povray(scene, size=(4, 3))
        assert_alike(values(said_by_us(scene)), values(said), 2e-6)


def test_macros_and_functions_have_povrays_values(povray):
    scene = HERE / "values.pov"
    _, said = povray(scene, size=(4, 3))
    ours, theirs = values(said_by_us(scene)), values(said)
    assert len(ours) > 100
    assert_alike(ours, theirs, 1e-5)
