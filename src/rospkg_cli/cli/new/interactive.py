"""`rospkg new --interactive`: a question for every option that was not given, each with its default."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from ...control_characters import visible
from ...light_dataclasses import field_names, replace
from ...scaffold import ScaffoldError
from ...scaffold.answers import Request
from ...scaffold.names import check_package_name
from ...scaffold.plan import Plan, make_plan, template_of
from .. import UsageError
from ..streams import say
from .questions import QUESTIONS, Question
from .summary import summary_lines

OPTIONS = {
    "template": "--type", "nodes": "--node", "plugins": "--plugin", "msgs": "--msg", "srvs": "--srv",
    "actions": "--action", "extras": "--with", "own_template": "--template",
    "parameters": "--params",
}  # fmt: skip
"""The options whose names differ from those of the request's fields."""


def ask(request: Request, folder: Path, defaults: Mapping[str, str]) -> Request:
    """Return the request with what was answered; raises UsageError where the answers end too soon."""
    while not request.name:
        request = answered(Question("name", "Package name"), request, lambda asked: check_package_name(asked.name), "")
    known = request.with_defaults(defaults)
    for question in QUESTIONS:
        template = template_of(request.template)
        typed = question.field != "template" and getattr(request, question.field)
        if typed or (question.field == "template" and request.template != Request.template):
            continue
        if request.own_template or not question.applies(template):
            continue
        show(choice_lines(question.choices(template)))
        default = str(getattr(known, question.field) or question.default(request, folder))
        request = all_answers(question, request, lambda asked: make_plan(asked, folder, defaults), default)
    return request


def choice_lines(choices: Mapping[str, str]) -> Iterator[str]:
    width = max(map(len, choices), default=0)
    return (f"  {name:<{width}}  {meaning}" for name, meaning in choices.items())


def all_answers(question: Question, request: Request, check: Callable[[Request], object], default: str) -> Request:
    found = answered(question, request, check, default)
    while question.each and found != request:
        request, found = found, answered(question, found, check, "")
    return found


def answered(question: Question, request: Request, check: Callable[[Request], object], default: str) -> Request:
    """Ask until there is an answer that holds; nothing answered leaves the request as it is."""
    while True:
        text = read_line(f"{question.text}{f' [{default}]' if default else ''}: ", question.text)
        if not text:
            return request
        value: Any = text
        if isinstance(getattr(request, question.field), tuple):
            more = (text,) if question.each else tuple(part.strip() for part in text.split(",") if part.strip())
            value = (*getattr(request, question.field), *more)
        asked = replace(request, **{question.field: value})
        try:
            check(asked)
        except ScaffoldError as error:
            say(str(error))
            continue
        return asked


def show(lines: Iterable[str]) -> None:
    """Print to stderr, where the questions are."""
    for line in lines:
        print(visible(line), file=sys.stderr)


def read_line(prompt: str, what: str) -> str:
    """Return one line from stdin; the prompt goes to stderr."""
    print(visible(prompt), end="", file=sys.stderr, flush=True)
    text = sys.stdin.readline()
    if not text:
        print(file=sys.stderr)
        raise UsageError(f"the answers ended at `{what}`; nothing was written")
    return text.strip()


def is_confirmed(plans: Sequence[Plan], into: Path, files: int) -> bool:
    """Show what was chosen, and return whether it is to be written; asked again until the answer is yes or no."""
    for plan in plans:
        show(summary_lines(plan, into))
    question = "Write this file?" if files == 1 else f"Write these {files} files?"
    while (answer := read_line(f"{question} [Y/n] ", question).lower()) not in ("", "y", "yes", "n", "no"):
        show(["Answer y or n."])
    return answer in ("", "y", "yes")


def command_of(request: Request) -> str:
    """Return the command that asks for the same without questions."""
    return shlex.join(["rospkg", "new", request.name, *words_of(request)])


def words_of(request: Request) -> Iterator[str]:
    default = Request(request.name)
    for name in field_names(request):
        value = getattr(request, name)
        if value == getattr(default, name):
            continue
        if name == "params":
            yield "--no-params"
            continue
        if name == "minimal":
            yield "--minimal"
            continue
        for each in value if isinstance(value, tuple) else (str(value),):
            yield from (OPTIONS.get(name, f"--{name}"), each)
