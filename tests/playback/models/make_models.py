"""Makes the models of the playback tests again: python3 make_models.py, in this folder."""

import json
import math
import struct


class Glb:
    def __init__(self):
        self.binary = b""
        self.json = {"asset": {"version": "2.0"}, "buffers": [], "bufferViews": [], "accessors": [], "meshes": [],
                     "materials": [], "nodes": [], "animations": [], "scene": 0, "scenes": [{"nodes": []}]}

    def accessor(self, values, kind, component="f"):
        flat = [x for v in values for x in (v if isinstance(v, (list, tuple)) else [v])]
        self.binary += b"\0" * (-len(self.binary) % 4)
        data = struct.pack("<%d%s" % (len(flat), component), *flat)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[kind]
        accessor = {"bufferView": len(self.json["bufferViews"]) - 1, "count": len(flat) // width, "type": kind,
                    "componentType": {"f": 5126, "H": 5123, "B": 5121}[component]}
        if kind in ("VEC3", "SCALAR") and component == "f":
            accessor["min"] = [min(flat[i::width]) for i in range(width)]
            accessor["max"] = [max(flat[i::width]) for i in range(width)]
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def material(self, name, color):
        self.json["materials"].append({"name": name, "pbrMetallicRoughness": {"baseColorFactor": color + [1]}})
        return len(self.json["materials"]) - 1

    def mesh(self, name, positions, normals, indices, material, **more):
        attributes = {"POSITION": self.accessor(positions, "VEC3"), "NORMAL": self.accessor(normals, "VEC3")}
        attributes.update(more.pop("attributes", {}))
        primitive = {"attributes": attributes, "indices": self.accessor(indices, "SCALAR", "H"), "material": material}
        primitive.update(more.pop("primitive", {}))
        self.json["meshes"].append({"name": name, "primitives": [primitive], **more})
        return len(self.json["meshes"]) - 1

    def node(self, **node):
        self.json["nodes"].append(node)
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)
        return len(self.json["nodes"]) - 1

    def clip(self, name, channels):
        samplers, list_ = [], []
        for node, path, times, values in channels:
            kind = {"rotation": "VEC4", "weights": "SCALAR"}.get(path, "VEC3")
            samplers.append({"input": self.accessor(times, "SCALAR"), "output": self.accessor(values, kind)})
            list_.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})
        self.json["animations"].append({"name": name, "samplers": samplers, "channels": list_})

    def write(self, file):
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        self.json = {key: value for key, value in self.json.items() if value != []}
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        binary = self.binary + b"\0" * (-len(self.binary) % 4)
        with open(file, "wb") as out:
            out.write(b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(binary)))
            out.write(struct.pack("<I", len(text)) + b"JSON" + text)
            out.write(struct.pack("<I", len(binary)) + b"BIN\0" + binary)


def grid(columns, rows, point, normal, closed=False):
    """A surface of quads over u, v in [0, 1]; it meets itself in u and, when closed, in v. No triangle without area."""
    place = {}
    positions, normals, indices = [], [], []

    def vertex(u, v):
        u, v = u % columns, v % rows if closed else v
        p = tuple(round(x, 7) + 0.0 for x in point(u / columns, v / rows))
        if p not in place:
            place[p] = len(positions)
            positions.append(p)
            normals.append(normal(u / columns, v / rows))
        return place[p]
    for v in range(rows):
        for u in range(columns):
            a, b, c, d = vertex(u, v), vertex(u, v + 1), vertex(u + 1, v), vertex(u + 1, v + 1)
            for triangle in ((a, b, c), (c, b, d)):
                if len(set(triangle)) == 3:
                    indices += triangle
    return positions, normals, indices


def sphere(radius):
    def normal(u, v):
        a, b = 2 * math.pi * u, math.pi * v
        return (math.sin(a) * math.sin(b), math.cos(b), math.cos(a) * math.sin(b))
    return grid(40, 24, lambda u, v: tuple(radius * x for x in normal(u, v)), normal)


def torus(radius, tube):
    def normal(u, v):
        a, b = 2 * math.pi * u, -2 * math.pi * v
        return (math.sin(a) * math.cos(b), math.sin(b), math.cos(a) * math.cos(b))
    def point(u, v):
        a, n = 2 * math.pi * u, normal(u, v)
        return (radius * math.sin(a) + tube * n[0], tube * n[1], radius * math.cos(a) + tube * n[2])
    return grid(48, 20, point, normal, closed=True)


def cube(half):
    positions, normals, indices = [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            n = [0, 0, 0]
            n[axis] = sign
            first = len(positions)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                p = [0, 0, 0]
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = sign * half, sign * u * half, v * half
                positions.append(tuple(p))
                normals.append(tuple(n))
            indices += [first, first + 1, first + 2, first, first + 2, first + 3]
    return positions, normals, indices


def turn(axis, angle):
    s = math.sin(angle / 2)
    return [axis[0] * s, axis[1] * s, axis[2] * s, math.cos(angle / 2)]


def multiply(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz]


def rotate(q, v):
    x, y, z, _ = multiply(multiply(q, list(v) + [0]), [-q[0], -q[1], -q[2], q[3]])
    return [x, y, z]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def shapes():
    """A sphere, a cube and a torus on a floor, with a camera and a sun; clips spin, orbit and sun, two seconds each."""
    glb = Glb()
    floor = glb.mesh("floor", [(-3, 0, -3), (3, 0, -3), (3, 0, 3), (-3, 0, 3)], [(0, 1, 0)] * 4, [0, 2, 1, 0, 3, 2],
                     glb.material("floor", [0.7, 0.7, 0.7]))
    red = glb.mesh("ball", *sphere(0.7), glb.material("red", [0.8, 0.2, 0.2]))
    blue = glb.mesh("box", *cube(0.55), glb.material("blue", [0.3, 0.4, 0.9]))
    green = glb.mesh("ring", *torus(0.6, 0.22), glb.material("green", [0.2, 0.7, 0.3]))
    glb.node(name="floor", mesh=floor)
    ball = glb.node(name="ball", mesh=red, translation=[-1.2, 0.7, 0.2])
    box = glb.node(name="box", mesh=blue, translation=[0.5, 0.55, -0.8], rotation=turn((0, 1, 0), 0.5))
    glb.node(name="ring", mesh=green, translation=[0.9, 0.22, 1.1])
    glb.json["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1, "zfar": 100}}]

    def view(angle):
        q = multiply(turn((0, 1, 0), angle), turn((1, 0, 0), -0.45))
        return q, [a + b for a, b in zip([0, 0.4, 0], rotate(q, (0, 0, 7)))]
    q, place = view(0.35)
    camera = glb.node(name="camera", camera=0, translation=place, rotation=q)
    glb.json["extensionsUsed"] = ["KHR_lights_punctual"]
    glb.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "name": "sun", "intensity": 3}]}}
    sun = glb.node(name="sun", rotation=turn((1, 0, 0), -0.9), extensions={"KHR_lights_punctual": {"light": 0}})
    steps = [i / 8 for i in range(17)]
    glb.clip("spin", [(box, "rotation", steps, [turn((0, 1, 0), 0.5 + math.pi * t / 4) for t in steps]),
                      (ball, "translation", [0, 1, 2], [(-1.2, 0.7, 0.2), (-1.2, 1.5, 0.2), (-1.2, 0.7, 0.2)])])
    views = [view(0.35 + 0.25 * t) for t in steps]
    glb.clip("orbit", [(camera, "rotation", steps, [v[0] for v in views]),
                       (camera, "translation", steps, [v[1] for v in views])])
    glb.clip("sun", [(sun, "rotation", steps,
                      [multiply(turn((0, 1, 0), 0.6 * t), turn((1, 0, 0), -0.9)) for t in steps])])
    glb.write("shapes.glb")


def arm():
    """A round arm of two metres along y with an elbow, skinned to two joints, with a morph target; clips bend and swell."""
    glb = Glb()
    def normal(u, v):
        a = 2 * math.pi * u
        return (math.sin(a), 0.0, math.cos(a))
    positions, normals, indices = grid(24, 32, lambda u, v: (0.25 * normal(u, v)[0], 2 - 2 * v, 0.25 * normal(u, v)[2]),
                                       normal)
    joints, weights, fat = [], [], []
    for p, n in zip(positions, normals):
        t = min(1.0, max(0.0, (p[1] - 0.7) / 0.6))
        elbow = t * t * (3 - 2 * t)
        joints.append((0, 1, 0, 0))
        weights.append((1 - elbow, elbow, 0.0, 0.0))
        bulge = 0.25 * math.exp(-((p[1] - 0.5) / 0.25) ** 2)
        fat.append((n[0] * bulge, 0.0, n[2] * bulge))
    skinned = {"JOINTS_0": glb.accessor(joints, "VEC4", "B"), "WEIGHTS_0": glb.accessor(weights, "VEC4")}
    glb.accessor(fat, "VEC3")
    target = len(glb.json["accessors"]) - 1
    material = glb.material("skin", [0.9, 0.7, 0.5])
    glb.json["materials"][material]["doubleSided"] = True
    mesh = glb.mesh("arm", positions, normals, indices, material, attributes=skinned,
                    primitive={"targets": [{"POSITION": target}]}, weights=[0.0], extras={"targetNames": ["fat"]})
    node = glb.node(name="arm", mesh=mesh, skin=0)
    shoulder = glb.node(name="shoulder", children=[2])
    glb.json["nodes"].append({"name": "elbow", "translation": [0, 1, 0]})
    elbow = 2
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    lowered = identity[:12] + [0, -1, 0, 1]
    glb.json["skins"] = [{"joints": [shoulder, elbow],
                          "inverseBindMatrices": glb.accessor([identity, lowered], "MAT4")}]
    steps = [i / 4 for i in range(5)]
    glb.clip("bend", [(elbow, "rotation", steps, [turn((0, 0, 1), -math.pi / 2 * t) for t in steps])])
    glb.clip("swell", [(node, "weights", [0.0, 1.0], [0.0, 1.0])])
    glb.write("arm.glb")


# Of the walker: joint, the one above, where it is at rest in a figure of height 1 with its feet at 0. Left is +x.
SKELETON = [("hips", None, (0, 0.53, 0)), ("chest", "hips", (0, 0.64, 0))]
for side, sign in (("left", 1), ("right", -1)):
    SKELETON += [(side + " arm", "chest", (0.115 * sign, 0.79, 0)),
                 (side + " forearm", side + " arm", (0.14 * sign, 0.63, 0)),
                 (side + " thigh", "hips", (0.06 * sign, 0.51, 0)),
                 (side + " shin", side + " thigh", (0.065 * sign, 0.28, 0))]
JOINTS = [joint for joint, _, _ in SKELETON]


def limb(start, end, start_radius, end_radius):
    """A limb with round ends about a straight axis: grid(), and the way along the axis, 0 to 1, of each vertex."""
    axis = [b - a for a, b in zip(start, end)]
    length = math.dist(start, end)
    flat = [0, 0, 1] if abs(axis[2]) < 0.9 * length else [0, 1, 0]
    side = cross(axis, flat)
    side = [x / math.hypot(*side) for x in side]
    front = [x / length for x in cross(side, axis)]

    def along(v):
        return 0.5 - 0.5 * math.cos(math.pi * v)  # rows lie closer where ends are round

    def point(u, v):
        a, t = 2 * math.pi * u, along(v)
        radius = (start_radius + (end_radius - start_radius) * t) * math.sqrt(max(0, 1 - (2 * t - 1) ** 6))
        return [s + t * x + radius * (math.cos(a) * i + math.sin(a) * k)
                for s, x, i, k in zip(start, axis, side, front)]

    def normal(u, v):
        if v in (0, 1):
            return [(2 * v - 1) * x / length for x in axis]
        h = 1e-4
        du = [b - a for a, b in zip(point(u - h, v), point(u + h, v))]
        dv = [b - a for a, b in zip(point(u, v - h), point(u, v + h))]
        n = cross(dv, du)
        return [x / math.hypot(*n) for x in n]
    positions, normals, indices = grid(14, 14, point, normal)
    ways = [sum((p - s) * x for p, s, x in zip(position, start, axis)) / length ** 2 for position in positions]
    return positions, normals, indices, ways


def swing(joint, phase):
    """The angle of a joint about x in a walk of two steps, as samples/common/lay_figure.cpp has it; forward is < 0."""
    if joint.startswith("right"):
        phase += math.pi
    forward = math.sin(phase)
    return {"thigh": -0.45 * forward - 0.1, "shin": 0.12 + 0.85 * max(0, math.cos(phase - 0.3)) ** 2,
            "arm": 0.5 * forward, "forearm": -0.45 + 0.2 * forward, "chest": 0.08, "hips": 0}[joint.split()[-1]]


def walker():
    """A figure of height 1 that looks along z, of limbs skinned to ten joints; a camera, a sun; clip walk, one second of
    two steps on the spot, in which the sun turns by an eighth."""
    glb = Glb()
    positions, normals, indices, joints, weights = [], [], [], [], []

    def add(first, second, bend, *shape):
        p, n, i, ways = limb(*shape)
        indices.extend(len(positions) + k for k in i)
        positions.extend(p)
        normals.extend(n)
        for t in ways:
            x = min(1.0, max(0.0, (t - bend + 0.12) / 0.24))
            other = x * x * (3 - 2 * x)
            joints.append((JOINTS.index(first), JOINTS.index(second), 0, 0))
            weights.append((1 - other, other, 0.0, 0.0))
    add("hips", "chest", 0.45, (0, 0.46, 0), (0, 0.84, 0), 0.085, 0.095)
    add("chest", "chest", 0.5, (0, 0.83, 0.01), (0, 1, 0.01), 0.062, 0.065)
    for side, sign in (("left", 1), ("right", -1)):
        add(side + " arm", side + " forearm", 0.5, (0.11 * sign, 0.83, 0), (0.165 * sign, 0.43, 0.01), 0.042, 0.028)
        add(side + " thigh", side + " shin", 0.52, (0.055 * sign, 0.58, 0), (0.07 * sign, 0.02, 0), 0.072, 0.034)
        add(side + " shin", side + " shin", 0.5, (0.07 * sign, 0.032, -0.045), (0.075 * sign, 0.028, 0.115), 0.03, 0.03)
    skinned = {"JOINTS_0": glb.accessor(joints, "VEC4", "B"), "WEIGHTS_0": glb.accessor(weights, "VEC4")}
    mesh = glb.mesh("walker", positions, normals, indices, glb.material("wood", [0.75, 0.68, 0.58]), attributes=skinned)
    glb.node(name="walker", mesh=mesh, skin=0)

    places = {joint: at for joint, _, at in SKELETON}
    first = len(glb.json["nodes"])
    for joint, above, at in SKELETON:
        children = [first + i for i, (_, other, _) in enumerate(SKELETON) if other == joint]
        glb.json["nodes"].append({"name": joint, **({"children": children} if children else {}),
                                  "translation": [a - b for a, b in zip(at, places.get(above, (0, 0, 0)))]})
    glb.json["scenes"][0]["nodes"].append(first)
    moved = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] + [-x for x in at] + [1] for _, _, at in SKELETON]
    glb.json["skins"] = [{"joints": [first + i for i in range(len(SKELETON))],
                          "inverseBindMatrices": glb.accessor(moved, "MAT4")}]

    glb.json["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1, "zfar": 100}}]
    view = multiply(turn((0, 1, 0), 0.8), turn((1, 0, 0), -0.15))
    glb.node(name="camera", camera=0, rotation=view,
             translation=[a + b for a, b in zip((0, 0.5, 0), rotate(view, (0, 0, 1.9)))])
    glb.json["extensionsUsed"] = ["KHR_lights_punctual"]
    glb.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "name": "sun", "intensity": 3}]}}
    sun = glb.node(name="sun", rotation=turn((1, 0, 0), -0.7), extensions={"KHR_lights_punctual": {"light": 0}})

    steps = [i / 24 for i in range(25)]
    channels = [(first + i, "rotation", steps, [turn((1, 0, 0), swing(joint, 2 * math.pi * t)) for t in steps])
                for i, joint in enumerate(JOINTS) if joint != "hips"]
    # Hips are lowest when the legs are farthest apart, twice a loop.
    channels.append((first, "translation", steps, [(0, 0.512 + 0.01 * math.cos(4 * math.pi * t), 0) for t in steps]))
    channels.append((sun, "rotation", steps,
                     [multiply(turn((0, 1, 0), -math.pi / 4 * t), turn((1, 0, 0), -0.7)) for t in steps]))
    glb.clip("walk", channels)
    glb.write("walker.glb")


shapes()
arm()
walker()
