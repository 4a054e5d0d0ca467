"""Double refraction where it can be measured: how far apart the two images of a luminous grid are, and which way."""

import numpy as np
import pytest

import icespar

CLEAVAGE = np.radians(101.92)  # the blunt angle of calcite's rhombs
SIZE = WIDTH, HEIGHT = 640, 480
EYE, THICKNESS = 9.0, 1.0  # of scenes/calcite_on_grid.spar, mm
PIXELS_PER_MM = WIDTH / (2 * EYE * np.tan(np.radians(11)))  # on the grid, seen without the rhomb


def turned(v, degrees):
    """The scene language's `rotate y * degrees`: seen from above, from z (up) towards x (right), clockwise."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([c * v[0] + s * v[2], v[1], c * v[2] - s * v[0]])


def walk_off(n_o, n_e, axis):
    """Horizontal shift of the extraordinary ray per unit of height, for light that goes straight up.

    In the principal section tan(axis, ray) = (n_o/n_e)^2 tan(axis, wave normal).
    """
    axis = np.asarray(axis) / np.linalg.norm(axis) * (1 if axis[1] > 0 else -1)
    level = np.array([axis[0], axis[2]])
    sine = np.linalg.norm(level)
    theta = np.arctan2(sine, axis[1])
    return -np.tan(np.arctan((n_o / n_e) ** 2 * np.tan(theta)) - theta) * level / sine


def calcite_axis():
    """The threefold axis of the rhomb as it lies in the scene: equally inclined to the edges of its blunt corner."""
    c, s = np.cos(CLEAVAGE), np.sin(CLEAVAGE)
    along = (c - c * c) / s
    edges = np.array([[1, 0, 0], [c, 0, s], [c, np.sqrt(1 - c * c - along**2), along]])
    axis = turned(edges.sum(axis=0) / np.linalg.norm(edges.sum(axis=0)), np.degrees(CLEAVAGE) / 2 - 45)
    assert np.degrees(np.arccos(axis[1])) == pytest.approx(44.6, abs=0.05)  # a cleavage face from the c axis: handbooks
    return axis


def grid_point(s, n):
    """Where a ray aimed at s on the bare grid meets it through a plate of index n, by Snell's law."""
    tan_i = s / EYE
    sin_t = np.sin(np.arctan(tan_i)) / n
    return s - THICKNESS * (tan_i - np.tan(np.arcsin(sin_t)))


def dark_lines(profile, first):
    """Centres (pixels from the picture's edge) of the dark lines of a profile that begins at pixel `first`."""
    depth = np.clip(np.median(profile) - profile - 0.3 * np.ptp(profile), 0, None)
    lines, inside = [], np.flatnonzero(depth)
    for run in np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1):
        lines.append(np.average(first + run + 0.5, weights=depth[run]))
    return np.array(lines)


def analysed(stokes, axis):
    """What passes an analyser across the principal section (the ordinary image) and along it (the extraordinary)."""
    azimuth = 2 * np.arctan2(axis[2], axis[0])
    polarised = np.cos(azimuth) * stokes[..., 1] + np.sin(azimuth) * stokes[..., 2]
    return {"o": (stokes[..., 0] - polarised) / 2, "e": (stokes[..., 0] + polarised) / 2}


@pytest.fixture(scope="module")
def calcite(root):
    return icespar.load(root / "scenes" / "calcite_on_grid.spar")


@pytest.fixture(scope="module")
def lines_in_the_picture(calcite):
    """Millimetres on the bare grid, right and up from the picture's centre: {"o": (xs, zs), "e": (xs, zs)}."""
    green = calcite.render(size=SIZE, spp=16, stokes=True, progress=False).stokes[..., 1]
    found = {}
    for mode, image in analysed(green, calcite_axis()).items():
        columns, rows = slice(190, 460), slice(120, 370)
        xs = dark_lines(image[260:325, columns].mean(axis=0), columns.start)
        zs = dark_lines(image[rows, 330:390].mean(axis=1), rows.start)
        found[mode] = (xs - WIDTH / 2) / PIXELS_PER_MM, (HEIGHT / 2 - zs) / PIXELS_PER_MM
    return found


def test_calcite_shifts_the_extraordinary_image_by_walk_off_times_thickness(lines_in_the_picture):
    n_o, n_e = icespar.mineral("calcite").indices(550)
    expected = THICKNESS * walk_off(n_o, n_e, calcite_axis())
    assert (np.abs(expected) * PIXELS_PER_MM > 10).all()  # so that a pixel decides
    reduced = (EYE - THICKNESS * (1 - 1 / n_o)) / EYE  # the plate brings the grid nearer to the eye
    for i in range(2):
        o, e = (min(lines_in_the_picture[mode][i], key=abs) for mode in "oe")
        assert abs(e - o - expected[i] / reduced) * PIXELS_PER_MM < 1


def test_snells_law_places_the_ordinary_image(lines_in_the_picture):
    n_o, _ = icespar.mineral("calcite").indices(550)
    for seen in lines_in_the_picture["o"]:
        seen = np.sort(seen)
        assert len(seen) == 3
        np.testing.assert_allclose(grid_point(seen, n_o), [-0.5, 0, 0.5], atol=1 / PIXELS_PER_MM)


def dark_spans(is_dark, low, high):
    """Exact ends (N, 2) of the dark spans that lie whole between low and high."""
    t = np.linspace(low, high, 400)
    dark = is_dark(t)
    before = np.flatnonzero(dark[:-1] != dark[1:])
    a, b, state = t[before], t[before + 1], dark[before]
    for _ in range(40):
        middle = (a + b) / 2
        same = is_dark(middle) == state
        a, b = np.where(same, middle, a), np.where(same, b, middle)
    ends = a[1:] if dark[0] else a
    return ends[: len(ends) // 2 * 2].reshape(-1, 2)


def crossing(scene, axis, mode, near, shift):
    """Where light that leaves straight up shows the crossing of two grid lines, and how wide these are, in mm.

    `shift` is about where the image lies, so that a line is not looked for along another line.
    """
    found = []
    for i in range(2):

        def is_dark(t, i=i):
            origins = np.full((len(t), 3), EYE)
            origins[:, 2 * i] = near[i] + t
            origins[:, 2 - 2 * i] = near[1 - i] + shift[1 - i] + 0.25
            stokes = scene.trace(origins, (0, -1, 0), (1, 0, 0), max_hits=2)
            return analysed(stokes, axis)[mode] < 0.25

        spans = dark_spans(is_dark, -0.4, 0.4)
        found.append(spans[np.argmin(np.abs(spans.mean(axis=1)))])
    ends = np.array(found)
    return near + ends.mean(axis=1), np.ptp(ends, axis=1)


def test_straight_down_the_two_images_are_exactly_a_walk_off_apart(calcite):
    axis = calcite_axis()
    expected = THICKNESS * walk_off(*icespar.mineral("calcite").indices(589.3), axis)
    for mode, shift in {"o": np.zeros(2), "e": expected}.items():
        at, width = crossing(calcite, axis, mode, np.zeros(2), shift)
        np.testing.assert_allclose(at, shift, atol=1e-9)
        np.testing.assert_allclose(width, 0.04, atol=1e-9)


def test_from_the_eye_the_ordinary_image_is_exactly_snells(calcite):
    def is_dark(t):
        aims = np.stack([t, np.zeros_like(t), np.full_like(t, 0.25)], axis=1)
        stokes = calcite.trace((0, EYE, 0), aims - (0, EYE, 0), (1, 0, 0), max_hits=2)
        return analysed(stokes, calcite_axis())["o"] < 0.25

    spans = dark_spans(is_dark, -0.7, 0.7)
    radius = np.hypot(spans, 0.25)
    n_o, _ = icespar.mineral("calcite").indices(589.3)
    expected = np.array([[-0.52, -0.48], [-0.02, 0.02], [0.48, 0.52]])
    np.testing.assert_allclose(spans * grid_point(radius, n_o) / radius, expected, atol=1e-9)


def cubes(figure):
    """What the paper's figures 5, 6 and 7 show: centre, n_o, n_e and axis of each cube, 1.8 mm high."""
    if figure == 5:
        return [((2.2 * i - 3.3, 0), 1.5, 1.5 + 0.1 * i, (-1, 1, -1)) for i in range(4)]
    if figure == 6:
        axes = [(0, 1, 0), (1, 1, 1), (0.904, 0.302, 0.302), (1, 1, 0)]
        return [((2.2 * i - 3.3, 0), 1.5, 1.7, axis) for i, axis in enumerate(axes)]
    return [((2.8 * (i % 3 - 1), 1.4 - 2.8 * (i // 3)), 1.35, 1.5, turned((1, 1, 1), 15 * i)) for i in range(6)]


def images(root, figure):
    """For each cube of the figure: measured shifts of its ordinary and extraordinary image, and the closed form's."""
    scene = icespar.load(root / "scenes" / f"paper_figure_{figure}.spar")
    shifts = []
    for centre, n_o, n_e, axis in cubes(figure):
        near = np.round((np.array(centre) - 0.25) * 2) / 2 + 0.25  # the crossing next to the cube's centre
        along_view = axis[0] == axis[2] == 0
        expected = np.zeros(2) if along_view else 1.8 * walk_off(n_o, n_e, axis)
        o, _ = crossing(scene, axis, "o", near, np.zeros(2))
        e, _ = crossing(scene, axis, "e", near, expected)
        shifts.append((o - near, e - near, expected))
    return np.array(shifts).swapaxes(0, 1)


@pytest.mark.parametrize("figure", [5, 6, 7])
def test_the_cubes_of_the_paper_shift_the_extraordinary_image_alone(root, figure):
    o, e, expected = images(root, figure)
    np.testing.assert_allclose(o, 0, atol=1e-9)
    np.testing.assert_allclose(e, expected, atol=1e-9)
    length = np.linalg.norm(e, axis=1)
    if figure == 5:  # farther with every step of n_e, and for n_e > n_o below, as the paper says
        assert (np.diff(length) > 0.05).all() and (e[1:, 1] < 0).all()
    if figure == 6:  # nothing along the axis; only the upright lines double when the axis leans to the right
        assert length[0] == pytest.approx(0, abs=1e-9) and (length[1:] > 0.1).all()
        assert e[3, 1] == pytest.approx(0, abs=1e-9)
    if figure == 7:  # round by 15 degrees a step, clockwise as the crystal
        np.testing.assert_allclose(length, length[0], atol=1e-9)
        np.testing.assert_allclose(np.diff(np.degrees(np.arctan2(e[:, 0], e[:, 1]))), 15, atol=1e-6)


def test_seen_along_its_axis_a_crystal_is_glass(root):
    text = (root / "scenes" / "paper_figure_6.spar").read_text(encoding="utf-8")
    assert "indices 1.5, 1.7" in text
    crystal, glass = (icespar.load(text.replace("1.5, 1.7", pair)) for pair in ("1.5, 1.7", "1.5, 1.5"))
    x, z = np.meshgrid(np.linspace(-0.89, 0.89, 60), np.linspace(-0.89, 0.89, 60))
    for i, alike in enumerate([True, False, False, False]):
        origins = np.stack([x + 2.2 * i - 3.3, np.full_like(x, EYE), z], axis=-1).reshape(-1, 3)
        seen, of_glass = (scene.trace(origins, (0, -1, 0), (1, 0, 0), threshold=1e-6) for scene in (crystal, glass))
        worst = np.abs(seen - of_glass).max()
        assert worst < 1e-12 if alike else worst > 0.3
