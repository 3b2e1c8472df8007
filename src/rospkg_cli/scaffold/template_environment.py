"""The environment of jinja2 in which a template is rendered, with its filters."""

from __future__ import annotations

from functools import cache
from typing import Any

from jinja2 import Environment, StrictUndefined

from .bounds import BoundedEnvironment
from .code_filters import in_order, includes, long_line
from .template import Template
from .template_loader import SourceLoader
from .user_text import (
    UnescapedError,
    UserText,
    comment,
    cpp,
    markdown,
    plain,
    python,
    python_argument,
    xml,
    yaml,
)

FILTERS = {
    "comment": comment,
    "cpp": cpp,
    "in_order": in_order,
    "includes": includes,
    "long_line": long_line,
    "markdown": markdown,
    "plain": plain,
    "python": python,
    "python_argument": python_argument,
    "xml": xml,
    "yaml": yaml,
}

BRACKETS: dict[str, Any] = {
    "variable_start_string": "[[",
    "variable_end_string": "]]",
    "block_start_string": "[%",
    "block_end_string": "%]",
    "comment_start_string": "[#",
    "comment_end_string": "#]",
}


@cache
def make_environment(template: Template, brackets: bool = False) -> Environment:
    environment = BoundedEnvironment(  # a template may be a stranger's
        **(BRACKETS if brackets else {}),
        loader=SourceLoader([str(folder) for folder in template.folders]),
        undefined=StrictUndefined,
        autoescape=False,  # each text names the language of its file
        finalize=escaped_only,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters.update(FILTERS)
    return environment


def escaped_only(value: object) -> object:
    """Return a value; raises UnescapedError for a user's text that no filter has escaped."""
    if isinstance(value, UserText):
        raise UnescapedError(str(value))
    return value
