"""Runs a notebook's code cells in order and stores what they print and draw; no kernel is needed.

tools/run_notebook.py docs/notebooks/paper.ipynb
"""

import argparse
import ast
import base64
import contextlib
import io
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402


def run_cell(source: str, names: dict, place: str) -> list[dict]:
    """The outputs of one cell: its text, the value of its last line, its figures."""
    printed = io.StringIO()
    tree = ast.parse(source, place)
    shows = tree.body and isinstance(tree.body[-1], ast.Expr) and not source.rstrip().endswith(";")
    last = tree.body.pop() if shows else None
    value = None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, place, "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), place, "eval"), names)
    outputs = []
    if printed.getvalue():
        outputs.append({"output_type": "stream", "name": "stdout", "text": printed.getvalue().splitlines(keepends=True)})
    if value is not None:
        outputs.append(
            {"output_type": "display_data", "metadata": {}, "data": {"text/plain": repr(value).splitlines(keepends=True)}}
        )
    for number in plt.get_fignums():
        picture = io.BytesIO()
        plt.figure(number).savefig(picture, format="png", dpi=72, metadata={"Software": None})
        data = {"image/png": base64.b64encode(picture.getvalue()).decode() + "\n", "text/plain": ["<Figure>"]}
        outputs.append({"output_type": "display_data", "metadata": {}, "data": data})
    plt.close("all")
    return outputs


def run(notebook: dict, name: str) -> dict:
    """The notebook with fresh outputs; raises what a cell raises."""
    names = {"__name__": "__main__"}
    plt.close("all")  # figures that the caller left open are none of a cell's
    count = 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            count += 1
            cell["outputs"] = run_cell("".join(cell["source"]), names, f"{name}, cell {count}")
            cell["execution_count"] = count
    return notebook


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("notebook", type=pathlib.Path)
    path = parser.parse_args().notebook
    notebook = run(json.loads(path.read_text(encoding="utf-8")), path.name)
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
