"""Stones by themselves: what goes in, what can be read off, and what is refused."""

import numpy as np
import pytest

import icespar

AXES = np.concatenate([np.eye(3), -np.eye(3)])


def test_a_box_from_planes_has_its_volume_areas_and_corners():
    stone = icespar.Stone.from_planes(normals=2 * AXES, distances=2 * np.array([1, 2, 3, 1, 2, 3]))
    assert stone.volume == pytest.approx(2 * 4 * 6, rel=1e-14)
    assert stone.size == pytest.approx((4, 2, 6), rel=1e-12)  # length, width, height (z)
    assert stone.vertices.shape == (8, 3)
    np.testing.assert_allclose(np.abs(stone.vertices), [[1, 2, 3]] * 8)
    np.testing.assert_allclose(stone.normals, AXES, atol=1e-15)
    np.testing.assert_allclose(stone.distances, [1, 2, 3, 1, 2, 3])
    np.testing.assert_allclose(stone.areas, [24, 12, 8, 24, 12, 8])
    assert stone.unreached == []


def test_one_distance_serves_all_planes():
    assert icespar.Stone.from_planes(AXES, 1.5).volume == pytest.approx(27, rel=1e-14)


def test_facets_run_counter_clockwise_as_seen_from_outside():
    rng = np.random.default_rng(3)
    stone = icespar.Stone.from_points(rng.normal(size=(40, 3)))
    assert len(stone.facets) == len(stone.normals) == len(stone.areas) == len(stone.names)
    for corners, normal, distance in zip(stone.facets, stone.normals, stone.distances, strict=True):
        polygon = stone.vertices[corners]
        assert np.cross(polygon[1] - polygon[0], polygon[2] - polygon[0]) @ normal > 0
        np.testing.assert_allclose(polygon @ normal, distance, atol=1e-12)


def test_names_follow_the_planes_and_a_plane_too_far_out_is_named():
    normals = np.concatenate([AXES, [[1, 1, 0]]])
    stone = icespar.Stone.from_planes(normals, [1, 1, 1, 1, 1, 1, 9], names=[*"abcdef", "far"])
    assert stone.names == [*"abcdef"]
    assert stone.unreached == ["far"]


@pytest.mark.parametrize(
    "build",
    [
        lambda: icespar.Stone.from_planes(AXES[:5], np.ones(5)),
        lambda: icespar.Stone.from_planes(AXES, [1, 1, 1, -2, 1, 1]),
        lambda: icespar.Stone.from_planes(0 * AXES, np.ones(6)),
        lambda: icespar.Stone.from_planes(AXES, np.full(6, np.nan)),
        lambda: icespar.Stone.from_planes(AXES, np.ones(5)),
        lambda: icespar.Stone.from_planes(AXES[:, :2], np.ones(6)),
        lambda: icespar.Stone.from_planes(AXES, np.ones(6), names=["a"]),
        lambda: icespar.Stone.from_points([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]),
        lambda: icespar.Stone.from_points(np.zeros((0, 3))),
        lambda: icespar.Stone.from_design("no_such_file.asc"),
    ],
)
def test_what_encloses_nothing_is_refused_with_a_reason(build):
    with pytest.raises(ValueError) as caught:
        build()
    assert len(str(caught.value)) > 15


def test_a_design_is_read_in_its_own_frame(tmp_path):
    design = tmp_path / "square.asc"
    design.write_text(
        "GemCad 5.0\ng 96 0.0\ny 4 n\nI 1.54\na -90.0 1.0 0 n G 24 48 72\na 0.0 0.5 96 n T\na -45.0 1.0 0 n P 24 48 72\n"
    )
    stone = icespar.Stone.from_design(design)
    table = stone.names.index("T")
    np.testing.assert_allclose(stone.normals[table], [0, 0, 1], atol=1e-15)
    assert stone.size[:2] == pytest.approx((2, 2))
    assert stone.vertices[:, 2].max() == pytest.approx(0.5)


def test_minerals_are_found_by_name_and_misspelt_ones_are_corrected():
    zircon = icespar.mineral("Zircon")
    assert zircon.id == "zircon" and zircon in icespar.minerals()
    np.testing.assert_allclose(zircon.indices(589.3), zircon.indices_589, atol=2e-4)
    assert zircon.indices([[400, 500, 600]]).shape == (1, 3, 2)
    medium = zircon.medium(axis=(0, 1, 0))
    assert medium.birefringent and medium.n_e > medium.n_o
    with pytest.raises(icespar.Error, match="did you mean 'zircon'"):
        icespar.mineral("zirkon")
    assert not icespar.mineral("diamond").medium().birefringent


def test_minerals_have_colours_by_name():
    corundum = icespar.mineral("corundum")
    assert "ruby" in corundum.colours and icespar.mineral("calcite").colours == []
    ruby = corundum.absorption("ruby", [550, 700])
    assert ruby.shape == (2, 2) and ruby[0, 0] > ruby[0, 1] > ruby[1, 0] >= 0
    with pytest.raises(icespar.Error, match="no colour 'rubi'"):
        corundum.absorption("rubi", 550)
