"""The plots of docs/accuracy.md can be drawn, one for each axis that the page shows."""

import re
import runpy


def test_every_axis_of_the_page_is_drawn(root, tmp_path, monkeypatch):
    axes = re.findall(r"\(accuracy/(\w+)\.png\)", (root / "docs" / "accuracy.md").read_text())
    rows = [
        "axis,medium,x,what,median_error,largest_error,single_median,single_largest,median_change,"
        "largest_change"
    ]
    for axis in axes:
        for what in ("totals", "waves"):
            rows += [f"{axis},{medium},{x},{what},1e-16,0,1e-7,1e-6,1e-16,2e-16" for medium in ("uniaxial", "biaxial") for x in (1, 2)]
    (tmp_path / "rows.csv").write_text("\n".join(rows) + "\n")
    tool = str(root / "tools" / "plot_accuracy.py")
    monkeypatch.setattr("sys.argv", [tool, str(tmp_path / "rows.csv"), str(tmp_path / "plots")])
    runpy.run_path(tool, run_name="__main__")
    assert sorted(p.stem for p in (tmp_path / "plots").iterdir()) == sorted(axes)
