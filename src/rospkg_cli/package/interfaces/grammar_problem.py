"""What rosidl refuses in an interface file, or reads otherwise than it is written: a code and what it is about.

`checks/interfaces/grammar_sentences.py` says what each means.
"""

from __future__ import annotations

from enum import Enum, auto
from typing import NamedTuple

from ...light_dataclasses import dataclass
from ...source import Span


class GrammarCode(Enum):
    """A kind of problem; after it what `details` holds."""

    BYTE_ORDER_MARK = auto()
    SEPARATOR_WITH_BLANKS = auto()
    TOO_MANY_SEPARATORS = auto()  # the kind of file
    TOO_FEW_SEPARATORS = auto()  # the kind of file, how many there are
    LEADING_BLANK = auto()
    ONE_WORD = auto()  # the line
    CONSTANT_WITH_QUOTE = auto()
    DEFAULT_WITH_EQUALS_SIGN = auto()
    CONSTANT_TYPE = auto()  # the type
    BRACKETS_AT_NAME = auto()  # the type, what is written for its name
    SIGN_AT_END = auto()  # the sign
    FIELD_NAME = auto()  # what is written for a name
    NUMBER_SIGN_IN_STRING = auto()  # what is left of the value
    STRING_ARRAY_NOT_ASCII = auto()
    BACKSLASH_IN_STRING = auto()  # the value
    BRACKET_NOT_OPENED = auto()  # the type, the same without its `]`
    ARRAY_SIZE = auto()  # the size, the type of an element
    STRING_BOUND = auto()  # the type, the same without its bound
    FOREIGN_TYPE = auto()  # the type, rosidl's; so are the next two
    ROS1_TYPE = auto()
    TYPE_WITH_FOLDER = auto()
    TYPE_WITH_FOLDERS = auto()  # the type
    PACKAGE_NAME = auto()  # the package, the type
    ARRAY_OF_ARRAYS = auto()  # the type
    TYPE_NAME = auto()  # the type
    INTERFACE_WITH_DEFAULT = auto()  # the type
    ARRAY_WITHOUT_BRACKETS = auto()  # the value without any
    ARRAY_ELEMENTS = auto()  # the value
    ARRAY_TOO_LONG = auto()  # the type, its size, how many elements there are; so has the next
    ARRAY_LENGTH = auto()
    NO_BOOL = auto()  # the value
    NO_INTEGER = auto()  # the value, the type, its smallest and its largest number
    NO_FLOAT = auto()  # the value, the type
    QUOTE_IN_STRING = auto()  # the quote
    STRING_TOO_LONG = auto()  # its length, the type, its bound
    UNIT_OVER_LINES = auto()  # its first line
    BACKSLASH_IN_COMMENT = auto()  # the escape


class ValueProblem(NamedTuple):
    """Why a value does not fit its type."""

    code: GrammarCode
    details: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class GrammarProblem:
    """A place that has a problem; `repair` replaces `repair_span`."""

    span: Span
    code: GrammarCode
    details: tuple[str, ...] = ()
    repair: str | None = None
    repair_span: Span | None = None
    is_certain: bool = True
    """Nothing but the repair can have been intended."""
