#!/usr/bin/env python3
"""Makes hills.png, the backdrop of the playback tests of pictures: python3 make_pictures.py

spin.mp4 is six frames of a model:
    hachure render ../models/shapes.glb -o spin.mp4 --clip spin --frames 0..5 --fps 10 --size 96x72
"""

import math
import struct
import zlib

WIDTH, HEIGHT = 150, 100


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def hills(x, y):
    """Three ridges under an evening sky, with a sun; y down."""
    color = mix((86, 120, 178), (250, 214, 160), y / HEIGHT)
    sun = math.hypot(x - 104, y - 38)
    color = mix((255, 246, 214), color, min(1, max(0, sun - 9)))
    for number, (base, wave, height, shade) in enumerate([(62, 31, 9, (126, 118, 148)), (72, 19, 7, (84, 84, 118)),
                                                          (86, 47, 6, (40, 46, 70))]):
        ridge = base - height * math.sin(x / wave * math.pi + number) - 0.3 * height * math.sin(x / wave * 9 + number)
        color = mix(color, shade, min(1, max(0, y - ridge + 0.5)))
    return color


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_png(name, pixel):
    rows = b"".join(b"\0" + bytes(round(c) for x in range(WIDTH) for c in pixel(x + 0.5, y + 0.5))
                    for y in range(HEIGHT))
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


write_png("hills.png", hills)
