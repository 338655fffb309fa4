"""Blender's cloth through bpy: implicit Euler in single precision, on the mesh of the sphere.

Blender counts time in frames of its own: it falls by 9.81e-3 m per frame squared, so that a frame is sqrt(1e-3) s, whatever
the frames per second. Only ratios to the mass of a particle count; it keeps its default of 0.3 kg, and stiffnesses follow.
"""
import numpy as np
from drop_scene import (BENDING, BRAKING, CELL, DENSITY, FRICTION, GRAVITY, SHEAR, SIDE, STRETCH, THICKNESS, clock, grid,
                        sphere)

FRAME = 1e-3**0.5  # s
MASS = 0.3  # kg
UNIT = MASS / (DENSITY * CELL**2) * FRAME**2  # kg/frame2 in Blender's mass for 1 kg/s2 in the cloth's
STEPS = 10  # a frame; with the default of 5 the cloth falls through the sphere at this thickness


def add(scene, name, points, faces):
    import bpy

    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points.tolist(), [], faces.tolist())
    thing = bpy.data.objects.new(name, mesh)
    scene.collection.objects.link(thing)
    return thing


def add_sheet(scene, frames):
    number = np.arange(SIDE**2).reshape(SIDE, SIDE)
    quads = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1)
    sheet = add(scene, "sheet", grid().reshape(-1, 3), quads.reshape(-1, 4))
    cloth = sheet.modifiers.new("Cloth", "CLOTH")
    cloth.point_cache.frame_start, cloth.point_cache.frame_end = 1, frames + 1
    how = cloth.settings
    how.quality, how.mass = STEPS, MASS
    # Springs pull with stiffness over their mean length, angles with a tenth of stiffness times length.
    how.tension_stiffness = how.compression_stiffness = STRETCH * UNIT * CELL
    how.shear_stiffness = SHEAR * UNIT * CELL
    how.bending_stiffness = BENDING * UNIT / (0.1 * CELL)
    how.air_damping = BRAKING * FRAME * MASS / 0.01
    cloth.collision_settings.distance_min = THICKNESS
    cloth.collision_settings.friction = 100 * FRICTION
    return sheet


def drop(seconds):
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.gravity = (0, 0, -GRAVITY)
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    ball = add(scene, "ball", *sphere())
    ball.modifiers.new("Collision", "COLLISION")
    ball.collision.thickness_outer = THICKNESS  # the smallest that it takes
    ball.collision.cloth_friction = 100 * FRICTION
    frames = max(1, round(seconds / FRAME))
    sheet = add_sheet(scene, frames)
    scene.frame_start, scene.frame_end = 1, frames + 1
    scene.frame_set(1)

    spent = [0.0, 0.0]
    with clock(spent):
        for frame in range(2, frames + 2):
            scene.frame_set(frame)
    places = np.empty(3 * SIDE**2, np.float32)
    sheet.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices.foreach_get("co", places)
    return places.reshape(SIDE, SIDE, 3), [s * seconds / (frames * FRAME) for s in spent]
