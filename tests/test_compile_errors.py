"""What Python's compiler refuses behind the parser, compared with the compiler itself."""

from __future__ import annotations

import ast

import pytest

from rospkg_cli.languages.python.compile_errors import compile_error
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError

REFUSED = [
    "f(a=1, a=2)",
    "class A(metaclass=B, metaclass=B):\n    pass",
    "def f(a, *, a):\n    pass",
    "lambda a, a: a",
    "return 1",
    "class A:\n    return",
    "for a in b:\n    pass\nelse:\n    break",
    "def f():\n    while True:\n        def g():\n            break",
    "with a:\n    continue",
    "nonlocal a",
    "def f():\n    a = 1\n    global a",
    "await f()",
    "def f():\n    async with a:\n        pass",
    "try:\n    pass\nexcept:\n    pass\nexcept A:\n    pass",
    "import os\nfrom __future__ import annotations",
    "if a:\n    from __future__ import annotations",
    "def f():\n    from a import *",
]
TAKEN = [
    "f(a=1, **b, **c)",
    "def f():\n    for a in b:\n        if a:\n            continue\n    return",
    "while True:\n    try:\n        break\n    except A:\n        continue\n    finally:\n        pass",
    '"""Text."""\nfrom __future__ import annotations\nfrom __future__ import division\nimport os',
    "def f():\n    global a\n    a = 1",
    "async def f():\n    async for a in b:\n        await a",
    "try:\n    from a import *\nexcept ImportError:\n    pass",
]


@pytest.mark.parametrize("text", REFUSED)
def test_what_the_compiler_refuses(text: str) -> None:
    with pytest.raises(SyntaxError):
        compile(text, "a.py", "exec", dont_inherit=True)
    assert compile_error(Source("a.py", text), ast.parse(text)) is not None


@pytest.mark.parametrize("text", TAKEN)
def test_what_the_compiler_takes(text: str) -> None:
    compile(text, "a.py", "exec", dont_inherit=True)
    assert compile_error(Source("a.py", text), ast.parse(text)) is None


def test_the_place_is_counted_in_characters() -> None:
    text = "a = 'üü'; f(b=1, b=2)"
    with pytest.raises(UnreadableError) as raised:
        parse_python(Source("a.py", text))
    unreadable = raised.value.unreadable
    assert unreadable.span.start == text.index("b=2")
    assert unreadable.grammar is False
