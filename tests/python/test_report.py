"""Analyses and reports: numbers against closed forms, pictures that are turned as they say, pages that stand by themselves."""

import csv
import json
import math
import re
import subprocess

import numpy as np
import pytest

import icespar
from icespar import Design, Tier, analysis
from icespar.gem import Gem

SQUARE = [0, 24, 48, 72]


def plate(half_thickness: float = 0.25, index: float = 1.5) -> Design:
    flat = [Tier(0, half_thickness, [0], ["T"]), Tier(-0.0, half_thickness, [0], ["K"])]
    return Design([*flat, Tier(90, 1, SQUARE, ["G"])], refractive_index=index)


def pyramid(pavilion: float) -> Design:
    """A table over four pavilion facets."""
    rows = [Tier(-pavilion, math.sin(math.radians(pavilion)), SQUARE, ["P"])]
    return Design([*rows, Tier(90, 1, SQUARE, ["G"]), Tier(0, 0.05, [0], ["T"])], refractive_index=2.417)


@pytest.fixture(scope="module")
def brilliant(root):
    return Gem.of(root / "scenes/designs/srb_tolkowsky_diamond.asc", "diamond")


def test_a_plate_is_a_window_of_what_two_faces_pass():
    gem = Gem(plate())
    found = analysis.numbers(analysis.trace(gem, bound=1e-9))
    passed = 1 - (0.5 / 2.5) ** 2
    assert found["window"][0] == pytest.approx(100 * passed**2, abs=1e-6)
    # Between two faces all comes from below but what an odd number of reflections sends back to the head.
    r = 1 - passed
    back = r + passed**2 * r / (1 - r**2)
    assert found["extinction"][0] == pytest.approx(100 * back, abs=1e-6)
    assert found["leakage"][0] == pytest.approx(100 * (1 - back), abs=1e-6)


@pytest.mark.parametrize("tilt", [(0.0, 0.0), (7.0, 0.0), (0.0, -12.0)])
def test_all_light_comes_from_somewhere(brilliant, tilt):
    seen = analysis.trace(brilliant, tilt, bound=5e-3)
    found = analysis.numbers(seen, analysis.frame_of(tilt)[2])
    rest, missing = 100 * seen.untraced, 100 * seen.residue
    value = {name: number.value for name, number in found.items()}
    assert value["iso"] + value["leakage"] + value["extinction"] == pytest.approx(100 - missing, abs=1e-6)
    scopes = [value[f"aset_{colour}"] for colour in ("red", "green", "blue", "black")]
    assert sum(scopes) == pytest.approx(100 - missing, abs=1e-6)
    assert value["idealscope_red"] == pytest.approx(value["aset_red"] + value["aset_green"], abs=1e-9)
    assert value["window"] <= value["leakage"]
    assert missing < 1e-4 * rest
    assert all(number.error <= number.bound for number in found.values())
    assert all(number.bound <= rest + 1e-9 for name, number in found.items() if not name.startswith("table"))


def test_tilting_a_symmetric_stone_either_way_is_the_same(brilliant):
    def iso(tilt):
        return analysis.numbers(analysis.trace(brilliant, tilt, bound=5e-3), analysis.frame_of(tilt)[2])["iso"][0]

    assert iso((10, 0)) == pytest.approx(iso((-10, 0)), abs=0.5)
    assert iso((0, 10)) == pytest.approx(iso((10, 0)), abs=0.5)  # eightfold


@pytest.mark.parametrize(("pavilion", "colour"), [(40.70, "green"), (40.80, "red")])
def test_the_tables_reflection_in_aset_toggles_at_a_pavilion_of_40_75_degrees(pavilion, colour):
    """After two mirrors at P the light is 180 - 4 P from the dop axis; n sin of that is sin 45 at P = 40.75 in diamond."""
    toggles = (180 - math.degrees(math.asin(math.sin(math.radians(45)) / icespar.mineral("diamond").indices(589.3)[0]))) / 4
    assert toggles == pytest.approx(40.75, abs=0.005)
    gem = Gem.of(pyramid(pavilion), "diamond", name="pyramid")
    seen = analysis.trace(gem, bound=5e-2)
    table = gem.stone.names.index("T")
    returned = (seen.entry == table) & (seen.facet == table) & (seen.hits == 4) & (seen.weight > 0.5)
    height = seen.direction[returned, 2]
    assert height.size and np.all((height > math.sin(math.pi / 4)) == (colour == "red"))
    rgb = gem.picture("aset", size=9, error=None, spp=2, clear=True).rgb[4, 3]
    assert rgb.argmax() == ("red", "green").index(colour)


def test_fire_needs_dispersion(brilliant):
    plain = Gem(brilliant.design, name="of one index")
    assert analysis.fire(plain, bound=0.02)[0] == pytest.approx(0, abs=1e-9)
    fire, _, error = analysis.fire(brilliant, bound=0.02)
    glass = Gem.of(brilliant.design, "fluorite", name="fluorite")
    assert fire > analysis.fire(glass, bound=0.02)[0] + 4 * error > 0


def test_the_culet_is_doubled_by_the_walk_off():
    gem = Gem.of(plate(0.25), "calcite", name="plate", axis=(1, 0, 1), width_mm=2)
    d = analysis.doubling(gem)
    walk_off = gem.medium().modes((0, 0, 1)).walk_off[0, 1]
    assert d.separation_mm == pytest.approx(0.5 * math.tan(walk_off), rel=1e-9)
    assert d.arc_minutes == pytest.approx(math.degrees(d.separation_mm / 250) * 60, rel=1e-6)
    assert analysis.doubling(Gem.of(plate(), "calcite", name="plate")).separation_mm == pytest.approx(0, abs=1e-12)


def test_without_birefringence_the_difference_is_a_number(root):
    gem = Gem.of(root / "scenes/designs/rose_cut_flat.asc", "zircon")
    found = analysis.analyse(gem, [0], bound=2e-2, error=1e-3)
    assert set(found.effect) == set(found.without)
    value, bound, error = found.effect["iso"]
    assert value == found.face_up["iso"].value - found.without["iso"].value and 0 < error < bound
    # The mean of n_o, n_o and n_e.
    assert gem.mean_index() == pytest.approx((2 * 1.925 + 1.984) / 3, abs=1e-4)


def test_pictures_are_turned_as_they_say():
    # A deep pavilion below a flat crown, wider to the right: what is raised is seen to move.
    long = [Tier(90, 1, SQUARE, ["G"]), Tier(0, 0.05, [0], ["T"]), Tier(-80, 1, SQUARE, ["P"])]
    gem = Gem(Design(long, refractive_index=1.5), name="deep")

    def middle(tilt):
        picture = gem.picture("idealscope", tilt, size=41, error=None, spp=1).rgb
        stone = np.argwhere(np.abs(picture - picture[0, 0]).max(axis=2) > 0.02)  # the corner is sky
        return stone.mean(axis=0) - 20

    row, column = middle((50, 0))  # the upper edge is raised: the culet swings up in the picture
    assert row < -3 and abs(column) < 2
    row, column = middle((0, 50))  # the right edge is lowered: the culet swings to the left
    assert column < -3 and abs(row) < 2
    row, column = middle((0, 0))
    assert abs(row) < 1 and abs(column) < 1


@pytest.mark.parametrize("axis", [(0.3, 0.5, 0.8), (-0.3, 0.5, 0.8)])
def test_a_picture_is_as_bright_as_the_numbers_say_whatever_the_axis_and_the_tilt(root, axis):
    """Two engines, and two ways from the design's frame to the viewer's."""
    gem, tilt, size = Gem.of(root / "scenes/designs/trilliant_quartz.asc", "calcite", axis=axis), (15.0, 8.0), 96
    seen = analysis.trace(gem, tilt, bound=1e-2)
    value, _, error = analysis.numbers(seen, analysis.frame_of(tilt)[2])["sc2"]
    assert error < 0.05
    picture = gem.picture("sc2", tilt, size=size, error=None, spp=16, clear=True)
    side = 2 * 1.05 * np.linalg.norm(gem.stone.vertices, axis=1).max() / size
    light = 100 * float(picture.rgb[..., 1].sum(dtype=float)) * side**2 / seen.area_total
    assert light == pytest.approx(value, abs=0.3)


@pytest.fixture(scope="module")
def call(program, root, tmp_path_factory):
    folder = tmp_path_factory.mktemp("reports")

    def run(*words):
        words = [str(root / "scenes/designs" / w) if str(w).endswith(".asc") else str(w) for w in words]
        return subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, timeout=120), folder

    return run


QUICK = ("--tilt", 10, "--step", 10, "--bound", 2, "--error", 0.2, "--size", 16, "--spp", 1)


def test_the_program_writes_a_page_that_stands_by_itself(call, root):
    done, folder = call(
        "analyse", "trilliant_quartz.asc", "--mineral", "corundum", "--colour", "ruby", "--width", 8, "--coloured", *QUICK,
        "-o", "r.html", "--json", "r.json", "--csv", "r.csv",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    page = (folder / "r.html").read_text(encoding="utf-8")
    assert page.count('src="data:image/png;base64,') == 6 and page.count('src="data:image/svg+xml;base64,') == 2
    assert not re.findall(r'(?:src|href)="(?!data:)', page) and "http" not in re.sub(r"base64,[^\"]*", "", page)
    design = Design.read(root / "scenes/designs/trilliant_quartz.asc")
    for row in icespar.cutting_table(design):
        assert f"<td>{row.name}</td>" in page
    numbers = json.loads((folder / "r.json").read_text())
    assert numbers["mineral"] == "corundum" and numbers["tilts"] == [-10, 0, 10]
    assert numbers["carats"] == pytest.approx(icespar.proportions(design.stone()).carats(8, 4.0))
    tinted = numbers["coloured"]
    assert set(numbers["face_up"]) | set(tinted["face_up"]) == set(numbers["meaning"])
    assert 0 < tinted["face_up"]["iso"]["value"] < numbers["face_up"]["iso"]["value"] and '<th class="n">ruby</th>' in page
    rows = list(csv.DictReader((folder / "r.csv").read_text().splitlines()))
    assert {row["quantity"] for row in rows} >= {"iso", "leakage", "fire", "weight", "doubling", "absorbed"}
    at = {(r["quantity"], r["colour"], r["birefringence"], r["tilt_x"], r["tilt_y"]): r for r in rows}
    iso = at["iso", "", "yes", "10.0", "0"]
    assert float(at["iso", "ruby", "yes", "10.0", "0"]["value"]) == pytest.approx(tinted["curves"]["x"][2]["iso"]["value"], abs=1e-5)
    assert float(iso["value"]) == pytest.approx(numbers["curves"]["x"][2]["iso"]["value"], abs=1e-5)


def test_designs_and_minerals_are_compared_side_by_side(call):
    done, _ = call("compare", "rose_cut_flat.asc", "trilliant_quartz.asc", "diamond", "fluorite", *QUICK, "--tilt", 0)
    assert done.returncode == 0, done.stderr
    head, *lines = done.stdout.splitlines()
    for label in ("rose_cut_flat, diamond", "rose_cut_flat, fluorite", "trilliant_quartz, diamond"):
        assert label in head
    (iso,) = (line for line in lines if line.startswith("Light return ISO"))
    assert len(re.findall(r"\d+\.\d\d %", iso)) == 4


def test_a_design_is_cut_for_its_mineral_where_asked(call, root):
    done, folder = call("analyse", "rose_cut_flat.asc", "--mineral", "diamond", "--retarget", *QUICK, "--csv", "r.csv")
    assert done.returncode == 0, done.stderr
    wanted = icespar.proportions(Design.read(root / "scenes/designs/rose_cut_flat.asc").retarget(2.41726).stone()).height
    rows = csv.DictReader((folder / "r.csv").read_text().splitlines())
    (height,) = (float(row["value"]) for row in rows if row["quantity"] == "height")
    assert height == pytest.approx(wanted, abs=1e-4)


@pytest.mark.parametrize("length", [1e-320, 1e-200, 1e300])
def test_an_axis_is_a_direction_however_long(root, length):
    design = root / "scenes/designs/rose_cut_flat.asc"
    axis = Gem.of(design, "zircon", axis=(length, 0, length)).axis
    assert axis == pytest.approx((math.sqrt(0.5), 0, math.sqrt(0.5)), abs=1e-3)


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("analyse",), 2, "DESIGN"),
        (("analyse", "rose_cut_flat.asc", "--mineral", "corundun"), 1, "did you mean 'corundum'"),
        (("analyse", "rose_cut_flat.asc", "--mineral", "corundum", "--colour", "emerald"), 1, "'ruby'"),
        (("analyse", "absent.asc"), 1, "absent.asc"),
        (("analyse", "rose_cut_flat.asc", "-o", "r.pdf"), 1, ".html"),
        (("analyse", "rose_cut_flat.asc", "-o", "none/r.html"), 1, "none"),
        (("analyse", "rose_cut_flat.asc", "--axis", "0,0,0"), 2, "--axis"),
        (("analyse", "rose_cut_flat.asc", "--width", "-1"), 2, "--width"),
        (("analyse", "rose_cut_flat.asc", "--mineral", "quartz", "--width", "1e300"), 1, "width"),
        (("analyse", "rose_cut_flat.asc", "--step", "1e-9"), 1, "--step"),
        (("analyse", "rose_cut_flat.asc", "--step", "5e-324"), 1, "--step"),
        (("convert", "rose_cut_flat.asc", "c.stl", "--from", "2"), 1, "--index"),
        (("convert", "rose_cut_flat.asc", "c.stl", "--index", "1e300"), 1, "between 1 and 10"),
        (("compare", "quartz"), 1, "design"),
    ],
)
def test_wrong_calls_say_what_is_wrong(call, words, code, said):
    done, folder = call(*words)
    assert done.returncode == code and said in done.stderr, done.stderr
    assert "Traceback" not in done.stderr and not (folder / "r.pdf").exists()


def test_a_python_that_is_not_there_is_named(program, root):
    design = root / "scenes/designs/rose_cut_flat.asc"
    environment = {"ICESPAR_PYTHON": "/no/such/python", "PATH": "/usr/bin:/bin"}
    done = subprocess.run([program, "analyse", design], capture_output=True, text=True, env=environment, timeout=60)
    assert done.returncode == 1 and "/no/such/python" in done.stderr and "ICESPAR_PYTHON" in done.stderr


def test_the_truth_lies_within_the_bound_of_a_number_and_bounds_are_no_wider_than_that(root):
    gem = Gem.of(root / "scenes/designs/srb_quartz.asc", "zircon", axis=(1, 0, 1))
    tilt = (0.0, 17.0)

    def sampled(seed, error):
        seen = analysis.trace(gem, tilt, bound=None, error=error, seed=seed, table_error=True)
        return analysis.numbers(seen, analysis.frame_of(tilt)[2])

    truth = sampled(99, 2e-4)
    names = ("iso", "sc2", "table_iso", "window", "extinction", "aset_red")
    off = np.array(
        [
            [abs(found[k].value - truth[k].value) / math.hypot(found[k].bound, truth[k].bound) for k in names]
            for found in (sampled(seed, 3e-3) for seed in range(60))
        ]
    )
    assert np.mean(off < 1) > 0.985
    assert np.mean(off < 1 / 6) < 0.6
