#!/usr/bin/python3
"""random: random scenes a hair on either side of their limit, the program's verdict against linear programming.

    random.py [--quick] [--cli build/stonepack] [--seed N] [--count N] [--seeds N,N..] [--jobs N] [--keep FOLDER] [--verbose]
              [--kind friction | strength | loads | supports | masses] [--limits]

Each scene is generated, changed at random (weights, friction, lost joints, a turned world; by its kind, joints with cohesion,
tension and crushing, loads at points, lost supports, masses 1e4 to 1e8 apart), and pushed: gravity g + lambda h in a random
direction h, where h and g are equally long. oracle.py finds the largest lambda that some forces balance; at relative
distances 1e-1 .. 1e-6 on either side the program must say stable or unstable. A millionth beyond its limit a scene may miss
balance by less than 1e-9 of its blocks' forces: where the program says that the limit is nearer than its tol, it is asked again
at a tenth and a hundredth of that ("finer"). Prints what was compared; the exit status is 1 if a verdict was wrong, of --seeds if
one was undecided, too. --limits: `limit` is asked for lambda instead, and must know it to a millionth. Forces beyond the
library's bound, and limits the oracle itself does not know well enough, are left out.
"""
import argparse
import json
import multiprocessing
import os
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path = [p for p in sys.path if os.path.abspath(p or ".") != HERE] + [HERE]   # our name is also one of the library's

import numpy as np
import oracle

DISTANCES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
KINDS = ("friction", "strength", "loads", "supports", "masses")
CONES = ("8i", "4c", "16i", "true")
TOLS = (1e-9, 1e-10, 1e-11)                             # the program's, and what it is asked for where that leaves it undecided


def numbers(rng):
    """A generator with small random numbers."""
    r, u = rng.integers, rng.uniform
    kinds = [
        ("wall", dict(rows=r(1, 5), bricks=r(1, 4), jitter=u(0, 0.45), seed=r(1, 1000), height=u(0.1, 0.4))),
        ("rubble", dict(rows=r(1, 4), bricks=r(1, 4), jitter=u(0, 1), seed=r(1, 1000))),
        ("vault", dict(around=r(3, 8), n=r(1, 4), t=u(0.1, 0.4), half=u(30, 90), seed=r(1, 1000), jitter=u(0, 0.4))),
        ("dome", dict(rings=r(1, 4), segments=r(4, 9), t=u(0.08, 0.3), eye=u(10, 40))),
        ("arch", dict(n=r(2, 16), t=u(0.11, 0.4), half=u(30, 100))),
        ("diamond", dict(rows=r(1, 6), height=u(0.1, 0.6))),
        ("tower", dict(n=r(1, 9), lean=u(0, 0.1))),
        ("flat-arch", dict(n=r(1, 9), height=u(0.2, 0.8), half=u(0, 40))),
        ("keystone", dict(angle=u(-30, 20), width=u(0.3, 2))),
        ("two-cubes", dict(offset=u(-0.45, 0.45))),
        ("cantilever", dict(reach=u(0.3, 1.1), weight=u(0.1, 1))),
    ]
    name, given = kinds[rng.choice(len(kinds), p=np.array([6, 6, 4, 4, 4, 3, 2, 3, 1, 1, 1]) / 35)]
    return [name] + ["%s=%s" % (k, int(v) if float(v).is_integer() else repr(float(v))) for k, v in given.items()]


def turn(rng):
    """A random rotation."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def change(scene, rng):
    """Weights, friction, lost joints, a turned world; says what it did."""
    done = []
    if rng.random() < 0.4:
        done.append("weights")
        for b in scene.blocks:
            b.density = float(scene.density * 10 ** rng.uniform(-2, 2))
    if rng.random() < 0.4:
        done.append("friction")
        for i in scene.interfaces:
            i.mu = float(rng.uniform(0.1, 1.2))
    elif rng.random() < 0.5:
        scene.mu = float(rng.uniform(0.2, 1.0))
        done.append("mu")
    if rng.random() < 0.25 and len(scene.interfaces) > 3:
        done.append("lost")
        keep = rng.random(len(scene.interfaces)) > 0.08
        scene.interfaces = [i for i, k in zip(scene.interfaces, keep) if k]
    if rng.random() < 0.4:
        done.append("turned")
        q = turn(rng)
        scene.x, scene.gravity = scene.x @ q.T, q @ scene.gravity
        for i in scene.interfaces:
            i.x = i.x @ q.T
    return done


def change_kind(scene, kind, rng):
    """What the kind of scenes has besides."""
    free = [b for b in scene.blocks if not b.fixed]
    volumes = [oracle.volume(scene.x, b.faces) for b in free]
    weight = 9.80665 * float(np.mean([v * (b.density or scene.density) for (v, _), b in zip(volumes, free)]))
    fixed = {b.name for b in scene.blocks if b.fixed}
    if kind == "masses":
        span = rng.uniform(4, 8)
        for b in free:
            b.density = float(scene.density * 10 ** rng.uniform(-span / 2, span / 2))
    if kind == "supports":
        held = [i for i in scene.interfaces if i.a in fixed or i.b in fixed]
        lost = [i for i in held[1:] if rng.random() < 0.4]
        scene.interfaces = [i for i in scene.interfaces if not any(i is k for k in lost)]
    for _ in range(rng.integers(1, 4) if kind == "loads" and free else 0):
        k = rng.integers(len(free))
        f = rng.normal(size=3) * weight * 10 ** rng.uniform(-2, 1)
        scene.loads.append((free[k].name, f, volumes[k][1] + 0.1 * rng.normal(size=3)))
    for i in scene.interfaces if kind == "strength" else []:
        if rng.random() < 0.2:
            continue
        stress = weight / oracle.frame(i.x)[1] * 10 ** rng.uniform(-1, 1)
        mu = scene.mu if i.mu is None else i.mu
        if rng.random() < 0.7:
            i.strength["cohesion"] = float(stress * rng.uniform(0.01, 1))
        if rng.random() < 0.5 and ("cohesion" in i.strength or not mu):
            i.strength["tension"] = float(stress * rng.uniform(0.01, 0.5))
        if rng.random() < 0.7:
            i.strength["crushing"] = float(stress * 10 ** rng.uniform(1, 2))


def ask(cli, scene, cone, gravity, tol):
    """The program's answer."""
    scene.gravity = gravity
    out = subprocess.run([cli, "check", "--json", "--forces", "--cone", cone, "--tol", repr(tol), "-"], input=scene.text(),
                         capture_output=True, text=True)
    if out.returncode not in (0, 1, 2):
        return dict(verdict="status %d: %s" % (out.returncode, out.stderr.strip()), omega=0, verified=False, reason="")
    return json.loads(out.stdout)


def judge(cli, scene, problem, cone, gravity, want, distance, label, tols=TOLS[:1]):
    """One comparison: right, finer, undecided, near or wrong. Finer: right, but not at the first tol. Near: stable beyond the
    limit, by forces that our own sums find balanced within tol, too; a limit is known no better than that. Forces that are not
    what they are said to be are wrong anywhere."""
    for tol in tols:
        r = ask(cli, scene, cone, gravity, tol)
        if r["verdict"] != "undecided" or r["reason"] != "limit":
            break
    got = r["verdict"]
    how = "right" if got == want else "undecided" if got == "undecided" else "wrong"
    if how == "right" and tol < TOLS[0]:
        how = "finer"
    if got != "undecided" and not r["verified"]:
        how = "wrong"
    omega = r["omega"]
    if got == "stable" and "forces" in r:
        omega, excess, pushing = oracle.evidence(problem, cone, gravity, r["forces"], tol)
        holds = omega <= 1.01 * tol and excess <= 1e-12 and pushing
        how = "wrong" if not holds else "near" if want != "stable" and distance <= 1e-5 else how
    return dict(how=how, got=got, want=want, distance=distance, omega=omega, least=r.get("least_imbalance", 0), tol=tol,
                label=label, cone=cone,
                text=scene.text() if how == "wrong" else None)


def judge_limit(cli, scene, cone, h, top, bottom, size, label):
    """The program's multiplier against that of the programme, and whether it falls under dead loads: right, undecided (either of
    the two) or wrong."""
    out = subprocess.run([cli, "limit", "--json", "--cone", cone, "--body=%r,%r,%r" % tuple(map(float, h)), "-"],
                         input=scene.text(), capture_output=True, text=True)
    r = json.loads(out.stdout) if out.returncode in (0, 2) else dict(multiplier="status %d" % out.returncode)
    got, falls, most = r["multiplier"], r.get("falls_under_dead_loads"), 1e-6 * size + top.error()
    if top.high < 0:                                    # dead loads fall, and a push this way makes it worse
        how = "right" if got is None else "undecided" if got == "undecided" else "wrong"
    elif got == "undecided":
        low, high = r.get("lower"), r.get("upper")
        out_of = (low is not None and low > top.value + most) or (high is not None and high < top.value - most)
        how = "wrong" if out_of else "undecided"
    else:
        how = "right" if isinstance(got, (int, float)) and abs(got - top.value) <= most and r["verified"] else "wrong"
        if bottom.status == "limit" and abs(bottom.value) > 1e-6 * size + bottom.error() and falls is (bottom.value > 0):
            how = "wrong"
    if how == "right" and falls is None:
        how, got = "undecided", "%s, dead loads undecided" % got
    return dict(how=how, got=str(got), want=repr(top.value), distance=0, omega=0, least=0, tol=TOLS[0], label=label, cone=cone,
                text=scene.text() if how == "wrong" else None)


def trial(job):
    """One scene, one direction, one cone: all its comparisons, or why there are none."""
    cli, seed, cone, kind, limits = job
    rng = np.random.default_rng(seed)
    given = numbers(rng)
    made = subprocess.run([cli, "gen"] + given, capture_output=True, text=True)
    if made.returncode:
        return dict(skip="gen: " + made.stderr.strip(), label=" ".join(given))
    scene = oracle.Scene(made.stdout)
    label = "seed %d: %s (%s)" % (seed, " ".join(given), ", ".join(change(scene, rng)))
    if kind != "friction":
        change_kind(scene, kind, rng)
    if not scene.interfaces:
        return dict(skip="no joint is left: a file without any has joints found", label=label)
    problem = oracle.Problem(scene)
    g = scene.gravity.copy()
    h = rng.normal(size=3)
    h *= np.linalg.norm(g) / np.linalg.norm(h)
    one = 1 / np.linalg.norm(g)
    top = oracle.limit(problem, cone, g * one, h * one, one)
    if top.status == "infeasible":
        least = oracle.least_imbalance(problem, cone, g)
        if not least > 1e-5:
            return dict(skip="infeasible, hardly", label=label)
        return dict(label=label, found=[judge(cli, scene, problem, cone, g, "unstable", 1.0, label)])
    if top.status != "limit":
        return dict(skip=top.status, label=label)
    if not oracle.within_bound(problem, top.f):
        return dict(skip="forces beyond the bound", label=label)
    tols = [t for t in TOLS if oracle.within_bound(problem, top.f, min(0.1, t / TOLS[0]))]     # the bound shrinks with tol
    bottom = oracle.limit(problem, cone, g * one, -h * one, one)
    width = top.value + bottom.value if bottom.status == "limit" else np.inf
    size = np.linalg.norm(g + top.value * h) / np.linalg.norm(h)
    found, unknown = [], 0
    if limits:
        return dict(label=label, found=[judge_limit(cli, scene, cone, h * one, top, bottom, size, label)])
    for d in DISTANCES:                                 # relative to gravity at the limit
        if top.error() > 0.1 * d * size:
            unknown += 1
            continue
        found.append(judge(cli, scene, problem, cone, g + (top.value + d * size) * h, "unstable", d, label, tols))
        if d * size < 0.5 * width:
            found.append(judge(cli, scene, problem, cone, g + (top.value - d * size) * h, "stable", d, label, tols))
    return dict(label=label, found=found, unknown=unknown)


def trials(options):
    """Answers in order, until the count or the time is spent."""
    until = time.time() + (22 if options.quick else 1e9)
    seeds = options.seeds or range(options.seed, options.seed + options.count)
    jobs = ((options.cli, k, "true" if options.kind == "strength" else CONES[k % len(CONES)], options.kind, options.limits)
            for k in seeds)
    if options.jobs < 2:
        for j in jobs:
            yield trial(j)
            if time.time() > until:
                return
    else:
        with multiprocessing.Pool(options.jobs) as pool:
            for answer in pool.imap_unordered(trial, jobs):
                yield answer


def report(options):
    tally, omega, skipped, unknown, scenes = {}, 0.0, {}, 0, 0
    for answer in trials(options):
        if "skip" in answer:
            skipped[answer["skip"]] = skipped.get(answer["skip"], 0) + 1
            continue
        scenes += 1
        unknown += answer.get("unknown", 0)
        for f in answer["found"]:
            key = (f["cone"], f["how"])
            tally[key] = tally.get(key, 0) + 1
            if f["got"] == "stable":
                omega = max(omega, f["omega"])
            if f["how"] != "right" or options.verbose:
                print("%-9s %s, want %s, %g from the limit, cone %s, tol %g, omega %.2g, least imbalance %.2g; %s"
                      % (f["how"], f["got"], f["want"], f["distance"], f["cone"], f["tol"], f["omega"], f["least"], f["label"]),
                      flush=True)
            if f["how"] == "wrong" and options.keep:
                with open(os.path.join(options.keep, "wrong-%d.obj" % sum(tally.values())), "w", encoding="utf-8") as out:
                    out.write(f["text"])
    total = {how: sum(n for (_, k), n in tally.items() if k == how) for how in ("right", "finer", "undecided", "near", "wrong")}
    for cone in CONES:
        print("%-5s " % cone + ", ".join("%d %s" % (tally.get((cone, how), 0), how) for how in total))
    for why, n in sorted(skipped.items()):
        print("left out: %d scenes, %s" % (n, why))
    print("left out: %d distances nearer than ten errors of the oracle" % unknown)
    print("%d scenes, %d compared: %d wrong, %d undecided, %d at a finer tol, %d stable within tol beyond the limit; "
          "worst omega %.2g"
          % (scenes, sum(total.values()), total["wrong"], total["undecided"], total["finer"], total["near"], omega))
    return 1 if total["wrong"] or not total["right"] or (options.seeds and total["undecided"]) else 0


def main():
    p = argparse.ArgumentParser(description="random scenes near their limit, against linear programming")
    p.add_argument("--quick", action="store_true", help="fewer scenes, at most 25 seconds")
    p.add_argument("--cli", default="build/stonepack")
    p.add_argument("--kind", default="friction", choices=KINDS, help="what the scenes have besides friction")
    p.add_argument("--limits", action="store_true", help="ask `limit`, not `check`")
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--count", type=int, default=0)
    p.add_argument("--seeds", type=lambda text: [int(k) for k in text.split(",")], help="these scenes only")
    p.add_argument("--jobs", type=int, default=1)
    p.add_argument("--keep", metavar="FOLDER", help="write scenes with wrong verdicts there")
    p.add_argument("--verbose", action="store_true")
    options = p.parse_args()
    options.count = options.count or (72 if options.quick else 300)
    return report(options)


if __name__ == "__main__":
    sys.exit(main())
