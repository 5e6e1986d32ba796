"""coverage.py: the table of coverage.sh, from what llvm-cov exports."""
import collections, json, os, re, sys

functions = json.load(open(sys.argv[1]))['data'][0]['functions']
here = os.getcwd() + '/'
lines, branches, conditions = {}, {}, {}          # by place; a place covered in one instance is covered

for f in functions:
    files = [n.replace(here, '') for n in f['filenames']]
    counts = {}
    for l0, c0, l1, c1, count, file, _, kind in f['regions']:
        if kind != 0 or not files[file].startswith('solvers/'): continue
        for line in range(l0, l1 + 1): counts.setdefault((files[file], line), []).append(((l0, c0), count))
    for place, inside in counts.items():          # the innermost region decides
        lines[place] = lines.get(place, False) or max(inside)[1] > 0
    for l0, c0, l1, c1, yes, no, file, _, kind in f['branches']:
        for which, count in ((0, yes), (1, no)):
            place = (files[file], l0, c0, l1, c1, which)
            if files[file].startswith('solvers/'): branches[place] = branches.get(place, False) or count > 0
    for record in f['mcdc_records']:
        l0, c0, l1, c1, file = record[:5]
        if not files[file].startswith('solvers/'): continue
        for k, shown in enumerate(record[-1]):
            place = (files[file], l0, c0, l1, c1, k)
            conditions[place] = conditions.get(place, False) or bool(shown)

of = os.environ['OF']
texts = {}


def text_of(place):
    """The expression that a condition is of, on one line."""
    file, l0, c0, l1, c1, _ = place
    if file not in texts: texts[file] = open(file).read().split('\n')
    text = texts[file]
    inside = text[l0 - 1][c0 - 1:c1 - 1] if l0 == l1 else ' '.join([text[l0 - 1][c0 - 1:]] + text[l0:l1 - 1] + [text[l1 - 1][:c1 - 1]])
    return re.sub(r'\s+', ' ', inside)


# What the build decides has one value in it; what is joined by && to what is false in it, by || to what is true, is not asked.
FIXED = r'SP__(HAS|WITH)_|SP__(FELL|IPM)_LAST|sizeof\(sp_real\)'
NEVER = r'\(*(!SP__WITH_(?!SMALL)|SP__WITH_SMALL|!SP__FELL_LAST)'
ALWAYS = r'\(*SP__FELL_LAST'


def decided(place):
    parts = [p.strip() for p in re.split(r'(&&|\|\|)', text_of(place))]
    k = 2 * place[5]
    if re.search(FIXED, parts[k]): return True
    while k >= 2 and not parts[k].startswith('('):
        k -= 2
        if re.match(NEVER if parts[k + 1] == '&&' else ALWAYS, parts[k]): return True
        if parts[k + 1] == '||': return False
    return False


conditions = {p: v for p, v in conditions.items() if not decided(p)}


def folder(place): return os.path.dirname(place[0]).replace('solvers/', '')


def score(places, name):
    mine = [v for p, v in places.items() if name in ('all', folder(p))]
    return '%d/%d' % (sum(mine), len(mine)), 100 * sum(mine) / len(mine) if mine else 100


names = sorted({folder(p) for p in lines}) if not of else [of]
print('%-12s %16s %18s %18s' % ('', 'lines', 'branch outcomes', 'MC/DC'))
for name in names + ['all'] * (not of):
    told = [score(places, name) for places in (lines, branches, conditions)]
    print('%-12s' % name + ''.join('%13s %5.1f' % t for t in told))
left = [p for p, shown in sorted(conditions.items()) if not shown and of in ('', folder(p))]


def key_of(place):
    """How left.txt names a condition: by its file and its text, for lines move."""
    part = re.split(r'&&|\|\|', text_of(place))[place[5]].strip()
    while part.count('(') > part.count(')') and part.startswith('('): part = part[1:]
    while part.count(')') > part.count('(') and part.endswith(')'): part = part[:-1]
    return place[0].replace('solvers/', ''), part + ' of ' + text_of(place)


def argued():
    """{what left.txt names: how often}, of the folder asked."""
    found = collections.Counter()
    for line in open(os.path.dirname(__file__) + '/left.txt'):
        if line.startswith('#') or not line.strip(): continue
        file, text, why = line.rstrip('\n').split(' :: ')
        assert why.strip(), line
        if of in ('', os.path.dirname(file)): found[file, text] += 1
    return found


fresh = collections.Counter()
if os.environ['LEFT'] == 'compare':
    listed, found = argued(), collections.Counter(key_of(p) for p in left)
    fresh = found - listed
    for key in sorted((listed - found).elements()): print('no longer left: %s :: %s' % key)
    for key in sorted(fresh.elements()): print('not in left.txt: %s :: %s' % key)
elif os.environ['LEFT']:
    for place in left: print('%s:%d: condition %d of  %s' % (*place[:2], place[5] + 1, text_of(place)))
last = score(conditions, of or 'all')[1]
print('%.1f %% of the conditions of %s' % (last, 'solvers/' + of))
sys.exit(last < float(os.environ['LEAST']) or bool(fresh))
