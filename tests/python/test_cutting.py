"""Designs in Python: read, written and retargeted; proportions, weight, cutting table and diagram."""

import re
import subprocess

import numpy as np
import pytest

import icespar
from icespar import diagram
from icespar.cutting import facet_names, tier_names

NAMES = ["srb_quartz", "emerald_cut_1.4", "rose_cut_flat", "srb_tolkowsky_diamond", "trilliant_quartz"]


@pytest.fixture(params=NAMES)
def path(root, request):
    return root / "scenes/designs" / f"{request.param}.asc"


def test_a_design_is_read_written_and_read_again_alike(path, tmp_path):
    design = icespar.Design.read(path)
    design.write(tmp_path / "again.asc")
    again = icespar.Design.read(tmp_path / "again.asc")
    assert (again.gear, again.headers, len(again.tiers)) == (design.gear, design.headers, len(design.tiers))
    for a, b in zip(design.tiers, again.tiers, strict=True):
        assert (a.angle, a.distance, a.names, a.instructions) == (b.angle, b.distance, b.names, b.instructions)
        np.testing.assert_array_equal(a.indices, b.indices)


def test_a_design_made_of_tiers_is_the_stone_it_says():
    tiers = [
        icespar.Tier(0, 0.5, [0], ["T"]),
        icespar.Tier(-0.0, 0.25, [0], ["K"], "by eye"),
        icespar.Tier(90, 1, [0, 16, 32, 48]),
    ]
    design = icespar.Design(tiers, gear=64, refractive_index=1.54, headers=["a box"])
    stone = design.stone()
    assert stone.volume == pytest.approx(2 * 2 * 0.75, rel=1e-14)
    assert facet_names(design) == ["T", "K", "G1", "G1", "G1", "G1"]
    p = icespar.proportions(stone)
    assert (p.length, p.height, p.table, p.block_yield) == pytest.approx((1, 0.375, 1, 1), rel=1e-12)
    assert (p.crown, p.girdle, p.pavilion) == pytest.approx((0, 0.375, 0), abs=1e-12)


def test_a_double_pyramid_without_girdle_has_half_its_height_above():
    tiers = [icespar.Tier(sign * 45, np.sqrt(0.5), [0, 24, 48, 72]) for sign in (1, -1)]
    p = icespar.proportions(icespar.Design(tiers).stone())
    assert (p.crown, p.girdle, p.pavilion, p.table) == pytest.approx((0.5, 0, 0.5, 0), abs=1e-12)
    assert p.volume == pytest.approx(1 / 3, rel=1e-12)
    assert p.block_yield == pytest.approx(1 / 3, rel=1e-12)


def test_a_tolkowsky_brilliant_of_one_carat_is_six_and_a_half_millimetres_wide(root):
    p = icespar.proportions(icespar.Design.read(root / "scenes/designs/srb_tolkowsky_diamond.asc").stone())
    assert p.table == pytest.approx(0.53, abs=0.005)  # Tolkowsky (1919): table 53 %, crown 16.2 %, pavilion 43.1 %
    assert p.crown == pytest.approx(0.162, abs=0.005)
    assert p.pavilion == pytest.approx(0.431, abs=0.01)
    assert p.carats(6.5, 3.52) == pytest.approx(1.0, abs=0.1)
    with pytest.raises(ValueError, match="width_mm"):
        p.carats(0, 3.52)


def test_proportions_agree_with_the_program(path, program):
    said = subprocess.run([program, "stone", path], capture_output=True, text=True, check=True).stdout
    p = icespar.proportions(icespar.Design.read(path).stone())
    for name, value in (("L/W", p.length), ("H/W", p.height), ("T/W", p.table)):
        (number,) = re.findall(rf"^{name} +([\d.]+|no table)", said, re.M)
        assert value == pytest.approx(0 if number == "no table" else float(number), abs=6e-5)
    assert p.crown + p.girdle + p.pavilion == pytest.approx(p.height, rel=1e-12)


def test_the_cutting_table_makes_the_stone_again(path):
    design = icespar.Design.read(path)
    rows = icespar.cutting_table(design)
    assert sum(row.count for row in rows) == sum(len(tier.indices) for tier in design.tiers)
    tiers = []
    for row in rows:
        angle = np.copysign(row.angle, -1) if row.side == "pavilion" else row.angle
        tiers.append(icespar.Tier(angle, row.distance, [float(i) for i in row.indices.split("-")]))
    again = icespar.Design(tiers, gear=design.gear, gear_offset=design.gear_offset).stone()
    assert again.volume == pytest.approx(icespar.proportions(design.stone()).volume, rel=1e-6)


def test_names_are_made_up_where_a_file_has_none_and_never_twice():
    index = [0, 24, 48, 72]
    tiers = [
        icespar.Tier(-40, 1, index),
        icespar.Tier(-42, 1, index, ["P1"]),
        icespar.Tier(90, 1, index),
        icespar.Tier(30, 1, index),
        icespar.Tier(0, 0.3, [0]),
    ]
    assert tier_names(icespar.Design(tiers)) == ["P2", "P1", "G1", "C1", "T"]


def test_retargeting_follows_the_program_and_asks_for_the_index(root, program, tmp_path):
    source = root / "scenes/designs/srb_quartz.asc"
    design = icespar.Design.read(source)
    subprocess.run([program, "convert", source, tmp_path / "c.asc", "--index", "1.76"], check=True, capture_output=True)
    program_says = icespar.Design.read(tmp_path / "c.asc")
    for a, b in zip(design.retarget(1.76).tiers, program_says.tiers, strict=True):
        assert (a.angle, a.distance) == pytest.approx((b.angle, b.distance), abs=1e-12)
    with pytest.raises(icespar.Error, match="from_index"):
        icespar.Design(design.tiers).retarget(1.76)


def test_facets_that_do_not_close_say_which_directions_are_open():
    with pytest.raises(icespar.Error, match="runs out towards"):
        icespar.Design([icespar.Tier(90, 1, [0, 24, 48, 72])]).stone()


def shown(axes):
    return [text.get_text() for text in axes.texts]


def test_every_facet_name_stands_in_the_diagram_and_the_views_are_turned_as_they_say(root):
    design = icespar.Design.read(root / "scenes/designs/srb_quartz.asc")
    crown, pavilion, front, end = diagram.facet_diagram(design).axes
    names = set(facet_names(design))
    assert names <= {name for axes in (crown, pavilion, front, end) for name in shown(axes)}

    def place(axes, word):
        (text,) = (t for t in axes.texts if t.get_text() == word)
        return np.sign(np.round(text.get_position(), 6)).tolist()

    assert (place(crown, "24"), place(crown, "96")) == ([1, 0], [0, 1])
    assert (place(pavilion, "24"), place(pavilion, "96")) == ([-1, 0], [0, 1])
    # The side views have the table above: the highest polygon corner is the table's height.
    for axes in (front, end):
        highest = max(patch.get_path().vertices[:, 1].max() for patch in axes.patches)
        assert highest == pytest.approx(design.stone().vertices[:, 2].max())


def test_no_line_to_a_name_strikes_another(root):
    figure = diagram.facet_diagram(root / "scenes/designs/srb_quartz.asc")
    (pavilion,) = (axes for axes in figure.axes if "CU" in shown(axes))
    (culet,) = (text for text in pavilion.texts if text.get_text() == "CU")
    start, end = np.array(culet.xy), np.array(culet.xyann)
    for text in pavilion.texts:
        if text is culet or text.get_transform() is not pavilion.transData:
            continue
        to, along = np.array(text.get_position()) - start, end - start
        part = np.clip(to @ along / (along @ along), 0, 1)
        assert np.linalg.norm(to - part * along) > 0.05 * np.linalg.norm(along), text.get_text()


def test_a_faceting_sheet_holds_the_whole_cutting_table(root):
    design = icespar.Design.read(root / "scenes/designs/trilliant_quartz.asc")
    sheet = diagram.faceting_sheet(design)
    text = "\n".join(t.get_text() for t in sheet.texts)
    for row in icespar.cutting_table(design):
        assert f"{row.angle:.2f}" in text and row.indices.split("-")[0] in text
