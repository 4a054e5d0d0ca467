#!/usr/bin/env python3
"""Makes core/spectrum/tables.cpp, CIE tables at 5 nm and the spectra that stand for an RGB colour, and lamps.cpp beside it.

    pip install colour-science==0.4.7 numpy==2.* && python tools/make_spectral_tables.py core/spectrum/tables.cpp

The observer and the illuminants are the published tables of the CIE (015:2018) as colour-science
carries them. The three reflectances of red, green and blue are the smoothest (least sum of squared
steps) that add to 1 at every node, stay above MARGIN and look like the primaries under D65; after
Mallett & Yuksel (2019), "Spectral Primary Decomposition for Rendering with sRGB Reflectance".
"""

import os
import sys
import warnings

import numpy as np

warnings.filterwarnings("ignore")
import colour  # noqa: E402

NODES = np.arange(380, 781, 5)
GRID = np.arange(380, 781, 1)
DECIMALS = 9  # of the reflectances: the renderer corrects the last digits, linearly and exactly
MARGIN = 1e-6  # keeps that correction from leaving 0 .. 1
#: The CIE's illuminants, D65 first; its FL1 is F1 here, as everyone says.
LIGHTS = ["D65", "D50", "A", "C", "D55", "D75", *(f"FL{i}" for i in range(1, 13)), *(f"LED-B{i}" for i in range(1, 6))]
LIGHTS += ["LED-BH1", "LED-RGB1", "LED-V1", "LED-V2"]
PRIMARIES = np.array([[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]])  # Rec. 709


def cie_tables():
    """Observer (81, 3) and the illuminants (81, lights)."""
    observer = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    lights = [colour.SDS_ILLUMINANTS[name] for name in LIGHTS]
    return (
        np.array([observer[float(nm)] for nm in NODES]),
        np.array([[light[float(nm)] for light in lights] for nm in NODES]),
    )


def on_grid():
    """Linear interpolation from the nodes to the 1 nm grid, as a matrix."""
    return np.array([np.interp(GRID, NODES, unit) for unit in np.eye(len(NODES))]).T


def rgb_of_reflectance(observer, d65):
    """(3, 81): linear RGB, under D65, of a reflectance given at the nodes."""
    weights = np.ones(len(GRID))
    weights[[0, -1]] = 0.5
    up = on_grid()
    to_xyz = (up @ observer).T * weights * (up @ d65)
    to_xyz = to_xyz @ up / to_xyz[1].sum()
    white = to_xyz.sum(axis=1)
    columns = np.array([[x / y, 1, (1 - x - y) / y] for x, y in PRIMARIES]).T
    rgb_to_xyz = columns * np.linalg.solve(columns, white)
    return np.linalg.solve(rgb_to_xyz, to_xyz)


def minimise(P, A, b, G, h):
    """argmin x.P.x / 2 with A x = b and G x <= h, by a primal-dual interior-point method."""
    n, m, p = len(P), len(h), len(b)
    x, y = np.full(n, 1 / 3), np.zeros(p)
    s, z = np.maximum(h - G @ x, 0.1), np.ones(m)
    for _ in range(200):
        r_dual, r_eq, r_in = P @ x + A.T @ y + G.T @ z, A @ x - b, G @ x + s - h
        gap = s @ z / m
        if gap < 1e-17 and max(abs(r_dual).max(), abs(r_eq).max(), abs(r_in).max()) < 1e-13:
            break
        kkt = np.block([[P + G.T @ (G * (z / s)[:, None]), A.T], [A, np.zeros((p, p))]])

        def step(target):
            r_c = s * z - target
            rhs = np.concatenate([-r_dual - G.T @ ((z * r_in - r_c) / s), -r_eq])
            d = np.linalg.solve(kkt, rhs)
            ds = -r_in - G @ d[:n]
            return d[:n], d[n:], ds, (-r_c - z * ds) / s

        def longest(v, dv):
            return min([1.0, *(-v[dv < 0] / dv[dv < 0])])

        _, _, ds, dz = step(0)
        a = min(longest(s, ds), longest(z, dz))
        centring = ((s + a * ds) @ (z + a * dz) / (s @ z)) ** 3
        dx, dy, ds, dz = step(centring * gap - ds * dz)
        a = 0.995 * min(longest(s, ds), longest(z, dz))
        x, y, s, z = x + a * dx, y + a * dy, s + a * ds, z + a * dz
    return x


def reflectances(observer, d65):
    """(81, 3): red, green and blue."""
    n = len(NODES)
    to_rgb = rgb_of_reflectance(observer, d65)
    steps = np.diff(np.eye(n), axis=0)
    smooth = steps.T @ steps
    # Blue is what red and green leave: |B'|^2 = |R' + G'|^2.
    P = np.block([[2 * smooth, smooth], [smooth, 2 * smooth]])
    zero, one = np.zeros((3, n)), np.eye(n)
    A = np.block([[to_rgb, zero], [zero, to_rgb]])
    b = np.array([1.0, 0, 0, 0, 1, 0])
    G = np.block([[-one, 0 * one], [0 * one, -one], [one, one]])
    h = np.concatenate([np.full(2 * n, -MARGIN), np.full(n, 1 - MARGIN)])
    red, green = np.round(minimise(P, A, b, G, h), DECIMALS).reshape(2, n)
    return np.array([red, green, 1 - red - green]).T


def rows(table, form):
    return "\n".join("    {" + ", ".join(form(v) for v in row) + "}," for row in table)


def main(path):
    observer, lights = cie_tables()
    basis = reflectances(observer, lights[:, 0])
    text = f"""// CIE tables from 380 to 780 nm at 5 nm, and reflectances of the RGB primaries.
// Made by tools/make_spectral_tables.py.
#include "spectrum/tables.hpp"

// clang-format off
namespace icespar::tables {{

/// CIE 1931 2-degree observer.
const std::array<std::array<double, 3>, nodes> observer{{{{
{rows(observer, lambda v: f"{max(v, 0):.12g}")}
}}}};

/// Red, green, blue.
const std::array<std::array<double, 3>, nodes> primaries{{{{
{rows(basis, lambda v: f"{v:.{DECIMALS}f}")}
}}}};

}}  // namespace icespar::tables
// clang-format on
"""
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    with open(os.path.join(os.path.dirname(path), "lamps.cpp"), "w", encoding="ascii") as file:
        file.write(lamps(lights))


def lamps(lights):
    text = """// Illuminants of the CIE (015:2018) from 380 to 780 nm at 5 nm.
// Made by tools/make_spectral_tables.py.
#include "spectrum/tables.hpp"

// clang-format off
namespace icespar::tables {

const std::array<Lamp, lamp_count> lamps{{
"""
    for name, values in zip(LIGHTS, lights.T):
        numbers = [f"{v:.8g}" for v in values]
        lines = ",\n        ".join(", ".join(numbers[i : i + 12]) for i in range(0, len(numbers), 12))
        text += f'    {{"{name.replace("FL", "F")}", {{\n        {lines}}}}},\n'
    return text + "}};\n\n}  // namespace icespar::tables\n// clang-format on\n"


if __name__ == "__main__":
    main(*sys.argv[1:])
