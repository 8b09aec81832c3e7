"""Makes the ramps of the playback tests again: python3 make_ramps.py, in this folder."""

import struct
import zlib


def write_png(file, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    raw = b"".join(b"\0" + bytes(value for texel in row for value in texel) for row in rows)
    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0))
                  + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def mix(a, b, t):
    return tuple(round(x + (y - x) * t) for x, y in zip(a, b))


def tone(x, detail):
    """Four tones at full detail; their edges part from x = .3 on, and all of it fades to paper where detail ends."""
    tones = [(58, 44, 92), (122, 84, 140), (226, 150, 120), (255, 226, 178)]
    edges = [0.3 + detail * (edge - 0.3) for edge in (0.3, 0.55, 0.8)]
    return mix((255, 250, 238), tones[sum(x >= edge for edge in edges)], min(1.0, 1.5 * detail))


columns, rows = 512, 128
write_png("x_toon.png", [[tone((x + 0.5) / columns, 1.0 - y / (rows - 1)) for x in range(columns)] for y in range(rows)])
