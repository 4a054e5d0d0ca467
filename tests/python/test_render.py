"""Pictures from Python: arrays without copies, the same bits, interruptions, files."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import icespar

SMALL = {"size": (24, 16), "spp": 4, "progress": False}


def test_a_picture_is_an_array_that_looks_into_its_memory(calcite_box):
    image = calcite_box.render(**SMALL)
    array = np.asarray(image)
    assert array.shape == image.shape == (16, 24, 3) and array.dtype == np.float32
    assert np.shares_memory(array, image.rgb)
    assert not np.shares_memory(np.array(image), image.rgb)
    assert np.asarray(image, dtype=float).dtype == float
    kept = array.copy()
    del image
    assert (array == kept).all()  # the array keeps the memory alive
    assert array.mean() == pytest.approx(1, abs=0.02)  # the furnace, by roulette


def test_what_is_not_asked_is_not_there(calcite_box):
    image = calcite_box.render(**SMALL)
    assert image.stokes is None and image.spectral is None and image.wavelengths.shape == (0,)


def test_stokes_without_bands_are_those_of_the_colours(glass_box):
    image = glass_box.render(**SMALL, stokes=True)
    assert image.stokes.shape == (16, 24, 4, 3)
    assert (image.stokes[:, :, 0] == image.rgb).all()
    assert (np.linalg.norm(image.stokes[:, :, 1:], axis=2) <= image.stokes[:, :, 0] * (1 + 1e-5)).all()


def test_bands_and_their_stokes_are_views(glass_box):
    image = glass_box.render(**SMALL, stokes=True, spectral=5)
    assert image.wavelengths.shape == (5,) and np.ptp(np.diff(image.wavelengths)) < 1e-9
    assert image.spectral.shape == (16, 24, 5) and image.stokes.shape == (16, 24, 4, 5)
    assert np.shares_memory(image.spectral, image.stokes)
    assert (image.spectral == image.stokes[:, :, 0]).all()
    alone = glass_box.render(**SMALL, spectral=5)
    assert alone.spectral.shape == (16, 24, 5) and alone.stokes is None


def test_the_same_bits_for_any_number_of_threads_and_other_bits_for_another_seed(calcite_box):
    one, two, seven = (calcite_box.render(**SMALL, threads=n).rgb.tobytes() for n in (1, 2, 7))
    assert one == two == seven
    assert one != calcite_box.render(**SMALL, seed=1).rgb.tobytes()


def test_the_report_says_what_was_done(calcite_box):
    report = calcite_box.render(**SMALL).report
    assert report.samples == 4 and report.paths == 16 * 24 * 4 and report.events > 0
    assert report.seconds > 0 and report.bad_samples == 0 and not report.interrupted


def test_a_picture_tells_the_error_of_each_pixel_and_may_be_made_to_the_largest(calcite_box):
    assert calcite_box.render(size=(24, 16), spp=8, engine="rays", progress=False).standard_error is None
    image = calcite_box.render(size=(24, 16), error=0.05, error_metric="max", engine="rays", progress=False)
    assert image.standard_error.shape == (16, 24)
    assert image.standard_error.max() / image.rgb.mean() == pytest.approx(image.report.error, rel=0.01)
    assert image.report.error <= 0.05


def test_files_are_chosen_by_their_ending(calcite_box, tmp_path):
    image = calcite_box.render(**SMALL)
    image.save(tmp_path / "a.exr")
    image.save(str(tmp_path / "a.PNG"))
    assert (tmp_path / "a.PNG").read_bytes() == image._repr_png_()
    assert image._repr_png_().startswith(b"\x89PNG")
    with pytest.raises(ValueError, match=r"\.exr or \.png"):
        image.save(tmp_path / "a.jpg")
    with pytest.raises(icespar.Error):
        image.save(tmp_path / "no_folder" / "a.exr")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.PNG", "a.exr"]
    assert {"seed", "samples", "version"} <= image.metadata.keys()
    assert image.metadata["scene"] == "text"


def test_other_threads_run_while_a_picture_is_made(calcite_box):
    counted = 0
    stop = threading.Event()

    def count():
        nonlocal counted
        while not stop.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    calcite_box.render(size=(64, 64), time=0.5, progress=False)
    stop.set()
    thread.join()
    assert counted > 50


def test_a_function_follows_the_render_and_may_end_it(calcite_box):
    seen = []

    def follow(progress):
        seen.append((progress.done, progress.seconds, progress.samples, progress.error))
        return len(seen) < 3

    image = calcite_box.render(size=(64, 48), spp=100000, engine="rays", progress=follow)
    assert len(seen) >= 3 and image.report.interrupted
    assert all(0 <= done <= 1 for done, *_ in seen)


def test_an_exception_of_that_function_ends_the_render(calcite_box):
    def follow(progress):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        calcite_box.render(size=(64, 48), spp=100000, progress=follow)


def test_ctrl_c_raises_keyboard_interrupt(calcite_box):
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    # A shell's background jobs, such as a runner's, are started with SIGINT ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    start = time.monotonic()
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            calcite_box.render(size=(256, 256), time=60, progress=False)
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - start < 10


@pytest.mark.parametrize(
    "change",
    [
        {"size": (0, 16)},
        {"size": (16,)},
        {"size": 16},
        {"size": (16.5, 16)},
        {"size": (70000, 16)},
        {"spp": 0},
        {"spp": 1.5},
        {"error": 0},
        {"error": float("nan")},
        {"time": -1},
        {"threads": -1},
        {"seed": -1},
        {"spectral": 401},
        {"spectral": -1},
        {"error_metric": "mean"},
    ],
)
def test_an_argument_that_makes_no_sense_is_named(calcite_box, change):
    with pytest.raises(ValueError, match=next(iter(change))):
        calcite_box.render(**({"size": (8, 8), "spp": 1, "progress": False} | change))


def test_a_plan_says_how_a_scene_would_be_rendered(calcite_box):
    plan = calcite_box.plan()
    assert plan.choices["engine"] == "beams" and plan.choices["polarisation"] == "intensity"
    assert "o and e" in plan.reasons["crystals"] and plan.warnings == []
    assert calcite_box.plan(stokes=True).choices["polarisation"] == "Stokes vectors"
    assert str(calcite_box.plan(engine="rays")).splitlines()[-1].split()[:2] == ["engine", "rays"]
    full = calcite_box.render(**SMALL, full=True)
    assert full.stokes is not None and np.mean(full.rgb) == pytest.approx(1, abs=0.05)
