"""One entry point, `name = module:attribute`, parsed with the position of every part.

The grammar is that of importlib.metadata (`module` and `attribute` are dotted names, extras in brackets). From version
60 on, setuptools refuses other texts; earlier ones write them into the metadata as they are.
"""

from __future__ import annotations

from typing import Literal

from ...languages.python.evaluate.values import Sequence
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from ..package_facts import NOWHERE
from .misspelt_names import SCRIPTS, intended_group
from .setup_text import SetupText

# Both are linear: they have to fit one whole line, from its start, and neighbours share no character but blanks.
WHOLE = regex(
    r"(?P<name>[^\s=](?:[^=]*[^\s=])?)\s*=\s*(?P<module>\w+(?:\.\w+)*)"
    r"(?:\s*:\s*(?P<attribute>[^\W\d]\w*(?:\.\w+)*))?\s*(?P<extras>\[[^\]]*\])?"
)

EntryPointFault = Literal["", "no-equals", "no-attribute", "joined", "file-name", "unreadable"]


@dataclass(frozen=True)
class EntryPoint:
    group: str
    setup_text: SetupText
    name: str
    """"" where the text can't be parsed."""
    module: str = ""
    attribute: str = ""
    name_span: Span = NOWHERE
    module_span: Span = NOWHERE
    attribute_span: Span = NOWHERE
    fault: EntryPointFault = ""
    list_value: Sequence | None = None
    """The list of setup.py that it is an item of."""
    position: Span = NOWHERE
    """Its position in that list."""

    @property
    def path(self) -> str:
        return self.setup_text.path

    @property
    def text(self) -> str:
        return self.setup_text.text

    @property
    def span(self) -> Span:
        return self.setup_text.shown

    @property
    def is_script(self) -> bool:
        """Whether it makes an executable."""
        return self.group in SCRIPTS

    @property
    def intended_group(self) -> str:
        """The group of scripts that is intended and misspelt; "" for all other groups."""
        return intended_group(self.group)


def parse_entry_point(
    group: str, setup_text: SetupText, list_value: Sequence | None = None, position: Span | None = None
) -> EntryPoint:
    """Parse one entry point; what does not fit the grammar gets a `fault`."""
    setup_text = setup_text.stripped()
    position = position or setup_text.span
    match = WHOLE.fullmatch(setup_text.text)
    if match is None:
        return EntryPoint(
            group,
            setup_text,
            loose_name(setup_text.text),
            fault=fault_of(setup_text.text),
            list_value=list_value,
            position=position,
        )
    fault: EntryPointFault = ""
    if match["attribute"] is None and group in SCRIPTS:
        fault = "no-attribute"
    elif match["module"].endswith(".py") and match["attribute"] is not None:
        fault = "file-name"
    return EntryPoint(
        group,
        setup_text,
        match["name"],
        match["module"],
        match["attribute"] or "",
        setup_text.part(*match.span("name")).shown,
        setup_text.part(*match.span("module")).shown,
        setup_text.part(*match.span("attribute")).shown if match["attribute"] else setup_text.shown,
        fault,
        list_value,
        position,
    )


def loose_name(text: str) -> str:
    """Return what is left of the equals sign; "" without one."""
    head, sign, _ = text.partition("=")
    return head.strip() if sign else ""


def fault_of(text: str) -> EntryPointFault:
    """Return what is wrong with a text that does not fit the grammar."""
    if "=" not in text:
        return "no-equals"
    return "joined" if text.count("=") > 1 and text.count(":") > 1 else "unreadable"
