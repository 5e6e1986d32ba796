#!/usr/bin/env python3
"""The coupled check on a folder of assemblies.    coupled_cases.py PROGRAM CASES [--quad PROGRAM] [--every N] [-v]

CASES/NAME/scene.obj (or .gz) with expected.json beside it, or CASES/*.obj of unknown truth. Every case is asked with its own
eps and eta, compas_cra's cone (8c) and its bound per component. Prints

    answers by truth and size, the shares of them that are found, every miss with its reason;
    with --quad, the same program in 113 bits: does `verify` there, from the written result alone, find every triple and every
        proof to hold, and how much of what is allowed they take. A negative of a_type-*, a solver's statement, is overridden by
        a triple that holds, and told;
    monotone: of questions that each allow what the one before allows and more, none is refuted after one is coupled;
    invariant: another unit, order, side A, a turn of everything with gravity, and a factor on eps and eta leave the answer;
        both of every N-th assembly, in the order of their names.

Exit status 1: something said is wrong, a share is missed, or an answer depends on how the scene is written. Standard library only.
tests/bench/coupled.py has the same cases as CSV, with times.
"""
import argparse, gzip, json, os, random, re, subprocess, sys, tempfile

SMALL, LARGE = 40, 300                  # contact vertices: as the shares count them; more are not asked again and again
SHARES = {(True, True): .95, (True, False): .90, (False, True): .80, (False, False): .80}       # (feasible, small)
WORDS = {True: "feasible", False: "infeasible", None: "not known"}


class Case:
    def __init__(self, folder, name):
        self.name, base = name, os.path.join(folder, name)
        self.path, self.exp = base, {}
        if os.path.isdir(base):
            self.path = os.path.join(base, "scene.obj")
            with open(os.path.join(base, "expected.json"), encoding="utf-8") as f:
                self.exp = json.load(f)
        self.cra = self.exp.get("cra") or {}
        truth = (self.exp.get("truth") or {}).get("cra")
        said = truth.get("feasible") if isinstance(truth, dict) else None
        self.feasible = said if isinstance(said, bool) else self.cra.get("feasible")
        if not os.path.exists(self.path):
            with gzip.open(self.path + ".gz", "rt") as f:
                self.text = f.read()
        else:
            with open(self.path, encoding="utf-8") as f:
                self.text = f.read()

    def lengths(self, scale=1.0, eta=1.0):
        given = [(k, self.cra[k] * scale * (eta if k == "eta" else 1)) for k in ("eps", "eta") if self.cra.get(k) is not None]
        return [x for k, v in given for x in ("--cra-" + k, repr(v))]


def ask(program, text, more):
    """`check --coupled` of a scene's text."""
    p = subprocess.run([program, "check", "--json", "--coupled"] + more + ["-"], input=text, capture_output=True, text=True)
    if p.returncode not in (0, 1, 2):
        sys.exit("stonepack check %s: %s" % (" ".join(more), p.stderr.strip()))
    return json.loads(p.stdout)


def answer(doc):
    return doc["coupled"]["verdict"]


# --------------------------------------------------------------------------------------------------------- answers, in 113 bits

def table(cases, got):
    """Answers by truth and size; misses; are all right and all shares reached?"""
    good = True
    print("truth, corners              coupled  refuted  not found   found  asked")
    for truth in (True, False, None):
        for small in (True, False):
            of = [c for c in cases if c.feasible is truth and (got[c.name]["contact_vertices"] <= SMALL) is small]
            n = [sum(answer(got[c.name]) == a for c in of) for a in ("coupled", "refuted", "not found")]
            if not of:
                continue
            right = n[0] if truth else n[1] if truth is False else n[0] + n[1]
            share = SHARES.get((truth, small))
            print("%-10s %s %-14d %7d %8d %10d  %5.1f %%  %s" % (WORDS[truth], "<=" if small else "> ", SMALL, n[0], n[1], n[2],
                  100 * right / len(of), "%.0f %%" % (100 * share) if share else ""))
            good = good and (share is None or right >= share * len(of))
    for c in cases:
        r = got[c.name]
        want = {True: "coupled", False: "refuted", None: None}[c.feasible]
        if answer(r) == want or (want is None and answer(r) != "not found"):
            continue
        print("  miss: %-28s %4d corners, %-10s: %s (%s)"
              % (c.name, r["contact_vertices"], WORDS[c.feasible], answer(r), r["coupled"]["reason"]))
        overrides = c.feasible is False and answer(r) == "coupled" and c.name.startswith("a_type-")
        good = good and (answer(r) == "not found" or overrides)
    return good


def in_quad(quad, cases, got):
    """The written results, judged in 113 bits."""
    worst, least, held, bad, over = (0.0, ""), (1e9, ""), {"coupled": 0, "refuted": 0}, [], []
    with tempfile.TemporaryDirectory() as room:
        scene, result = os.path.join(room, "scene.obj"), os.path.join(room, "result.json")
        for c in cases:
            r = got[c.name]
            if answer(r) not in held or r["coupled"]["reason"] == "statics":
                continue
            with open(scene, "w", encoding="utf-8") as f:
                f.write(c.text)
            with open(result, "w", encoding="utf-8") as f:
                json.dump(r, f)
            p = subprocess.run([quad, "verify", "--cra-box", "--cone", "8c"] + c.lengths() + [scene, result], capture_output=True, text=True)
            residual = re.search(r": stable by .*, coupled, residual ([^,\s]+)", p.stdout)
            margin = re.search(r": unstable by .*, refuted, margin ([^,\s]+)", p.stdout)
            if not (residual if answer(r) == "coupled" else margin):
                bad.append("%s: %s" % (c.name, (p.stdout + p.stderr).strip()))
                continue
            held[answer(r)] += 1
            if residual:
                worst = max(worst, (float(residual.group(1)), c.name))
                if c.feasible is False:
                    over.append(c.name)
            else:
                least = min(least, (float(margin.group(1)), c.name))
    print("113 bits: %d triples hold, the worst takes %.2g of what is allowed (%s)" % (held["coupled"], *worst))
    print("          %d proofs hold, the least margin is %.2g (%s)" % (held["refuted"], *least))
    print("          called infeasible, but overridden by a triple: " + (" ".join(over) or "none"))
    for line in bad:
        print("  FAILS in 113 bits: " + line)
    return not bad


# ---------------------------------------------------------------------------------------------------------- monotone, invariant

def weaker(c, mu):
    """Questions, each allowing all triples of the one before: friction within 8 faces, the cone, around it 8, 4; a bound of the
    slip's length, of its components; a larger eta; more friction."""
    e, far, last = c.lengths(), c.lengths(eta=3), ["--cone", "4c", "--cra-box"]
    return [["--cone", "8i"] + e, ["--cone", "true"] + e, ["--cone", "true", "--cra-box"] + e,
            ["--cone", "8c", "--cra-box"] + e, last + e, last + far, last + ["--mu", repr(1.25 * mu)] + far]


def friction(text):
    return float(re.search(r"^#@ mu (\S+)", text, re.M).group(1)) if re.search(r"^#@ mu ", text, re.M) else 0.84


def monotone(program, cases):
    count, lost, bad = 0, [], []
    for c in cases:
        before = None
        for more in weaker(c, friction(c.text)):
            now = answer(ask(program, c.text, more))
            count += 1
            if before and now == "refuted":
                bad.append("%s: coupled %s, refuted %s" % (c.name, " ".join(before), " ".join(more)))
            if before and now == "not found":
                lost.append("%s %s" % (c.name, " ".join(more)))
            before = more if now == "coupled" else before
    print("monotone: %d questions of %d assemblies; after a stricter one was coupled %d refuted, %d not found"
          % (count, len(cases), len(bad), len(lost)))
    for line in bad + lost:
        print("  " + line)
    return not bad


def turn(rng):
    """A rotation, of a random unit quaternion."""
    while True:
        w = [rng.uniform(-1, 1) for _ in range(4)]
        s = sum(x * x for x in w)
        if .1 < s < 1:
            break
    a, b, d, e = (x / s ** .5 for x in w)
    return [[a * a + b * b - d * d - e * e, 2 * (b * d - a * e), 2 * (b * e + a * d)],
            [2 * (b * d + a * e), a * a - b * b + d * d - e * e, 2 * (d * e - a * b)],
            [2 * (b * e - a * d), 2 * (d * e + a * b), a * a - b * b - d * d + e * e]]


def rewritten(text, unit, heavy, rng):
    """The scene turned, in another unit of length and mass, blocks and joints in another order, every other joint from B."""
    q = turn(rng)

    def moved(words, scale):
        x = [float(w) for w in words]
        return " ".join(repr(scale * sum(q[i][k] * x[j + k] for k in range(3))) for j in range(0, len(x), 3) for i in range(3))

    head, blocks, joints, g = [], [], [], ["0", "0", "-9.80665"]
    for line in text.splitlines():
        w = line.split()
        if not w:
            continue
        if w[0] == "o":
            blocks.append([line])
        elif w[0] == "v":
            blocks[-1].append(["v", moved(w[1:4], unit)])
        elif w[:2] == ["#@", "gravity"]:
            g = w[2:]
        elif w[:2] == ["#@", "interface"]:
            joints.append([w[2], w[3], w[4:], []])
        elif w[:2] == ["#@", "density"]:
            (blocks[-1] if blocks else head).append("#@ density %r" % (float(w[2]) * heavy))
        else:
            (joints[-1][3] if joints else blocks[-1] if blocks else head).append(line)
    first, out, seen, new = {}, head + ["#@ gravity " + moved(g, unit)], 0, 0
    for k, b in enumerate(blocks):
        first[k] = seen
        seen += sum(isinstance(x, list) for x in b)
    order = list(range(len(blocks)))
    rng.shuffle(order)
    for k in order:
        shift = new - first[k]
        for x in blocks[k]:
            if isinstance(x, list):
                out.append(" ".join(x))
                new += 1
            elif x.startswith("f "):
                corners = [int(i.split("/")[0]) for i in x.split()[1:]]
                out.append("f " + " ".join(str(i + shift if i > 0 else i) for i in corners))
            else:
                out.append(x)
    rng.shuffle(joints)
    for k, (a, b, xyz, own) in enumerate(joints):
        corners = [xyz[i:i + 3] for i in range(0, len(xyz), 3)]
        if k % 2:
            a, b, corners = b, a, corners[::-1]
        out += ["#@ interface %s %s %s" % (a, b, moved(sum(corners, []), unit))] + own
    return "\n".join(out) + "\n"


def invariant(program, cases):
    bad, unsure, rng = [], [], random.Random(1)
    for c in cases:
        plain = answer(ask(program, c.text, ["--cone", "true"] + c.lengths()))
        ways = [(rewritten(c.text, unit, heavy, rng), unit) for unit, heavy in ((1000., 1e-9), (.3048, 40.))]
        for text, unit in ways + [(c.text, 37.)]:       # the last: eps and eta alone are longer
            other = answer(ask(program, text, ["--cone", "true"] + c.lengths(unit)))
            if other != plain:
                to = unsure if "not found" in (other, plain) else bad
                to.append("%s: %s, written otherwise: %s" % (c.name, plain, other))
    print("invariant: %d assemblies written in 2 other ways, and eps and eta times 37: %d contradict, %d found in one way only"
          % (len(cases), len(bad), len(unsure)))
    for line in bad + unsure:
        print("  " + line)
    return not bad


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("program")
    p.add_argument("cases")
    p.add_argument("--quad", help="the program in 113 bits")
    p.add_argument("--every", type=int, default=1, metavar="N", help="what is asked in other forms: every N-th assembly")
    p.add_argument("-v", action="store_true", help="every answer")
    a = p.parse_args()
    cases = [Case(a.cases, n) for n in sorted(os.listdir(a.cases))
             if n.endswith(".obj") or os.path.exists(os.path.join(a.cases, n, "expected.json"))]
    if not cases:
        sys.exit("no scenes in " + a.cases)
    got = {c.name: ask(a.program, c.text, ["--forces", "--cra-box", "--cone", "8c"] + c.lengths()) for c in cases}
    if a.v:
        for c in cases:
            x = got[c.name]["coupled"]
            print("%-32s %-10s %-10s %s" % (c.name, WORDS[c.feasible], x["verdict"], x["reason"]))
    good = table(cases, got)
    if a.quad:
        good = in_quad(a.quad, cases, got) and good
    few = [c for c in cases if got[c.name]["contact_vertices"] <= LARGE][::a.every]
    good = monotone(a.program, few) and good
    good = invariant(a.program, few) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
