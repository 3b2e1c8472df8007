"""DEP117 undefined-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.undefined_sentences import CAUGHT, ENDS, OF_TYPE, advice, of_member
from ...checks.depends.undefined_uses import UndefinedUses
from ...checks.depends.unset_members import UnsetMembers
from ...checks.depends.unwritten_parts import why_unwritten
from ...checks.depends.wrong_rclpy_calls import FOR_OLDER
from ...edits.python_imports import import_module
from ...example import Example, manifest, scripts, setup_py
from ...finding import Fix, Hit, Related, Safety, Severity
from ...ros.imports import STANDARD
from ...rule import rule

FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
NODE = """\
import time

import rclpy
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.modes = {}


def main():
    rclpy.init()
    rclpy.spin(Talker())
    time.sleep(1)
"""
LOADED = NODE.format("json.loads('{}')")
SAID = """\
from my_pkg.words import GREETING


def main():
    print(GREETING, «answer»())
"""
WORDS = "GREETING = 'hello'\n\n\ndef answer():\n    return GREETING\n"


@rule(
    "DEP117",
    "undefined-name",
    over=UndefinedUses,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is in a function that a program is shown to come to, under one condition at most, in a "
        "test, in an annotation, in a module of a library that nothing here imports, or in a program that nothing "
        "starts, while others are started",
        Severity.INFO: "no program is shown to reach it, or under several conditions alone, nothing in the package "
        "calls the function, imports the module, or installs the file, it is behind a switch that nothing turns on, it "
        "stands behind `rclpy.spin`, an attribute is read under a condition, nothing spins the node, a comment says "
        "that it is still to be written, the run ends before, at another fault or in a loop, or Python 3.8 has the "
        "name, and the repository is for Galactic or older alone",
    },
    examples=(
        Example(
            bad={**FILES, "my_pkg/talker.py": LOADED.replace("json", "«json»")},
            good={"my_pkg/talker.py": f"import json\n{LOADED}"},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={**FILES, "my_pkg/words.py": WORDS, "my_pkg/talker.py": SAID},
            good={
                "my_pkg/talker.py": SAID.replace("«answer»", "answer").replace("GREETING\n\n", "GREETING, answer\n\n")
            },
        ),
    ),
)
def undefined_name(uses: UndefinedUses) -> Iterator[Hit]:
    """
    ## What it does
    Finds names that installed Python code and tests use, and that nothing defines or imports.
    Each name is one finding of its file. Names that common modules of Python do not have are reported, too
    (`os.path.joint`, `from xml.etree import ET`), and those that a class reads of `self` while neither it, its bases
    nor any other code of the package sets them.

    ## Why is this bad?
    Nothing looks before the line runs: the build is green, and the node ends with NameError, often only in a callback
    that a rare message reaches.

    ## When it is quiet
    In files of folders for docs, tools, templates or leftovers that nothing installs, in those that import `*` from a
    package of others, that set names by `exec`, `globals()` or `setattr`, where a NameError is caught, behind a `raise`
    or `return`, and under what never holds on Linux (`os.name == 'nt'`); for names that some branch or handler binds,
    for builtins of Python 2 in a branch, for attributes of modules in one that a version of Python decides, and for
    what newer Pythons, notebooks, profilers and build tools have among the builtins.
    For `self`, also in classes that have a base of other packages but rclpy's nodes, or that nothing makes an object
    of; where code sets attributes by `setattr`, or asks for the name by `hasattr`; for names a newer rclpy may have.
    Launch files have a rule of their own, and setup.py, too.

    ## Fix safety
    Only modules of the standard library get an import; another object of that name may be intended.
    """
    for use in uses.all():
        name, file = use.found.name, use.file
        is_module = file.source.text.startswith(".", use.found.span.end)
        line = f"import {name}" if name in STANDARD and is_module else ""
        edits = import_module(file, line) if line else ()
        fix = Fix(f"add `{line}`", edits, Safety.UNSAFE) if edits else None
        ends = OF_TYPE if use.found.is_annotation else CAUGHT if use.found.is_caught else ENDS[use.when]
        left = why_unwritten(use)
        message = f"`{name}` is neither defined nor imported: {ends}{left or advice(use, line)}"
        places = tuple(Related(file.path, each.span, "here too") for each in use.others)
        yield Hit(file.path, use.found.span, message, Severity.INFO if left else LEVELS[use.when], places, fix)
    for file, each, when in uses.absent():
        ends, older = ENDS[when].replace("NameError", each.raised), FOR_OLDER if uses.is_for_older(file, each) else ""
        message = f"`{each.module}` has no `{each.name}`: {ends}{each.advice}{older}"
        yield Hit(file.path, each.span, message, Severity.INFO if older else LEVELS[when])
    for member in UnsetMembers(uses).all():
        places = tuple(Related(member.file.path, span, "here too") for span in member.others)
        level = Severity.INFO if member.is_unwritten else LEVELS[member.when]
        yield Hit(member.file.path, member.span, of_member(member), level, places)


LEVELS = {
    "certainly": None,
    "maybe": Severity.WARNING,
    **dict.fromkeys(("branch", "late", "ended", "unspun", "seldom", "unshown", "never", "aside"), Severity.INFO),
}
