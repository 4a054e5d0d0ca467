"""The optic axis hardly changes what quartz reflects, but it shares out the rest between o and e (Weidlich & Wilkie, figure 3)."""

import argparse
import pathlib

import matplotlib
import numpy as np

import icespar

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

N_O, N_E = 1.544, 1.553
AXES = {  # x lies in the plane of incidence, z is the normal of the face and points into the crystal
    "Axis along the normal (0, 0, 1)": (0, 0, 1),
    "Axis in the face (cos 45°, sin 45°, 0)": (1, 1, 0),
    "Axis inclined (0.75, 0.5, 0.433)": (0.75, 0.5, 0.433),
}
WAVES = {  # where each coefficient stands in a solution, its name and its colour
    ("reflected", 0): ("$R_{%ss}$", "tab:blue"),
    ("reflected", 1): ("$R_{%sp}$", "tab:cyan"),
    ("transmitted", 0): ("$T_{%so}$", "tab:red"),
    ("transmitted", 1): ("$T_{%se}$", "tab:orange"),
}


def coefficients(axis, mode: str, angle: np.ndarray) -> dict:
    """Powers of the four waves that light of polarisation `mode` excites, at each angle of incidence in degrees."""
    radians = np.radians(angle)
    direction = np.stack([np.sin(radians), np.zeros_like(radians), np.cos(radians)], axis=1)
    quartz = icespar.Medium.uniaxial(n_o=N_O, n_e=N_E, axis=axis)
    w = icespar.interface(icespar.Medium.isotropic(1.0), quartz, normal=(0, 0, 1), direction=direction, mode=mode)
    return {(side, column): getattr(w, side).power[:, column] for side, column in WAVES}


def draw(angle: np.ndarray):
    """The figure: a column for each axis, a row for each polarisation of the incident light; and max |R + T - 1|."""
    figure, panels = plt.subplots(2, len(AXES), figsize=(9.6, 6), sharex=True, sharey=True, layout="constrained")
    worst = 0.0
    for column, (title, axis) in enumerate(AXES.items()):
        for row, mode in enumerate("sp"):
            panel = panels[row, column]
            powers = coefficients(axis, mode, angle)
            total = sum(powers.values())
            worst = max(worst, np.abs(total - 1).max())
            for wave, power in powers.items():
                name, colour = WAVES[wave]
                panel.plot(angle, power, color=colour, label=name % mode, zorder=3)
            panel.plot(angle, total, "k:", linewidth=1, label="$R + T$")
            panel.set(xlim=(0, 90), ylim=(-0.02, 1.05), xticks=range(0, 91, 15))
            panel.grid(alpha=0.3)
            cross = powers["reflected", 1 - row].max()
            name = WAVES["reflected", 1 - row][0] % mode
            panel.text(4, 0.16, f"{name} at most {cross:.0e}" if cross > 1e-20 else f"{name} = 0", fontsize=9)
            if row == 0:
                panel.set_title(title, fontsize=10)
            else:
                panel.set_xlabel("angle of incidence (degrees)")
    for row, light in enumerate(("s (across", "p (in")):
        panels[row, 0].set_ylabel(f"power, incident light {light}\nthe plane of incidence)", fontsize=9)
        panels[row, -1].legend(loc="center left", bbox_to_anchor=(1.02, 0.5), fontsize=10, frameon=False)
    figure.suptitle(f"Air to quartz, $n_o$ = {N_O}, $n_e$ = {N_E}: reflection and transmission coefficients")
    return figure, worst


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=pathlib.Path, default="out/paper_figure_3.png", help="the PNG to write")
    output = parser.parse_args().output
    figure, worst = draw(np.linspace(0, 89.9, 900))
    assert worst < 1e-11, f"R + T misses 1 by {worst:.1e}"
    output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(output, dpi=100)
    print(f"R + T = 1 within {worst:.0e} on all curves; the figure is in {output}")


if __name__ == "__main__":
    main()
