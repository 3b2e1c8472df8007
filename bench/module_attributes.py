"""Write the table of what modules of Python's standard library have: python -m bench.module_attributes PYTHON…

Each PYTHON is an interpreter whose modules are asked; the stubs of typeshed, which come with mypy, name the rest.
"""

from __future__ import annotations

import ast
import json
import subprocess
import sys
import textwrap
from collections.abc import Iterator
from datetime import date
from pathlib import Path

from .tables import Origin, Revision, write

MODULES = (
    "abc argparse array ast asyncio atexit base64 binascii bisect calendar cmath collections collections.abc "
    "concurrent concurrent.futures configparser contextlib copy csv ctypes dataclasses datetime decimal enum fcntl "
    "fnmatch fractions functools getpass glob hashlib heapq http http.client http.server importlib "
    "importlib.machinery importlib.metadata importlib.resources importlib.util inspect io ipaddress itertools json "
    "logging logging.handlers math multiprocessing numbers operator os os.path pathlib pickle pkgutil platform pprint "
    "queue random re secrets select selectors shlex shutil signal socket socketserver sqlite3 stat statistics string "
    "struct subprocess sys tarfile tempfile termios textwrap threading time timeit traceback tty types typing "
    "unittest unittest.mock urllib urllib.error urllib.parse urllib.request uuid warnings weakref xml xml.dom "
    "xml.dom.minidom xml.etree xml.etree.ElementTree zipfile zlib"
).split()
ABOUT = {"module_attributes.txt": "What common modules of Python's standard library have: module, then names."}
ORIGIN = Origin(
    "`dir()` of the modules of CPython 3.10 to 3.13, and the stubs of typeshed for all versions and platforms",
    "PSF-2.0, Apache-2.0",
    "bench/module_attributes.py",
)
OTHERS = {"shutil": ("WindowsError",)}
"""What modules have on other platforms, as typeshed does not say."""
ASKED = """
import importlib, json, pkgutil, sys
found = {}
for name in sys.argv[1:]:
    module = importlib.import_module(name)
    inside = pkgutil.iter_modules(module.__path__) if hasattr(module, "__path__") else ()
    found[name] = [*dir(module), *(each.name for each in inside)]
print(json.dumps(found))
"""


def names_of(python: str) -> dict[str, list[str]]:
    """Return what the modules of one interpreter have, with the modules inside of them."""
    asked = [python, "-W", "ignore", "-c", ASKED, *MODULES]
    found: dict[str, list[str]] = json.loads(subprocess.run(asked, check=True, capture_output=True).stdout)
    return found


def stub_of(module: str) -> Path:
    import mypy

    path = Path(mypy.__file__).parent / "typeshed/stdlib" / module.replace(".", "/")
    return path / "__init__.pyi" if path.is_dir() else path.with_suffix(".pyi")


def statements(body: list[ast.stmt]) -> Iterator[ast.stmt]:
    """Yield the statements of a stub with those of all branches for versions and platforms."""
    for node in body:
        yield node
        if isinstance(node, ast.If):
            yield from statements([*node.body, *node.orelse])


def stubbed(module: str) -> Iterator[str]:
    """Yield the names that a stub defines or hands on."""
    path = stub_of(module)
    for node in statements(ast.parse(path.read_text(encoding="utf-8")).body if path.exists() else []):
        if isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            yield node.name
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            names = [each for each in ast.walk(node) if isinstance(each, ast.Name)]
            yield from (each.id for each in names if isinstance(each.ctx, ast.Store))
        elif isinstance(node, ast.ImportFrom) and node.names[0].name == "*":
            package = module if path.name == "__init__.pyi" else module.rpartition(".")[0]
            yield from stubbed(f"{package}.{node.module}" if node.level else node.module or "")
        elif isinstance(node, ast.ImportFrom | ast.Import):
            yield from (each.asname for each in node.names if each.asname == each.name)


def main() -> None:
    asked = [names_of(python) for python in (sys.argv[1:] or [sys.executable])]
    rows: list[str] = []
    for module in MODULES:
        names = {*stubbed(module), *OTHERS.get(module, ()), *(name for found in asked for name in found[module])}
        text = " ".join(sorted(each for each in names if each[0] != "_" and each.isidentifier()))
        rows += [f"{module} {line}" for line in textwrap.wrap(text, 110 - len(module), break_on_hyphens=False)]
    for table, about in ABOUT.items():
        write(table, about, rows, ORIGIN, Revision("3.10 to 3.13", date.today().isoformat()))


if __name__ == "__main__":
    main()
