"""A loop that changes nothing any more is left after some rounds; one that does may go on."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.python.evaluate.endless_loops import ENDLESS, rounds_of
from rospkg_cli.languages.python.evaluate.evaluator import Evaluator
from rospkg_cli.languages.python.evaluate.limits import CostMeter, LimitError
from rospkg_cli.languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from rospkg_cli.languages.python.evaluate.values import Mapping, Namespace, Sequence, Text, Unknown
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.source import Source, Span
from rospkg_cli.tree import MemoryTree

HERE, THERE = Span(0, 1), Span(1, 2)


def rounds(change: Callable[[Namespace, int], object], **names: object) -> int:
    """Return after how many rounds the loop is left, at most 500."""
    scope = Namespace()
    scope.names.update(names)  # type: ignore[arg-type]
    done = 0
    try:
        with CostMeter().running():
            for number in rounds_of(scope):
                change(scope, number)
                done += 1
                if done == 500:
                    break
    except LimitError:
        pass
    return done


@pytest.mark.parametrize(
    "change",
    [
        lambda scope, number: None,
        lambda scope, number: scope.bind("a", Unknown(HERE, f"round {number}")),
        lambda scope, number: scope.bind("b", Text(HERE, "same", HERE)),
    ],
)
def test_a_loop_that_changes_nothing_is_left(change: Callable[[Namespace, int], object]) -> None:
    assert rounds(change) == ENDLESS + 1


@pytest.mark.parametrize(
    "change",
    [
        lambda scope, number: scope.bind("a", Unknown(Span(number, number), "it moves")),
        lambda scope, number: scope.bind("a", Text(HERE, str(number), HERE)),
        lambda scope, number: scope.bind(f"a{number}", Unknown(HERE, "one more")),
        lambda scope, number: scope.names["list"].items.append(Unknown(HERE, "")),
        lambda scope, number: scope.names["map"].items.update({number: (Unknown(HERE, ""), Unknown(HERE, ""))}),
    ],
)
def test_a_loop_that_changes_something_goes_on(change: Callable[[Namespace, int], object]) -> None:
    assert rounds(change, list=Sequence(HERE, "list"), map=Mapping(HERE)) == 500


def test_a_loop_that_ends_late_ends() -> None:
    text = "n = 0\nwhile True:\n    n += 1\n    if n > 300:\n        break\nx = n"
    file = parse_python(Source("x.py", text))
    found = Evaluator(file, SandboxFilesystem(PackageFiles(MemoryTree({}))))
    found.run_file()
    assert str(getattr(found.get("x"), "value", None)) == "301"
