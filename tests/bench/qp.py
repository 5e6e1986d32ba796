#!/usr/bin/env python3
"""qp: runs a folder of QPS files through `stonepack qp` and holds the objectives against published ones.

    qp.py FOLDER OPTIMA [options]           CSV on standard output, a summary on standard error

OPTIMA: lines `name,objective` (a header and comments are skipped). Options: --eps X (1e-4), --limit SECONDS (60),
--columns N (2000: files of more columns are left out), --program PATH (build/stonepack), -- OPTIONS for `stonepack qp`.

A solved problem is `right` if its objective is within 10 eps of the published one, relative to the larger of that, that without
the file's constant, and 1; else `wrong`. Files without a published objective are `unknown`. Standard library only; nothing of the collections is kept here.
"""
import argparse
import csv
import json
import os
import subprocess
import sys


def published(path):
    """Name in capitals -> objective."""
    optima = {}
    with open(path, encoding="utf-8") as f:
        for row in csv.reader(line for line in f if not line.startswith("#")):
            try:
                optima[row[0].strip().upper()] = float(row[1])
            except (IndexError, ValueError):
                continue
    return optima


def columns(path):
    """Columns of a QPS file, without solving it."""
    section, names, last = "", 0, None
    with open(path, encoding="latin-1") as f:
        for line in f:
            if line[:1].strip() and line[0] != "*":
                section = line.split()[0]
            elif section == "COLUMNS" and line.split() and "MARKER" not in line and line[0] != "*":
                name = line[4:12] if len(line) > 12 and line[4] != " " else line.split()[0]
                names += name != last
                last = name
    return names


def run(options, path):
    command = [options.program, "qp", "--json", "--eps", options.eps] + options.more + [path]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=options.limit, check=False)
    except subprocess.TimeoutExpired:
        return {"status": "time limit"}
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError:
        return {"status": "refused: " + done.stderr.strip()[:80]}


def judge(result, want, eps):
    if result["status"] != "solved":
        return result["status"], ""
    if want is None:
        return "unknown", ""
    error = abs(result["objective"] - want) / max(1.0, abs(want), abs(want - result.get("constant", 0.0)))
    return ("right" if error <= 10 * eps else "wrong"), "%.1e" % error


def main():
    parse = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parse.add_argument("folder")
    parse.add_argument("optima")
    parse.add_argument("--eps", default="1e-4")
    parse.add_argument("--limit", type=float, default=60)
    parse.add_argument("--columns", type=int, default=2000)
    parse.add_argument("--program", default="build/stonepack")
    parse.add_argument("--only", default="", help="names, separated by commas")
    parse.add_argument("more", nargs="*")
    options = parse.parse_args()
    optima, count, told = published(options.optima), {}, csv.writer(sys.stdout)
    only = options.only.upper().split(",") if options.only else None
    told.writerow(["name", "outcome", "error", "objective", "columns", "rows", "iterations", "factorisations", "seconds",
                   "polished"])
    for name in sorted(os.listdir(options.folder)):
        stem, path = name.rsplit(".", 1)[0].upper(), os.path.join(options.folder, name)
        if not name.lower().endswith(".qps") or (only and stem not in only) or columns(path) >= options.columns:
            continue
        result = run(options, path)
        outcome, error = judge(result, optima.get(stem), float(options.eps))
        objective = result.get("objective")
        told.writerow([stem, outcome, error, "" if objective is None else "%.9g" % objective]
                      + [result.get(key, "") for key in ("columns", "rows", "iterations", "factorisations")]
                      + ["%.3g" % result["seconds"] if "seconds" in result else "", result.get("polished", "")])
        sys.stdout.flush()
        count[outcome] = count.get(outcome, 0) + 1
    total = sum(count.values())
    print("%d files: %s" % (total, ", ".join("%d %s" % (n, what) for what, n in sorted(count.items(), key=lambda c: -c[1]))),
          file=sys.stderr)
    return 1 if count.get("wrong") else 0


sys.exit(main())
