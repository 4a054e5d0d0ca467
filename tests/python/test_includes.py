"""The library's includes: made anew from the data, and each macro in docs/includes.md with its parameters."""

import re
import runpy


def files(root):
    return sorted((root / "scenes" / "include").glob("*.inc"))


def test_minerals_are_those_of_the_data(root):
    made = runpy.run_path(str(root / "tools" / "make_minerals_inc.py"))["text"]()
    assert (root / "scenes" / "include" / "minerals.inc").read_text() == made, "run tools/make_minerals_inc.py"


def test_every_macro_is_documented_with_its_parameters(root):
    page = (root / "docs" / "includes.md").read_text()
    for file in files(root):
        assert f"{file.name}" in page
        for name, parameters in re.findall(r"#macro (\w+)\(([^)]*)\)", file.read_text()):
            if (name, file.name) not in {("Step_Rows", "cuts.inc"), ("Step_Outline", "cuts.inc")}:
                assert f"`{name}({parameters})`" in page, f"{file.name}: {name}({parameters})"


def test_every_macro_that_the_page_names_is_there(root):
    macros = {
        f"{name}({parameters})"
        for file in files(root)
        for name, parameters in re.findall(r"#macro (\w+)\(([^)]*)\)", file.read_text())
    }
    page = (root / "docs" / "includes.md").read_text()
    for call in re.findall(r"`(\w+\([^`)]*\))`", page):
        assert call in macros or call.startswith(("vtransform", "vinv_transform")), call


