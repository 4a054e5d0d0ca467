"""The progress bar of a render: on a terminal or in a notebook, nowhere else."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from . import _core


@contextmanager
def shown(wanted: bool) -> Iterator[Callable[[_core.Progress], None] | None]:
    """A function that draws a Progress while the context lasts; None where no one would see it."""
    if not wanted or not (sys.stderr.isatty() or "ipykernel" in sys.modules):
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
