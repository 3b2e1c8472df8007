"""Python files: spans in characters, imports, top-level names, and what is said of a file that can't be parsed."""

from __future__ import annotations

import ast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.languages.python.file import PythonFile, parse_python
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError


def read(text: str) -> PythonFile:
    return parse_python(Source("a.py", text))


@given(
    st.lists(
        st.text(st.characters(codec="utf-8", exclude_categories=["Cc", "Cs", "Zl", "Zp"]), max_size=12), max_size=5
    ),
    st.sampled_from(["\n", "\r\n", "\r"]),
)
def test_spans_are_characters(texts: list[str], newline: str) -> None:
    names = [f"{'é' * i}name{i}" for i in range(len(texts))]
    text = newline.join(
        f"{name} = {value!r}; after{i} = {i}" for i, (name, value) in enumerate(zip(names, texts, strict=True))
    )
    file = read(text)
    shown = [file.text(node.value) for node in file.tree.body if isinstance(node, ast.Assign)]  # type: ignore[arg-type]
    assert shown == [s for i, value in enumerate(texts) for s in (repr(value), str(i))]


IMPORTS = """\
import os, numpy.linalg as la
from . import sibling
from ..pkg.mod import a as b, c
try:
    import cv2
except (ImportError, OSError):
    cv2 = None
try:
    import rclpy
finally:
    pass
if TYPE_CHECKING:
    from geometry_msgs.msg import Twist
else:
    import other
def f():
    import late
"""


def test_imports() -> None:
    file = read(IMPORTS)
    shown = [
        (i.module, i.names, i.level, file.source.slice(i.span), i.is_optional, i.is_for_typing, i.is_local)
        for i in file.imports
    ]
    assert shown == [
        ("os", (), 0, "os", False, False, False),
        ("numpy.linalg", (), 0, "numpy.linalg", False, False, False),
        ("", ("sibling",), 1, ".", False, False, False),
        ("pkg.mod", ("a", "c"), 2, "..pkg.mod", False, False, False),
        ("cv2", (), 0, "cv2", True, False, False),
        ("rclpy", (), 0, "rclpy", False, False, False),
        ("geometry_msgs.msg", ("Twist",), 0, "geometry_msgs.msg", False, True, False),
        ("other", (), 0, "other", False, False, False),
        ("late", (), 0, "late", False, False, True),
    ]


NAMES = """\
import a.b
from c import d as e
from f import *
x: int = 1
(y, [z]) = w, q = 1, (2,)
if x:
    def g(): global made; made = 1; inner = 2
else:
    class h: inside = 1
try:
    i = 1
except E as j:
    k = 1
with open('x') as l:
    pass
for m in [n for n in x]:
    (o := 1)
match x:
    case [p, *r] | {'j': [p], **r}:
        pass
    case str() as s:
        pass
"""


def test_top_level_names() -> None:
    file = read(NAMES)
    assert set(file.definitions) == set("aexyzwqghiklmoprs") | {"made"}
    assert [each.module for each in file.star_imports] == ["f"]
    assert not file.has_dynamic_names


@pytest.mark.parametrize(
    "text",
    [
        "def __getattr__(name): pass",
        "globals()['x'] = 1",
        "import mod\nsetattr(mod, 'x', 1)",
        "mod = import_module('mod')\nsetattr(mod, 'x', 1)",
        "setattr(sys.modules[__name__], 'x', 1)",
        "vars()['x'] = 1",
        "exec('x = 1')",
        "f(setattr)",
        "from pkg import mod\nmod.__dict__['x'] = 1",
    ],
)
def test_a_module_may_have_more_names_than_it_shows(text: str) -> None:
    assert read(text).has_dynamic_names


@pytest.mark.parametrize(
    "text",
    [
        "setattr(self, 'x', 1)",
        "setattr(cls, 'x', 1)",
        "setattr(a.b, 'x', 1)",
        "print(vars(a))",
        "self.__dict__.update(x=1)",
        "setattr(message, 'x', 1)",
        "import json\nprint(json.dumps(message.__dict__))",
    ],
)
def test_what_objects_get_are_no_names_of_the_module(text: str) -> None:
    assert not read(text).has_dynamic_names


@pytest.mark.parametrize(
    "text, at, grammar",
    [
        ("x = 1\nprint 'hello'\n", "print", False),
        ("def f(:\n    pass\n", ":", False),
        ("x = (1,\n", "(", False),
        ("x = 'é' 'é' y\n", "y", False),
        ("\0", "", False),
        ("async with = 1", "=", False),
    ],
)
def test_what_is_no_python(text: str, at: str, grammar: bool) -> None:
    with pytest.raises(UnreadableError) as caught:
        read(text)
    found = caught.value.unreadable
    assert text[found.span.start :].startswith(at)
    assert found.grammar is grammar


@pytest.mark.parametrize(
    "condition, expected",
    [
        ("platform.system() in ['Linux', 'Darwin']", (False, True)),
        ("platform.system().lower() != 'windows'", (False, True)),
        ("os.name == 'nt'", (True, False)),
        ("sys.platform.startswith('linux')", (False, True)),
        ("not sys.platform == 'linux2'", (True, False)),
        ("'win' in sys.platform", (True, False)),
        ("sys.platform == name", (True, True)),
        ("sys.version_info > (3, 8)", (True, True)),
        ("platform.machine() == 'aarch64'", (True, True)),
        ("'linux' in names", (False, False)),
    ],
)
def test_what_linux_imports_is_not_optional(condition: str, expected: tuple[bool, bool]) -> None:
    file = read(f"if {condition}:\n    import a\nelse:\n    import b\n")
    assert tuple(each.is_optional for each in file.imports) == expected
