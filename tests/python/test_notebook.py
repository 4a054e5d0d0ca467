"""The notebook of the founding paper runs, and its stored outputs are of the kind that a run gives."""

import json
import runpy


def kinds(notebook):
    return [[o["output_type"] for o in cell["outputs"]] for cell in notebook["cells"] if cell["cell_type"] == "code"]


def test_the_paper_can_be_replayed(root):
    path = root / "docs" / "notebooks" / "paper.ipynb"
    stored = json.loads(path.read_text(encoding="utf-8"))
    before = kinds(stored)
    assert sum(map(len, before)) >= 13, "run tools/run_notebook.py on it"
    run = runpy.run_path(str(root / "tools" / "run_notebook.py"))["run"]
    assert kinds(run(stored, path.name)) == before  # its cells assert what they claim
