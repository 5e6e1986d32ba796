#!/usr/bin/python3
"""coupled: small random scenes, `check --coupled` against a search of another kind where it says that there is no triple, or finds none.

    coupled.py [--cli build/stonepack] [--count 40] [--seed 1] [--starts 30] [--jobs 1] [--keep FOLDER] [--verbose]

A scene is one to three cubes that touch a support or each other in random polygons, at random slants, under gravity. Where the
program says `refuted` or `not found` although admissible forces exist, the opponent looks for a triple (f, dq, alpha) as a
nonlinear least-squares problem from many random starts: balance, fn (dn + eps) = 0 and its signs by the Fischer-Burmeister
function, ft = -s^2 dt, |ft| <= mu fn, |dt| and dn <= eta [trust region, analytic Jacobian]. A triple counts if every condition
holds to 1e-9 of the weights and of eps, with alpha no larger than 1e5 weights an eps; the program's own `verify` is asked for it,
too. Where it says `coupled` the triple is checked by the same sums.

wrong: refuted, and there is one, or a told triple is none; then the exit status is 1. missed: not found, which promises nothing.
Needs numpy and scipy (Debian: python3-numpy, python3-scipy).
"""
import argparse
import json
import multiprocessing
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path = [p for p in sys.path if os.path.abspath(p or ".") != HERE] + [HERE]   # random.py beside us is not the library's

import tempfile

import numpy as np
from scipy.optimize import least_squares
import oracle

G = -oracle.GRAVITY[2]
ALPHA_MOST = 1e5                                        # weights an eps
NEAR = 1e-9
CUBE = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def cube(name, middle, size, fixed, first):
    """Lines of a box; first: the number of its first vertex."""
    corners = [(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    out = ["o " + name] + ["#@ fixed"] * fixed
    out += ["v " + " ".join(repr(float(m + 0.5 * s * k)) for m, s, k in zip(middle, size, c)) for c in corners]
    return out + ["f " + " ".join(str(first + k) for k in f) for f in CUBE]


def polygon(rng, middle, normal, size):
    """Three or four corners anticlockwise about that normal."""
    normal = normal / np.linalg.norm(normal)
    a = np.cross(normal, [1.0, 0, 0] if abs(normal[0]) < 0.7 else [0, 1.0, 0])
    a /= np.linalg.norm(a)
    b = np.cross(normal, a)
    n = int(rng.integers(3, 5))
    turns = 2 * np.pi * (np.arange(n) + rng.uniform(-0.3, 0.3, n)) / n
    return [middle + size * (np.cos(t) * a + np.sin(t) * b) for t in turns]


def make(rng):
    """A scene: cubes, and joints that squeeze, lean or bear."""
    free = int(rng.choice([1, 1, 1, 1, 1, 2, 2, 2, 3, 3]))
    lines = ["#@ mu %r" % float(rng.uniform(0.2, 2.5)), "#@ gravity 0.0 0.0 %r" % -G] + cube("b0", (-9, -9, -9), (1, 1, 1), 1, 1)
    middles = []
    for k in range(free):
        middles.append(np.array([1.3 * k, 0, 0]) + rng.normal(scale=0.1, size=3))
        lines += cube("b%d" % (k + 1), middles[k], rng.uniform(0.6, 1.2, 3), 0, 9 + 8 * k)
    joints = []
    for k in range(free):
        turn = rng.uniform(0, 2 * np.pi)
        for side in range(int(rng.integers(2, 4)) if k == 0 or rng.random() < 0.5 else 1):
            t = turn + np.pi * side + rng.normal(scale=0.4)
            away = np.array([np.cos(t), 0.3 * rng.normal(), np.sin(t)])
            joints.append((0, k + 1, polygon(rng, middles[k] + 0.5 * away, -away, rng.uniform(0.1, 0.4))))
        if k + 1 < free:
            away = middles[k + 1] - middles[k] + rng.normal(scale=0.2, size=3)
            joints.append((k + 1, k + 2, polygon(rng, 0.5 * (middles[k] + middles[k + 1]), away, rng.uniform(0.1, 0.4))))
    for a, b, x in joints:
        lines.append("#@ interface b%d b%d " % (a, b) + " ".join(repr(float(t)) for p in x for t in p))
    return "\n".join(lines) + "\n"


class Conditions:
    """The conditions as residuals, forces in mean weights, lengths in eps. u = dq, fn, s; s^2 = alpha."""

    def __init__(self, problem, eta):
        self.n, self.b = len(problem.mu), len(problem.mass)
        self.mu, self.eta = problem.mu, eta
        A = problem.A.toarray()
        self.A = [A[:, k::3] for k in range(3)]
        self.p = problem.load(np.array([0, 0, -1.0]), 1.0)

    def parts(self, u):
        q, fn, s = u[:6 * self.b], u[6 * self.b:6 * self.b + self.n], u[6 * self.b + self.n:]
        return fn, s, [a.T @ q for a in self.A]

    def residual(self, u):
        fn, s, (dn, d1, d2) = self.parts(u)
        ft, slip = s * s, np.hypot(d1, d2)
        balance = self.A[0] @ fn - self.A[1] @ (ft * d1) - self.A[2] @ (ft * d2) + self.p
        return np.concatenate([balance, np.hypot(fn, dn + 1) - fn - dn - 1, np.maximum(0, ft * slip - self.mu * fn),
                               np.maximum(0, slip / self.eta - 1), np.maximum(0, dn / self.eta - 1)])

    def jacobian(self, u):
        fn, s, (dn, d1, d2) = self.parts(u)
        A0, A1, A2 = self.A
        n, m, ft, slip = self.n, 6 * self.b, s * s, np.maximum(np.hypot(d1, d2), 1e-300)
        J = np.zeros((m + 4 * n, m + 2 * n))
        J[:m, :m] = -(A1 * ft) @ A1.T - (A2 * ft) @ A2.T
        J[:m, m:m + n] = A0
        J[:m, m + n:] = -2 * (A1 * (s * d1) + A2 * (s * d2))
        h = np.maximum(np.hypot(fn, dn + 1), 1e-300)
        J[m:m + n, :m] = ((dn + 1) / h - 1)[:, None] * A0.T
        J[m:m + n, m:m + n] = np.diag(fn / h - 1)
        along = (d1 / slip)[:, None] * A1.T + (d2 / slip)[:, None] * A2.T
        over = ft * slip > self.mu * fn
        J[m + n:m + 2 * n, :m] = (over * ft)[:, None] * along
        J[m + n:m + 2 * n, m:m + n] = -np.diag(over * self.mu)
        J[m + n:m + 2 * n, m + n:] = np.diag(over * 2 * s * slip)
        J[m + 2 * n:m + 3 * n, :m] = ((slip > self.eta) / self.eta)[:, None] * along
        J[m + 3 * n:, :m] = ((dn > self.eta) / self.eta)[:, None] * A0.T
        return J

    def misses(self, u):
        """How far the worst condition is off, in weights or eps."""
        fn, s, (dn, d1, d2) = self.parts(u)
        ft, slip = s * s, np.hypot(d1, d2)
        off = [np.abs(self.residual(u)[:6 * self.b]), np.minimum(np.abs(fn), np.abs(dn + 1)), np.maximum(0, -fn),
               np.maximum(0, -dn - 1), np.maximum(0, ft * slip - self.mu * fn), np.maximum(0, slip - self.eta),
               np.maximum(0, dn - self.eta)]
        return float(max(np.max(o) for o in off))


def search(c, rng, starts):
    """The best of many starts.     returns its misses, and it"""
    best, kept = np.inf, None
    for k in range(starts):
        q = rng.normal(size=6 * c.b) * 10 ** rng.uniform(-1, 1.5) + 10 * c.p        # the way of the loads, or nearly
        fn = rng.exponential(1, c.n) * (rng.random(c.n) < 0.6)
        u = np.concatenate([q, fn, np.full(c.n, 10 ** rng.uniform(-1.5, 0.5))])
        r = least_squares(c.residual, u, c.jacobian, method="trf", x_scale="jac", xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=300)
        u = r.x
        idle = 6 * c.b + np.flatnonzero(u[6 * c.b:6 * c.b + c.n] < 1e-10)
        u[idle] = u[idle + c.n] = 0
        miss = c.misses(u) if np.max(u[6 * c.b + c.n:] ** 2) <= ALPHA_MOST else np.inf
        if miss < best:
            best, kept = miss, u
        if best <= NEAR:
            break
    return best, kept


def told(problem, c, r):
    """The program's triple in our numbers."""
    f = np.array(r["forces"], float)[problem.place] / problem.unit / G
    dq = np.array(r["coupled"]["motion"], float)[1:] / r["coupled"]["eps"]
    dq[:, 3:] *= np.array(problem.size)[:, None]
    alpha = np.array(r["coupled"]["alpha"], float)[problem.place] * r["coupled"]["eps"] / problem.unit / G
    return np.concatenate([dq.ravel(), f[:, 0], np.sqrt(alpha)])


def verify(cli, text, problem, r, c, u):
    """What the program's verify says of our triple."""
    fn, s, (_, d1, d2) = c.parts(u)
    newton = problem.unit * G
    f, alpha = np.zeros((r["contact_vertices"], 3)), np.zeros(r["contact_vertices"])
    f[problem.place] = newton * np.stack([fn, -s * s * d1, -s * s * d2], axis=1)
    alpha[problem.place] = s * s * newton / r["coupled"]["eps"]
    dq = u[:6 * c.b].reshape(-1, 6) * r["coupled"]["eps"]
    dq[:, 3:] /= np.array(problem.size)[:, None]
    r["forces"], r["coupled"]["alpha"] = f.tolist(), alpha.tolist()
    r["coupled"]["motion"] = [[0] * 6] + dq.tolist()
    with tempfile.TemporaryDirectory() as folder:
        names = [os.path.join(folder, n) for n in ("scene.obj", "result.json")]
        for name, what in zip(names, (text, json.dumps(r))):
            with open(name, "w", encoding="utf-8") as out:
                out.write(what)
        return subprocess.run([cli, "verify"] + names, capture_output=True, text=True).stdout.strip()


def trial(job):
    """One scene: what the program says, what the opponent finds."""
    cli, seed, starts = job
    rng = np.random.default_rng(seed)
    text = make(rng)
    out = subprocess.run([cli, "check", "--coupled", "--json", "--forces", "-"], input=text, capture_output=True, text=True)
    if out.returncode not in (0, 1, 2):
        return dict(seed=seed, how="wrong", says="status %d: %s" % (out.returncode, out.stderr.strip()), text=text)
    r = json.loads(out.stdout)
    says = r["coupled"]["verdict"] if r.get("coupled") else "statics"
    if says == "refuted" and r["reason"] != "no consistent motion":
        says = "statics"
    problem = oracle.Problem(oracle.Scene(text))
    if says == "statics":
        return dict(seed=seed, how="statics", says=says)
    c = Conditions(problem, r["coupled"]["eta"] / r["coupled"]["eps"])
    if says == "coupled":
        miss = c.misses(told(problem, c, r))
        return dict(seed=seed, how="right" if miss <= 1e-6 else "wrong", says=says, miss=miss, text=text)
    miss, u = search(c, rng, starts)
    found = miss <= NEAR
    how = "right" if not found else "wrong" if says == "refuted" else "missed"
    return dict(seed=seed, how=how, says=says + " (%s)" % r["coupled"]["reason"], miss=miss, text=text,
                verify=verify(cli, text, problem, r, c, u) if found else "")


def main():
    p = argparse.ArgumentParser(description="small random scenes, check --coupled against a search of another kind")
    p.add_argument("--cli", default="build/stonepack")
    p.add_argument("--count", type=int, default=40)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--starts", type=int, default=30)
    p.add_argument("--jobs", type=int, default=1)
    p.add_argument("--keep", metavar="FOLDER", help="write scenes with missed triples there")
    p.add_argument("--verbose", action="store_true")
    o = p.parse_args()
    tally, least = {}, np.inf
    with multiprocessing.Pool(o.jobs) as pool:
        for t in pool.imap_unordered(trial, ((o.cli, s, o.starts) for s in range(o.seed, o.seed + o.count))):
            tally[(t["says"], t["how"])] = tally.get((t["says"], t["how"]), 0) + 1
            fault = t["how"] in ("wrong", "missed")
            if t["says"].startswith("refuted"):
                least = min(least, t["miss"])
            if fault or o.verbose:
                print("%-8s seed %d: %s, opponent's least miss %.2g %s"
                      % (t["how"], t["seed"], t["says"], t.get("miss", 0), t.get("verify", "")), flush=True)
            if fault and o.keep:
                with open(os.path.join(o.keep, "coupled-%d.obj" % t["seed"]), "w", encoding="utf-8") as out:
                    out.write(t["text"])
    for (says, how), n in sorted(tally.items()):
        print("%-30s %-8s %d" % (says, how, n))
    count = {how: sum(n for (_, h), n in tally.items() if h == how) for how in ("wrong", "missed")}
    print("%d scenes: %d wrong, %d missed; to what is refuted the opponent came no nearer than %.2g" % (o.count, *count.values(), least))
    return 1 if count["wrong"] or not tally else 0


if __name__ == "__main__":
    sys.exit(main())
