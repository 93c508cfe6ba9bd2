# Makes models with Blender, and what Blender itself says of them: python make_models.py DIRECTORY
# (bpy 4.5 from PyPI). models.csv: file, triangles, area, integrals of reflectance and of exitance (r, g, b) over it;
# the lines of quantised models are those of read_models.py.
import bpy, math, sys
from mathutils import Vector
out = sys.argv[-1]
rows = []


def begin():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def material(name, colour, emission=(0, 0, 0), strength=0.0, attribute=None):
    m = bpy.data.materials.new(name)
    m.use_nodes = True
    tree = m.node_tree
    surface = tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*colour, 1)
    surface.inputs["Emission Color"].default_value = (*emission, 1)
    surface.inputs["Emission Strength"].default_value = strength
    if attribute:
        node = tree.nodes.new("ShaderNodeVertexColor")
        node.layer_name = attribute
        tree.links.new(node.outputs["Color"], surface.inputs["Base Color"])
    m.use_backface_culling = True
    return m


def mesh(name, points, faces, *materials):
    m = bpy.data.meshes.new(name)
    m.from_pydata(points, [], faces)
    for each in materials:
        m.materials.append(each)
    for i, polygon in enumerate(m.polygons):
        polygon.material_index = i % len(materials)
    return m


def place(name, data, parent=None, at=(0, 0, 0), turn=(0, 0, 0), scale=(1, 1, 1)):
    o = bpy.data.objects.new(name, data)
    o.parent, o.location, o.rotation_euler, o.scale = parent, at, turn, scale
    bpy.context.scene.collection.objects.link(o)
    return o


def colours(m, i):
    surface = m.materials[i].node_tree.nodes["Principled BSDF"]
    strength = surface.inputs["Emission Strength"].default_value
    return (list(surface.inputs["Base Color"].default_value)[:3],
            [strength * c for c in list(surface.inputs["Emission Color"].default_value)[:3]])


def end(name, **options):
    """What the evaluated objects are, in the world, triangle by triangle; then the file."""
    bpy.context.view_layer.update()
    graph = bpy.context.evaluated_depsgraph_get()
    count, area, reflected, emitted = 0, 0.0, [0.0] * 3, [0.0] * 3
    for o in bpy.context.scene.objects:
        if o.type != "MESH":
            continue
        done = o.evaluated_get(graph)
        m = done.to_mesh()
        m.calc_loop_triangles()
        layer = m.color_attributes[0] if m.color_attributes else None
        for t in m.loop_triangles:
            a, b, c = (done.matrix_world @ Vector(m.vertices[v].co) for v in t.vertices)
            size = (b - a).cross(c - a).length / 2
            rho, light = colours(m, t.material_index)
            if layer:
                corners = [layer.data[v].color for v in t.vertices]
                rho = [sum(x[k] for x in corners) / 3 for k in range(3)]
            count += 1
            area += size
            for k in range(3):
                reflected[k] += size * rho[k]
                emitted[k] += size * light[k]
        done.to_mesh_clear()
    rows.append(",".join([name, str(count)] + ["%.9g" % x for x in [area] + reflected + emitted]))
    bpy.ops.export_scene.gltf(filepath=out + "/" + name, export_format="GLB", export_normals=False,
                              export_texcoords=False, export_animations=False, **options)


ring = [(math.cos(2 * math.pi * i / 7) * (1 if i % 2 else .4), math.sin(2 * math.pi * i / 7) * (1 if i % 2 else .4), 0)
        for i in range(7)]
star = [tuple(range(7))] + [(i, (i + 1) % 7, 7) for i in range(7)]


def stars(parent):
    shape = mesh("Star", ring + [(0, 0, -1)], star, material("red", (.6, .1, .05)), material("wood", (.4, .25, .1)))
    for i in range(5):
        place("Star %d" % i, shape, parent, (2 * i, i % 2, .3 * i), (.3 * i, .5, -.2 * i), (1, 1, 1 + .1 * i))


# one mesh under turned, scaled and mirrored parents; a concave polygon and two materials
begin()
top = place("Top", None, None, (1, 2, 3), (.4, 0, .2), (1.5, 1.5, 1.5))
stars(place("Mirror", None, top, (0, 0, 1), (0, 0, .7), (-1, 1, 1)))
end("instances.glb")

# the same as EXT_mesh_gpu_instancing
begin()
stars(place("Holder", None))
end("gpu-instances.glb", export_gpu_instances=True)

# a tube of ten rings that two bones bend, with weights of both
begin()
points = [(.5 * math.cos(a * math.pi / 4), .5 * math.sin(a * math.pi / 4), .2 * h) for h in range(11) for a in range(8)]
sides = [(8 * h + a, 8 * h + (a + 1) % 8, 8 * h + 8 + (a + 1) % 8, 8 * h + 8 + a) for h in range(10) for a in range(8)]
tube = place("Tube", mesh("Tube", points, sides, material("skin", (.7, .5, .4))))
bones = bpy.data.armatures.new("Bones")
rig = place("Rig", bones, None, (0, 0, .1))
bpy.context.view_layer.objects.active = rig
bpy.ops.object.mode_set(mode="EDIT")
for i in range(2):
    bone = bones.edit_bones.new("bone %d" % i)
    bone.head, bone.tail = (0, 0, i), (0, 0, i + 1)
    bone.parent = bones.edit_bones[0] if i else None
bpy.ops.object.mode_set(mode="POSE")
rig.pose.bones[1].rotation_mode = "XYZ"
rig.pose.bones[1].rotation_euler = (.8, 0, .1)
bpy.ops.object.mode_set(mode="OBJECT")
for i in range(2):
    group = tube.vertex_groups.new(name="bone %d" % i)
    for v, p in enumerate(points):
        upper = min(1, max(0, p[2] - .5))
        group.add([v], upper if i else 1 - upper, "REPLACE")
tube.parent = rig
tube.modifiers.new("bend", "ARMATURE").object = rig
end("skinned.glb", export_skins=True, export_rest_position_armature=False)

# two shapes between which it rests, of which one moves few points: sparse accessors
begin()
grid = [(x, y, 0) for y in range(20) for x in range(20)]
cells = [(20 * y + x, 20 * y + x + 1, 20 * y + x + 21, 20 * y + x + 20) for y in range(19) for x in range(19)]
sheet = place("Sheet", mesh("Sheet", grid, cells, material("paper", (.75, .75, .7))))
sheet.shape_key_add(name="flat")
for name, value in (("hill", .35), ("edge", .6)):
    key = sheet.shape_key_add(name=name, from_mix=False)
    key.value = value
    for v, p in enumerate(grid):
        if name == "hill" and (p[0] - 9) ** 2 + (p[1] - 9) ** 2 < 9 or name == "edge" and p[0] == 0:
            key.data[v].co.z += 3
end("morphed.glb", export_morph=True, export_try_sparse_sk=True, export_morph_normal=False)

# colours at points, and lamps of several strengths
begin()
painted = mesh("Painted", grid, cells, material("paint", (1, 1, 1), attribute="Col"))
layer = painted.color_attributes.new("Col", "FLOAT_COLOR", "POINT")
for v, p in enumerate(grid):
    layer.data[v].color = (.1 + .04 * p[0], .8 - .03 * p[1], .25, 1)
place("Painted", painted, None, scale=(.1, .2, 1))
end("coloured.glb")
begin()
for i, strength in enumerate((.5, 1, 25, 4000)):
    place("Lamp %d" % i, mesh("Lamp", ring, star[:1], material("lamp %d" % i, (.2, .1, 0), (1, .8, .5), strength)),
          None, (3 * i, 0, 0))
end("emitting.glb")

# what has no reader here
begin()
stars(None)
end("draco.glb", export_draco_mesh_compression_enable=True)
rows.pop()
with open(out + "/models.csv", "w") as table:
    table.write("\n".join(rows) + "\n")
