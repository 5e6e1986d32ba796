"""worker: what happens to a worker and its client when everything goes wrong: no hang, no process left, no answer lost.

    python3 -B tests/checks/worker.py PROGRAM [--whole]

Mutated requests in long sessions, every one answered by a whole message; timeouts in a row; clients that die, half a request said or
their worker at work; full discs; closed pipes. --whole: 10,000 requests, 500 timeouts, 200 deaths; else a thirtieth. The last line is
`N passed, N failed`. A PROGRAM with sanitizers tells of leaks, too: it then ends with another status.
"""
import os, random, resource, signal, stat, struct, subprocess, sys, tempfile, time, zlib

PROGRAM, WHOLE = os.path.abspath(sys.argv[1]), '--whole' in sys.argv[2:]
REQUESTS, TIMEOUTS, DEATHS = (10000, 500, 200) if WHOLE else (300, 15, 10)
AMPLE = 300                             # [s] what takes as long hangs
HEADER, REQUEST, RESULT, ERROR = 16, 1, 2, 3
HURTFUL = [0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x7ff00000, 0x7ff80000, 0x7fe00000, 0x00100000, 65536]
SCENES = ['two-cubes', 'arch', 'h-model', 'overhang']
passed = failed = 0
dice = random.Random(20)


def check(held, what):
    global passed, failed
    passed, failed = passed + bool(held), failed + (not held)
    if not held: print('FAILED  ' + what, flush=True)
    return held


def scene(name): return 'tests/scenes/%s.obj' % name


def request_of(name, folder):
    """What `check --worker` says to the worker it starts, which is itself, by the name it was given."""
    script, said = os.path.join(folder, 'listens'), os.path.join(folder, 'said')
    with open(script, 'w') as f: f.write('#!/bin/sh\nexec cat > %s\n' % said)
    os.chmod(script, stat.S_IRWXU)
    subprocess.run([script, 'check', '--quiet', '--worker', '60', scene(name)], executable=PROGRAM, capture_output=True, timeout=AMPLE)
    with open(said, 'rb') as f: return f.read()


def mutated(message):
    """One to four places of the body changed; length and checksum made right again."""
    body = bytearray(message[HEADER:-4])
    for _ in range(dice.randint(1, 4)):
        at, kind = dice.randrange(len(body) - 4), dice.randrange(5)
        if kind == 0: body[at] ^= 1 << dice.randrange(8)
        elif kind == 1: body[at] = dice.randrange(256)
        elif kind == 2: body[at // 4 * 4:at // 4 * 4 + 4] = struct.pack('<I', dice.choice(HURTFUL))
        elif kind == 3: body[dice.randrange(40) * 4:][:4] = struct.pack('<i', dice.randint(-2, 70))
        elif len(body) > 400 and dice.randrange(4) == 0: del body[at:at + 4]
    whole = message[:12] + struct.pack('<I', len(body)) + bytes(body)
    return whole + struct.pack('<I', zlib.crc32(whole))


def answers(data):
    """Kinds of the messages in what a worker said; None where they are not whole."""
    kinds = []
    while data:
        if len(data) < HEADER + 4: return None
        magic, _, kind, _, length = struct.unpack('<IHHII', data[:HEADER])
        end = HEADER + length + 4
        if magic != 0x4b505453 or kind not in (RESULT, ERROR) or len(data) < end: return None
        if struct.unpack('<I', data[end - 4:end])[0] != zlib.crc32(data[:end - 4]): return None
        kinds.append(kind)
        data = data[end:]
    return kinds


def left_of(session):
    """Processes of a session that are still there, after as long as a signal takes."""
    for _ in range(200):
        there = []
        for pid in filter(str.isdigit, os.listdir('/proc')):
            try:
                with open('/proc/%s/stat' % pid) as f: fields = f.read().rsplit(')', 1)[1].split()
            except OSError: continue
            if int(fields[3]) == session and fields[0] != 'Z': there.append(int(pid))
        if not there: return []
        time.sleep(0.05)
    return there


def run(args, data=b'', **more):
    """(status, what was said) of the program in a session of its own, of which nothing stays; None: it hangs."""
    p = subprocess.Popen([PROGRAM, *args], stdin=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True,
                         **{'stdout': subprocess.PIPE, **more})
    try: said = p.communicate(data, timeout=AMPLE)[0]
    except subprocess.TimeoutExpired:
        os.killpg(p.pid, signal.SIGKILL)
        p.wait()
        return None, b''
    check(not left_of(p.pid), 'processes stay: %s' % ' '.join(args))
    return p.returncode, said


def mutations(requests):
    told, each = {RESULT: 0, ERROR: 0}, 100
    for done in range(0, REQUESTS, each):
        status, said = run(['worker'], b''.join(mutated(dice.choice(requests)) for _ in range(each)))
        kinds = answers(said)
        if check(status == 0 and kinds is not None and len(kinds) == each,
                 'session %d: status %s, %s answers' % (done // each, status, kinds and len(kinds))):
            for k in kinds: told[k] += 1
    check(told[RESULT] > REQUESTS // 20 and told[ERROR] > REQUESTS // 20, 'both kinds of answers: %s' % told)
    print('%d mutated requests: %d results, %d refusals' % (REQUESTS, told[RESULT], told[ERROR]), flush=True)


def timeouts():
    for _ in range(TIMEOUTS):
        status, _ = run(['check', '--quiet', '--worker', '0.000001', scene('wall')])
        check(status == 70, 'no time: status %s' % status)
    print('%d timeouts' % TIMEOUTS, flush=True)


def deaths(requests):
    for k in range(DEATHS):
        message = dice.choice(requests)
        status, said = run(['worker'], message + message[:dice.randrange(1, len(message))])    # gone in the midst of the second
        check(status == 65 and answers(said) == [RESULT, ERROR], 'half a request: status %s' % status)
        p = subprocess.Popen([PROGRAM, 'check', '--quiet', '--worker', '60', scene('wall')], start_new_session=True,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(dice.uniform(0, 0.02))
        p.send_signal(dice.choice([signal.SIGKILL, signal.SIGTERM]))
        p.wait(AMPLE)
        check(not left_of(p.pid), 'a worker outlives its client')
    print('%d clients that die' % (2 * DEATHS), flush=True)


def full_and_closed(requests):
    if os.path.exists('/dev/full'):
        for args, data in ((['worker'], requests[1]), (['check', '--worker', '60', scene('arch')], b'')):
            with open('/dev/full', 'wb') as full: status, _ = run(args, data, stdout=full)
            check(status == 70, 'full disc, %s: status %s' % (args[0], status))
    for args, data in ((['worker'], b''.join(requests)), (['check', '--worker', '60', scene('arch')], b'')):
        reads, writes = os.pipe()
        os.close(reads)                                 # nobody will ever read
        status, _ = run(args, data, stdout=writes)
        os.close(writes)
        check(status in (70, -signal.SIGPIPE), 'closed pipe, %s: status %s' % (args[0], status))
    status, said = run(['worker'], b'')
    check((status, said) == (0, b''), 'nothing asked: status %s' % status)
    print('full discs, closed pipes', flush=True)


def main():
    with tempfile.TemporaryDirectory() as folder: requests = [request_of(name, folder) for name in SCENES]
    for name, r in zip(SCENES, requests):               # as they are they are answered
        status, said = run(['worker'], r + r)
        check(status == 0 and answers(said) == [RESULT, RESULT], '%s, not changed: status %s' % (name, status))
    mutations(requests)
    timeouts()
    deaths(requests)
    full_and_closed(requests)
    print('largest process: %d MB' % (resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024))
    print('%d passed, %d failed' % (passed, failed))
    return failed > 0


sys.exit(main())
