"""stonepack: does this assembly of rigid blocks stand, how sure are we, and why?

    import stonepack

    scene = stonepack.Scene(mu=0.6)
    scene.box((2, 1, 0.4), at=(0, 0, -0.2), fixed=True, name="table")
    scene.box((2, 1, 0.8), at=(0.6, 0, 0.4), name="stone")
    result = scene.check()
    print(result.verdict, result.verified)              # stable True

SI units: m, kg, s, N. Forces act on block b of a joint, fn > 0 presses.
"""
from . import meshes, scenes
from ._library import FileError, SceneError, StonepackError, __version__
from .answers import (Block, Effect, Evidence, Held, Hinge, Joint, JointForce, Limit, Overlap, Plan, Result, Sliding, Step,
                      Strong)
from .scene import BuildOrder, Scene, check_many
from .scenefiles import parse, read
from .settling import Pose, Settled

__all__ = ["Block", "BuildOrder", "Effect", "Evidence", "FileError", "Held", "Hinge", "Joint", "JointForce", "Limit", "Overlap",
           "Plan", "Pose", "Result", "Scene", "SceneError", "Settled", "Sliding", "Step", "StonepackError", "Strong", "__version__",
           "check_many", "meshes", "parse", "read", "scenes"]
