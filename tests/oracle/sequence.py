#!/usr/bin/python3
"""sequence: build orders, the verdict of every step and the sets to be held against linear programming.

    sequence.py [--cli build/stonepack] [--count N] [--seed N]
    sequence.py --orders [--cli build/stonepack]

Arches stone by stone, then random scenes in random orders, built or taken down. At every step the least imbalance that any
forces leave is found by HiGHS for what is there: none within pyramids inside the cone is stable, some with pyramids around it
unstable; what lies between is left out. With the blocks to be held fixed there is none, and where a set of one or two is called minimal,
every smaller one leaves some. Prints at which step each arch first fails; the exit status is 1 if an answer was wrong.
--orders: the table of tests/sequence/test_orders.c, whose every letter the programmes must find.
Needs numpy and scipy (Debian: python3-numpy, python3-scipy).
"""
import argparse
import copy
import json
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path = [p for p in sys.path if os.path.abspath(p or ".") != HERE] + [HERE]   # random.py beside us is not the library's

import tempfile

import numpy as np
import oracle

NONE, SOME = 1e-8, 1e-6                                 # least imbalance that counts as none, as some


def stands(scene, present, held, cone):
    """1 stands, 0 falls, None: the programme can't tell."""
    part = copy.copy(scene)
    part.blocks = []
    for b in scene.blocks:
        if b.fixed or b.name in present:
            b = copy.copy(b)
            b.fixed = b.fixed or b.name in held
            part.blocks.append(b)
    names = {b.name for b in part.blocks}
    part.interfaces = [i for i in scene.interfaces if i.a in names and i.b in names]
    if all(b.fixed for b in part.blocks):
        return 1
    problem = oracle.Problem(part)
    inner, outer = ("48i", "48c") if cone == "true" else (cone, cone)
    if oracle.least_imbalance(problem, inner, part.gravity) <= NONE:
        return 1
    return 0 if oracle.least_imbalance(problem, outer, part.gravity) > SOME else None


def compare(cli, scene, order, remove, cone, count):
    """What the program says of a build order against the programme; returns what is wrong, and the first step that fails."""
    with tempfile.TemporaryDirectory() as tmp:
        path = os.path.join(tmp, "scene.obj")
        with open(path, "w") as f:
            f.write(scene.text())
        command = [cli, "sequence", "--json", "--cone", cone, "--order", ",".join(order), path]
        command += ["--remove"] if remove else []
        run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode > 2:
        return ["exit status %d: %s" % (run.returncode, run.stderr)], None
    told, wrong = json.loads(run.stdout), []
    there = {b.name for b in scene.blocks if not b.fixed} if remove else set()
    for step in told["steps"]:
        there = there - {step["remove"]} if remove else there | {step["add"]}
        truth = stands(scene, there, set(), cone)
        count["steps"] += 1
        count["open"] += truth is None
        if truth is not None and step["verdict"] != ("stable" if truth else "unstable"):
            wrong.append("step %d is %s, the programme says %d" % (step["step"], step["verdict"], truth))
        held = step["hold"]["blocks"]
        if step["verdict"] == "stable":
            continue
        count["held"] += 1
        if stands(scene, there, set(held), cone) == 0:
            wrong.append("step %d falls with %s held" % (step["step"], ", ".join(held)))
        if step["hold"]["proof"] == "minimal" and len(held) == 2:
            less = [b for b in sorted(there) if stands(scene, there, {b}, cone) == 1]
            if less:
                wrong.append("step %d: %s alone suffices" % (step["step"], less[0]))
    return wrong, told["first_failing"]


def generated(cli, words):
    return oracle.Scene(subprocess.run([cli, "gen"] + words, capture_output=True, text=True, check=True).stdout)


def orders(cli):
    """Every row of the table against the programmes: what is wrong with it."""
    path = os.path.join(HERE, "..", "sequence", "test_orders.c")
    rows = re.findall(r'\{ "([a-z-]+)", (?:"(\w+)"|NULL), ([0-9.]+), "(\w+)", "(\w*)" \}', open(path).read())
    bad = steps = 0
    for name, number, value, moves, told in rows:
        scene = generated(cli, [name] + (["%s=%s" % (number, value)] if number else []))
        free, there, truth = [b.name for b in scene.blocks if not b.fixed], set(), ""
        for move in moves:
            there ^= {free[int(move, 36)]}
            truth += {1: "s", 0: "f", None: "?"}[stands(scene, there, set(), "true")]
        steps += len(moves)
        if truth != told:
            bad += 1
            print("%s %s %s, %s: %s, the programmes say %s" % (name, number, value, moves, told, truth))
    print("%d build orders of %d steps; %d wrong" % (len(rows), steps, bad))
    return 1 if bad or len(rows) < 10 else 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cli", default=os.path.join(HERE, "..", "..", "build", "stonepack"))
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--orders", action="store_true")
    a = parser.parse_args()
    if a.orders:
        return orders(a.cli)
    rng = np.random.default_rng(a.seed)
    count, bad = {"steps": 0, "open": 0, "held": 0}, 0
    for k in range(a.count + 3):
        arch = ["arch", "n=%d" % (7, 9, 15)[k]] if k < 3 else None
        if arch:
            words = arch
        else:
            kind = rng.integers(0, 6)
            words = [["wall", "rows=%d" % rng.integers(2, 5), "bricks=%d" % rng.integers(2, 4),
                      "jitter=%.3f" % rng.uniform(0, 0.4)],
                     ["arch", "n=%d" % rng.integers(3, 10), "t=%.3f" % rng.uniform(0.1, 0.4)],
                     ["diamond", "rows=%d" % rng.integers(2, 4)],
                     ["tower", "n=%d" % rng.integers(2, 7), "lean=%.3f" % rng.uniform(0, 0.4)],
                     ["rubble", "rows=3", "bricks=2", "seed=%d" % rng.integers(1, 1000)],
                     ["inverted-triangle", "rows=%d" % rng.integers(2, 5)]][kind]
            words.append("mu=%.2f" % rng.uniform(0.2, 1))
        scene = generated(a.cli, words)
        order = [b.name for b in scene.blocks if not b.fixed]
        if not arch and rng.random() < 0.6:
            order = [str(b) for b in rng.permutation(order)]
        remove, cone = bool(not arch and rng.random() < 0.4), "true" if arch or rng.random() < 0.5 else "8i"
        wrong, first = compare(a.cli, scene, order, remove, cone, count)
        if arch:
            print("%s: step %s fails first" % (" ".join(words), first))
        for w in wrong:
            print("%s, cone %s%s: %s" % (" ".join(words), cone, ", taken down" if remove else "", w))
        bad += len(wrong)
    print("%d steps, %d of them too near their limit to compare; %d sets to be held; %d wrong"
          % (count["steps"], count["open"], count["held"], bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
