"""The program: exit codes, what it says where, and that a wrong call touches no file."""

import contextlib
import os
import pty
import signal
import subprocess
import time

import pytest

from conftest import BOX

GOOD = BOX.replace("INDICES", "1.5")


@pytest.fixture
def run(program, tmp_path):
    (tmp_path / "box.spar").write_text(GOOD)
    (tmp_path / "bad.spar").write_text(GOOD.replace("interior", "interiro"))

    def call(*arguments):
        return subprocess.run([program, *map(str, arguments)], cwd=tmp_path, capture_output=True, text=True, timeout=60)

    return call


SMALL = ("--size", "16x12", "--spp", "2")


def test_a_scene_becomes_both_files_and_its_lines_are_said(run, tmp_path):
    done = run("render", "box.spar", "-o", "a.exr", "-o", "a.png", *SMALL, "--threads", 1, "--seed", 3)
    assert done.returncode == 0 and done.stdout == ""
    first, kernels, last = done.stderr.splitlines()  # and before the last the bar, on a terminal only
    assert "16x12" in first and "a.exr" in first and "a.png" in first
    assert kernels == "by beams, one path for all wavelengths, intensity, isotropic, sky alone"
    for word in ("Mpath/s", "2 samples", "dropped energy", "0 bad samples"):
        assert word in last
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "a.exr").read_bytes()[:4] == b"\x76\x2f\x31\x01"


def test_the_same_bits_for_any_number_of_threads(run, tmp_path):
    for n in (1, 2, 7):
        assert run("render", "-o", f"{n}.png", "box.spar", *SMALL, "--threads", n).returncode == 0
    assert len({(tmp_path / f"{n}.png").read_bytes() for n in (1, 2, 7)}) == 1


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        ([], "command"),
        (["paint"], "paint"),
        (["render"], "SCENE"),
        (["render", "box.spar"], "--output"),
        (["render", "box.spar", "-o", "a.jpg"], ".png"),
        (["render", "box.spar", "-o", "none/a.exr"], "none"),
        (["render", "box.spar", "-o", "folder.exr"], "folder"),
        (["render", "box.spar", "-o", "a.png", "--stokes"], ".exr"),
        (["render", "box.spar", "-o", "a.exr", "--size", "16"], "640x480"),
        (["render", "box.spar", "-o", "a.exr", "--size", "0x9"], "640x480"),
        (["render", "box.spar", "-o", "a.exr", "--size", "-16x9"], "640x480"),
        (["render", "box.spar", "-o", "a.exr", "--size", "99999999999x9"], "640x480"),
        (["render", "box.spar", "-o", "a.exr", "--spp", "0"], "--spp"),
        (["render", "box.spar", "-o", "a.exr", "--spp", "1.5"], "--spp"),
        (["render", "box.spar", "-o", "a.exr", "--error", "-0.1"], "--error"),
        (["render", "box.spar", "-o", "a.exr", "--error", "nan"], "--error"),
        (["render", "box.spar", "-o", "a.exr", "--time", "0"], "--time"),
        (["render", "box.spar", "-o", "a.exr", "--threads", "-1"], "--threads"),
        (["render", "box.spar", "-o", "a.exr", "--seed", "-1"], "--seed"),
        (["render", "box.spar", "-o", "a.exr", "--spectral", "401"], "--spectral"),
        (["render", "box.spar", "-o", "a.exr", "--frames", "9-1"], "--frames"),
        (["render", "box.spar", "box.spar", "-o", "a.exr"], "box.spar"),
        (["render", "box.spar", "-o", "a.exr", "--allow", "nowhere"], "nowhere"),
    ],
)
def test_wrong_usage_is_code_2_names_the_word_and_touches_no_file(run, tmp_path, arguments, word):
    (tmp_path / "folder.exr").mkdir()
    before = sorted(tmp_path.iterdir())
    done = run(*arguments)
    assert done.returncode == 2
    assert word in done.stderr
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize("scene", ["bad.spar", "missing.spar"])
def test_a_scene_at_fault_is_code_1_and_the_old_picture_stays(run, tmp_path, scene):
    (tmp_path / "a.exr").write_text("old")
    done = run("render", scene, "-o", "a.exr")
    assert done.returncode == 1 and scene in done.stderr
    assert (tmp_path / "a.exr").read_text() == "old"
    assert run("check", scene).returncode == 1


def test_the_error_may_be_that_of_the_worst_pixel(run):
    bounds = ("render", "box.spar", "-o", "max.exr", "--size", "16x16", "--error", "0.2")
    assert run(*bounds, "--error-metric", "max").returncode == 0
    assert run(*bounds, "--error-metric", "mean").returncode == 2


def test_check_says_what_a_good_scene_holds(run):
    done = run("check", "box.spar")
    assert done.returncode == 0 and "1 gem" in done.stdout and done.stderr == ""


def test_plan_gives_the_choice_of_render_with_its_reasons(run, tmp_path):
    done = run("plan", "box.spar")
    assert done.returncode == 0 and done.stderr == ""
    subjects = [line.split()[0] for line in done.stdout.splitlines()]
    assert subjects == "wavelengths polarisation crystals absorption objects surroundings lights pixels survivors engine".split()
    assert "Stokes vectors" in run("plan", "--stokes", "box.spar").stdout
    assert "asked for" in run("plan", "--engine", "rays", "box.spar").stdout.splitlines()[-1]
    assert "found by Embree" in run("plan", "--full", "box.spar").stdout
    assert run("plan", "bad.spar").returncode == 1
    full = run("render", "box.spar", "-o", "full.exr", *SMALL, "--full")
    assert full.returncode == 0 and "Stokes, isotropic, absorbing, Embree" in full.stderr


@contextlib.contextmanager
def ending(process):
    """No render outlives its test."""
    try:
        yield
    finally:
        process.kill()
        process.wait()


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_saves_what_is_there_and_is_code_3(run, program, tmp_path, which):
    process = subprocess.Popen(
        [program, "render", "box.spar", "-o", "a.exr", "--time", "60", "--size", "64x48"],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
    )
    with ending(process):
        assert "64x48" in process.stderr.readline()
        time.sleep(1)
        process.send_signal(which)
        _, rest = process.communicate(timeout=20)
    assert process.returncode == 3
    assert "interrupted" in rest
    assert [p.name for p in tmp_path.glob("a*")] == ["a.exr"]


def test_a_bar_is_drawn_on_a_terminal_and_wiped(run, program, tmp_path):
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [program, "render", "box.spar", "-o", "a.exr", "--time", "1", "--size", "64x48"], cwd=tmp_path, stderr=theirs
    )
    with ending(process):
        process.wait(timeout=30)
    os.close(theirs)
    text = os.read(ours, 1 << 16).decode()
    os.close(ours)
    assert process.returncode == 0
    assert "%" in text and "[#" in text and "|00:0" in text
    assert "\r\x1b[K" in text


def test_the_version_is_the_packages(run):
    import icespar

    assert run("--version").stdout.split() == ["icespar", icespar.__version__]


def test_help_offers_every_command(run):
    everything = run("--help").stdout
    for command in ("render", "plan", "check", "format", "stone", "minerals", "analyse", "compare"):
        assert command in everything
        shown = run(command, "--help")
        assert shown.returncode == 0 and len(shown.stdout) > 100


def test_minerals_are_listed_and_described(run):
    assert "zircon" in run("minerals").stdout
    assert "1.92500" in run("minerals", "Zircon").stdout
    missing = run("minerals", "kryptonite")
    assert missing.returncode == 1 and "kryptonite" in missing.stderr


def test_a_design_is_described(run, root):
    design = next((root / "scenes" / "designs").glob("*.asc"))
    done = run("stone", design)
    assert done.returncode == 0 and "volume" in done.stdout
    broken = run("stone", "none.asc")
    assert broken.returncode == 1 and "none.asc" in broken.stderr
