"""Writes a scene of the peers for this program: the scene and its object (LWSC 3, LWO2), its points, its reference.

peer_scenes.py <folder of the peers> <output folder> <scene>: SCENE.npz and SCENE.ref.npz become lightwave/SCENE.lws,
lightwave/SCENE.lwo, points/SCENE.csv (x, y, z, nx, ny, nz) and truth/SCENE.csv (what scripts/accuracy reads).
"""
import math
import struct
import sys
from pathlib import Path

import numpy as np


def chunk(name, data):
    return name + struct.pack(">I", len(data)) + data + b"\0" * (len(data) % 2)


def sub_chunk(name, data):
    return name + struct.pack(">H", len(data)) + data


def index(i):
    return struct.pack(">H", i) if i < 0xFF00 else struct.pack(">I", i | 0xFF000000)


def text(name):
    return name + b"\0" * (2 - len(name) % 2)


def surface(name, reflectance, exitance):
    """Colour times diffuse is what it reflects, colour times luminosity what it emits; here it does one of them."""
    luminosity = max(exitance)
    colour = [x / luminosity for x in exitance] if luminosity > 0 else reflectance
    return chunk(b"SURF", text(name) + text(b"")
                 + sub_chunk(b"COLR", struct.pack(">3fH", *colour, 0))
                 + sub_chunk(b"DIFF", struct.pack(">fH", 0 if luminosity > 0 else 1, 0))
                 + sub_chunk(b"LUMI", struct.pack(">fH", luminosity, 0))
                 + sub_chunk(b"SIDE", struct.pack(">H", 1)))


def lwo2(scene):
    """LightWave is left-handed and sees a polygon from where its corners go clockwise, so z and the order are turned."""
    vertices, faces = scene["V"] * [1, 1, -1], scene["F"]
    values, tag = np.unique(np.concatenate([scene["R"], math.pi * scene["L"]], 1), axis=0, return_inverse=True)
    names = [b"surface %d" % i for i in range(len(values))]
    polygons = b"".join(b"\0\3" + index(c) + index(b) + index(a) for a, b, c in faces.tolist())
    tags = b"".join(index(i) + struct.pack(">H", t) for i, t in enumerate(tag.ravel().tolist()))
    body = chunk(b"TAGS", b"".join(map(text, names)))
    body += chunk(b"LAYR", struct.pack(">HH3f", 0, 0, 0, 0, 0) + text(b""))
    body += chunk(b"PNTS", np.ascontiguousarray(vertices, ">f4").tobytes())
    body += chunk(b"POLS", b"FACE" + polygons) + chunk(b"PTAG", b"SURF" + tags)
    body += b"".join(surface(n, v[:3].tolist(), v[3:].tolist()) for n, v in zip(names, values))
    return chunk(b"FORM", b"LWO2" + body)


def write(peers, out, name):
    data, truth = (np.load(peers / "data" / (name + end)) for end in (".npz", ".ref.npz"))
    for folder in ("lightwave", "points", "truth"):
        (out / folder).mkdir(parents=True, exist_ok=True)
    (out / "lightwave" / (name + ".lwo")).write_bytes(lwo2(data))
    (out / "lightwave" / (name + ".lws")).write_text("LWSC\n3\n\nLoadObjectLayer 1 %s.lwo\n" % name)
    places = np.concatenate([data["P"], data["N"]], 1)
    np.savetxt(out / "points" / (name + ".csv"), places, "%.9g", ",", header="x,y,z,nx,ny,nz", comments="")
    radiosity, count = truth["B"], np.arange(len(places))[:, None]
    noise = float(truth["noise"]) * np.ones((1, 3)) * radiosity
    rows = np.concatenate([count, 0 * count, places, data["A"][:, None], 0 * count, radiosity, noise], 1)
    np.savetxt(out / "truth" / (name + ".csv"), rows, "%.9g", ",", comments="",
               header="idx,surface,x,y,z,nx,ny,nz,w,tag,B_r,B_g,B_b,se_r,se_g,se_b")


if __name__ == "__main__":
    write(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3])
