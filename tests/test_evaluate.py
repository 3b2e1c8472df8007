"""The static evaluator: what it knows, what it knows that it can't know, and that it comes to an end."""

from __future__ import annotations

import contextlib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.python.evaluate.conversion import NoPythonValueError, to_python, unknowns
from rospkg_cli.languages.python.evaluate.evaluator import Evaluator
from rospkg_cli.languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from rospkg_cli.languages.python.evaluate.values import Call, PartialText, Sequence, Text, Unknown, Value
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.source import Source
from rospkg_cli.tree import MemoryTree
from rospkg_cli.unreadable import UnreadableError

FILES = {
    "setup.py": "",
    "launch/a.launch.py": "",
    "launch/b_launch.py": "",
    "launch/sub/c.launch.py": "",
    "launch/.hidden.launch.py": "",
    "config/nav.yaml": "",
    "README.md": "# Hello\nWorld\n",
    "my_pkg/__init__.py": "__version__ = '1.2.3'\n",
}


def evaluate(text: str, **files: str) -> Evaluator:
    folder = SandboxFilesystem(PackageFiles(MemoryTree.of({**FILES, **files})))
    found = Evaluator(parse_python(Source("setup.py", text)), folder)
    found.run_file()
    return found


def value(text: str, name: str = "x") -> Value:
    found = evaluate(text).get(name)
    assert found is not None
    return found


KNOWN = [
    "x = 'a' + 'b' * 2",
    "x = 'share/%s/%s' % ('a', 'b')",
    "x = '%(a)s-%(b)03d' % {'a': 'q', 'b': 7}",
    "x = '{}/{n}/{0}'.format('a', n='b') if False else '{}/{n}'.format('a', n='b')",
    "x = '{:>5}|{!r}'.format('a', 'b')",
    "name = 'p'\nx = f'share/{name}/{name!r:>6}/{3:03d}'",
    "import os\nx = os.path.join('a', 'b', '/c', 'd')",
    "from os.path import join as j, dirname, basename\nx = [j('a', 'b'), dirname('a/b/c'), basename('a/b')]",
    "from pathlib import Path\nx = [str(Path('a') / 'b' / 'c.txt'), Path('a/b.tar.gz').stem, Path('a/b').name]",
    "from pathlib import Path\np = Path('a/b/c')\nx = [str(p.parent), str(p.parents[1]), str(p.with_suffix('.x'))]",
    "x = []\nfor n in ['a', 'b']:\n    x.append((n, [n + '.py']))\nx += [1]\nx.extend(['z'])\nx.insert(0, 'first')",
    "x = {'a': 1, **{'b': 2}}\nx['c'] = 3\nx.update(d=4)\nx = sorted(x.items())",
    "x = [a + b for a in 'xy' for b in ['1', '2'] if a + b != 'x2']",
    "x = {k: v for k, v in zip(['a', 'b'], range(2))}",
    "def f(a, *rest, b='b', **more):\n    return [a, rest, b, sorted(more)]\nx = f('a', 1, 2, c=3)",
    "def gen():\n    for i in range(3):\n        yield i\nx = list(gen())",
    "x = 0\nwhile x < 5:\n    x += 2",
    "x = [i for i in range(10) if i % 2 == 0][1:3][-1]",
    "try:\n    x = 1\nexcept ImportError:\n    x = 2",
    "x = 'yes' if 'a' in ['a'] and not [] else 'no'",
    "q = 'q'\nx = 1 if None is None and q is not None else 2",
    "a, (b, c) = 1, (2, 3)\nx = [c, b, a]",
    "x = list(map(lambda n: n.upper(), filter(None, ['a', '', 'b'])))",
    "x = ' '.join(s.strip() for s in 'a , b'.split(','))",
    "class C:\n    name = 'n'\nx = C.name + '!'",
    "x = []\ndef add(y):\n    x.append(y)\nadd(1)\nadd(2)",
    "x = 1\ndef f():\n    global x\n    x = 2\nf()",
    "for i in range(5):\n    if i == 2:\n        continue\n    if i == 4:\n        break\n    x = i\nelse:\n    x = 99",
    "import itertools\nx = list(itertools.chain(['a'], ('b',))) + sum([[1], [2]], [])",
    "x = (lambda a, b=2: a * b)(3)",
    "x = [*range(2), *'ab']\ny = {**{}}",
    "x = 'a' 'b'.upper()",
    "x = (n := 5) + n",
    "x = len('abc') + len([1, 2]) + max(1, 2) + int('7')",
    "x = isinstance('a', str) and isinstance([], (tuple, list)) and not isinstance(1, str)",
    "x = any([0, 1]) and all([1, 2])",
    "d = {}\nd.setdefault('k', []).append(1)\nd.setdefault('k', []).append(2)\nx = d",
    "x = ['b', 'a']\nx.remove('b')\nx.append('c')\ny = x.pop()",
    "x = 'naïve – ü' + f'{\"é\"}'",
    "x = ['c', 'a', 'b']\nx.sort()\nx = [x[0], x]",
    "x = ['bb', 'a', 'ccc']\nx.sort(key=len, reverse=True)",
    "x = ['a', 'b', 'c']\nx[0] = 'z'\ndel x[1]\nx[-1], x[0] = x[0], x[-1]",
    "it = iter(['a', 'b'])\nx = [next(it), next(it), next(it, 'end')]",
    "x = [callable(lambda: 1), callable('a')]",
    "x = {'a': 1} | {'a': 2, **dict(b=3)}\nx = list(x.items())",
]


@pytest.mark.parametrize("text", KNOWN)
def test_what_it_computes_is_what_python_computes(text: str) -> None:
    scope: dict = {}
    exec(text, scope)
    assert to_python(value(text)) == scope["x"]


ON_DISK = [
    "import glob, os\nx = []\nd = glob.glob('launch')\nfor n in d:\n    for f in sorted(glob.glob(n + '/*')):\n"
    "        (d if os.path.isdir(f) else x).append(f)",
    "from glob import glob\nx = sorted(glob('launch/*.launch.py'))",
    "import glob\nx = sorted(glob.glob('launch/**/*.py', recursive=True))",
    "import glob\nx = sorted(glob.glob('launch/**', recursive=True))",
    "import glob\nx = sorted(glob.glob('./*/'))",
    "import glob\nx = sorted(glob.glob('launch/*') + glob.glob('launch/.*'))",
    "import glob\nx = sorted(glob.glob('*/nav.y*ml') + glob.glob('nothing/*') + glob.glob('README.md'))",
    "import os\nx = sorted(f for f in os.listdir('launch') if os.path.isfile(os.path.join('launch', f)))",
    "import os\nx = sorted((p, sorted(d), sorted(f)) for p, d, f in os.walk('launch'))",
    "import os\nx = os.path.relpath(os.path.join(os.path.abspath('.'), 'launch'), os.getcwd())",
    "from pathlib import Path\nx = sorted(str(p) for p in Path('launch').glob('*.py'))",
    "from pathlib import Path\nx = sorted(str(p) for p in Path('.').rglob('*.py'))",
    "from pathlib import Path\nx = sorted(str(p) for p in Path('launch').iterdir() if p.is_file())",
    "x = open('README.md').read()",
    "with open('README.md', encoding='utf-8') as f:\n    x = [line.strip() for line in f]",
    "from pathlib import Path\nx = Path('README.md').read_text().splitlines()",
    "f = open('README.md')\nx = [f.readline(), f.read(), f.readlines(), list(f)]",
    "import os\nx = [os.path.exists('launch'), os.path.isdir('launch'), os.path.isfile('nope')]",
]


@pytest.mark.parametrize("text", ON_DISK)
def test_the_package_looks_as_it_does_on_disk(text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for path, content in FILES.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(content)
    monkeypatch.chdir(tmp_path)
    scope: dict = {}
    exec(text, scope)
    assert to_python(value(text)) == scope["x"]


NOT_KNOWN = [
    "import os\nx = os.environ['HOME']",
    "import os\nx = os.environ.get('HOME', 'a')",
    "import requests\nx = requests.get('x').text",
    "import random\nx = random.choice(['a', 'b'])",
    "import glob\nx = glob.glob('../other/*')",
    "import subprocess\nx = ['a', subprocess.check_output(['ls'])]",
    "import os\nx = 'a'\nif os.environ.get('Q'):\n    x = 'b'",
    "import os\nx = ['a']\nif os.environ.get('Q'):\n    x.append('b')",
    "import os\nx = ['a']\nfor f in os.environ:\n    x.append(f)",
    "from somewhere import change\nx = ['a']\nchange(x)",
    "try:\n    import sphinx\n    x = True\nexcept ImportError:\n    x = False",
    "x = undefined",
    "x = [1][5]",
    "x = {'a': 1}['b']",
    "import os\nx = []\nfor n in 'ab':\n    if os.environ.get('Q'):\n        continue\n    x.append(n)",
    "import os\ndef f():\n    if os.environ.get('Q'):\n        return 1\n    return 2\nx = f()",
    "import os\nx = {'a': 1}\nif os.environ.get('Q'):\n    x['a'] = 2",
    "import os\nx = ''\nfor n in 'ab':\n    x = n\n    if os.environ.get('Q'):\n        break",
    "import os\nfor x in 'ab':\n    if os.environ.get('Q'):\n        break",
    "x = 'a' % ()['b']",
    "import os\nx = 'a'\ndef f():\n    global x\n    if os.environ.get('Q'):\n        x = 'b'\nf()",
    "import os\nd = {}\nif os.environ.get('Q'):\n    d['a'] = 1\nx = 'a' in d",
    "import os\nd = {}\nif os.environ.get('Q'):\n    d.update(a=1)\nx = len(d)",
    "import os\nd = {}\nif os.environ.get('Q'):\n    d['a'] = 1\nx = list(d)",
    "import os\nd = {}\nif os.environ.get('Q'):\n    d['a'] = 1\nx = {'a': 2, **d}['a']",
    "import os\nd = {}\nif os.environ.get('Q'):\n    d['a'] = 1\nx = 'y' if d else 'n'",
    "import os\nd = {}\nif os.environ.get('Q'):\n    d['a'] = 1\nx = list(d.items())",
    "import os\nx = ['a', 'b']\nif os.environ.get('Q'):\n    x[0] = 'c'\nx = x[0]",
    "import os\nx = ['a', 'b']\nif os.environ.get('Q'):\n    x.pop(0)\nx = x[0]",
    "import os\nx = ['a', 'b']\ndel x[int(os.environ['Q'])]\nx = x[0]",
    "from somewhere import f\ndef g():\n    try:\n        f()\n        return 1\n    except ValueError:\n        pass\n"
    "    return 2\nx = g()",
]


@pytest.mark.parametrize("text", NOT_KNOWN)
def test_it_knows_what_it_does_not_know(text: str) -> None:
    with pytest.raises(NoPythonValueError):
        to_python(value(text))


def test_what_perhaps_is_there_is_kept_aside() -> None:
    found = value("import os\nx = ['a']\nif os.environ.get('Q'):\n    x.append('b')")
    assert isinstance(found, Sequence)
    sure, perhaps = found.items
    assert isinstance(sure, Text)
    assert isinstance(perhaps, Unknown)
    assert perhaps.is_many
    assert [to_python(option) for option in perhaps.options] == ["b"]
    assert "os.environ" in perhaps.why


def test_a_key_that_perhaps_is_there_keeps_its_options() -> None:
    start = "import os\nd = {}\nif os.environ.get('Q'):\n    d['a'] = 1\n"
    (found,) = unknowns(value(start + "x = d.get('a', 2)"))
    assert [to_python(option) for option in found.options] == [1, 2]
    kept = value(start + "x = {**d}['a']")
    assert isinstance(kept, Unknown)
    assert not kept.is_many
    call = evaluate(start + "from m import Node\nNode(**d)").calls[-1]
    assert call.rest is not None


def test_the_else_of_a_loop_that_perhaps_ends_early_is_run() -> None:
    start = "import os\nfrom m import Node\nfor n in 'ab':\n    if os.environ.get('Q'):\n        break\n"
    (call,) = evaluate(start + "else:\n    Node()").calls
    assert not call.is_certain


def test_a_choice_keeps_its_options() -> None:
    (found,) = unknowns(value("import os\nx = 'a' if os.environ.get('Q') else 'b'"))
    assert [to_python(option) for option in found.options] == ["a", "b"]


LAUNCH = """\
import os
from ament_index_python.packages import get_package_share_directory as share
from launch_ros.actions import Node
from launch import LaunchDescription, actions

NAV = 'nav2_bringup'

def node(name, **more):
    return Node(package='demo', executable=name, output='screen', **more)

def generate_launch_description():
    here = share(NAV)
    params = os.path.join(here, 'config', f'{NAV}.yaml')
    ld = LaunchDescription()
    for name in ('talker', 'listener'):
        ld.add_action(node(name, parameters=[params]))
    return ld
"""


def test_calls_that_it_does_not_know_are_values() -> None:
    found = evaluate(LAUNCH)
    made = found.get("generate_launch_description")
    assert made is not None
    assert isinstance(found.call(made), Call)
    nodes = [call for call in found.calls if call.callee == "launch_ros.actions.Node"]
    assert [to_python(node.get("executable")) for node in nodes] == ["talker", "listener"]  # type: ignore[arg-type]
    parameters = nodes[0].get("parameters")
    assert isinstance(parameters, Sequence)
    (joined,) = parameters.items
    assert isinstance(joined, PartialText)
    directory, rest = joined.parts
    assert isinstance(directory, Call)
    assert directory.callee == "ament_index_python.packages.get_package_share_directory"
    assert to_python(directory.positional[0]) == "nav2_bringup"
    assert isinstance(rest, Text)
    assert rest.text == "/config/nav2_bringup.yaml"
    assert [call.receiver.callee for call in found.calls if call.callee == "add_action"] == [
        "launch.LaunchDescription"
    ] * 2  # type: ignore[union-attr]


def test_spans_lead_to_the_expression_that_made_the_value() -> None:
    text = "# ü\nname = 'my_pkg'\nx = ['ä' + name, name, f'{name}!']\n"
    found = evaluate(text)
    items = found.get("x").items  # type: ignore[union-attr]
    assert [found.file.source.slice(item.span) for item in items] == ["'ä' + name", "'my_pkg'", "f'{name}!'"]
    assert found.file.source.slice(items[1].literal) == "my_pkg"
    assert [found.file.source.slice(place) for place in found.get("x").places] == ["'ä' + name", "name", "f'{name}!'"]  # type: ignore[union-attr]


ENDLESS = [
    "x = 1\nwhile True:\n    x += 1",
    "def f(n):\n    return f(n + 1)\nx = f(1)",
    "x = [0] * 10**9",
    "x = 'a' * 10**9",
    "x = '%1000000000d' % 1",
    "x = '{:1000000000}'.format(1)",
    "x = 10 ** 10 ** 10",
    "x = list(range(10**12))",
    "x = ['a']\nfor y in x:\n    x.append(y)\n    x.extend(x)",
    "x = 'a'\nfor i in range(100):\n    x = x + x",
    "x = 'a'\nfor i in range(100):\n    x = x.replace('a', 'aaaaaaaa')",
    "x = []\nx.append(x)\ny = str(x) + str(x == x)",
    "x = {}\nx['x'] = x\ny = f'{x}'",
    "f = lambda g: g(g)\nx = f(f)",
    "x = [a for a in range(9999) for b in range(9999) for c in range(9999)]",
    "x = " + "(" * 90 + "1" + ")" * 90,
    "x = " + "-" * 5000 + "1",
    "x = " + " + ".join(["'a'"] * 5000),
]


@pytest.mark.parametrize("text", ENDLESS)
def test_it_comes_to_an_end(text: str) -> None:
    with contextlib.suppress(UnreadableError):
        assert evaluate(text).steps < 1_000_000


OPERATORS = st.sampled_from(["+", "%", "/", "*", "==", "in", "and", "|", "-", "<"])
METHODS = st.sampled_from(["join", "format", "append", "items", "split", "x", "pop", "update"])
ATOMS = st.sampled_from(["a", "'s'", "1", "[]", "{}", "None", "f", "b'x'", "os.path", "os.environ", "''"])
EXPRESSIONS = st.recursive(
    ATOMS,
    lambda e: st.one_of(
        st.tuples(e, OPERATORS, e).map(lambda t: f"({t[0]} {t[1]} {t[2]})"),
        st.tuples(e, e).map(lambda t: f"{t[0]}({t[1]})"),
        st.tuples(e, METHODS).map(lambda t: f"({t[0]}).{t[1]}"),
        st.tuples(e, e).map(lambda t: f"[{t[0]} for a in {t[1]}]"),
        st.tuples(e, e).map(lambda t: f"{{{t[0]}: {t[1]}}}"),
        st.tuples(e, e, e).map(lambda t: f"({t[0]})[{t[1]}:{t[2]}]"),
        e.map(lambda t: f"glob.glob({t})"),
        e.map(lambda t: f"(lambda a, *b, **c: {t})"),
        st.lists(e, max_size=3).map(lambda t: f"sorted([{', '.join(t)}], key=len)"),
    ),
    max_leaves=12,
)


@settings(max_examples=150, deadline=None)
@given(EXPRESSIONS)
def test_no_expression_makes_it_fall_over(text: str) -> None:
    found = evaluate(
        f"import os, glob\na = 'A'\ndef f(x=1, *y, **z):\n    return x\nx = {text}\nfor i in {text}:\n    y = [i]"
    )
    assert found.get("a") is not None


@pytest.mark.parametrize("name", "abcd")
def test_what_stands_behind_unknown_arguments_is_for_no_known_parameter(name: str) -> None:
    text = (
        "import os\nmore = os.environ['MORE'].split()\ndef f(a, b, c=3, *, d=4):\n    return NAME\nx = f('a', *more, 5)"
    )
    found = value(text.replace("NAME", name))
    assert isinstance(found, Text if name == "a" else Unknown)


@pytest.mark.parametrize(
    "joined, parts",
    [
        ("share('p'), 'maps', name + '.yaml'", ["?", "/maps/", "?", ".yaml"]),
        ("'maps', f'{name}.yaml', 'b'", ["maps/", "?", ".yaml/b"]),
        ("share('p'), '/maps', f'{name}.yaml'", ["/maps/", "?", ".yaml"]),
        ("share('p'), 'maps/', f'/{name}.yaml'", ["/", "?", ".yaml"]),
        ("share('p'), name", None),
        ("share('p'), 5", None),
    ],
)
def test_paths_that_are_known_in_part(joined: str, parts: list[str] | None) -> None:
    head = "import os\nfrom ament_index_python.packages import get_package_share_directory as share\n"
    found = evaluate(f"{head}name = os.environ['NAME']\nx = os.path.join({joined})\n").get("x")
    texts = [p.text if isinstance(p, Text) else "?" for p in found.parts] if isinstance(found, PartialText) else None
    assert texts == parts
