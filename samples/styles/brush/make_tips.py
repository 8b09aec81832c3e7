"""Makes the bitmap tips of these looks again: python3 make_tips.py, in this folder."""

import math
import random
import struct
import zlib

SIZE = 64


def write_png(file, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    raw = b"".join(b"\0" + bytes(round(255 * (1 - ink)) for ink in row) for row in rows)
    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIZE, SIZE, 8, 0, 0, 0, 0))
                  + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def dry_tip(tufts):
    """A flat brush that runs dry: tufts of hair side by side, each with more or less ink. Dark is ink; the brush moves
    along the picture's x."""
    rows = [[0.0] * SIZE for _ in range(SIZE)]
    draw = random.Random(8)
    for tuft in range(tufts):
        across = (tuft + 0.5 + draw.uniform(-0.3, 0.3)) / tufts * 2 - 1
        along = draw.uniform(-0.3, 0.3)
        radius, ink = draw.uniform(0.05, 0.12), draw.uniform(0.2, 1.0)
        for y in range(SIZE):
            for x in range(SIZE):
                u, v = (x + 0.5) / SIZE * 2 - 1 - along, (y + 0.5) / SIZE * 2 - 1 - 0.9 * across
                covered = min(1.0, max(0.0, (radius - math.hypot(0.5 * u, v)) / 0.04))
                rows[y][x] = max(rows[y][x], ink * covered)
    return rows


write_png("dry.png", dry_tip(9))
