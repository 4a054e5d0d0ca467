"""How long a small scene takes from the start of the program to a picture of one pixel and one sample; then reads
long scenes with `icespar check`, and tells the processor's time and the memory of each.

    python bench/parse.py build/icespar [--tokens 1000000] [--triangles 100000] [--keep FOLDER]

Needs nothing but Python. The time is user + system, the least of three runs; the memory is the largest of them.
"""

import argparse
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile

SCENES = pathlib.Path(__file__).parents[1] / "scenes"
TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\d.e-]*|\S")


def things():
    for i in itertools.count():
        x, y, z = i % 97, i // 97 % 89, i // 8633
        yield f"sphere {{ <{x}.25, {y * 0.5}, {z}>, 0.{i % 8 + 1} pigment {{ rgb <0.{i % 10}, 0.5, 1> }} }}\n"


def declarations():
    for i in itertools.count():
        yield f"#declare Value{i % 1000} = vrotate(<{i}, 2.5, -3>*0.5 + y, z*30) + <sin({i}), 1, max(1, {i % 7}, 3)>;\n"


def loops():
    yield "#declare Sum = 0;\n#macro Add(A, B) (A + B*0.5) #end\n"
    for i in itertools.count():
        yield f"#for (I, 1, 2) #if (mod(I, 2) = 1) #declare Sum = Add(Sum, {i}); #else #declare Sum = Sum - I; #end #end\n"


def points():
    yield "#declare Points = array {\n"
    for i in itertools.count():
        yield f"  <{i}.125, {-i}, 0.{i}>,\n"


def corner(i, j):
    return f"<{i * 0.01:.6f}, {(i * i + j * j) * 1e-5:.6f}, {j * 0.01:.6f}>"


def triangles():
    """Two in a cell, as programs write them."""
    yield "mesh {\n"
    for n in itertools.count():
        i, j = n // 2 % 224, n // 448
        a, b, c, d = corner(i, j), corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1)
        yield f"  triangle {{ {b if n % 2 else a}, {d if n % 2 else b}, {c} }}\n"


ENDS = {points: "  0 };\n", triangles: "  pigment { rgb 1 }\n}\n"}


def write(kind, file, tokens=None, lines=None):
    """Whole lines of the kind until there are so many tokens, or so many lines."""
    written, out = 0, []
    for line in kind():
        out.append(line)
        written += len(TOKEN.findall(line))
        if len(out) == lines or tokens and written >= tokens:
            break
    file.write_text("".join(out) + ENDS.get(kind, ""))
    return written


def measured(*command):
    """Seconds of processor and MB of one run."""
    out = subprocess.run([sys.executable, "-c", RUN, *command], capture_output=True, text=True, check=True).stdout
    return tuple(float(number) for number in out.split())


# A process of its own, so that the largest memory of all its children is that of one.
RUN = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
use = resource.getrusage(resource.RUSAGE_CHILDREN)
print(use.ru_utime + use.ru_stime, use.ru_maxrss / 1000)
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--tokens", type=int, default=1_000_000)
    parser.add_argument("--triangles", type=int, default=100_000)
    parser.add_argument("--keep", type=pathlib.Path, help="leave the scenes in this folder")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        print(f"{'start-up':24}{'ms':>6}{'MB used':>9}")
        for scene in sorted(SCENES.glob("*.spar")):
            picture = ["-o", pathlib.Path(scratch, "dot.png"), "--size", "1x1", "--spp", "1", "--threads", "1"]
            runs = [measured(arguments.program.resolve(), "render", scene, *picture) for _ in range(3)]
            print(f"{scene.stem:24}{1000 * min(runs)[0]:6.0f}{max(m for _, m in runs):9.0f}")
        folder = arguments.keep or pathlib.Path(scratch)
        folder.mkdir(exist_ok=True)
        print(f"{'scene':14}{'tokens':>10}{'MB':>8}{'s':>8}{'ns/token':>10}{'MB used':>9}")
        for kind in (things, declarations, loops, points, triangles):
            file = folder / f"{kind.__name__}.spar"
            if kind is triangles:
                tokens = write(kind, file, lines=arguments.triangles + 1)
            else:
                tokens = write(kind, file, arguments.tokens)
            runs = [measured(arguments.program.resolve(), "check", file) for _ in range(3)]
            seconds, memory = min(s for s, _ in runs), max(m for _, m in runs)
            size = file.stat().st_size / 1e6
            print(f"{kind.__name__:14}{tokens:10}{size:8.1f}{seconds:8.3f}{1e9 * seconds / tokens:10.0f}{memory:9.0f}")


if __name__ == "__main__":
    main()
