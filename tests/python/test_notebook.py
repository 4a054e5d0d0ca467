"""The notebooks run, and their stored outputs are of the kind that a run gives."""

import json
import runpy

import pytest


def kinds(notebook):
    return [[o["output_type"] for o in cell["outputs"]] for cell in notebook["cells"] if cell["cell_type"] == "code"]


@pytest.mark.parametrize(("name", "least"), [("paper", 13), ("polariscope", 11)])
def test_a_notebook_can_be_replayed(root, name, least, monkeypatch):
    monkeypatch.chdir(root)
    path = root / "docs" / "notebooks" / f"{name}.ipynb"
    stored = json.loads(path.read_text(encoding="utf-8"))
    before = kinds(stored)
    assert sum(map(len, before)) >= least, "run tools/run_notebook.py on it"
    run = runpy.run_path(str(root / "tools" / "run_notebook.py"))["run"]
    assert kinds(run(stored, path.name)) == before  # its cells assert what they claim
