"""oracle: the limit load of a scene by linear programming, sharing nothing with the library but the scene file.

    gravity g + lambda h:   largest lambda with   Aeq f + p(g) + lambda p(h) = 0,  f in the cones

A scene file is read, masses and frames are computed, and the problem is handed to HiGHS (scipy). Pyramids are one programme;
the true cone is closed in between two of them, one of whose edges lie on it and one of whose faces touch it, refined where the
forces are. Joints with strength, whose cone is moved down by cohesion and ended by tension and crushing, are for the true cone
only. Every limit comes with its own error bound from the residuals of its primal and dual solution.

Needs numpy and scipy (Debian: python3-numpy, python3-scipy).
"""
import math
import sys

if sys.path and sys.path[0].endswith("oracle"):
    sys.path.append(sys.path.pop(0))                    # random.py beside us is not the library's

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix, csc_matrix, hstack, vstack

GRAVITY, MU, DENSITY = (0.0, 0.0, -9.80665), 0.84, 2400.0
FORCE_BOUND = 9e5                                       # the library's at its default tol


STRENGTH = ("cohesion", "tension", "crushing")


class Block:
    def __init__(self, name):
        self.name, self.fixed, self.density = name, False, None
        self.vertices, self.faces = [], []              # vertex numbers of the whole file


class Interface:
    def __init__(self, a, b, points):
        self.a, self.b, self.mu = a, b, None
        self.strength = {}                              # cohesion, tension, crushing [Pa]
        self.x = np.array(points, float).reshape(-1, 3)


class Scene:
    """A scene file with given interfaces: blocks, x, interfaces, mu, density, gravity, loads (name, force [N], point)."""

    def __init__(self, text):
        self.mu, self.density, self.gravity = MU, DENSITY, np.array(GRAVITY)
        self.blocks, self.interfaces, self.loads, x = [], [], [], []
        after = None                                    # what a following mu or density belongs to
        for line in text.splitlines():
            w = line.split()
            if not w:
                continue
            if w[0] == "v":
                x.append([float(t) for t in w[1:4]])
            elif w[0] == "o":
                after = Block(w[1])
                self.blocks.append(after)
            elif w[0] == "f":
                corners = [int(t.split("/")[0]) for t in w[1:]]
                self.blocks[-1].faces.append([c - 1 if c > 0 else len(x) + c for c in corners])
            elif w[0] == "#@" and w[1] == "gravity":
                self.gravity = np.array([float(t) for t in w[2:5]])
            elif w[0] == "#@" and w[1] == "fixed":
                self.blocks[-1].fixed = True
            elif w[0] == "#@" and w[1] == "interface":
                after = Interface(w[2], w[3], [float(t) for t in w[4:]])
                self.interfaces.append(after)
            elif w[0] == "#@" and w[1] in ("mu", "density"):
                owner = Interface if w[1] == "mu" else Block
                setattr(after if isinstance(after, owner) else self, w[1], float(w[2]))
            elif w[0] == "#@" and w[1] == "load" and len(w) == 9:
                self.loads.append((w[2], np.array(w[3:6], float), np.array(w[6:9], float)))
            elif w[0] == "#@" and w[1] in STRENGTH and isinstance(after, Interface):
                after.strength[w[1]] = float(w[2])
            elif w[0] == "#@":
                raise ValueError("not for the oracle: " + line)
        self.x = np.array(x)

    def text(self):
        """The scene as a file again; numbers round-trip."""
        out = ["#@ mu %r" % self.mu, "#@ density %r" % self.density, "#@ gravity %r %r %r" % tuple(map(float, self.gravity))]
        place, n = {}, 0
        for b in self.blocks:
            out.append("o " + b.name)
            if b.fixed:
                out.append("#@ fixed")
            if b.density is not None:
                out.append("#@ density %r" % b.density)
            for v in sorted({c for f in b.faces for c in f}):
                n += 1
                place[v] = n
                out.append("v %r %r %r" % tuple(map(float, self.x[v])))
            out += ["f " + " ".join(str(place[c]) for c in f) for f in b.faces]
        for i in self.interfaces:
            out.append("#@ interface %s %s " % (i.a, i.b) + " ".join(repr(float(t)) for t in i.x.ravel()))
            if i.mu is not None:
                out.append("#@ mu %r" % i.mu)
            out += ["#@ %s %r" % s for s in sorted(i.strength.items())]
        for name, force, point in self.loads:
            out.append("#@ load %s " % name + " ".join(repr(float(t)) for t in (*force, *point)))
        return "\n".join(out) + "\n"


def volume(x, faces):
    """Volume and centroid: pyramids from a corner of the block to triangles about each face's mean."""
    o = x[faces[0][0]]
    total, moment = 0.0, np.zeros(3)
    for f in faces:
        p = x[f] - o
        m = p.mean(axis=0)
        for k in range(len(f)):
            a, b = p[k], p[(k + 1) % len(f)]
            triples = [(m, a, b)] if len(f) > 3 else ([(p[0], p[1], p[2])] if k == 0 else [])
            for s, t, u in triples:
                v = float(np.dot(s, np.cross(t, u))) / 6
                total += v
                moment += v * (s + t + u) / 4
    return total, o + moment / total


def frame(x):
    """n, t1, t2 of a polygon: Newell's normal, the first true edge, and what makes them right-handed; its area."""
    p = x - x[0]
    n = sum(np.cross(p[k], p[(k + 1) % len(p)]) for k in range(len(p)))
    area = np.linalg.norm(n) / 2
    n = n / np.linalg.norm(n)
    edges = np.roll(x, -1, axis=0) - x
    lengths = np.linalg.norm(edges, axis=1)
    e = next(e for e, l in zip(edges, lengths) if l > 1e-9 * lengths.sum())
    t1 = e - np.dot(e, n) * n
    t1 /= np.linalg.norm(t1)
    return (n, t1, np.cross(n, t1)), area


class Problem:
    """Aeq, one block of three columns a vertex, rows scaled: forces in weights, moments in weights times size."""

    def __init__(self, scene):
        self.scene = scene
        free = [b for b in scene.blocks if not b.fixed]
        self.row = {b.name: k for k, b in enumerate(free)}
        mass, self.centre, self.size = [], [], []
        for b in free:
            v, c = volume(scene.x, b.faces)
            mass.append(v * (scene.density if b.density is None else b.density))
            self.centre.append(c)
            pts = scene.x[sorted({c for f in b.faces for c in f})]
            self.size.append(float(np.linalg.norm(pts.max(axis=0) - pts.min(axis=0))))
        self.mass = np.array(mass)
        self.unit = float(np.mean(self.mass)) if free else 1.0
        r, c, v, self.mu, self.least, self.place, caps, passed = [], [], [], [], [], [], [], 0
        for f in scene.interfaces:
            sides = [(self.row[s], sign) for s, sign in ((f.b, 1.0), (f.a, -1.0)) if s in self.row]
            passed += len(f.x)
            if not sides:
                continue
            axes, area = frame(f.x)
            stress = [f.strength.get(s, 0.0) for s in STRENGTH]
            for at, x in enumerate(f.x, passed - len(f.x)):
                k = len(self.mu)
                self.place.append(at)                   # of the vertex among all of the file
                self.mu.append(scene.mu if f.mu is None else f.mu)
                self.least.append(min(self.mass[i] for i, _ in sides) / self.unit)
                caps.append([(s or math.inf if q == 2 else s) * area / len(f.x) / self.unit for q, s in enumerate(stress)])
                for i, sign in sides:
                    for q, a in enumerate(axes):
                        m = np.cross(x - self.centre[i], a) / self.size[i]
                        r += range(6 * i, 6 * i + 6)
                        c += [3 * k + q] * 6
                        v += list(sign * np.concatenate([a, m]))
        self.mu, self.least = np.array(self.mu), np.array(self.least)
        self.A = csc_matrix(coo_matrix((v, (r, c)), shape=(6 * len(free), 3 * len(self.mu))))
        self.strong = any(f.strength for f in scene.interfaces)
        self.C, self.T, self.N = np.array(caps).reshape(-1, 3).T      # per vertex, in units for newtons
        self.T = np.where(self.mu > 0, np.minimum(self.T, self.C / np.maximum(self.mu, 1e-300)), self.T)

    def load(self, g, newton=0.0):
        """p for gravity g; a unit of force is the mean mass times the unit of g. Loads of the scene are there `newton` times:
        once for a g in m/s^2."""
        p = np.zeros((len(self.mass), 6))
        p[:, :3] = np.outer(self.mass / self.unit, g)
        for name, force, point in self.scene.loads:
            i = self.row[name]
            f = newton * force / self.unit
            p[i] += np.concatenate([f, np.cross(point - self.centre[i], f) / self.size[i]])
        return p.ravel()

    def walls(self, turns, newton, inner):
        """G, h of G f <= h: planes that touch each vertex's cone at its turns, or cut it off between two of them; and its ends."""
        r, c, v, h, n = [], [], [], [], 0
        for k, mu in enumerate(self.mu):
            C, T, N, t = newton * self.C[k], newton * self.T[k], newton * self.N[k], turns[k]
            halves = [0.5 * (b - a) for a, b in zip(t, t[1:] + [t[0] + 2 * math.pi])]
            planes = [(a + d, math.cos(d)) for a, d in zip(t, halves)] if inner else [(a, 1.0) for a in t]
            rows = [(-mu * w, math.cos(a), math.sin(a), C * w) for a, w in planes] + [(-1.0, 0.0, 0.0, T)]
            for x, y, z, most in rows + ([(1.0, 0.0, 0.0, N)] if N < math.inf else []):
                r += [n] * 3
                c += [3 * k, 3 * k + 1, 3 * k + 2]
                v += [x, y, z]
                h.append(most)
                n += 1
        return csc_matrix((v, (r, c)), shape=(n, 3 * len(self.mu))), np.array(h)

    def rays(self, edges):
        """Edges of each vertex's cone as columns (1, x, y); edges[k]: pairs (angle, friction)."""
        r, c, v, n = [], [], [], 0
        for k, mu in enumerate(self.mu):
            for a, w in (edges[k] if mu > 0 else [(0.0, 0.0)]):
                r += [3 * k, 3 * k + 1, 3 * k + 2]
                c += [n] * 3
                v += [1.0, w * math.cos(a), w * math.sin(a)]
                n += 1
        return csc_matrix((v, (r, c)), shape=(3 * len(self.mu), n))


class Limit:
    """value: largest lambda, between low and high; status: limit, unbounded, infeasible, trouble."""

    def __init__(self, status, value=math.nan, low=-math.inf, high=math.inf, f=None):
        self.status, self.value, self.low, self.high, self.f = status, value, low, high, f

    def error(self):
        return max(self.high - self.value, self.value - self.low)


def programme(problem, R, pg, ph):
    """max lambda, A R a + pg + lambda ph = 0, a >= 0, bounded from both sides by weak duality:
    lambda <= -y.pg + sum a max(0, -(A R)'y) for y.ph = 1, lambda >= value - |y.residual|."""
    G = problem.A @ R
    n = G.shape[1]
    M = hstack([G, csc_matrix(ph.reshape(-1, 1))]).tocsc()
    cost = np.zeros(n + 1)
    cost[n] = -1.0
    bounds = [(0, None)] * n + [(-1e3, 1e3)]
    tight = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
    s = linprog(cost, A_eq=M, b_eq=-pg, bounds=bounds, method="highs", options=tight)
    if s.status == 2:
        return Limit("infeasible")
    if s.status != 0:
        s = linprog(cost, A_eq=M, b_eq=-pg, bounds=bounds, method="highs-ds")
        if s.status == 2:
            return Limit("infeasible")
        if s.status != 0:
            return Limit("trouble")
    value = float(s.x[n])
    if value > 999.0:
        return Limit("unbounded")
    y = -np.asarray(s.eqlin.marginals)
    scale = float(np.dot(y, ph))
    if not abs(scale - 1) < 1e-3:
        return Limit("trouble")
    y = y / scale
    a = np.maximum(s.x[:n], 0)
    left = np.asarray(G @ a) + pg + value * ph
    slack = np.asarray(G.T @ y)
    high = -float(np.dot(y, pg)) + float(np.sum((a + 1.0) * np.maximum(0, -slack)))
    low = value - float(np.sum(np.abs(y * left)))
    return Limit("limit", value, min(low, value), max(high, value), np.asarray(R @ a))


def strong_programme(problem, walls, pg, ph):
    """max lambda, A f + pg + lambda ph = 0, G f <= h; bounded as above: with A'y + G'z = rest, z >= 0, y.ph = 1 it is at most
    z.h - y.pg + |rest|.|f|."""
    G, h = walls
    n = G.shape[1]
    M = hstack([problem.A, csc_matrix(ph.reshape(-1, 1))]).tocsc()
    cost = np.zeros(n + 1)
    cost[n] = -1.0
    tight = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
    for method, options in (("highs-ipm", tight), ("highs", tight), ("highs-ds", {}), ("highs-ipm", {})):
        s = linprog(cost, A_ub=hstack([G, csc_matrix((G.shape[0], 1))]).tocsc(), b_ub=h, A_eq=M, b_eq=-pg,
                    bounds=[(None, None)] * n + [(-1e3, 1e3)], method=method, options=options)
        if s.status in (0, 2):
            break
    if s.status != 0:
        return Limit("infeasible" if s.status == 2 else "trouble")
    value = float(s.x[n])
    if value > 999.0:
        return Limit("unbounded")
    y, z = -np.asarray(s.eqlin.marginals), np.maximum(-np.asarray(s.ineqlin.marginals), 0)
    scale = float(np.dot(y, ph))
    if not abs(scale - 1) < 1e-3:
        return Limit("trouble")
    y, z, f = y / scale, z / scale, s.x[:n]
    rest = np.asarray(problem.A.T @ y) + np.asarray(G.T @ z)
    high = float(np.dot(z, h) - np.dot(y, pg) + np.sum(np.abs(rest) * (np.abs(f) + 1.0)))
    left = np.asarray(problem.A @ f) + pg + value * ph
    low = value - float(np.sum(np.abs(y * left)) + np.sum(z * np.maximum(0, np.asarray(G @ f) - h)))
    return Limit("limit", value, min(low, value), max(high, value), f)


def corners(problem, cone):
    """The edges of a pyramid such as 8i or 4c, half a step off its faces' directions."""
    K, kind = int(cone[:-1]), cone[-1]
    turns = [2 * math.pi * (k + 0.5) / K for k in range(K)]
    stretch = 1.0 if kind == "i" else 1 / math.cos(math.pi / K)
    return problem.rays([[(a, mu * stretch) for a in turns] for mu in problem.mu])


def inside(problem, turns):
    """Edges on the true cone."""
    return problem.rays([[(a, mu) for a in t] for t, mu in zip(turns, problem.mu)])


def outside(problem, turns):
    """Edges where tangents at neighbouring turns meet: at friction mu / cos(half the angle between them)."""
    edges = []
    for t, mu in zip(turns, problem.mu):
        halves = [0.5 * (b - a) for a, b in zip(t, t[1:] + [t[0] + 2 * math.pi])]
        edges.append([(a + d, mu / math.cos(d)) for a, d in zip(t, halves)])
    return problem.rays(edges)


def bound(problem, turns, newton, pg, ph, inner):
    """The limit for pyramids inside of the true cones, or outside."""
    if problem.strong:
        return strong_programme(problem, problem.walls(turns, newton, inner), pg, ph)
    return programme(problem, (inside if inner else outside)(problem, turns), pg, ph)


def true_cone(problem, g, h, newton, gap=1e-7, rounds=40):
    """The limit for the true cone, closed in by pyramids inside and outside of it."""
    pg, ph = problem.load(g, newton), problem.load(h)
    turns = [[2 * math.pi * k / 16 for k in range(16)] for _ in problem.mu]
    best, before = None, math.inf
    for _ in range(rounds):
        outer = bound(problem, turns, newton, pg, ph, inner=False)
        if problem.strong and outer.status == "limit" and before - outer.high > gap:    # far from it: the inside can wait
            before = outer.high
            refine(problem, turns, (outer.f,), newton)
            continue
        inner = bound(problem, turns, newton, pg, ph, inner=True)
        if outer.status != "limit":
            return outer if inner.status == outer.status else Limit("trouble")
        if inner.status == "limit":
            best = Limit("limit", inner.value, inner.low, outer.high, inner.f)
            if outer.high - inner.low < gap:
                return best
        refine(problem, turns, (outer.f,) if inner.status != "limit" else (outer.f, inner.f), newton)
    return best or Limit("trouble")


def refine(problem, turns, forces, newton):
    """New edges and tangents where a force leans on its cone."""
    for f in forces:
        for k, mu in enumerate(problem.mu):
            fn, a, b = f[3 * k:3 * k + 3]
            most = mu * fn + newton * problem.C[k]
            if most <= 1e-9 * (mu or 1) or math.hypot(a, b) < 0.98 * most:
                continue
            new = math.atan2(b, a) % (2 * math.pi)
            if min(abs((new - t + math.pi) % (2 * math.pi) - math.pi) for t in turns[k]) > 1e-7:
                turns[k] = sorted(turns[k] + [new])


def within_bound(problem, f, share=0.1):
    """Do forces stay that far below the library's bound on them? Beyond it, falling is an honest answer."""
    size = np.linalg.norm(f.reshape(-1, 3), axis=1)
    return bool(np.all(size <= share * FORCE_BOUND * problem.least)) if len(size) else True


def least_imbalance(problem, cone, g):
    """min t: components of each block's imbalance <= t times its weight (and size): what no forces can do better than. For the
    true cone that of 64 faces around it."""
    p = problem.load(g, 1.0)
    if problem.strong:
        turns = [[2 * math.pi * k / 64 for k in range(64)] for _ in problem.mu]
        G, (walls, most), bounds = problem.A, problem.walls(turns, 1.0, False), (None, None)
    else:
        G, walls, most, bounds = problem.A @ corners(problem, "64c" if cone == "true" else cone), None, [], (0, None)
    w = csc_matrix(-np.repeat(problem.mass / problem.unit, 6).reshape(-1, 1) * float(np.linalg.norm(g)))
    A = vstack([hstack([G, w]), hstack([-G, w])] + ([hstack([walls, csc_matrix((len(most), 1))])] if problem.strong else []))
    cost = np.zeros(G.shape[1] + 1)
    cost[-1] = 1
    s = linprog(cost, A_ub=A, b_ub=np.concatenate([-p, p, most]), bounds=[bounds] * G.shape[1] + [(0, None)], method="highs")
    return float(s.x[-1]) if s.status == 0 else math.nan


def evidence(problem, cone, g, forces, tol=1e-9):
    """Our own judgement of the program's forces [N]: the largest imbalance of a block relative to load and forces, and the
    largest excess over the cone relative to fn."""
    f = np.array(forces, float)[problem.place] / problem.unit
    p = problem.load(g, 1.0).reshape(-1, 6)
    left = (problem.A @ f.ravel()).reshape(-1, 6) + p
    scale = np.zeros((len(p), 2))
    A = problem.A.tocsr()
    for i in range(len(p)):
        rows = A[6 * i:6 * i + 6].toarray().reshape(6, -1, 3)
        each = np.einsum("rvk,vk->vr", rows, f)
        scale[i, 0] = np.linalg.norm(p[i, :3]) + np.linalg.norm(each[:, :3], axis=1).sum()
        scale[i, 1] = np.linalg.norm(each[:, 3:], axis=1).sum() + 16 * 2.0 ** -53 / tol * scale[i, 0]
    omega = max(float(np.max(np.linalg.norm(left[:, :3], axis=1) / scale[:, 0])),
                float(np.max(np.linalg.norm(left[:, 3:], axis=1) / scale[:, 1]))) if len(p) else 0.0
    if cone == "true":
        most, mu = np.linalg.norm(f[:, 1:], axis=1), problem.mu
    else:
        K = int(cone[:-1])
        turns = 2 * math.pi * np.arange(K) / K
        most = np.max(np.outer(f[:, 1], np.cos(turns)) + np.outer(f[:, 2], np.sin(turns)), axis=1)
        mu = problem.mu * (math.cos(math.pi / K) if cone[-1] == "i" else 1.0)
    over = np.maximum(most - mu * f[:, 0] - problem.C, f[:, 0] - problem.N)
    excess = float(np.max(over / np.maximum(np.abs(f[:, 0]), 1e-9 * problem.least + problem.C))) if len(f) else 0.0
    return omega, excess, bool(len(f) == 0 or np.min(f[:, 0] + (1 + 1e-12) * problem.T) >= 0)


def limit(problem, cone, g, h, newton=0.0):
    """Largest lambda for `cone`: true, or Ki, Kc. newton: of a newton of load or strength, in the units of g."""
    if cone == "true":
        return true_cone(problem, g, h, newton)
    return programme(problem, corners(problem, cone), problem.load(g, newton), problem.load(h))
