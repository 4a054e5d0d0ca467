"""Progress bars: on a terminal or in a notebook, nowhere else."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from . import _core


@contextmanager
def shown(wanted: bool) -> Iterator[Callable[[_core.Progress], None] | None]:
    """A function that draws a Progress while the context lasts; None where no one would see it."""
    if not wanted or not _seen():
        yield None
        return
    from tqdm.auto import tqdm

    layout = "{percentage:3.0f} % |{bar}| {postfix[0]} {elapsed}|{remaining}"
    with tqdm(total=1.0, leave=False, file=sys.stderr, bar_format=layout, postfix=[""]) as bar:

        def draw(progress: _core.Progress) -> None:
            if progress.error > 0:
                bar.postfix[0] = f"error {progress.error:.2g}"
            bar.update(min(max(progress.done, 0.0), 1.0) - bar.n)

        yield draw


@contextmanager
def bar(label: str) -> Iterator[Callable[[float], None] | None]:
    """A function that draws the part that is done, 0 .. 1; None where no one would see it."""
    if not _seen():
        yield None
        return
    from tqdm.auto import tqdm

    layout = "{desc} {percentage:3.0f} % |{bar}| {elapsed}|{remaining}"
    with tqdm(total=1.0, leave=False, file=sys.stderr, bar_format=layout, desc=label) as drawn:
        yield lambda done: drawn.update(done - drawn.n)


def _seen() -> bool:
    return sys.stderr.isatty() or "ipykernel" in sys.modules
