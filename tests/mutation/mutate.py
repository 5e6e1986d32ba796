#!/usr/bin/env python3
"""mutate: does a test notice when one place of the library is wrong?

    python3 -B tests/mutation/mutate.py [--of proof|verify|limit|small|core|PATH...] [--sample N [--after N]] [--seed N] [--jobs N]
                                        [--guided] [--longest MS] [--hashes] [--line FILE:N] [--list] [--table FILE]
                                        [--least PERCENT] [--kept FILE [--minutes M]] [--constants [--float]]

Each mutant is the library with one place changed: a relation, an arithmetic sign, a number, a condition negated, a statement left out.
It is compiled whole by tcc, else by CC at -O0, linked with the suites, which are compiled once (white-box suites that include the
changed file anew), and run until a test fails, quick tests first. Tests have SLACK times the processor time they take of the
unchanged library, so what no longer ends is noticed too; those that take longer than SLOW are not asked [--longest]. What no test
noticed meets its white-box suites once more, with sanitizers and a fence behind every piece of memory. `survived` are those that
no test noticed. What changes nothing that anyone could see is listed in equivalents.txt, one line of argument each, and left out.

    --after     of a sample, the first N were asked before
    --guided    a suite is asked only where it reaches the changed line, by gcov; it takes minutes to find out which do, and is for
                large samples of the core
    --longest   tests of up to so many milliseconds are asked (250, of the core 50); with more of them and --again the survivors of
                a first run meet the slower ones, too
    --hashes    a second score: survivors that the stored hashes of tests/corpus notice
    --kept      what was killed, a line each, is read from it and written to it: a run goes in pieces that add up; survivors are
                written, too, and asked again by --again alone (killed stays killed while tests are only added)
    --minutes   no new mutant is begun after so many
    --table     adds a row for each folder to a CSV: what, mutants, killed, equivalent, invalid
    --least     exit status 1 where fewer per cent are killed
    --constants instead of all these, numbers that have a name or no whole value, each made larger and smaller: those of #define, enum
                and static tables, and in functions decimals and multiples of SP_EPSILON. A whole number by 1; one with an exponent,
                or a multiple of SP_EPSILON, four times and a quarter; any other decimal by a tenth
    --float     the build with SP_REAL_FLOAT, which has constants of its own
"""
import argparse, fcntl, hashlib, json, os, re, resource, shutil, subprocess, sys, time
from concurrent.futures import ThreadPoolExecutor

HERE = 'tests/mutation/'
SLACK = 20
QUICK, SLOW = 50, 250          # [ms]
SETS = {
    'proof': ['solvers/proof/*.c'],
    'verify': ['solvers/check/verify.c', 'solvers/strong/strong.c'],
    'limit': ['solvers/limit/*.c'],
    'small': ['solvers/small/*.c', 'solvers/*/small_*.c'],     # in the build with SP_SMALL
    'core': ['solvers/*/*.c'],
}
# Suites by what is changed, quick ones first.
JUDGES = ['moving', 'scale', 'search', 'forces', 'spin', 'leaf', 'corner', 'refute', 'still', 'shear', 'triple', 'verify', 'claims',
          'strong', 'shapes', 'spared', 'attack', 'exact', 'coupled', 'strength', 'closed', 'sliding']
INSIDE = ['moving', 'scale', 'search', 'forces', 'spin', 'leaf', 'corner', 'refute', 'still', 'shear', 'triple', 'sliding',
          'coupled']                                    # of proof in float, where some of the others take minutes
VERIFIES = ['hint', 'verify', 'islands', 'claims', 'arguments', 'exact', 'memory', 'capacity', 'holds',
            'strong']                                       # of verify alone
LIMITS = ['asked', 'ask', 'ends', 'start', 'embed', 'climb', 'moves', 'count', 'limit', 'arguments', 'bracket', 'spent', 'effort',
          'sliding']                                        # of limit alone
FIRST = ('tally', 'count', 'drawn')      # they count work, which hardly any change leaves as it was
NOT_CORE = ('host', 'settle', 'small')          # of the core all other suites are asked, their quick tests
# What a survivor is asked by once more, fenced.
WHITE = ['scale', 'search', 'forces', 'spin', 'leaf', 'still', 'shear', 'corner', 'moving', 'fence', 'holds']
FLAGS = ['-std=c99', '-ffp-contract=off', '-fno-math-errno']
FENCED = shutil.which('clang-19') or 'gcc'      # with sanitizers clang takes a third of gcc's time


def run(command, **more):
    return subprocess.run(command, capture_output=True, text=True, errors='replace', **more)


def blank_comments(text):
    """The text with comments, strings and preprocessor lines blanked, columns kept."""
    hide = lambda m: re.sub(r'[^\n]', ' ', m.group(0))
    text = re.sub(r'/\*.*?\*/|"(?:\\.|[^"\\])*"', hide, text, flags=re.S)
    return re.sub(r'(?m)^[ \t]*#.*(?:\\\n.*)*', hide, text)


def compiled_lines(path):
    """Numbers of the lines that the preprocessor keeps in the build at hand, its #define too."""
    keep, file, number = set(), '', 0
    for line in run(['gcc', '-E', '-dD', *FLAGS, 'stonepack.c']).stdout.split('\n'):
        mark = re.match(r'# (\d+) "([^"]*)"', line)
        if mark:
            number, file = int(mark.group(1)), os.path.normpath(mark.group(2))
            continue
        if file == path and line.strip(): keep.add(number)
        number += 1
    return keep


RELATION = {'<': ['<=', '>='], '<=': ['<', '>'], '>': ['>=', '<='], '>=': ['>', '<'], '==': ['!='], '!=': ['==']}
SWAP = {'+': '-', '-': '+', '*': '/', '/': '*', '&&': '||', '||': '&&'}


def changes(code):
    """(kind, from, to, new text) of every change of one line without comments."""
    for m in re.finditer(r'(?<=[ ])(<=|>=|==|!=|<|>)(?=[ ])', code):
        for new in RELATION[m.group(1)]: yield 'relation', m.start(1), m.end(1), new
    for m in re.finditer(r'(?<=[ ])([+\-*/])(?=[ ])', code): yield 'arithmetic', m.start(1), m.end(1), SWAP[m.group(1)]
    for m in re.finditer(r'(?<=[ ])(&&|\|\|)(?=[ ])', code): yield 'logic', m.start(1), m.end(1), SWAP[m.group(1)]
    for m in re.finditer(r'([+\-*/])=', code): yield 'arithmetic', m.start(1), m.end(1), SWAP[m.group(1)]
    for m in re.finditer(r'(?<=[=(?:,] )-(?=[\w(])|(?<=return )-(?=[\w(])|(?<=\()-(?=[a-z(])', code):
        yield 'arithmetic', m.start(), m.end(), ''
    for m in re.finditer(r'(?<![\w.])(\d+)(?![\w.])', code):
        if re.search(r'return $', code[:m.start()]) and m.group(1) in '01' and code[m.end()] == ';':
            yield 'number', m.start(), m.end(), '10'[int(m.group(1))]
            continue
        if re.match(r'\s*(static )?(const )?(sp_real|int32_t|int|size_t) (\w+(\[\w+\])*, )*\w+\[$', code[:m.start()]): continue
        if re.match(r'\](\[\w+\])*[,;]', code[m.end():]) and '=' not in code and '(' not in code: continue
        yield 'number', m.start(), m.end(), str(int(m.group(1)) + 1)
    m = re.match(r'\s*(?:\} )?(?:else )?if \(', code)
    if m:
        depth, end = 1, m.end()
        while end < len(code) and depth:
            depth += {'(': 1, ')': -1}.get(code[end], 0)
            end += 1
        if not depth: yield 'condition', m.end(), end - 1, '!(' + code[m.end():end - 1] + ')'
    m = re.match(r'\s*((?:\*?[a-z_][\w\->.\[\] +*()]*? [+\-*/|&]?= |[a-z_]\w*\().*;|[\w\->.\[\]]+(?:\+\+|--);|continue;|break;)\s*$', code)
    if m and not re.match(r'(const|return|sp_\w+ \w|int32_t|size_t|int|for|if|while) ?', m.group(1)) and \
            code.count('(') == code.count(')') and '{' not in code:
        yield 'statement', m.start(1), m.end(1), ';'


NUMBER = re.compile(r'(?<![\w.])(?:(?P<decimal>\d+\.\d*(?:[eE][-+]?\d+)?|\.?\d+[eE][-+]?\d+)f?|(?P<whole>\d+))(?![\w.])')


def other_numbers(code, begin, only_decimals):
    """(kind, from, to, new text) of a larger and a smaller number for each from column `begin` on."""
    for m in NUMBER.finditer(code, begin):
        of_rounding = re.match(r' \* (\(sp_real\))?SP_EPSILON', code[m.end():])
        if m.group('whole') and only_decimals and not of_rounding: continue
        name, x = ('decimal', float(m.group('decimal'))) if m.group('decimal') else ('whole', int(m.group('whole')))
        if of_rounding or 'e' in m.group(0).lower(): new = 4 * x, x / 4
        else: new = (x + 1, x - 1) if name == 'whole' else (1.1 * x, 0.9 * x)
        for y in new: yield 'constant', m.start(name), m.end(name), '%.17g' % y if name == 'decimal' and len(m.group(0)) > 12 else '%.12g' % y


def constants(text):
    """(line number, kind, from, to, new text) of every constant in another size."""
    where = ''                                                  # in an enum or a static table outside functions
    plain = re.sub(r'/\*.*?\*/|"(?:\\.|[^"\\])*"', lambda m: re.sub(r'[^\n]', ' ', m.group(0)), text, flags=re.S)
    for number, code in enumerate(plain.split('\n'), 1):
        name = re.match(r'[ \t]*#[ \t]*define[ \t]+\w+[ \t]', code)
        opens = re.match(r'enum\b[^{;]*\{|static const [^=;(]*= ', code)
        if opens: where = 'table'
        if name: found = other_numbers(code, name.end(), False)
        elif where: found = other_numbers(code, opens.end() if opens else 0, False)
        elif code.startswith(' '): found = other_numbers(code, 0, True)
        else: found = ()
        if re.search(r';\s*$', code): where = ''
        for change in found: yield (number, *change)


def mutants_of(path):
    """(file, line number, kind, old line, new line)"""
    with open(path) as f: text = f.read()
    keep, lines, found = compiled_lines(path), text.split('\n'), []

    def add(number, kind, a, b, new):
        old = lines[number - 1]
        found.append((path, number, kind, old, old[:a] + new + old[b:]))
    for number, code in enumerate(blank_comments(text).split('\n'), 1):
        if number not in keep or not code.startswith(' '): continue         # bodies of functions only
        for change in changes(code): add(number, *change)
    for number, *change in constants(text):
        if number in keep: add(number, *change)
    return found


def sample(mutants, n, seed):
    """n of them, by hashes of what they are: a line that is changed, or a mutant that is listed as equivalent, leaves the others."""
    name = lambda m: hashlib.sha256(('%d %s %s' % (seed, m[0], m[4].strip())).encode()).digest()
    return sorted(mutants, key=name)[:n]


def equivalents():
    """{(file, mutated line without its margins)} that change nothing anyone could see; `in double: ` before why: there alone."""
    listed = set()
    for line in open(HERE + 'equivalents.txt'):
        if line.startswith('#') or not line.strip(): continue
        file, text, why = line.rstrip('\n').split(' :: ')
        assert why.strip(), line
        if why.startswith(('in double: ', 'in float: ')) and why.startswith('in float: ') != ('-DSP_REAL_FLOAT' in FLAGS): continue
        listed.add(('solvers/' + file, text.strip()))
    return listed


class Kept:
    """What earlier pieces of a run said: {(file, line number, mutated line): (status, by)}, in a file of a line each."""
    def __init__(self, path):
        self.path, self.known = path, {}
        if path and os.path.exists(path):
            for line in open(path):
                file, number, status, by, text = line.rstrip('\n').split('\t')
                self.known[file, int(number), text] = status, by

    def key(self, mutant): return mutant[0], mutant[1], mutant[4].strip()

    def said(self, mutant, again):
        was = self.known.get(self.key(mutant))
        return None if was and again and was[0] == 'survived' else was

    def add(self, mutant, status, by):
        if self.path:
            with open(self.path, 'a') as f: f.write('%s\t%d\t%s\t%s\t%s\n' % (*self.key(mutant)[:2], status, by, self.key(mutant)[2]))


class Suites:
    """Suites, compiled once, and two runners over them: quick tests, then the others that take no more than SLOW."""
    def __init__(self, names, work, compiler, longest, slow=SLOW):
        """longest: tests of up to so many ms are asked, no slower ones; 0: quick ones, then those of up to `slow`."""
        self.work, self.compiler, self.longest, self.slow, self.parts, self.objects = work, compiler, longest, slow, {}, {}
        self.reach, self.took, self.sound = None, {}, set()
        os.makedirs(work, exist_ok=True)
        where = {re.sub(r'.*/test_(\w+)\.c', r'\1', p): p for p in glob('tests/*/test_*.c')}
        self.names = [n for n in names if n in where]
        self.where = where
        sources = [where[n] for n in self.names] + ['tests/scenes/gen.c']
        with ThreadPoolExecutor(os.cpu_count()) as pool: list(pool.map(self.compile_once, sources))
        self.runners = [self.runner('all', [])]

    def compile_once(self, source):
        self.objects[source] = self.gcc(source, source.replace('/', '_'), [])
        self.parts[source] = includes(source)

    def gcc(self, source, name, more):
        o = os.path.join(self.work, name + '.o')
        done = run(['gcc', *FLAGS, '-O0', '-w', *more, '-c', source, '-o', o])
        assert done.returncode == 0, done.stderr
        return o

    def runner(self, name, left_out):
        """run.c for all tests but these."""
        with open(os.path.join(self.work, name + '.h'), 'w') as f: f.writelines('"%s",\n' % t for t in left_out)
        return self.gcc('tests/run.c', name, ['-DTEST_SUITES=' + ' '.join('X(%s)' % n for n in self.names), '-DTEST_FIRST=1',
                                              '-DTEST_LEAVE_OUT="%s"' % os.path.abspath(os.path.join(self.work, name + '.h'))])

    def fence(self, name):
        """run.c for one suite, with sanitizers."""
        o = os.path.abspath(os.path.join(self.work, 'fenced_' + name + '.o'))
        if not os.path.exists(o):
            done = run([FENCED, *FLAGS, '-w', '-fsanitize=address', '-DTEST_SUITES=X(%s)' % name, '-c', 'tests/run.c', '-o', o])
            assert done.returncode == 0, done.stderr
        return o

    def split(self, program):
        """Times of the unchanged library; runners of quick tests and of slow ones."""
        told = run([program, '-m']).stdout
        assert told.rstrip().endswith(' 0 failed'), 'the unchanged library fails: ' + told
        took = [(l.split()[0], int(l.split()[2])) for l in told.split('\n') if len(l.split()) == 3]
        most = self.longest or QUICK
        first = {n: sum(ms for t, ms in took if t.startswith(n + '/') and ms <= most) for n in self.names}
        self.names.sort(key=lambda n: (n not in FIRST, first[n]))
        quick = [t for t, ms in took if ms <= most]
        self.took = {n: first[n] / 1000 for n in self.names if any(t.startswith(n + '/') for t in quick)}
        slow = [t for t, ms in took if most < ms <= self.slow and not self.longest]
        parts = [(name, which) for name, which in (('quick', quick), ('slow', slow)) if which]
        self.runners = [self.runner(name, [t for t, ms in took if t not in which]) for name, which in parts]
        self.seconds = [sum(ms for t, ms in took if t in which) / 1000 for _, which in parts]
        return len(quick), len(slow), len(took)


    def guide(self, jobs):
        """Which lines of the unchanged library each suite's quick tests reach, by gcov."""
        at = os.path.abspath(self.work)
        library = self.gcc('stonepack.c', 'cover', ['--coverage'])
        self.reach = {}

        def reached(name):
            here = os.path.join(at, 'of_' + name)
            shutil.rmtree(here, ignore_errors=True)
            os.makedirs(here)
            suite = self.gcc(self.where[name], 'cover_' + name, ['--coverage'])
            runner = self.gcc('tests/run.c', 'run_' + name, ['-DTEST_SUITES=X(%s)' % name,
                                                             '-DTEST_LEAVE_OUT="%s"' % os.path.join(at, 'quick.h')])
            program = os.path.join(here, 'run')
            done = run(['gcc', '--coverage', suite, runner, library, self.objects['tests/scenes/gen.c'], '-lm', '-o', program])
            assert done.returncode == 0, done.stderr
            run([program], env=dict(os.environ, GCOV_PREFIX=here, GCOV_PREFIX_STRIP='99'))
            for notes in ('cover', 'cover_' + name): shutil.copy(os.path.join(at, notes + '.gcno'), here)
            told = run(['gcov', '--json-format', '--stdout', 'cover.gcda', 'cover_%s.gcda' % name], cwd=here).stdout
            shutil.rmtree(here)
            return name, [f for line in told.splitlines() if line.startswith('{') for f in json.loads(line)['files']]

        with ThreadPoolExecutor(jobs) as pool:
            for name, files in pool.map(reached, self.took):
                for file in files:
                    lines = self.reach.setdefault(os.path.normpath(file['file']), {})
                    for l in file['lines']: lines.setdefault(l['line_number'], set()).update([name] if l['count'] else [])

    def reaching(self, path, number):
        """Suites that reach a line, or the last one before it that was counted: quick ones, then those that count, then all others."""
        lines = self.reach[path]
        counted = max((l for l in lines if l <= number), default=min(lines))
        return sorted(lines[counted], key=lambda n: (self.took[n] > 0.06 and n not in FIRST, self.took[n] > 0.06, self.took[n]))


def glob(pattern):
    import glob as g
    return sorted(g.glob(pattern))


def includes(source, seen=None):
    """All files of solvers/ that a file includes."""
    seen = set() if seen is None else seen
    for name in re.findall(r'(?m)^#include "([^"]+)"', open(source).read()):
        path = os.path.normpath(os.path.join(os.path.dirname(source), name))
        if path in seen or not os.path.exists(path): continue
        seen.add(path)
        includes(path, seen)
    return seen


class Room:
    """A copy of the tree, in which one mutant at a time is built."""
    def __init__(self, number, suites):
        self.suites, self.at = suites, 'build/mutation/room%d' % number
        shutil.rmtree(self.at, ignore_errors=True)
        os.makedirs(self.at)
        for part in ('stonepack.c', 'stonepack.h', 'solvers', 'tests'):
            if os.path.isdir(part):
                keep = shutil.ignore_patterns('figures', 'results', 'examples', '*.svg', '*.csv')
                shutil.copytree(part, os.path.join(self.at, part), ignore=keep)
            else: shutil.copy(part, self.at)

    def compile(self, source, object):
        cc = self.suites.compiler
        return run(cc + ['-std=c99', '-w', '-c', source, '-o', object], cwd=self.at).returncode == 0

    def build(self, changed):
        """The runners of the tree as it is now; None where it does not compile."""
        if not self.compile('stonepack.c', 'library.o'): return None
        objects = []
        for source, object in self.suites.objects.items():
            if changed in self.suites.parts[source]:
                object = os.path.join(self.at, os.path.basename(source)[:-2] + '.o')
                if not self.compile(source, os.path.basename(object)): return None
            objects.append(object)
        return [lambda k=k, r=r: self.link('run%d' % k, [r] + objects) for k, r in enumerate(self.suites.runners)]

    def link(self, name, objects):
        out = os.path.join(self.at, name)
        of_tcc = glob('/usr/lib/*/tcc/libtcc1.a') if self.suites.compiler[0] == 'tcc' else []
        done = run(['gcc', *objects, self.at + '/library.o', *of_tcc, '-lm', '-z', 'noexecstack', '-o', out])
        assert done.returncode == 0, done.stderr
        return out

    def noticed(self, command, seconds):
        """The test that noticed, of a runner that takes so many seconds of the unchanged library; or None."""
        most = int(SLACK * seconds + 2)
        limit = lambda: (resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1)),
                         resource.setrlimit(resource.RLIMIT_CORE, (0, 0)))
        try: done = run(command, preexec_fn=limit, timeout=20 * most)
        except subprocess.TimeoutExpired: return 'time'
        return (re.findall('FAILED (\\S+)', done.stdout) or ['crash or time'])[0] if done.returncode else None

    def ask(self, runners):
        """The test that noticed, or None."""
        for link, seconds in zip(runners, self.suites.seconds):
            by = self.noticed([link()], seconds)
            if by: return by
        return None

    def ask_guided(self, path, number):
        """The same, of suites that reach the line alone; those that include the file are compiled anew, one by one."""
        program = None
        for name in self.suites.reaching(path, number):
            source = self.suites.where[name]
            if path in self.suites.parts[source]:
                assert self.compile(source, 'white.o'), source     # as the library did
                runner = os.path.join(self.suites.work, 'run_%s.o' % name)
                asked = self.link('white', [runner, self.at + '/white.o', self.suites.objects['tests/scenes/gen.c']])
            else:
                program = program or self.link('run0', [self.suites.runners[0], *self.suites.objects.values()])
                asked = program
            by = self.noticed([asked, name + '/'], self.suites.took[name])
            if by: return by
        return None

    def fenced(self, changed):
        """White-box suites that include one of these files, with sanitizers and a fence behind every piece of memory: what is
        read beyond an array."""
        name = lambda source: re.sub(r'.*/test_(\w+)\.c', r'\1', source)
        white = [s for s in self.suites.objects if self.suites.parts[s].intersection(changed) and name(s) in WHITE]
        flags = [*FLAGS, '-O0', '-w', '-g0', '-fsanitize=address,undefined', '-fno-sanitize-recover=all', '-DSP_API=static', '-include',
                 'tests/base/fence.h', '-DTEST_FIRST=1']
        for source in white:
            done = run([FENCED, *flags, '-DTEST_SUITES=X(%s)' % name(source), '-c', source, '-o', 'fenced.o'], cwd=self.at)
            linked = run([FENCED, '-fsanitize=address,undefined', 'fenced.o', self.suites.fence(name(source)), 'library.o',
                          os.path.abspath(self.suites.objects['tests/scenes/gen.c']), '-lm', '-z', 'noexecstack', '-o', 'fenced'],
                         cwd=self.at)
            assert not done.returncode and not linked.returncode, done.stderr + linked.stderr
            limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (60, 61))
            if run(['./fenced'], cwd=self.at, preexec_fn=limit).returncode: return name(source) + ', fenced'
        return None

    def hashes(self):
        """Do the stored hashes notice?"""
        out = os.path.join(self.at, 'hashes')
        done = run(['gcc', *FLAGS, '-O1', '-w', '-Ibuild', 'tests/corpus/hashes.c', 'tests/scenes/gen.c', self.at + '/library.o',
                    '-lm', '-z', 'noexecstack', '-o', out])
        if done.returncode: return True
        limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (120, 121))
        done = run([out], preexec_fn=limit)
        kind = 'float ' if '-DSP_REAL_FLOAT' in FLAGS else 'double '
        stored = [l[len(kind):] for l in open('tests/corpus/hashes.txt').read().split('\n') if l.startswith(kind)]
        return done.returncode != 0 or done.stdout.split('\n')[:-1] != stored

    def sound(self, path):
        """What is fenced notices nothing by failing always: asked of the unchanged library where it notices first."""
        if path in self.suites.sound: return
        assert self.compile('stonepack.c', 'library.o')
        noticed = self.fenced([path])
        assert not noticed, 'the unchanged library fails: ' + noticed
        self.suites.sound.add(path)

    def judge(self, mutant, ask_hashes):
        """(invalid, killed, survived; by which suite)"""
        status, by = self.judged(mutant, ask_hashes)
        if by.endswith(', fenced'): self.sound(mutant[0])
        return status, by

    def judged(self, mutant, ask_hashes):
        path, number, kind, old, new = mutant
        there = os.path.join(self.at, path)
        with open(there) as f: text = f.read()
        lines = text.split('\n')
        assert lines[number - 1] == old
        lines[number - 1] = new
        with open(there, 'w') as f: f.write('\n'.join(lines))
        try:
            runners = self.compile('stonepack.c', 'library.o') if self.suites.reach else self.build(path)
            if not runners: return 'invalid', ''
            by = self.ask_guided(path, number) if self.suites.reach else self.ask(runners)
            by = by or self.fenced([path])
            if by: return 'killed', by
            return 'survived', 'hashes' if ask_hashes and self.hashes() else ''
        finally:
            with open(there, 'w') as f: f.write(text)


def alone():
    """One run at a time has build/mutation of a clone: two would write over each other's trees. The system frees it at the end."""
    os.makedirs('build/mutation', exist_ok=True)
    lock = open('build/mutation/lock', 'a+')
    try: fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        lock.seek(0)
        sys.exit('mutate.py: process %s asks mutants in this clone already; wait for it, or take a second clone' % lock.read().strip())
    lock.truncate(0)
    lock.write('%d\n' % os.getpid())
    lock.flush()
    return lock


def folder(path):
    return path if path in ('solvers/check/verify.c',) else os.path.dirname(path)


def main():
    say = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    say.add_argument('--of', nargs='+', default=['proof', 'verify'])
    say.add_argument('--sample', type=int, default=0)
    say.add_argument('--after', type=int, default=0)
    say.add_argument('--seed', type=int, default=20)
    say.add_argument('--jobs', type=int, default=os.cpu_count())
    say.add_argument('--line', action='append', default=[])
    say.add_argument('--suites', nargs='+')
    say.add_argument('--hashes', action='store_true')
    say.add_argument('--guided', action='store_true')
    say.add_argument('--longest', type=int, default=0)
    say.add_argument('--list', action='store_true')
    say.add_argument('--quiet', action='store_true')
    say.add_argument('--kept')
    say.add_argument('--again', action='store_true')
    say.add_argument('--minutes', type=float, default=1e9)
    say.add_argument('--constants', action='store_true')
    say.add_argument('--float', action='store_true')
    say.add_argument('--table')
    say.add_argument('--least', type=float, default=0)
    args = say.parse_args()

    if args.of == ['small']: FLAGS.append('-DSP_SMALL')
    if args.float: FLAGS.append('-DSP_REAL_FLOAT')
    files = sorted({f for what in args.of for pattern in SETS.get(what, [what]) for f in glob(pattern)})
    found, known = [m for f in files for m in mutants_of(f)], equivalents()
    if args.line: found = [m for m in found if '%s:%d' % (m[0].replace('solvers/', ''), m[1]) in args.line]
    same = [m for m in found if (m[0], m[4].strip()) in known]
    used = {(m[0], m[4].strip()) for m in same}
    for file, text in known - used:
        if file in files and not args.line: print('no such mutant, listed as equivalent: %s: %s' % (file, text))
    found = [m for m in found if (m[2] == 'constant') == args.constants]
    same = [m for m in same if m in found]
    rest = [m for m in found if (m[0], m[4].strip()) not in known]
    if args.sample: rest = sample(rest, args.sample, args.seed)[args.after:]
    if args.list:
        for m in rest: print('%s:%d: %s: %s' % (m[0], m[1], m[2], m[4].strip()))
        return 0

    lock = alone()                                      # kept open
    if args.hashes and not os.path.exists('build/scenes.h'):
        with open('build/scenes.h', 'w') as f:
            f.write(run(['awk', '-f', 'tests/corpus/scenes.awk', *glob('tests/scenes/*.obj')]).stdout)
    compiler = ['tcc', *FLAGS[3:]] if shutil.which('tcc') else [os.environ.get('CC', 'gcc'), *FLAGS[1:], '-O0']
    core = [re.sub(r'.*/test_(\w+)\.c', r'\1', p) for p in glob('tests/*/test_*.c') if p.split('/')[1] not in NOT_CORE]
    small = open('tests/small/suites.txt').read().split()
    those = {'limit': LIMITS, 'verify': VERIFIES, 'small': small, 'core': core}.get(' '.join(args.of), INSIDE if args.float else JUDGES)
    longest = (args.longest or QUICK) if those is core else 0
    suites = Suites(args.suites or those, 'build/mutation/suites' + ''.join(FLAGS[3:]), compiler, longest, args.longest or SLOW)
    rooms = [Room(k, suites) for k in range(args.jobs)]
    counts = suites.split(rooms[0].build(None)[0]())
    noticed = rooms[0].ask(rooms[0].build(None))
    assert not noticed, 'the unchanged library fails, in parts: ' + noticed
    if args.guided: suites.guide(args.jobs)
    print('%d quick tests and %d slow ones, %.1f s, of %d' % (*counts[:2], sum(suites.seconds), counts[2]), flush=True)

    free, kept, end = list(rooms), Kept(args.kept), time.time() + 60 * args.minutes

    def one(mutant):
        status, by = kept.said(mutant, args.again) or ('open', '')
        if status != 'open' or time.time() > end: return mutant, status, by
        room = free.pop()
        status, by = room.judge(mutant, args.hashes)
        free.append(room)
        kept.add(mutant, status, by)
        if not args.quiet and status == 'survived':
            print('survived%s  %s:%d: %s\n    %s\n    %s' % (', hashes notice' if by else '', mutant[0], mutant[1], mutant[2],
                                                           mutant[3].strip(), mutant[4].strip()), flush=True)
        return mutant, status, by

    with ThreadPoolExecutor(args.jobs) as pool: judged = list(pool.map(one, rest))
    rows = {}
    for mutant, status, by in (j for j in judged if j[1] != 'open'):
        row = rows.setdefault(folder(mutant[0]), dict(killed=0, survived=0, hashes=0, invalid=0, same=0))
        row[status] += 1
        row['hashes'] += by == 'hashes'
    for m in same: rows.setdefault(folder(m[0]), dict(killed=0, survived=0, hashes=0, invalid=0, same=0))['same'] += 1
    all_killed = all_mutants = 0
    for name in sorted(rows):
        r = rows[name]
        n = r['killed'] + r['survived']
        all_killed, all_mutants = all_killed + r['killed'], all_mutants + n
        print('%-24s %5d mutants, %5d killed = %.1f %%%s; %d equivalent, %d do not compile' % (
            name, n, r['killed'], 100 * r['killed'] / max(n, 1),
            ', with hashes %.1f %%' % (100 * (r['killed'] + r['hashes']) / max(n, 1)) if args.hashes else '', r['same'], r['invalid']))
        if args.table:
            with open(args.table, 'a') as f:
                f.write('%s,%d,%d,%d,%d,%d\n' % (name, n, r['killed'], r['hashes'], r['same'], r['invalid']))
    share = 100 * all_killed / max(all_mutants, 1)
    left = sum(status == 'open' for _, status, _ in judged)
    print('%d mutants, %d killed = %.1f %%%s' % (all_mutants, all_killed, share, '; %d not asked yet' % left if left else ''))
    return share < args.least


if __name__ == '__main__': sys.exit(main())
