"""What a check costs from Python, as CSV: microseconds of one processor, the best of many short runs.

    PYTHONPATH=build/python python3 tests/bench/python.py [RUNS]
"""
import ctypes
import sys
import time

import stonepack
from stonepack import _bindings as c
from stonepack import _library, scenes


def best(call, times, runs):
    """Seconds of a call: the best of `runs` runs of `times`."""
    fastest = float("inf")
    for _ in range(runs):
        start = time.perf_counter()
        for _ in range(times):
            call()
        fastest = min(fastest, (time.perf_counter() - start) / times)
    return fastest


def cubes(count):
    s = stonepack.Scene()
    s.box((1, 1, 1), (0, 0, -0.5), fixed=True)
    for k in range(1, count):
        s.box((1, 1, 1), (0, 0, k - 0.5))
    return s


def library(scene):
    """The call of the library alone, as little of Python around it as there can be."""
    scene._ready()
    memory, arena = _library.arena(scene._bytes(c.SP_FOR_CHECK, None))
    result, check = c.sp_result(), _library.lib.sp_check
    refs = ctypes.byref(scene._c), None, ctypes.byref(arena), ctypes.byref(result)

    def call():
        arena.used = 0
        check(*refs)
    call.kept = memory
    return call


def touch(scene):
    scene.live = 1.0
    scene.check()


def main(runs):
    print("what,blocks,us,us of the library's call")
    for scene in (cubes(2), cubes(8), scenes.wall(6, 6), stonepack.read("tests/scenes/arch.obj")):
        n = max(1, 2000 // len(scene) ** 2)
        inside = best(library(scene), n, runs)
        print("check again,%d,%.2f,%.2f" % (len(scene), 1e6 * best(scene.check, n, runs), 1e6 * inside))
        print("check after a number changed,%d,%.2f,%.2f" % (len(scene), 1e6 * best(lambda: touch(scene), n, runs), 1e6 * inside))
    for count in (2, 8):
        inside = best(library(cubes(count)), 200, runs)
        print("build with contacts and check,%d,%.2f,%.2f" % (count, 1e6 * best(lambda: cubes(count).check(), 50, runs), 1e6 * inside))
    many = [scenes.wall(8, 8) for _ in range(64)]
    for threads in (1, 2):
        took = best(lambda: stonepack.check_many(many, threads=threads), 1, runs)
        print("check_many of 64 walls over %d threads,%d,%.2f," % (threads, len(many[0]), 1e6 * took / 64))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 40)
