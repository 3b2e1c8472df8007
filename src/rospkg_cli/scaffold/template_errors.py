"""What a template of one's own gets wrong: one sentence that names its file and line."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from traceback import walk_tb
from types import TracebackType

from jinja2 import TemplateError, TemplateNotFound

from ..resources import resources
from . import OwnFaultError, ScaffoldError
from .template import Template
from .user_text import UnescapedError

OTHERS = (ArithmeticError, AttributeError, LookupError, OSError, RecursionError, SyntaxError, TypeError, ValueError)


class TemplateValueError(Exception):
    """A fault in a value of template.toml; the cause says which."""

    def __init__(self, value: str) -> None:
        super().__init__(value)
        self.value = value


@contextmanager
def in_value(value: str) -> Iterator[None]:
    """Remember of which value of template.toml a fault is."""
    try:
        yield
    except (TemplateError, UnescapedError, *OTHERS) as error:
        raise TemplateValueError(value) from error


@contextmanager
def template_errors(asked: str, template: Template) -> Iterator[None]:
    """Say of which template a fault is, and where in it; raises ScaffoldError."""
    try:
        yield
    except TemplateValueError as fault:
        where = line_of(fault.value, template)
        raise ScaffoldError(f"the template `{asked}`, {where}{error_text(fault.__cause__)}") from fault
    except TemplateError as error:
        raise ScaffoldError(f"the template `{asked}`, {place_of(error, template)}{error_text(error)}") from error
    except (UnescapedError, *OTHERS) as error:
        where = place_of(error, template)
        raise ScaffoldError(f"the template `{asked}`{f', {where}' if where else ''}{error_text(error)}") from error
    except OwnFaultError as error:
        raise ScaffoldError(f"the template `{asked}`: {error}") from error


def error_text(error: BaseException | None) -> str:
    if isinstance(error, TemplateNotFound):
        return f": there is no `{error.name}`"
    if isinstance(error, TemplateError):
        return f": {error.message or type(error).__name__}"
    return f": {error}" if isinstance(error, UnescapedError) else f" fails: {type(error).__name__}: {error}"


def place_of(error: BaseException, template: Template) -> str:
    """Return file and line of the last step within the template, else within what it includes of ours; "" for none."""
    name, line = getattr(error, "filename", None), getattr(error, "lineno", None)
    if isinstance(error, TemplateError) and name and line:
        return f"{shown(str(name), template)} line {line}"
    steps = list(steps_of(error.__traceback__))
    own = [step for step in steps if Path(step[0]).is_relative_to(template.folder)]
    ours = [step for step in steps if Path(step[0]).is_relative_to(resources("templates"))]
    for name, line in (own or ours)[-1:]:
        return f"{shown(name, template)} line {line}"
    return "template.toml" if isinstance(error, TemplateError) else ""


def steps_of(traceback: TracebackType | None) -> Iterator[tuple[str, int]]:
    for frame, line in walk_tb(traceback):
        if frame.f_code.co_filename.endswith(".j2"):
            yield frame.f_code.co_filename, line


def shown(name: str, template: Template) -> str:
    for folder in (template.folder, resources("templates")):
        if Path(name).is_relative_to(folder):
            return Path(name).relative_to(folder).as_posix()
    return Path(name).name


def line_of(value: str, template: Template) -> str:
    """Return the line of template.toml in which a value begins."""
    first = value.strip().split("\n")[0]
    lines = (template.folder / "template.toml").read_text("utf-8").splitlines()
    found = [number for number, line in enumerate(lines, 1) if first in line]
    return f"template.toml line {found[0]}" if found else "template.toml"
