#!/usr/bin/env python3
"""limit: `stonepack limit` beside one linear program by HiGHS, the better of its simplex and its interior points.

    limit.py PROGRAM [--long]           CSV on standard output

Inscribed pyramids of 8 faces, pushed along x. Ours: cost.seconds of the answer, verified, the least of nine. HiGHS: the
processor's time of SciPy's linprog, without making the matrices. --long: scenes at which HiGHS takes
minutes, too. Needs SciPy; without it the script says so.
"""
import json
import os
import subprocess
import sys
import time

try:
    import numpy as np
    from scipy.optimize import linprog
    from scipy.sparse import csc_matrix, hstack
    sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "oracle"))
    import oracle
except ImportError as e:
    print("skipped limit: no %s" % e.name, file=sys.stderr)
    sys.exit(0)

SCENES = ["arch n=11 t=0.12", "arch n=51 t=0.12", "wall size=54 jitter=0.35", "wall size=147 jitter=0.35",
          "dome rings=6 segments=12"]
LONG = ["arch n=200 t=0.12", "wall size=500 jitter=0.35", "dome rings=12 segments=24"]
CONE = "8i"


def ours(program, scene):
    """Least of nine: its clock is the wall's."""
    best = None
    for _ in range(9):
        done = subprocess.run([program, "limit", "--json", "--cone", CONE, "--body", "1,0,0", "-"], input=scene, text=True,
                              capture_output=True, check=False)
        told = json.loads(done.stdout)
        if best is None or told["cost"]["seconds"] < best["cost"]["seconds"]:
            best = told
    return best


def highs(scene, method):
    """lambda and seconds of max lambda, A R a + p + lambda q = 0, a >= 0."""
    problem = oracle.Problem(oracle.Scene(scene))
    p, q = problem.load(np.array([0, 0, -1.0])), problem.load(np.array([1.0, 0, 0]))
    G = problem.A @ oracle.corners(problem, CONE)
    cost = np.zeros(G.shape[1] + 1)
    cost[-1] = -1
    M = hstack([G, csc_matrix(q.reshape(-1, 1))]).tocsc()
    start = time.process_time()
    s = linprog(cost, A_eq=M, b_eq=-p, bounds=[(0, None)] * G.shape[1] + [(None, None)], method=method)
    return (float(s.x[-1]) if s.status == 0 else float("nan")), time.process_time() - start


def main():
    program, scenes = sys.argv[1], SCENES + (LONG if "--long" in sys.argv else [])
    print("scene,multiplier,highs,factorisations,ms,highs_simplex_ms,highs_interior_ms,ratio")
    for words in scenes:
        scene = subprocess.run([program, "gen"] + words.split(), capture_output=True, text=True, check=True).stdout
        us = ours(program, scene)
        value, simplex = highs(scene, "highs-ds")
        other, interior = highs(scene, "highs-ipm")
        seconds = us["cost"]["seconds"]
        print("%s,%.9g,%.9g,%d,%.3g,%.4g,%.4g,%.3g" % (words, us["multiplier"], value if value == value else other,
              us["cost"]["factorisations"], 1e3 * seconds, 1e3 * simplex, 1e3 * interior, min(simplex, interior) / seconds))
        sys.stdout.flush()


main()
