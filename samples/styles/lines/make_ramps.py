"""Makes the base coats of these looks again, as ramps of tones: python3 make_ramps.py, in this folder."""

import struct
import zlib

COLUMNS = 256


def write_png(file, row):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    raw = b"\0" + bytes(value for texel in row for value in texel)
    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(row), 1, 8, 2, 0, 0, 0))
                  + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def smooth(x, low, high):
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3.0 - 2.0 * t)


def ramp(first, *steps):
    """Colours from dark to light; a step is (where it begins, where it ends, the colour that it leads to)."""
    row = []
    for column in range(COLUMNS):
        color = first
        for low, high, to in steps:
            t = smooth((column + 0.5) / COLUMNS, low, high)
            color = tuple(a + (b - a) * t for a, b in zip(color, to))
        row.append(tuple(round(value) for value in color))
    return row


CREAM, TAN, SLATE = (246, 240, 228), (190, 166, 132), (88, 96, 104)
WHITE, BLUE, BLACK = (255, 255, 255), (26, 66, 122), (20, 20, 22)

write_png("charcoal.png", ramp((92, 88, 84), (0.02, 0.2, (168, 163, 155)), (0.25, 0.55, CREAM)))
write_png("pencil.png", ramp((176, 176, 180), (0.0, 0.25, (224, 224, 226)), (0.25, 0.5, WHITE)))
write_png("conte.png", ramp((104, 70, 50), (0.02, 0.25, (146, 112, 84)), (0.2, 0.45, TAN), (0.75, 1.0, (232, 216, 190))))
write_png("ink.png", ramp((0, 0, 0), (0.09, 0.11, WHITE)))
write_png("blueprint.png", ramp((18, 50, 98), (0.25, 0.4, BLUE)))
write_png("scratchboard.png", ramp(BLACK, (0.3, 0.9, (52, 52, 56))))
write_png("chalk.png", ramp((58, 58, 96), (0.05, 0.25, (72, 80, 104)), (0.25, 0.5, SLATE), (0.6, 0.9, (196, 168, 138))))
