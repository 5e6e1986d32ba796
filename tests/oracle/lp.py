"""lp: solvers/linear/lp.c against HiGHS on random linear programmes, feasible or not, many of them degenerate.

    lp.py [COUNT]       1000 programmes by default; builds tests/oracle/lp.c with $CC or cc

Every answer is judged on its own besides: a point by its violations, a proof by the sum of its rows. Exit status 1 if any is
wrong.
Needs numpy and scipy (Debian: python3-numpy, python3-scipy).
"""
import os
import sys

here = os.path.dirname(os.path.abspath(__file__))
sys.path = [p for p in sys.path if os.path.abspath(p or ".") != here]       # random.py beside us is not the library's

import subprocess
import tempfile

import numpy as np
from scipy.optimize import linprog


def programme(rng):
    """Bounds around a point, many of them tight; half of the programmes then get some bounds moved away from it."""
    n = int(rng.integers(2, 40))
    m = int(rng.integers(1, 4 * n))
    whole = rng.random() < 0.5
    A = rng.integers(-3, 4, (m, n)).astype(float) if whole else rng.normal(size=(m, n))
    A *= rng.random((m, n)) < 0.5
    x = rng.integers(-2, 3, n).astype(float)
    v = np.concatenate([A @ x, x])
    low = v - rng.choice([0, 0, 1, 5, 1e30], m + n)
    high = v + rng.choice([0, 1, 5, 1e30, 1e30], m + n)
    if rng.random() < 0.5:
        for i in rng.integers(0, m, rng.integers(1, 4)):
            shift = rng.choice([-1, 1]) * rng.choice([0.01, 1, 3, 6])
            low[i] += shift
            high[i] += shift
    return A, low, high


def wrong(A, low, high, status, y):
    """What is wrong with an answer, None if nothing is."""
    B = np.vstack([A, np.eye(A.shape[1])])
    if status == 0:
        out = max(np.max(low - B @ y), np.max(B @ y - high))
        return "point out by %g" % out if out > 1e-8 else None
    b = np.where(y > 0, high, low)
    if np.any((np.abs(y) > 1e-12) & (np.abs(b) > 1e29)):
        return "a bound that is none"
    right = float(np.sum(np.where(np.abs(y) > 1e-12, y * b, 0)))
    left = float(np.sum(np.abs(np.where(np.abs(y) > 1e-12, y, 0) @ B)))
    return "proves nothing: %g, %g" % (right, left) if right + 100 * left >= 0 else None


def main():
    rng = np.random.default_rng(1)
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    programmes = [programme(rng) for _ in range(count)]
    with tempfile.TemporaryDirectory() as tmp:
        program = os.path.join(tmp, "lp")
        subprocess.run([os.environ.get("CC", "cc"), "-O2", "-std=c99", "-ffp-contract=off", "-Wno-unused-function",
                        os.path.join(here, "lp.c"), "-lm", "-o", program], check=True)
        text = "".join("%d %d\n%s\n%s\n" % (A.shape[1], A.shape[0], " ".join(map(repr, A.ravel().tolist())),
                       " ".join("%r %r" % p for p in zip(low.tolist(), high.tolist()))) for A, low, high in programmes)
        lines = subprocess.run([program], input=text, capture_output=True, text=True, check=True).stdout.splitlines()
    bad, empty = 0, 0
    for k, ((A, low, high), line) in enumerate(zip(programmes, lines, strict=True)):
        w = line.split()
        status, y = int(w[0]), np.array(w[2:], float)
        m = len(A)
        b = np.clip(np.concatenate([high[:m], -low[:m]]), -1e20, 1e20)
        ref = linprog(np.zeros(A.shape[1]), A_ub=np.vstack([A, -A]), b_ub=b,
                      bounds=[(None if l < -1e29 else l, None if h > 1e29 else h) for l, h in zip(low[m:], high[m:])],
                      method="highs")
        said = "gave up" if status > 1 else wrong(A, low, high, status, y)
        if not said and ref.status != (2 if status else 0):
            said = "HiGHS says %d" % ref.status
        if said:
            print("programme %d, status %d: %s" % (k, status, said))
            bad += 1
        empty += status == 1
    print("%d programmes, %d of them empty, %d wrong" % (count, empty, bad))
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
