"""What readers and parsers find wrong with a file: a code; `checks/read_sentences.py` says what each means."""

from __future__ import annotations

from enum import Enum, auto


class ReadProblem(Enum):
    """A kind of problem; after it what `details` holds."""

    ENCODING = auto()  # the encoding, the byte
    UNDECODABLE = auto()  # the codec's own text
    SKIPPED = auto()  # why, with the path
    NO_ACCESS = auto()  # the system's own text
    LFS_POINTER = auto()
    GIT_CRYPT = auto()
    READER_CRASH = auto()  # the model

    CMAKE_LENGTH = auto()  # the most characters
    CMAKE_CONFLICT = auto()  # the mark
    CMAKE_SAME_LINE = auto()  # the text
    CMAKE_CLOSES_NOTHING = auto()
    CMAKE_NO_COMMAND = auto()  # the text
    CMAKE_OPEN_QUOTE = auto()
    CMAKE_OPEN_QUOTE_BEFORE = auto()
    CMAKE_OPEN_BRACKET = auto()  # the bracket
    CMAKE_CHARACTER = auto()  # the character
    CMAKE_NO_PARENTHESIS = auto()  # the command
    CMAKE_OPEN_PARENTHESIS = auto()  # the command
    CMAKE_NO_BLANK = auto()
    CMAKE_OUTSIDE = auto()  # the command, the one that opens its block
    CMAKE_WRONG_END = auto()  # the command, the right one, the one that opened the block
    CMAKE_OPEN_BLOCK = auto()  # the command, the one that closes its block

    PYTHON_LENGTH = auto()  # the most tokens
    PYTHON_DEPTH = auto()  # the most levels
    PYTHON_TOO_DEEP = auto()
    PYTHON_VALUE = auto()  # Python's own text
    PYTHON_SYNTAX = auto()  # Python's own text

    XML_CONFLICT = auto()  # the mark
    XML_OPEN = auto()  # the tag
    XML_EMPTY = auto()
    XML_MISMATCH = auto()  # the tag, the one that closes it
    XML_AFTER_ROOT = auto()
    XML_DECLARATION = auto()
    XML_AMPERSAND = auto()
    XML_LESS_THAN = auto()  # the tag around
    XML_OTHER = auto()  # expat's own text
    XML_OTHER_INSIDE = auto()  # expat's own text, the tag around
    XML_NUL = auto()
    XML_PREFIX = auto()  # the name, its prefix
    XML_DOCTYPE = auto()
    XML_DEPTH = auto()  # the most elements
    XML_LENGTH = auto()  # the most elements
    XML_ATTRIBUTES = auto()  # the tag, the most attributes

    YAML_TAB = auto()
    YAML_SYNTAX = auto()  # the parser's own text
    YAML_UNREADABLE = auto()
    YAML_DEPTH = auto()  # the most levels
    YAML_DOCUMENTS = auto()
    YAML_SIZE = auto()
    YAML_ALIAS = auto()  # its name

    CONDITION_TOKEN = auto()  # the token
    CONDITION_DEPTH = auto()  # the most parentheses
    CONDITION_PARENTHESIS = auto()
    CONDITION_COMPARISON = auto()
    CONDITION_VALUE = auto()

    NO_PACKAGE = auto()  # the root element
    INTERFACE_LENGTH = auto()  # the most characters
    LAUNCH_LENGTH = auto()  # the most characters
    LAUNCH_KEYS = auto()
    LAUNCH_ENTRY = auto()
    LAUNCH_TWO_IN_ONE = auto()  # the second name, the first
    SUBSTITUTION_DEPTH = auto()  # the most substitutions
    SUBSTITUTION_NAME = auto()
    SUBSTITUTION_OPEN = auto()  # its name
    SUBSTITUTION_CHARACTER = auto()  # the character, the name of the substitution
    SUBSTITUTION_QUOTE = auto()  # the quote
    SUBSTITUTION_ARGUMENT = auto()

    CFG_LENGTH = auto()  # the most characters
    CFG_BLANKS = auto()
    CFG_NO_SECTION = auto()
    CFG_LINE = auto()
    CFG_OPTION_TWICE = auto()  # the option, the section
    CFG_SECTION_TWICE = auto()  # the section
    CFG_OTHER = auto()  # configparser's own text
