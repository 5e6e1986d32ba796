"""How wide is the tie around a limit? Scenes are pushed to so much less and more than their limit, and asked what they do.

    python3 ties.py        a table: relative distance from the limit, right, undecided, stable beyond it, unstable below it
"""
import math
import random

import stonepack
from stonepack import scenes

G = 9.80665


def families(rng):
    """146 scenes that stand, and fall when pushed hard enough."""
    between = rng.uniform
    for count in [1, 2, 3, 5, 8] * 12:
        yield scenes.stack([(between(0.3, 1), between(0.3, 1), between(0.1, 0.6)) for _ in range(count)],
                           [(between(-0.1, 0.1), between(-0.1, 0.1)) for _ in range(count)], between(0.2, 1))
    for _ in range(40):
        yield scenes.wall(rng.randint(2, 6), rng.randint(2, 6), mu=between(0.2, 1))
    for _ in range(40):
        heights = [between(0.1, 0.5) for _ in range(rng.randint(2, 5))]
        cuts = [[(x / 10, x / 10 + between(-0.04, 0.04)) for x in sorted(rng.sample(range(1, 19), rng.randint(1, 5)))]
                for _ in heights]
        yield scenes.rubble(cuts, heights, 1.9, 0.4, between(0.2, 1))
    for name in ("arch", "wall", "trilithon", "rubble", "dome", "vault"):
        yield stonepack.read("tests/scenes/%s.obj" % name)


def ask(scene, distances, tol, counts):
    """Verdicts at so much below and above the scene's limit; counts[distance]: right, undecided, stable beyond, unstable below.
    Returns 1, of a scene without a limit 0."""
    multiple = scene.limit((1, 0.3, 0)).multiplier
    if not multiple or multiple == math.inf:
        return 0
    scene.live_acceleration = (G, 0.3 * G, 0)
    for distance in distances:
        for sign in (-1, 1):
            scene.live = multiple * (1 + sign * distance)
            result = scene.check(tol=tol, localise=False)
            right = result.unstable if sign > 0 else result.stable
            counts[distance][0 if right else 1 if result.undecided else 2 if result.stable else 3] += 1
    return 1


if __name__ == "__main__":
    for tol in (1e-9, 1e-6, 1e-3):
        distances = [10.0 ** -e for e in range(1, 13)]
        counts = {d: [0, 0, 0, 0] for d in distances}
        asked = sum(ask(s, distances, tol, counts) for s in families(random.Random(3)))
        print("tol %g, %d scenes\n  distance   right  undecided  stable beyond  unstable below" % (tol, asked))
        for d in distances:
            print("  %-8.0e  %6d %10d %14d %15d" % ((d,) + tuple(counts[d])))
