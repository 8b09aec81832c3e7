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

write_png("paper.png", ramp(WHITE))
write_png("tones.png", ramp((176, 178, 184), (0.42, 0.44, (216, 218, 222)), (0.66, 0.68, WHITE)))
write_png("charcoal.png", ramp((72, 69, 66), (0.2, 0.5, (158, 153, 146)), (0.5, 0.85, CREAM)))
write_png("pencil.png", ramp((150, 150, 156), (0.2, 0.5, (206, 206, 210)), (0.5, 0.85, WHITE)))
write_png("conte.png", ramp((96, 58, 40), (0.2, 0.5, (150, 112, 82)), (0.45, 0.65, TAN), (0.8, 1.0, (228, 212, 186))))
write_png("ink.png", ramp((0, 0, 0), (0.33, 0.35, WHITE)))
write_png("blueprint.png", ramp((16, 46, 92), (0.3, 0.6, BLUE)))
write_png("scratchboard.png", ramp(BLACK, (0.5, 1.0, (60, 60, 64))))
write_png("chalk.png", ramp((50, 50, 92), (0.2, 0.45, (68, 76, 102)), (0.45, 0.65, SLATE), (0.75, 1.0, (178, 158, 134))))
