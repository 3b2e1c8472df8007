"""LCH022: arguments that well-known programs refuse when they start."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...ros.program_options import CREATE, CREATORS, OF_ENTITY, PROGRAMS, TRANSFORMS, ProgramOptions
from ...source import Span
from ...suggest import nearest
from ..fault import Fault
from .argument_words import ArgumentWord, words_of
from .static_transforms import transform_problem

NEGATIVE = regex(r"-(?:\d+|\d*\.\d+)$")
TESTING = "launch_testing"
"""In what runs tests, the model's name or place are known to be right as they are."""
ENDS = "it stops when it starts"


@dataclass(frozen=True)
class StartedPrograms:
    file: LaunchFile
    workspace: Workspace

    def faults(self) -> Iterator[Fault]:
        """Yield what the programs refuse; one of the workspace may take anything."""
        seen = set[Span]()
        for fault in node_argument_faults(self.file, self.workspace):
            if fault.span not in seen:
                seen.add(fault.span)
                yield fault


def node_argument_faults(file: LaunchFile, workspace: Workspace) -> Iterator[Fault]:
    for node in file.nodes if not file.is_ros1 and file.has_entry_point else ():
        started = (literal(node.package), literal(node.executable))
        is_known = started == TRANSFORMS or started in PROGRAMS or started in CREATORS
        words = words_of(file, node) if is_known and workspace.named(started[0]) is None else None
        if words is None:
            continue
        if started in CREATORS:
            yield from passed_over(words) if TESTING not in file.source.text else ()
            continue
        problem = transform_problem(words) if started == TRANSFORMS else option_problem(words, PROGRAMS[started])
        if problem is not None:
            word, message = problem
            whole = words[0].span if words else node.span
            yield Fault(word.span if word else whole, f"`{started[1]}` {message}: {ENDS}")


def literal(text: object) -> str:
    return getattr(text, "literal", None) or ""


def option_problem(words: Sequence[ArgumentWord], program: ProgramOptions) -> tuple[ArgumentWord | None, str] | None:
    """Return the first word that argparse refuses, or what it misses; None where all may be right."""
    given, plain, index = set[str](), 0, 0
    while index < len(words):
        word = words[index]
        option = option_of(word.text, program) if word.text else None
        if word.text is None or option in program.others:
            return None
        if option == "":
            near = nearest(word.text.split("=")[0], program.all)
            return word, f"has no option `{word.text.split('=')[0]}`" + (f", but `{near}`" if near else "")
        given.add(option or "")
        plain += option is None
        index += 2 if option in program.valued and word.text == option else 1
    for group in program.required:
        if not group & given:
            return None, f"needs {' or '.join(f'`{each}`' for each in sorted(group))}"
    return (None, f"needs {program.words}") if program.words and not plain and "-h" not in given else None


def passed_over(words: Sequence[ArgumentWord]) -> Iterator[Fault]:
    """Yield the first flag that `create` does not have."""
    index = 0
    while index < len(words):
        text = words[index].text or ""
        name = text.lstrip("-").split("=")[0]
        is_flag = text.startswith("-") and bool(name) and " " not in text and not NEGATIVE.match(text)
        if is_flag and name in CREATE.others:
            return
        if is_flag and name not in CREATE.all:
            better = OF_ENTITY.get(name) or (f"-{near}" if (near := nearest(name, CREATE.all)) else "")
            intended = f"; write `{better}`" if better else ""
            yield Fault(
                words[index].span, f"`create` has no flag `{text.split('=')[0]}` and passes over it{intended}", "info"
            )
            return
        index += 2 if is_flag and name in CREATE.valued and "=" not in text else 1


def option_of(text: str, program: ProgramOptions) -> str | None:
    """Return the option that a word is, also shortened; None for a word that is none, "" for an unknown one."""
    if not text.startswith("-") or text == "-" or " " in text or NEGATIVE.match(text):
        return None
    name = text.split("=")[0]
    known = [each for each in program.all if each == name] or [each for each in program.all if each.startswith(name)]
    short = text[:2] if text[:2] in program.all and text[1] != "-" else ""
    return min(known) if known else short
