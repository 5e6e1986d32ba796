#!/usr/bin/env python3
"""Strong verdicts of a folder of assemblies and of random ones.
    strong_cases.py PROGRAM FOLDER... [--quad PROGRAM] [--attack PROGRAM] [--attempts N] [--random N] [--seed N] [-v]

FOLDER/NAME/scene.obj (or .gz), or FOLDER/*.obj. Each is asked `check --strong`. Prints

    answers by size: strong, strong at its corners, ambiguous, admissible (neither shown); of those that stand the share decided;
    --quad, the same program in 113 bits: does `verify` there, from the written result alone, prove the same;
    --attack, tests/instruments/friction.c: attempts to move what is called strong, up to N a scene;
    --random: so many made scenes, each written in two other ways (turned with gravity, in another unit of length and mass, in
        another order, every other joint from B, all loads c times as large): do answers contradict, is what falls strong?

Exit status 1: a proof does not hold, something strong moves, two answers contradict each other. Standard library only.
"""
import argparse, gzip, json, os, random, re, subprocess, sys, tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from coupled_cases import rewritten

FEW = 24                                # corners: as the shares count them
MORE = []                                # more words of every question
BUDGET = ["--budget", "1e8"]             # of a made scene: most are small
KINDS = ("strong", "strong at these corners", "ambiguous", "admissible")


def scenes(folder):
    for name in sorted(os.listdir(folder)):
        base = os.path.join(folder, name)
        for path in (base,) if name.endswith(".obj") else (base + "/scene.obj", base + "/scene.obj.gz"):
            if os.path.isfile(path):
                with (gzip.open(path, "rt") if path.endswith(".gz") else open(path, encoding="utf-8")) as f:
                    yield name, f.read()
                break


def ask(program, text, more=()):
    """`check --strong`; None: it is refused."""
    p = subprocess.run([program, "check", "--json", "--strong", *MORE, *more, "-"], input=text, capture_output=True, text=True)
    return json.loads(p.stdout) if p.returncode in (0, 1, 2) else None


def kind(r):
    return r["strong"]["verdict"] if r["verdict"] == "stable" else r["verdict"]


def table(got):
    print("corners      stand   strong  at corners  ambiguous  admissible  decided")
    for few in (True, False):
        of = [kind(r) for r in got.values() if r["verdict"] == "stable" and (r["contact_vertices"] <= FEW) is few]
        n = [of.count(k) for k in KINDS]
        print("%s %-9d %5d %8d %11d %10d %11d  %s" % ("<=" if few else "> ", FEW, len(of), *n, share(n)))
    of = [kind(r) for r in got.values() if r["verdict"] == "stable"]
    n = [of.count(k) for k in KINDS]
    print("all          %5d %8d %11d %10d %11d  %s" % (len(of), *n, share(n)))


def share(n):
    return "%.0f %%" % (100 * sum(n[:3]) / sum(n)) if sum(n) else "-"


def in_quad(quad, texts, got):
    """The written results, judged in 113 bits."""
    held, bad = 0, []
    with tempfile.TemporaryDirectory() as room:
        scene, result = os.path.join(room, "scene.obj"), os.path.join(room, "result.json")
        for name, r in got.items():
            if kind(r) not in KINDS[:3]:
                continue
            with open(scene, "w", encoding="utf-8") as f:
                f.write(texts[name])
            with open(result, "w", encoding="utf-8") as f:
                json.dump(r, f)
            p = subprocess.run([quad, "verify", scene, result], capture_output=True, text=True)
            said = re.search(r"whatever friction does: (.*)", p.stdout)
            if said and said.group(1).split(",")[0].strip() == kind(r):
                held += 1
            else:
                bad.append("%s: %s in double; %s" % (name, kind(r), (p.stdout + p.stderr).strip()))
    print("113 bits: %d proofs hold, %d do not" % (held, len(bad)))
    for line in bad:
        print("  FAILS in 113 bits: " + line)
    return not bad


def attacked(program, texts, got, attempts):
    """Attempts to move what is strong."""
    n, moved, scenes_of = [0, 0], [], 0
    with tempfile.TemporaryDirectory() as room:
        paths = []
        for k, (name, r) in enumerate(got.items()):
            if kind(r) in KINDS[:2]:
                paths.append((os.path.join(room, "%d.obj" % k), name))
                with open(paths[-1][0], "w", encoding="utf-8") as f:
                    f.write(texts[name])
        names = dict(paths)
        p = subprocess.run([program, str(attempts)] + [x for x, _ in paths], capture_output=True, text=True)
        for line in p.stdout.splitlines():
            w = [x.strip() for x in line.split("|")]
            if len(w) == 7:
                scenes_of += int(w[4]) > 0
                n = [n[0] + int(w[4]), n[1] + int(w[5])]
            if len(w) != 7 or int(w[6]):
                moved.append(names.get(w[0], "") + " " + line)
    print("attempts: %d to move %d scenes that are strong, %d of them settled; %d moved" % (n[0], scenes_of, n[1], len(moved)))
    for line in moved:
        print("  MOVED: " + line)
    return not moved and p.returncode == 0


def made(rng):
    """Words for `gen`: a small scene."""
    r, u = rng.randint, rng.uniform
    name, given = rng.choice([
        ("wall", dict(rows=r(1, 3), bricks=r(1, 3), jitter=u(0, .45), seed=r(1, 999), height=u(.1, .4))),
        ("rubble", dict(rows=r(1, 3), bricks=r(1, 3), jitter=u(0, 1), seed=r(1, 999))),
        ("arch", dict(n=r(2, 8), t=u(.1, .4), half=u(30, 100))),
        ("diamond", dict(rows=r(1, 5), height=u(.1, .6))),
        ("tower", dict(n=r(1, 6), lean=u(0, .2))),
        ("flat-arch", dict(n=r(1, 7), height=u(.2, .8), half=u(0, 40))),
        ("keystone", dict(angle=u(-30, 20), width=u(.3, 2))),
        ("two-cubes", dict(offset=u(-.6, .6))),
        ("incline", dict(angle=u(0, 45))),
        ("h-model", dict(mu=u(.01, 2))),
        ("cantilever", dict(reach=u(.3, 1.3), weight=u(.1, 1)))])
    return [name] + ["%s=%r" % x for x in given.items()]


def heavier(text, c):
    """Gravity c times as large; these scenes have no other load."""
    def times(m):
        return "#@ gravity " + " ".join(repr(c * float(x)) for x in m.group(0).split()[2:])
    return re.sub(r"^#@ gravity .*", times, text, flags=re.M)


def at_random(program, count, seed):
    """Answers of made scenes do not depend on how they are written; what falls is never strong."""
    rng, tally, bad, unsure = random.Random(seed), {}, [], 0
    for k in range(count):
        words = made(rng)
        text = subprocess.run([program, "gen"] + words, capture_output=True, text=True).stdout
        if not re.search(r"^#@ gravity", text, re.M):
            text = "#@ gravity 0 0 -9.80665\n" + text
        if rng.random() < .3:
            text = re.sub(r"^#@ mu \S+", "#@ mu %r" % rng.uniform(.05, 1.2), text, count=1, flags=re.M)
        first = ask(program, text, BUDGET)
        if first is None:
            continue
        a = kind(first)
        tally[a] = tally.get(a, 0) + 1
        if first["verdict"] != "stable" and first["strong"]["verdict"] != "none":
            bad.append("%s: %s, but %s" % (" ".join(words), first["verdict"], first["strong"]["verdict"]))
        for unit, heavy in ((1000., 1e-9), (.3048, 40.)):
            other = ask(program, heavier(rewritten(text, unit, heavy, rng), 10 ** rng.uniform(-2, 2)), BUDGET)
            b = kind(other) if other else "refused"
            if a == b:
                continue
            if "admissible" in (a, b) or "undecided" in (a, b):
                unsure += 1
            else:
                bad.append("%s: %s, written otherwise: %s" % (" ".join(words), a, b))
    print("random: %d scenes (%s), each written in 2 other ways: %d contradict, %d decided in one way only"
          % (sum(tally.values()), ", ".join("%d %s" % (n, k) for k, n in sorted(tally.items())), len(bad), unsure))
    for line in bad:
        print("  " + line)
    return not bad


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("program")
    p.add_argument("folder", nargs="+")
    p.add_argument("--quad", help="the program in 113 bits")
    p.add_argument("--attack", help="tests/instruments/friction.c, built")
    p.add_argument("--attempts", type=int, default=60)
    p.add_argument("--corners", action="store_true", help="pressure is at the corners that joints list")
    p.add_argument("--random", type=int, default=0)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("-v", action="store_true", help="every answer")
    a = p.parse_args()
    MORE.extend(["--corners"] if a.corners else [])
    texts, got = {}, {}
    for folder in a.folder:
        for name, text in scenes(folder):
            r = ask(a.program, text, ["--forces"])
            if r:
                texts[name], got[name] = text, r
    if not got:
        sys.exit("no scenes in " + " ".join(a.folder))
    for name, r in got.items() if a.v else ():
        print("%-36s %5d  %-24s %s" % (name, r["contact_vertices"], kind(r), r["strong"]["reason"]))
    table(got)
    good = not a.quad or in_quad(a.quad, texts, got)
    good = (not a.attack or attacked(a.attack, texts, got, a.attempts)) and good
    good = (not a.random or at_random(a.program, a.random, a.seed)) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
