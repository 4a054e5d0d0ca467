"""Exact beams in parallel views from Python."""

import math

import icespar
import numpy as np
import pytest


@pytest.fixture(scope="module")
def brilliant(root):
    return icespar.Stone.from_design(root / "scenes/designs/srb_tolkowsky_diamond.asc")


def test_all_light_is_traced_or_untraced(brilliant):
    view = icespar.view(brilliant, icespar.Medium.isotropic(2.42), bound=0.01, error=None)
    total = (view.weight * view.area).sum() / view.area_total + view.untraced
    assert total == pytest.approx(1, abs=1e-12)
    assert view.residue == view.untraced <= 0.01
    assert view.groups == 0 and not view.group.any()
    iso = view.light_return()
    assert iso.error == iso.bound == view.untraced
    assert view.direction.shape == (view.area.size, 3)
    assert np.allclose(np.linalg.norm(view.direction, axis=1), 1)
    assert view.facet_area.sum() == pytest.approx(view.area_total)
    assert not view.direction.flags.writeable


def test_what_is_left_is_sampled(brilliant):
    tilted = {"axis": (1, 0, 0), "direction": (0.1, 0.23, -1)}
    plain = icespar.view(brilliant, "zircon", bound=0.05, error=None, **tilted)
    views = [icespar.view(brilliant, "zircon", bound=0.05, seed=seed, **tilted) for seed in range(2)]
    for view in views:
        exact = view.group == 0
        assert view.groups > 1 and view.group.max() == view.groups
        assert np.array_equal(view.weight[exact], plain.weight)
        assert view.untraced == plain.untraced
        assert (view.weight * view.area).sum() / view.area_total + view.residue == pytest.approx(1, abs=1e-12)
        assert view.residue < 1e-4 * view.untraced
    a, b = (view.light_return("cosine") for view in views)
    assert a.value != b.value
    assert abs(a.value - b.value) < 5 * (a.error + b.error) < a.bound
    low = plain.light_return("cosine")
    assert low.value < a.value < low.value + low.bound
    own = views[0].light_return(lambda d: d @ np.array([-0.1, -0.23, 1]) > 0)
    named = views[0].light_return("iso", head_shadow=0)
    assert own == pytest.approx(named, abs=1e-9)
    # To an error alone: exact tracing ends when sampling costs no more.
    soon = icespar.view(brilliant, "zircon", bound=None, error=1e-3, **tilted)
    assert soon.beams < views[0].beams
    assert soon.light_return("cosine").error < 2e-3
    assert soon.light_return("cosine").value == pytest.approx(a.value, abs=6e-3)


def test_arrays_outlive_their_view(brilliant):
    area = icespar.view(brilliant, "quartz", bound=0.1).area
    assert np.isfinite(area.copy()).all() and (area > 0).all()


def test_a_light_may_be_a_function(brilliant):
    view = icespar.view(brilliant, "zircon", axis=(0, 0, 1), bound=0.02)
    limit = math.cos(math.radians(10))
    own = view.light_return(lambda d: (d[:, 2] > 0) & (d[:, 2] < limit))
    named = view.light_return("iso")
    assert own.value == pytest.approx(named.value, abs=1e-9)
    assert own.bound == pytest.approx(named.bound, abs=1e-12)
    assert own.error == pytest.approx(named.error, abs=1e-9)
    both = view.light_return("cosine", table=True), view.light_return(
        lambda d: np.where(d[:, 2] < limit, np.maximum(d[:, 2], 0), 0), table=True
    )
    assert both[0].value == pytest.approx(both[1].value, abs=1e-9)
    assert both[0].bound == pytest.approx(both[1].bound)
    assert both[0].error == pytest.approx(both[1].error)


def test_a_symmetric_view_is_what_it_is_without(brilliant):
    zircon = icespar.Medium.uniaxial(1.925, 1.984, (0, 0, 1))
    oblique = {"direction": (1e-9, 3e-10, -1)}  # without symmetry
    view, off = (icespar.view(brilliant, zircon, bound=0.01, **way) for way in ({}, oblique))
    exact = [icespar.view(brilliant, zircon, bound=0.01, error=None, **way).beams for way in ({}, oblique)]
    assert exact[0] < 0.15 * exact[1]
    for light in "iso", "cosine":
        a, b = view.light_return(light, table=True), off.light_return(light, table=True)
        assert abs(a.value - b.value) <= 5 * (a.error + b.error) < a.bound + b.bound
    low = [v.light_return(lambda d: d[:, 0] > 0.5) for v in (view, off)]
    assert low[0].value == pytest.approx(low[1].value, abs=0.01)


def test_tilts(brilliant):
    glass = icespar.Medium.isotropic(1.6)
    curve = icespar.tilt_curve(brilliant, glass, (-20, 0, 20), bound=0.02, threads=2)
    assert curve.value.shape == curve.bound.shape == (3, 3)
    assert (curve.bound <= 0.02).all() and (curve.error < 2e-3).all()
    assert curve.value[0] == pytest.approx(curve.value[2], abs=5e-3)
    one = icespar.view(brilliant, glass, bound=0.02, error=5e-4)
    assert curve.value[1, 1] == pytest.approx(one.light_return("cosine").value, abs=1e-15)
    side = icespar.tilt_curve(brilliant, glass, 20, about="y", lights=("iso",), bound=0.02)
    assert side.value.shape == (1, 1)
    with pytest.raises(icespar.Error):
        icespar.tilt_curve(brilliant, glass, about="z")
    with pytest.raises(icespar.Error):
        icespar.tilt_curve(brilliant, glass, direction=(0, 0, -1))


def test_gemray_agrees(brilliant):
    view = icespar.view(brilliant, icespar.Medium.isotropic(2.42), cutoff="gemray")
    assert 100 * view.light_return("iso").value == pytest.approx(74.389, abs=0.15)
    assert view.cut > 0.02


def test_polarisation(brilliant):
    medium = icespar.Medium.isotropic(2.42)
    view = icespar.view(brilliant, medium, direction=(0.3, 0.1, -1), bound=0.02, stokes=True)
    plain = icespar.view(brilliant, medium, direction=(0.3, 0.1, -1), bound=0.02)
    assert view.weight.shape == (view.area.size, 4)
    assert (np.linalg.norm(view.weight[:, 1:], axis=1) <= view.weight[:, 0] * (1 + 1e-12)).all()
    assert view.light_return().value == pytest.approx(plain.light_return().value, abs=1e-12)


def test_coloured_stones_keep_light(brilliant):
    glass = icespar.Medium.isotropic(1.76)
    red = icespar.view(brilliant, glass, absorption=0.3, bound=0.01)
    assert red.absorbed > 0.2
    assert (red.weight * red.area).sum() / red.area_total + red.residue + red.absorbed == pytest.approx(1, abs=1e-11)
    assert red.light_return().value < icespar.view(brilliant, glass, bound=0.01).light_return().value
    across, along = (
        icespar.view(brilliant, "tourmaline", axis=axis, absorption=(2, 0), bound=0.01) for axis in ((0, 0, 1), (1, 0, 0))
    )
    assert across.absorbed > along.absorbed > 0
    name = icespar.mineral("corundum").colours[0]
    assert icespar.view(brilliant, "corundum", colour=name, bound=0.02).absorbed > 0


def test_calls_that_cannot_be_carried_out(brilliant):
    glass = icespar.Medium.isotropic(1.5)
    view = icespar.view(brilliant, glass, bound=0.1)
    for call in (
        lambda: icespar.view(brilliant, "no such stone"),
        lambda: icespar.view(brilliant, glass, axis=(0, 0, 1)),
        lambda: icespar.view(brilliant, glass, cutoff="other"),
        lambda: icespar.view(brilliant, glass, cutoff="gemray", stokes=True),
        lambda: icespar.view(brilliant, glass, direction=(0, 1, 0)),
        lambda: icespar.view(brilliant, glass, bound=-1),
        lambda: icespar.view(brilliant, glass, bound=0, max_beams=0),
        lambda: icespar.view(brilliant, glass, error=-1),
        lambda: icespar.view(brilliant, glass, bound=None, error=None),
        lambda: icespar.view(brilliant, "zircon", cutoff="gemray"),
        lambda: icespar.view(brilliant, glass, absorption=(1, 2)),
        lambda: icespar.view(brilliant, glass, absorption=-1),
        lambda: icespar.view(brilliant, glass, colour="ruby"),
        lambda: icespar.view(brilliant, "corundum", colour="no such colour"),
        lambda: view.light_return("moon"),
        lambda: view.light_return(head_shadow=100),
        lambda: view.light_return(zenith=(0, 0, 0)),
        lambda: view.light_return(lambda d: 1.0),
        lambda: icespar.view(
            icespar.Stone.from_points([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), glass
        ).light_return(table=True),
    ):
        with pytest.raises(icespar.Error):
            call()
