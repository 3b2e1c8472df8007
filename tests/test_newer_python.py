"""What a newer Python can read is no fault of the file; what none can read is told, whatever stands in its line."""

from __future__ import annotations

import sys

import pytest

from rospkg_cli.languages.python import newer_syntax
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.languages.python.newer_syntax import is_newer, needs_newer
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError

TRY = "try:\n    pass\n"

NEWER = [
    "x = a[*b]\n",
    "x: tuple[int, *Ts]\n",
    "def f(a, *args: *Ts): pass\n",
    f"{TRY}except* ValueError:\n    pass\n",
    f"{TRY}except* (A, B) as e:\n    pass\n",
    "type X = int\n",
    "type X[T: (int, str) = int, *Ts = *tuple[int], **P] = dict[T, P]\n",
    "class A: type X = int\n",
    "def f[T](a: T) -> T:\n    return a\n",
    "class A[T: int,]:\n    pass\n",
    "async def g[T, *Ts]():\n    pass\n",
    'x = f"{a["b"]}"\n',
    'x = f"{"\\n".join(a)}"\n',
    'x = f"""{\na  # } "\n}"""\n',
    "f'{a\n}'",
    'f"{f"{f"{1}"}"}"',
    'f"{x:%Y-%m}{{}}{x=}{x = !r}{a != b}{a == b}{ {1: 2}[1] }{(lambda x: 1)}" + t""',
    'x = rf"\\{a["b"]}\\d"\n',
    'f"\\N{DASH}{a["b"]}"',
    'f"{a["b"]:{c["d"]}}"',
    'return f"{a["b"]}"\n',
    "x = t'{a!r:>{w}}'\n",
    "def f(): return t''\n",
    'f"{x!r:{w}}" "s"; type X = int\n',
    f"{TRY}except A, B:\n    pass\n",
    f"{TRY}except (A, B), C:\n    pass\n",
    f"{TRY}except* A, socket.error:\n    pass\n",
    f"from socket import error\n{TRY}except OSError, error:\n    pass\n",
]

BROKEN = [
    "return (\n",
    "return x y\n",
    "return = 1\n",
    "    return 1\n  x\n",
    "break 1\n",
    "continue x\n",
    'x = f"{a" \n',
    'x = f"{}"\n',
    'x = f"{a b}"\n',
    'x = f"{a!z}"\n',
    'x = f"{!r}"\n',
    'x = f"{*a}"\n',
    'x = f"{lambda x: 1}"\n',
    'x = f"}"\n',
    'x = f"{a}" y\n',
    'x = f"{a["b"]}" )\n',
    "x = f'{a\n",
    "x = f'{a:\n}'\n",
    "return f'{a}' f'{b'\n",
    "print f'{a}'\n",
    "print 'hello', f'{a}'\n",
    "if f'{a}':\nprint(1)\n",
    "x = f'{a}'\n  y = 1\n",
    "x = tt'a'\n",
    "x = t'{a}' ?\n",
    "type X\n",
    "type X = int ?\n",
    "def f[T(x): pass\n",
    "def f[](x): pass\n",
    "def f[T](): ?\n",
    "class A[1]: pass\n",
    f"{TRY}except*:\n    pass\n",
    f"{TRY}except A as b, C:\n    pass\n",
    "except* ValueError:\n",
]

TAKEN_SINCE_3_12 = ('x = f"{*a}"\n', "x = f'{a:\n}'\n")
"""Read by some Pythons from 3.12 on, and hardly ever meant: told where the Python that runs refuses them."""


@pytest.mark.parametrize("text", NEWER)
def test_a_newer_grammar_is_no_fault(text: str) -> None:
    assert is_newer(text)


@pytest.mark.parametrize("text", BROKEN)
def test_a_mistake_is_told(text: str) -> None:
    assert not is_newer(text)
    if sys.version_info >= (3, 12) and text in TAKEN_SINCE_3_12:
        return
    with pytest.raises(UnreadableError) as caught:
        parse_python(Source("a.py", text))
    assert not caught.value.unreadable.grammar


@pytest.mark.parametrize("newer", NEWER)
@pytest.mark.parametrize("broken", ["x = (\n", "return f'{a' \n", "print 'x'\n"])
def test_a_mistake_beside_a_newer_construct_is_told(newer: str, broken: str) -> None:
    assert not is_newer(f"{newer}\n{broken}")
    assert not is_newer(f"{broken}{newer}\n")


def test_python_2_is_told() -> None:
    """Python 3.14 would take the name for a second type, but nothing defines it."""
    assert not is_newer(f"{TRY}except OSError, e:\n    print(e)\n")


def test_what_the_newest_python_refuses_is_wrong(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(newer_syntax, "RUNNING", (3, 11))
    assert needs_newer(NEWER[-1])
    monkeypatch.setattr(newer_syntax, "RUNNING", newer_syntax.NEWEST)
    assert not needs_newer(NEWER[-1])


def test_deep_and_long_text_ends() -> None:
    for text in ('f"{' * 50_000, 'f"' + "{a:" * 50_000, "def f[" * 20_000, "except (" * 20_000, "type \\\n" * 20_000):
        assert not is_newer(text)
    assert is_newer(f"from a import e\n{TRY}" + "except A, e: pass\n" * 5_000)
