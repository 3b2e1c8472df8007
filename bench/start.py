"""Which modules the start of a lint takes its time for: CPU milliseconds of each, without those that it imports."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

CODE = """
import collections, importlib.machinery as machinery, sys, time, typer
inner, own = [], {}
real = machinery.SourceFileLoader.exec_module
def timed(self, module):
    began = time.thread_time(); inner.append(0.0)
    try:
        real(self, module)
    finally:
        took = time.thread_time() - began
        own[module.__name__] = took - inner.pop()
        if inner:
            inner[-1] += took
machinery.SourceFileLoader.exec_module = timed
sys.argv = ['rospkg', 'lint', '--no-cache', '.']
from rospkg_cli.__main__ import main
began = time.thread_time(); main(); took = time.thread_time() - began
rooms = collections.defaultdict(list)
for name, seconds in own.items():
    rooms['.'.join(name.split('.')[:2])].append(seconds)
show = lambda name, seconds, count: print(f'{seconds * 1000:7.1f} ms {count:4}  {name}', file=sys.stderr)
show('the whole lint, after typer', took, 1)
show('of that, modules', sum(own.values()), len(own))
for name, found in sorted(rooms.items(), key=lambda each: -sum(each[1]))[:25]:
    show(name, sum(found), len(found))
print('', file=sys.stderr)
for name, seconds in sorted(own.items(), key=lambda each: -each[1])[:25]:
    show(name, seconds, 1)
"""


def print_imports(package: Path) -> None:
    """Print what a lint of a package imports beside typer: by room, then the dearest modules."""
    done = subprocess.run([sys.executable, "-c", CODE], cwd=package, capture_output=True, text=True, check=True)
    print(done.stderr)
