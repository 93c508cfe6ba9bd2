# Makes room.glb and room.obj with Blender (bpy 5.0 from PyPI): python make_room.py DIRECTORY
import bpy, math, sys
out = sys.argv[-1]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
# sides of a box whose corners are numbered 4 x + 2 y + z, seen from outside
OUTWARD = [(0, 2, 6, 4), (1, 5, 7, 3), (0, 4, 5, 1), (2, 3, 7, 6), (0, 1, 3, 2), (4, 6, 7, 5)]

def material(name, colour, emission=None, strength=0):
    m = bpy.data.materials.new(name); m.use_nodes = True
    b = m.node_tree.nodes["Principled BSDF"]
    b.inputs["Base Color"].default_value = (*colour, 1)
    if emission:
        b.inputs["Emission Color"].default_value = (*emission, 1)
        b.inputs["Emission Strength"].default_value = strength
    m.use_backface_culling = True
    return m

def mesh(name, points, faces, materials, slots=None):
    m = bpy.data.meshes.new(name); m.from_pydata(points, [], faces)
    for each in materials: m.materials.append(each)
    for i, slot in enumerate(slots or []): m.polygons[i].material_index = slot
    return m

def place(name, data, parent=None, at=(0, 0, 0), turn=0, scale=(1, 1, 1)):
    o = bpy.data.objects.new(name, data); o.parent = parent
    o.location, o.rotation_euler, o.scale = at, (0, 0, turn), scale
    scene.collection.objects.link(o); return o

white = material("white", (.7, .7, .7)); red = material("red", (.6, .1, .05)); wood = material("wood", (.4, .25, .1))
lamp = material("lamp", (0, 0, 0), (1, .8, .5), 12)
c = [(x, y, z) for x in (0, 4) for y in (0, 3) for z in (0, 2.5)]
room = place("Room", mesh("RoomShell", c, [s[::-1] for s in OUTWARD],
                          [white, red], [0, 0, 0, 0, 1, 0]))
cube = [(x, y, z) for x in (-.5, .5) for y in (-.5, .5) for z in (0, 1)]
stool = mesh("Stool", cube, OUTWARD, [wood])
furniture = place("Furniture", None, room, (1, 1, 0))
place("Stool near", stool, furniture, (0, 0, 0.01), .3, (.5, .5, .6))
place("Stool far", stool, furniture, (1.7, .9, 0.01), -.4, (.5, .5, .8))
place("Lamp", mesh("Panel", [(-.5, -.5, 0), (-.5, .5, 0), (.5, .5, 0), (.5, -.5, 0)], [(0, 1, 2, 3)], [lamp]), room, (2, 1.5, 2.4))
light = bpy.data.lights.new("Bulb", "POINT"); light.energy = 50; place("Bulb", light, room, (3, 2, 1.5))
camera = bpy.data.cameras.new("View"); camera.angle = 1.0
v = place("View", camera, None, (2, .2, 1.3)); v.rotation_euler = (math.pi / 2, 0, 0); scene.camera = v
bpy.ops.export_scene.gltf(filepath=out + "/room.glb", export_format="GLB", export_cameras=True, export_lights=True, export_normals=False,
                          export_texcoords=False, export_animations=False, export_import_convert_lighting_mode="SPEC")
bpy.ops.wm.obj_export(filepath=out + "/room.obj", export_normals=False, export_uv=False, export_object_groups=False)
