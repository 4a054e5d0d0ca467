"""Writes scenes/room.exr, the panorama of a room that scenes/room.spar stands in.

    .venv/bin/python tools/make_room.py scenes/room.exr
"""

import sys

import numpy as np
import OpenImageIO as oiio

WIDTH, HEIGHT = 256, 128


def room() -> np.ndarray:
    """Linear RGB as a lat-long panorama: +z in the middle, +x to the right of it, +y at the top."""
    longitude = (np.arange(WIDTH) + 0.5) / WIDTH * 2 * np.pi - np.pi
    latitude = np.pi / 2 - (np.arange(HEIGHT) + 0.5) / HEIGHT * np.pi
    a, b = np.meshgrid(longitude, latitude)
    x, y, z = np.cos(b) * np.sin(a), np.sin(b), np.cos(b) * np.cos(a)
    picture = np.empty((HEIGHT, WIDTH, 3), np.float32)
    # Walls at a distance of 2 in a square room, 1.2 high above the table and 0.8 deep below it.
    reach = 2 / np.maximum(np.abs(x), np.abs(z))
    height = y * reach
    picture[:] = (0.10, 0.09, 0.08)
    picture[height > 1.2] = (0.16, 0.16, 0.16)
    picture[height < -0.8] = (0.05, 0.03, 0.02)

    def panel(wall: np.ndarray, along: np.ndarray, low: float, high: float, colour: tuple[float, ...]) -> None:
        on = wall & (np.abs(along * reach) < 0.6) & (height > low) & (height < high)
        bar = np.abs(along * reach) < 0.05
        picture[on & ~bar] = colour

    panel((-x > np.abs(z)), z, 0.1, 1.1, (9, 10, 12))  # a window to the left
    panel((z > np.abs(x)), x, 0.2, 1.0, (5, 5.5, 6.5))  # one straight behind
    lamp = (x - 0.55) ** 2 + (y - 0.8) ** 2 + (z + 0.24) ** 2 < 0.02
    picture[lamp] = (24, 17, 8)
    return picture


def main() -> None:
    picture = room()
    out = oiio.ImageOutput.create(sys.argv[1])
    spec = oiio.ImageSpec(WIDTH, HEIGHT, 3, oiio.HALF)
    spec.attribute("compression", "zip")
    if not out or not out.open(sys.argv[1], spec) or not out.write_image(picture):
        sys.exit(oiio.geterror())
    out.close()


if __name__ == "__main__":
    main()
