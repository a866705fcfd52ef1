"""scripts/check/mutate: breaks the code in one place after another and counts what its tests catch.

The mutants are all in one program (instrument.py); the environment names the active one. For each,
only the test cases that reach it are run, until one fails: first those that caught others of
the same file, then the quickest.
"""
import argparse
import concurrent.futures as futures
import itertools
import os
import re
import resource
import signal
import subprocess
import sys
import time
from collections import defaultdict
from fnmatch import fnmatch
from pathlib import Path

import instrument

ROOT = Path(__file__).resolve().parents[3]
MUTATED = ('lib/discmc', 'ports/mesh/host')
BUILD = ROOT / 'build' / 'mutation'
PROGRAM = BUILD / 'mutants'
RESULTS = BUILD / 'results.tsv'
SURVIVORS = Path(__file__).with_name('survivors.txt')
BATCH = 0.05  # seconds of test cases per process
MEMORY = 2 << 30  # bytes that a mutant may take


# ---- the program that holds the mutants ----

def write_copy(refused):
    """Writes the mutated code to the build folder. Unchanged files are not touched."""
    numbers = itertools.count(1)
    mutants, targets = [], set()
    for path in sorted(path for folder in MUTATED for path in (ROOT / folder).rglob('*.*')):
        text = path.read_text()
        if path.suffix in ('.cpp', '.hpp'):
            flags = ['-x', 'c++', '-std=c++17', f'-I{ROOT}/lib', f'-I{ROOT}/ports/mesh']
            file = instrument.Instrumenter(path, flags, lambda: next(numbers), refused[path.name])
            mutants += file.mutants
            text = file.rewritten()
        target = BUILD / path.relative_to(ROOT)
        targets.add(target)
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text() != text:
            target.write_text(text)
    for folder in MUTATED:
        for path in (BUILD / folder).rglob('*.*'):
            if path not in targets:
                path.unlink()
    return mutants


def build():
    """Returns the mutants, and the number of lines without any, because their mutants do not compile."""
    refused = defaultdict(set)
    while True:
        mutants = write_copy(refused)
        subprocess.run(['cmake', '-S', Path(__file__).parent, '-B', BUILD, '-G', 'Ninja'],
                       check=True, stdout=subprocess.DEVNULL)
        ninja = subprocess.run(['cmake', '--build', BUILD, '--', '-k', '0'],
                               stdout=subprocess.PIPE, text=True)
        if ninja.returncode == 0:
            return mutants, sum(len(lines) for lines in refused.values())
        found = re.findall(rf'(?:{"|".join(MUTATED)})/(?:\w+/)*(\w+\.[ch]pp):(\d+):\d+: error',
                           ninja.stdout)
        found = {(file, int(line)) for file, line in found if int(line) not in refused[file]}
        if not found:
            sys.exit(ninja.stdout[-4000:] + '\nmutate: this does not build, whatever is left out')
        for file, line in sorted(found):
            print(f'mutate: the compiler refuses the mutants of {file}:{line}')
            refused[file].add(line)


# ---- test cases ----

class Case:
    def __init__(self, name):
        self.name = name
        self.seconds = 0.0
        self.sites = set()


def outcome(cases, seconds, **environment):
    """Returns the exit code of a process that runs these cases."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        signal.setitimer(signal.ITIMER_PROF, seconds)  # of processor time
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    names = ','.join(case.name.replace(',', '?') for case in cases)  # a comma separates filters
    return subprocess.run([PROGRAM, '--abort-after=1', f'--test-case={names}'],
                          env={**os.environ, **environment}, preexec_fn=limit,
                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode


def measure(case, slowest):
    """Returns the time of the case and the mutants that it reaches; None if it is too slow."""
    file = BUILD / f'reached.{id(case)}'
    code = outcome([case], slowest, MUTANTS_REACHED=str(file))
    if code == -signal.SIGPROF:
        return None
    if code != 0:
        sys.exit(f'mutate: "{case.name}" fails without a mutant')
    seconds, *sites = file.read_text().split()
    case.seconds, case.sites = float(seconds), set(map(int, sites))
    file.unlink()
    return case


def measured_cases(slowest):
    listed = subprocess.run([PROGRAM, '--list-test-cases', '--no-colors=true'], check=True,
                            stdout=subprocess.PIPE, text=True).stdout
    names = [line for line in listed.splitlines() if not line.startswith(('[doctest]', '==='))]
    with futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        measured = pool.map(lambda name: measure(Case(name), slowest), names)
        cases = [case for case in measured if case]
    print(f'mutate: {len(cases)} test cases, {sum(case.seconds for case in cases):.0f} s; '
          f'{len(names) - len(cases)} that are slower than {slowest} s are left out')
    return sorted(cases, key=lambda case: case.seconds)


# ---- a mutant ----

def batches(cases):
    """Tries mutants in order, many per process. If one hangs, the rest run in another process."""
    batch = []
    for case in cases:
        if batch and sum(each.seconds for each in batch + [case]) > BATCH:
            yield batch
            batch = []
        batch.append(case)
    yield batch


def verdict(mutant, orders):
    """Returns killed, survived, unreached, or constant: evaluated only by the compiler."""
    cases = orders[mutant.file]
    asked = [case for case in cases if mutant.site in case.sites]
    if not asked:
        return 'constant' if mutant.constant else 'unreached'
    for batch in batches(asked):
        seconds = 0.3 + 5 * sum(case.seconds for case in batch)
        if outcome(batch, seconds, MUTANT=str(mutant.id)) != 0:
            orders[mutant.file] = batch + [case for case in cases if case not in batch]
            return 'killed'
    return 'survived'


def known_results():
    """Results of earlier runs, by the text of the mutant, because numbers change."""
    if not RESULTS.exists():
        return {}
    lines = (line.split('\t') for line in RESULTS.read_text().splitlines())
    return {key: result for result, key in lines}


def run(mutants, cases, resume):
    known = known_results() if resume else {}
    results = {mutant.key(): 'killed' for mutant in mutants if known.get(mutant.key()) == 'killed'}
    # Survivors take longest, so they are tried again last.
    left = sorted((mutant for mutant in mutants if mutant.key() not in results),
                  key=lambda mutant: mutant.key() in known)
    orders = defaultdict(lambda: cases)  # by file: the order in which cases are tried
    begin = shown = time.monotonic()
    with open(RESULTS, 'a' if resume else 'w') as file, \
            futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = {pool.submit(verdict, mutant, orders): mutant for mutant in left}
        for done, job in enumerate(futures.as_completed(jobs), 1):
            key = jobs[job].key()
            results[key] = job.result()
            file.write(f'{results[key]}\t{key}\n')
            file.flush()
            now = time.monotonic()
            if now - shown > 20 or done == len(left):
                shown, rate = now, done / (now - begin)
                print(f'mutate: {done} of {len(left)}, {rate:.1f} a second, '
                      f'{(len(left) - done) / rate / 60:.0f} min left', flush=True)
    return results


# ---- the report ----

def recorded():
    """Returns the number of survivors by file, from survivors.txt, which also has the reasons."""
    lines = (line.split(maxsplit=2) for line in SURVIVORS.read_text().splitlines())
    counts = {}
    for file, count, reasons in (line for line in lines if line and not line[0].startswith('#')):
        counts[file] = int(count)
        if sum(int(reason.split()[1]) for reason in reasons.split(',')) != counts[file]:
            sys.exit(f'mutate: {SURVIVORS.name}: the reasons of {file} do not add up to {count}')
    return counts


def share(part, whole):
    return 100 * part / whole if whole else 100.0


def report(mutants, results):
    """Returns the table of results."""
    rows = defaultdict(lambda: defaultdict(int))
    for mutant in mutants:
        for row in (mutant.file, 'all'):
            rows[row][results[mutant.key()]] += 1
    columns = ('killed', 'survived', 'unreached', 'constant')
    print(f'\n{"":24}{"mutants":>9}', *(f'{name:>10}' for name in columns), '  caught')
    for name in sorted(rows, key=lambda name: (name == 'all', name)):
        row = rows[name]
        whole = sum(row.values()) - row['constant']
        print(f'{name:24}{sum(row.values()):9}', *(f'{row[column]:10}' for column in columns),
              f'{share(row["killed"], whole):7.1f}%')


def agrees(mutants, results, is_sample, all_files):
    """Prints the survivors, and each file whose number of survivors differs from the record."""
    found = defaultdict(int)
    for mutant in mutants:
        if results[mutant.key()] in ('survived', 'unreached'):
            found[mutant.file] += 1
            print(f'{mutant.file}:{mutant.line}: {results[mutant.key()]}: '
                  f'{mutant.source} | {mutant.change}')
    counts = recorded()
    wrong = [file for file in {mutant.file for mutant in mutants}
             if found[file] > counts.get(file, 0)
             or not is_sample and found[file] < counts.get(file, 0)]
    wrong += [file for file in counts if file not in all_files]
    for file in sorted(wrong):
        print(f'mutate: {SURVIVORS.name} has {counts.get(file, 0)} survivors of {file}; '
              f'found {found[file]}', file=sys.stderr)
    return not wrong


def arguments():
    parser = argparse.ArgumentParser(
        prog='scripts/check/mutate', description=__doc__.splitlines()[0].partition(': ')[2],
        epilog='Fails if a file has another number of survivors than '
        f'tests/proofs/mutation/{SURVIVORS.name}; a sample fails only if it has more. All mutants '
        'take two cores two hours, most of it for those that survive.')
    parser.add_argument('files', nargs='*', metavar='FILE', default=['*'],
                        help='of lib/discmc and ports/mesh/host, as holes.hpp or "*.hpp"; all when '
                        'none is named')
    parser.add_argument('--share', default='1/1', metavar='1/N', help='every N-th mutant alone')
    parser.add_argument('--slowest', type=int, default=1, metavar='SECONDS',
                        help='test cases that take longer are left out (1)')
    parser.add_argument('--resume', action='store_true',
                        help='mutants that were caught before are not run again: after an '
                        'interruption, or when tests were added')
    given = parser.parse_args()
    if not re.fullmatch(r'1/[1-9]\d*', given.share):
        parser.error(f'--share {given.share}: give 1/10 for every tenth mutant')
    return given


def main():
    given = arguments()
    mutants, refused_lines = build()
    whole = len(mutants)
    chosen = [mutant for mutant in mutants if any(fnmatch(mutant.file, f) for f in given.files)]
    chosen = chosen[::int(given.share[2:])]
    if not chosen:
        sys.exit(f'mutate: no mutants in {" ".join(given.files)}: name files of {" or ".join(MUTATED)}')
    print(f'mutate: {len(chosen)} of {whole} mutants; {refused_lines} lines were refused')
    results = run(chosen, measured_cases(given.slowest), given.resume)
    is_right = agrees(chosen, results, given.share != '1/1', {mutant.file for mutant in mutants})
    report(chosen, results)
    sys.exit(0 if is_right else 1)


main()
