"""The optics library by itself: installed, found, and linked by the example of its page."""

import re
import shutil
import subprocess

import pytest

NONE_OF = ("CGAL", "embree", "OpenEXR", "TBB", "PNG", "Python", "pybind11")


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def installed(program, tmp_path_factory):
    prefix = tmp_path_factory.mktemp("installed")
    run("cmake", "--install", program.parent, "--component", "optics", "--prefix", prefix)
    return prefix


@pytest.fixture
def project(root, tmp_path):
    page = (root / "docs" / "optics_library.md").read_text()
    for name, language in (("CMakeLists.txt", "cmake"), ("main.cpp", "cpp")):
        (example,) = re.findall(rf"```{language}\n(.*?)```", page, re.S)
        (tmp_path / name).write_text(example)
    return tmp_path


def build(project, installed, *options):
    ninja = ("-G", "Ninja") if shutil.which("ninja") else ()
    launcher = ("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache",) if shutil.which("ccache") else ()
    run("cmake", *ninja, *launcher, "-S", project, "-B", project / "b", f"-DCMAKE_PREFIX_PATH={installed}", *options)
    run("cmake", "--build", project / "b", "--parallel", "2")
    return run(project / "b" / "calcite")


@pytest.mark.parametrize("form", ["optics", "optics_headers"])
def test_the_example_of_the_page_runs_with_either_form(project, installed, form):
    text = project / "CMakeLists.txt"
    text.write_text(text.read_text().replace("icespar::optics)", f"icespar::{form})"))
    said = build(project, installed)
    powers = [float(power) for power in re.findall(r"power ([\d.]+)", said)]
    assert len(powers) == 2 and powers[0] == 0 and powers[1] > 0.9  # p light in the plane of the axis is all e
    assert "R + T = 1.000000000000" in said or "R + T = 0.999999999999" in said


def test_an_unknown_component_and_a_newer_version_are_not_found(project, installed):
    text = project / "CMakeLists.txt"
    whole = text.read_text()
    for wanted, reason in (("0.1 REQUIRED COMPONENTS paint", "paint"), ("0.99 REQUIRED COMPONENTS optics", "version")):
        text.write_text(whole.replace("0.1 REQUIRED COMPONENTS optics", wanted))
        done = subprocess.run(
            ["cmake", "-S", project, "-B", project / "b", f"-DCMAKE_PREFIX_PATH={installed}"], capture_output=True, text=True
        )
        assert done.returncode != 0 and reason in done.stderr


def test_the_optics_alone_look_for_no_package(root, tmp_path):
    without = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in NONE_OF]
    run("cmake", "-S", root, "-B", tmp_path, "-DICESPAR_OPTICS_ONLY=ON", *without)
    for name in NONE_OF:
        assert f"{name}_DIR" not in (tmp_path / "CMakeCache.txt").read_text()
