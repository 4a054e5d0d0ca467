"""What a stone may be made of."""

import difflib

from . import _core
from ._core import Error, Mineral


def minerals() -> list[Mineral]:
    """All minerals of the table that scenes name in `mineral "..."`."""
    return _core.minerals()


def mineral(name: str) -> Mineral:
    """The mineral of that id or name, whatever the case. Error (a ValueError) when there is none."""
    found = _core.find_mineral(name)
    if found is None:
        names = [m.id for m in minerals()] + [m.name for m in minerals()]
        near = difflib.get_close_matches(name, names, n=1)
        hint = f"did you mean {near[0]!r}?" if near else "icespar.minerals() lists them"
        raise Error(f"no mineral is called {name!r}; {hint}")
    return found
