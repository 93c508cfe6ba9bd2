# What readers that are not ours find in glTF and OBJ models: python read_models.py FOLDER FILE... > sample-models.csv
# (PyPI: trimesh 5.2, pygltflib 1.16, numpy, pillow, lxml; for sample-models.csv FOLDER is /usr/share/assimp/models of
# Debian's assimp-testmodels). glTF is read by pygltflib's accessors in doubles, morphed by its weights, and where
# trimesh reads it, too, both areas agree to 1e-7; the area of OBJ is trimesh's. A line: file below FOLDER, triangles
# with an area, area, integrals of reflectance and of exitance (r, g, b) over it, and whether an image gives colours.
import io, logging, pathlib, sys, warnings
import numpy, pygltflib, trimesh
from PIL import Image

TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
STEPS = 96
logging.disable(logging.CRITICAL)
warnings.simplefilter("ignore")


class Model:
    def __init__(self, file):
        self.file = file
        self.g = pygltflib.GLTF2().load(str(file))
        self.bytes = [self.g.binary_blob() if b.uri is None
                      else pygltflib.base64.b64decode(b.uri.split(",")[1]) if b.uri.startswith("data:")
                      else (file.parent / b.uri).read_bytes() for b in self.g.buffers]

    def view(self, index, offset, kind, count, width):
        v = self.g.bufferViews[index]
        item = numpy.dtype(kind).itemsize * width
        step = v.byteStride or item
        data = self.bytes[v.buffer][(v.byteOffset or 0) + (offset or 0):]
        return numpy.stack([numpy.frombuffer(data, kind, width, step * i) for i in range(count)])

    def array(self, index):
        a = self.g.accessors[index]
        kind, width = TYPES[a.componentType], WIDTHS[a.type]
        values = numpy.zeros((a.count, width)) if a.bufferView is None \
            else self.view(a.bufferView, a.byteOffset, kind, a.count, width).astype(float)
        if a.sparse:
            s = a.sparse
            places = self.view(s.indices.bufferView, s.indices.byteOffset, TYPES[s.indices.componentType], s.count, 1)
            values[places[:, 0]] = self.view(s.values.bufferView, s.values.byteOffset, kind, s.count, width)
        if a.normalized:
            values = numpy.maximum(values / numpy.iinfo(kind).max, -1)
        return values

    def image(self, texture):
        i = self.g.images[self.g.textures[texture].source]
        if i.bufferView is not None:
            v = self.g.bufferViews[i.bufferView]
            data = self.bytes[v.buffer][v.byteOffset or 0:][:v.byteLength]
        elif i.uri.startswith("data:"):
            data = pygltflib.base64.b64decode(i.uri.split(",")[1])
        else:
            data = (self.file.parent / i.uri).read_bytes()
        return linear(numpy.asarray(Image.open(io.BytesIO(data)).convert("RGB"), float) / 255)

    def wraps(self, texture):
        s = self.g.textures[texture].sampler
        s = self.g.samplers[s] if s is not None else None
        return [(s and w) or 10497 for w in ((s and s.wrapS), (s and s.wrapT))]

    def triangles(self):
        """Corners (n, 3, 3), material and primitive of each primitive with triangles, in the scene's space."""
        def down(node, above):
            n = self.g.nodes[node]
            own = numpy.array(n.matrix).reshape(4, 4).T if n.matrix else numpy.eye(4)
            if n.translation:
                own[:3, 3] = n.translation
            turned = trimesh.transformations.quaternion_matrix([n.rotation[3], *n.rotation[:3]]) if n.rotation \
                else numpy.eye(4)
            own = own @ turned @ numpy.diag([*(n.scale or (1, 1, 1)), 1])
            here = above @ own
            if n.mesh is not None:
                mesh = self.g.meshes[n.mesh]
                for p in mesh.primitives:
                    if p.mode is not None and p.mode < 4 or p.attributes.POSITION is None:
                        continue
                    points = self.array(p.attributes.POSITION)
                    for w, target in zip(getattr(n, "weights", None) or mesh.weights or [], p.targets or []):
                        moved = target.get("POSITION") if isinstance(target, dict) else target.POSITION
                        points = points + w * self.array(moved)
                    points = points @ here[:3, :3].T + here[:3, 3]
                    order = numpy.arange(len(points)) if p.indices is None \
                        else self.array(p.indices)[:, 0].astype(int)
                    if p.mode == 5:
                        order = numpy.concatenate([order[i:i + 3] for i in range(len(order) - 2)])
                    elif p.mode == 6:
                        order = numpy.concatenate([[order[0], order[i], order[i + 1]] for i in range(1, len(order) - 1)])
                    order = order[:len(order) // 3 * 3].reshape(-1, 3)
                    yield points[order], order, p
            for child in n.children or []:
                yield from down(child, here)
        scene = self.g.scenes[self.g.scene or 0]
        for root in scene.nodes:
            yield from down(root, numpy.eye(4))


def linear(c):
    return numpy.where(c <= .04045, c / 12.92, ((c + .055) / 1.055) ** 2.4)


def wrapped(i, size, wrap):
    if wrap == 33071:
        return numpy.clip(i, 0, size - 1)
    if wrap == 33648:
        i = i % (2 * size)
        return numpy.where(i < size, i, 2 * size - 1 - i)
    return i % size


def means(model, info, uv):
    """The image's mean over each triangle, by bilinear samples at STEPS x STEPS / 2 places."""
    at = (info.extensions or {}).get("KHR_texture_transform", {})
    (sx, sy), turn = at.get("scale", (1, 1)), at.get("rotation", 0)
    c, s = numpy.cos(turn), numpy.sin(turn)
    uv = numpy.stack([c * sx * uv[..., 0] + s * sy * uv[..., 1], c * sy * uv[..., 1] - s * sx * uv[..., 0]], -1) \
        + numpy.array(at.get("offset", (0, 0)))
    image = model.image(info.index)
    high, wide = image.shape[:2]
    wx, wy = model.wraps(info.index)
    sums = numpy.zeros((len(uv), 3))
    count = 0
    for i in range(STEPS):
        for j in range(STEPS - i):
            for third in (1, 2) if i + j < STEPS - 1 else (1,):
                a, b = (i + third / 3) / STEPS, (j + third / 3) / STEPS
                p = uv[:, 0] * (1 - a - b) + uv[:, 1] * a + uv[:, 2] * b
                x, y = p[:, 0] * wide - .5, p[:, 1] * high - .5
                x0, y0 = numpy.floor(x).astype(int), numpy.floor(y).astype(int)
                for dx in (0, 1):
                    for dy in (0, 1):
                        weight = numpy.abs(1 - dx - (x - x0)) * numpy.abs(1 - dy - (y - y0))
                        sums += weight[:, None] * image[wrapped(y0 + dy, high, wy), wrapped(x0 + dx, wide, wx)]
                count += 1
    return sums / count


def gltf(file):
    model = Model(file)
    count, total, textured = 0, 0.0, False
    reflected, emitted = numpy.zeros(3), numpy.zeros(3)
    for corners, order, p in model.triangles():
        areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        longest = max(numpy.ptp(corners.reshape(-1, 3), axis=0).max(), 1e-300)
        sound = areas > 1e-13 * longest ** 2
        m = model.g.materials[p.material] if p.material is not None else pygltflib.Material()
        base = m.pbrMetallicRoughness or pygltflib.PbrMetallicRoughness()
        rho = numpy.ones((len(areas), 3)) * numpy.array((base.baseColorFactor or (1, 1, 1))[:3])
        light = numpy.ones((len(areas), 3)) * numpy.array(m.emissiveFactor or (0, 0, 0)) \
            * (m.extensions or {}).get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
        for info, values in ((base.baseColorTexture, rho), (m.emissiveTexture, light)):
            if info is not None:
                uv = model.array(getattr(p.attributes, "TEXCOORD_%d" % (info.texCoord or 0)))[order]
                values *= means(model, info, uv)
                textured = True
        if p.attributes.COLOR_0 is not None:
            rho = rho * model.array(p.attributes.COLOR_0)[order][:, :, :3].mean(axis=1)
        rho = numpy.minimum(rho, .9999)
        count += int(sound.sum())
        total += areas[sound].sum()
        reflected += (areas[:, None] * rho)[sound].sum(axis=0)
        emitted += (areas[:, None] * light)[sound].sum(axis=0)
    return count, total, reflected, emitted, textured


def obj(file):
    scene = trimesh.load(file, process=False, group_material=True)
    meshes = scene.dump() if isinstance(scene, trimesh.Scene) else [scene]
    sound = [m.area_faces[m.area_faces > 1e-13 * m.extents.max() ** 2] for m in meshes if hasattr(m, "area_faces")]
    return sum(map(len, sound)), sum(s.sum() for s in sound)


folder = pathlib.Path(sys.argv[1])
for name in sys.argv[2:]:
    file = folder / name
    if name.endswith(".obj"):
        print(name, *("%d %.12g" % obj(file)).split(), *[""] * 7, sep=",")
        continue
    count, total, reflected, emitted, textured = gltf(file)
    other = sum(m.area for m in trimesh.load(file, process=False).dump() if hasattr(m, "area"))
    if other > 0 and "morphed" not in name:
        assert abs(other - total) <= 1e-7 * total, (name, other, total)
    print(name, count, *("%.12g" % x for x in (total, *reflected, *emitted)), "image" if textured else "", sep=",")
