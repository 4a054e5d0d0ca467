"""The extension for editors: valid files, and a grammar that colours a scene."""

import json
import pathlib
import re

FOLDER = pathlib.Path(__file__).parents[2] / "editors" / "vscode"
GRAMMAR = json.loads((FOLDER / "syntaxes" / "spar.tmLanguage.json").read_text())


def scope(text, at=0):
    """The name of the first rule that matches at this place."""
    for rule in GRAMMAR["patterns"]:
        match = re.compile(rule.get("match", rule.get("begin", r"(?!)"))).match(text, at)
        if match and match.end() > at:
            return rule["name"]
    return None


def test_words_have_the_colour_of_their_kind():
    for text, name in [
        ("#declare A = 3;", "keyword.control.directive.spar"),
        ("# while (1)", "keyword.control.directive.spar"),
        ("gem { box { 0, 1 } }", "support.type.block.spar"),
        ("vrotate(x, y)", "support.function.spar"),
        ("pi*2", "constant.language.spar"),
        ("look_at y", "keyword.other.spar"),
        ("photons { }", "comment.unused.left-out.spar"),
        ("difference { }", "invalid.illegal.not-rendered.spar"),
        ("12.5e-3", "constant.numeric.spar"),
        ("// a comment", "comment.line.double-slash.spar"),
        ('"text"', "string.quoted.double.spar"),
        ("My_Own_Name", None),
        ("looking", None),
    ]:
        assert scope(text) == name, text


def test_the_extension_names_files_that_are_there():
    package = json.loads((FOLDER / "package.json").read_text())
    contributes = package["contributes"]
    assert contributes["languages"][0]["extensions"] == [".spar"]
    for path in (contributes["languages"][0]["configuration"], contributes["grammars"][0]["path"]):
        json.loads((FOLDER / path).read_text())
    assert contributes["grammars"][0]["scopeName"] == GRAMMAR["scopeName"]
