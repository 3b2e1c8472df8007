"""The evaluator bounds the sum of what it builds, whichever way it is built, and each step of what it asks."""

from __future__ import annotations

import pytest

from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.python.evaluate.conversion import unknowns
from rospkg_cli.languages.python.evaluate.evaluator import Evaluator
from rospkg_cli.languages.python.evaluate.limits import MAX_STEPS
from rospkg_cli.languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from rospkg_cli.languages.python.evaluate.values import Text, Unknown
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.source import Source
from rospkg_cli.tree import MemoryTree

A = "a = 'ab' * 400_000\n"

TOO_MUCH = [
    "x = 'a' * 900_000\nx = [x + str(i) for i in range(9999)]",
    "x = list(map(lambda q: q * 2, ['b' * 400_000] * 9999))",
    "x = [i + 'b' for i in ['a' * 900_000] * 19_000]",
    "x = sorted(['a' + str(i) for i in range(9999)], key=lambda a: a * 9999)",
    f"{A}x = [a.split('b') for i in range(50)]",
    f"{A}x = [a.upper() for i in range(9999)]",
    f"{A}x = [a.replace('b', 'c') for i in range(9999)]",
    f"{A}x = [a[i:] for i in range(9999)]",
    f"{A}x = ['{{}}{{}}'.format(i, a) for i in range(9999)]",
    f"{A}x = ['%s%s' % (i, a) for i in range(9999)]",
    f"{A}x = [f'{{i}}{{a}}' for i in range(9999)]",
    f"{A}x = [repr([a, i]) for i in range(9999)]",
    f"{A}x = {{i: a + str(i) for i in range(9999)}}",
    f"{A}import os\nx = [os.path.join(a, str(i)) for i in range(9999)]",
    f"{A}import os\nx = [os.path.normpath(a + str(i)) for i in range(9999)]",
    f"{A}from pathlib import Path\nx = [Path(a) / str(i) for i in range(9999)]",
    f"{A}b = a[:-1] + 'b'\nfor i in range(19_999):\n    c = a == b\n    d = 'c' in a",
    "x = ''\nfor i in range(19_999):\n    x += 'a' * 50",
    "x = []\nfor i in range(19_999):\n    x = x + [i]",
    "a = [1] * 19_999\nx = [list(a) for i in range(9999)]",
    "a = [1] * 19_999\nx = [a[i:] for i in range(9999)]",
    "a = [1] * 19_999\nx = [a.copy() for i in range(9999)]",
    "x = [[i] * 19_999 for i in range(9999)]",
    "def f(*a): return a\na = [1] * 19_999\nx = [f(*a) for i in range(9999)]",
    "import itertools\na = [1] * 19_999\nx = [list(itertools.chain(*[a] * 999)) for i in range(99)]",
    "a = {i: i for i in range(9999)}\nx = [{**a} for i in range(9999)]",
    "a = {i: i for i in range(9999)}\nx = [dict(a) for i in range(9999)]",
    "a = {i: i for i in range(9999)}\nx = [a.items() for i in range(9999)]",
    "a = list(range(19_999))\nfor i in range(19_999):\n    x = len(a)",
    "a = list(range(9_999))\nfor i in range(9_999):\n    a.remove(9_998 - i)",
    "a = set()\nfor i in range(9_999):\n    a.add(i)",
    "import foo\nx = foo.a()\nfor i in range(9999):\n    x = x + 'a' + foo.b()",
    "for i in range(19_999):\n    x = open('README.md').read()",
    "import glob\nfor i in range(9999):\n    x = glob.glob('**/**/*' + str(i), recursive=True)",
    "import foo\n" + "".join(f"a{i} = 1\n" for i in range(999)) + "if foo.x():\n    b = 1\n" * 9999,
]

ONE_TOO_MANY = [
    "x = ''.join(['a' * 999_999] * 19_999)",
    "x = '{0}{0}'.format('a' * 900_000)",
    "x = '%s%s' % ('a' * 900_000, 'a' * 900_000)",
    "x = ('%s' * 19_999) % tuple(['a' * 99_999] * 19_999)",
    "x = ('{:>999}' * 9_999).format(*['a'] * 9_999)",
    "import os\nx = os.path.join(*['a' * 9999] * 9999)",
    "x = 'a' * 9_999_999",
    "x = 999_999_999 * 'a'",
    "x = 999_999_999 * [1]",
    "x = b'a' * 999_999_999",
    "x = b'%999999999d' % 5",
    "x = round(5, -1_000_000_000)",
    "x = int('9' * 4_000)",
    "x = str(0x" + "f" * 6_000 + ")",
    "x = '%c' % 99_999_999_999_999_999_999",
    "x = ('a' * 1_000_000).rfind('b' + 'a' * 500_000)",
    "x = ('a' * 999_999).strip('b' * 999_998 + 'a')",
    "x = 'a\t'.expandtabs(999_999_999)",
    "x = 'a'.zfill(999_999_999)",
    "x = 'a'.ljust(999_999_999)",
    "x = ('a' * 9_999).translate({97: 'b' * 9_999})",
    "import glob\nx = glob.glob('*' + 'a' * 900_000)",
    "import glob\nx = glob.glob('*/' * 300_000)",
    "x = []\nx.append(x)\nx.append(x)\nx = str(x)",
]


def evaluated(text: str) -> Evaluator:
    tree = MemoryTree.of({"README.md": "abc\n" * 50_000, **{f"d{i}/e/{i}.txt": "" for i in range(50)}})
    found = Evaluator(parse_python(Source("setup.py", text)), SandboxFilesystem(PackageFiles(tree)))
    found.run_file()
    return found


@pytest.mark.parametrize("text", TOO_MUCH)
def test_the_sum_is_bounded(text: str) -> None:
    found = evaluated(text)
    assert found.gave_up.startswith("it takes more than 200,000 steps or 20,000,000 characters")
    assert found.steps == MAX_STEPS


@pytest.mark.parametrize("text", ONE_TOO_MANY)
def test_one_value_is_bounded(text: str) -> None:
    found = evaluated(text)
    value = found.get("x")
    assert found.gave_up or not isinstance(value, Text)
    assert found.gave_up or any(isinstance(each, Unknown) for each in unknowns(value)) or "Call" in repr(type(value))
    assert found.steps <= MAX_STEPS


def test_numbers_that_are_no_index() -> None:
    found = evaluated("n = 99999999999999999999999\nx = [1]\nx.insert(n, 2)\ny = 'a'[n]\nz = chr(n)\nr = range(n)\n")
    assert not found.gave_up


@pytest.mark.parametrize("depth", [35, 60])
def test_lists_that_hold_each_other_often(depth: int) -> None:
    """Who reads a call walks what it is handed: such a call is not handed on."""
    found = evaluated("import foo\nx = [foo.a]\n" + "x = [x, x]\n" * depth + "foo.first(1)\nfoo.bar(x)\n")
    assert [call.callee for call in found.calls] == ["foo.first"]
    assert found.gave_up == "what it builds is too large"
    value = found.get("x")
    assert value is not None
    assert len(list(unknowns(value))) <= 1
