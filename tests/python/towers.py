"""Random towers against the closed form: a tower of level joints stands if and only if, at every joint, the weight above it
acts within the joint's polygon and within the cone of friction.

    python3 towers.py [COUNT [SEED]]        prints how many were asked, how near a limit verdicts stay right, and the seconds

The resultant R of all that stands above a joint is along gravity g and passes through its mass centre. Forces R w_v at the
corners, w_v >= 0 with sum 1 and sum w_v r_v where the line meets the joint, balance it; each is in its cone if R is. Outside
the polygon the normal forces can't have that centre, outside the cone their sum can't have that direction.
"""
import math
import random
import sys
import time

import stonepack


class Tower:
    """Stones (mass, centroid) on a support, joints as rectangles (x0, x1, y0, y1, z); gravity; friction."""

    def __init__(self, rng):
        count = rng.randint(1, 6)
        self.mu = rng.uniform(0.1, 1.0)
        tilt = math.atan(self.mu) * rng.uniform(0, 1.3) if rng.random() < 0.5 else 0.0
        turn = rng.uniform(0, 2 * math.pi)
        self.gravity = (9.80665 * math.sin(tilt) * math.cos(turn), 9.80665 * math.sin(tilt) * math.sin(turn),
                        -9.80665 * math.cos(tilt))
        self.stones, self.joints = [], []
        x = y = z = 0.0
        a = b = 1.0                                     # size in plan of the block below
        for _ in range(count):
            c, d, h = rng.uniform(0.3, 1.2), rng.uniform(0.3, 1.2), rng.uniform(0.1, 0.8)
            nx, ny = x + rng.uniform(-0.45, 0.45) * (a + c) / 2, y + rng.uniform(-0.45, 0.45) * (b + d) / 2
            self.joints.append((max(x - a / 2, nx - c / 2), min(x + a / 2, nx + c / 2),
                                max(y - b / 2, ny - d / 2), min(y + b / 2, ny + d / 2), z))
            density = 10 ** rng.uniform(2, 4)
            self.stones.append((density * c * d * h, (nx, ny, z + h / 2), (c, d, h), density))
            x, y, z, a, b = nx, ny, z + h, c, d

    def margin(self):
        """Above 0: it stands; relative distance from the nearest limit, in the joint's size and in friction."""
        gx, gy, gz = self.gravity
        worst = self.mu * -gz / max(math.hypot(gx, gy), 1e-300) - 1 if gx or gy else math.inf
        mass = mx = my = mz = 0.0
        for (m, (cx, cy, cz), _, _), (x0, x1, y0, y1, z) in zip(reversed(self.stones), reversed(self.joints)):
            mass, mx, my, mz = mass + m, mx + m * cx, my + m * cy, mz + m * cz
            down = (z - mz / mass) / gz                 # from the centre to the joint's plane, along gravity
            x, y = mx / mass + gx * down, my / mass + gy * down
            worst = min(worst, (x - x0) / (x1 - x0), (x1 - x) / (x1 - x0), (y - y0) / (y1 - y0), (y1 - y) / (y1 - y0))
        return worst

    def scene(self):
        """Of meshes, joints to be found."""
        s = stonepack.Scene(mu=self.mu, gravity=self.gravity)
        s.box((1, 1, 0.5), (0, 0, -0.25), fixed=True)
        for _, at, size, density in self.stones:
            s.box(size, at, density=density)
        return s

    def bare(self):
        """Of masses and joints alone: no mesh, nothing to be found."""
        s = stonepack.Scene(mu=self.mu, gravity=self.gravity)
        s.body(0, (0, 0, -0.25), fixed=True)
        for k, ((mass, at, _, _), (x0, x1, y0, y1, z)) in enumerate(zip(self.stones, self.joints)):
            s.body(mass, at)
            s.joint(k, k + 1, ((x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)))
        return s


def ask(count, seed, make):
    """(wrong, undecided margins, stable, nearest margin that was decided)."""
    rng, wrong, open_, stable, nearest = random.Random(seed), [], [], 0, math.inf
    for k in range(count):
        tower = Tower(rng)
        margin, result = tower.margin(), make(tower).check(localise=False)
        stable += result.stable
        if result.undecided:
            open_.append(abs(margin))
            continue
        nearest = min(nearest, abs(margin))
        if result.stable != (margin > 0) or not result.verified:
            wrong.append((k, margin, result.verdict, result.verified))
    return wrong, open_, stable, nearest


if __name__ == "__main__":
    count, seed = (int(sys.argv[1]) if len(sys.argv) > 1 else 1000000), (int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    start = time.process_time()
    wrong, open_, stable, nearest = ask(count, seed, Tower.bare)
    took = time.process_time() - start
    print("%d towers, seed %d: %d stand, %d fall, %d undecided (up to %.1e of a joint from its limit), %d wrong; nearest "
          "decided %.1e; %.0f s of processor" % (count, seed, stable, count - stable - len(open_), len(open_),
                                                 max(open_, default=0), len(wrong), nearest, took))
    for each in wrong[:20]:
        print("wrong: tower %d, margin %.3e, %s, verified %s" % each)
    sys.exit(bool(wrong))
