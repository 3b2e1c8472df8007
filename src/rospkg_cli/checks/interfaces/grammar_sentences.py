"""The sentences on what rosidl refuses in an interface file, and the titles of the repairs."""

from __future__ import annotations

from ...package.interfaces.grammar_problem import GrammarCode, GrammarProblem

SEPARATORS = {"msg": "no line `---`", "srv": "exactly one line `---`", "action": "exactly two lines `---`"}
PARTS = {"srv": "request and response", "action": "goal, result and feedback"}

SENTENCES = {
    GrammarCode.BYTE_ORDER_MARK: (
        "the file begins with a byte order mark, which rosidl takes for a part of the first type"
    ),
    GrammarCode.SEPARATOR_WITH_BLANKS: (
        "rosidl takes only a line that is exactly `---` for a separator, without spaces around it: the build stops here"
    ),
    GrammarCode.TOO_MANY_SEPARATORS: "a .{0} file has {separators}; this one is too many, and the build stops here",
    GrammarCode.TOO_FEW_SEPARATORS: "a .{0} file has {separators} between {parts}; here is {1}",
    GrammarCode.LEADING_BLANK: (
        "rosidl can't read a line that begins with a blank: the build stops with an IndexError"
    ),
    GrammarCode.ONE_WORD: "`{0}` lacks a blank between a type and a name",
    GrammarCode.CONSTANT_WITH_QUOTE: "rosidl reads a line with `=` as a constant; a default value can't hold one",
    GrammarCode.DEFAULT_WITH_EQUALS_SIGN: "rosidl reads a line with `=` as a constant; a default has none",
    GrammarCode.CONSTANT_TYPE: "a constant has a primitive type without bounds or brackets, not `{0}`",
    GrammarCode.BRACKETS_AT_NAME: "the brackets belong to the type, without a blank: `{0}{1} …`",
    GrammarCode.SIGN_AT_END: "a line ends without `{0}`: one field a line",
    GrammarCode.FIELD_NAME: "`{0}` is no name of a field: lowercase letters, digits and single `_`",
    GrammarCode.NUMBER_SIGN_IN_STRING: ("rosidl cuts the line at the `#`, even inside quotes: the value becomes `{0}`"),
    GrammarCode.STRING_ARRAY_NOT_ASCII: "rosidl can't write default values of string arrays that are not ASCII",
    GrammarCode.BACKSLASH_IN_STRING: (
        "rosidl decodes the backslashes in `{0}` as escapes and then can't read what it wrote; double them"
    ),
    GrammarCode.BRACKET_NOT_OPENED: "`{0}` has a `]` without a `[`; an array is `{1}[]`",
    GrammarCode.ARRAY_SIZE: "`{0}` is no size of an array: write `{1}[]`, `{1}[3]` or `{1}[<=3]`",
    GrammarCode.STRING_BOUND: "`{0}` needs a whole number above 0 behind `<=`: `{1}<=10`",
    GrammarCode.FOREIGN_TYPE: "`{0}` is no type of rosidl; the build stops here: write `{1}`",
    GrammarCode.ROS1_TYPE: "`{0}` is a type of ROS 1; rosidl can't generate it: write `{1}`",
    GrammarCode.TYPE_WITH_FOLDER: "rosidl refuses `{0}`: in an interface file it is written `{1}`",
    GrammarCode.TYPE_WITH_FOLDERS: "`{0}` is no type: write `package/Name`",
    GrammarCode.PACKAGE_NAME: "`{0}` in `{1}` can't be the name of a package: lowercase, digits and single `_`",
    GrammarCode.ARRAY_OF_ARRAYS: (
        "`{0}` is no type: an array has one pair of brackets, without spaces: `int32[]`, `int32[3]`"
    ),
    GrammarCode.TYPE_NAME: (
        "`{0}` is no type: primitive types are `bool`, `int32`, `float64`, `string` …; others are CamelCase"
    ),
    GrammarCode.INTERFACE_WITH_DEFAULT: "`{0}` can't have a default value: only primitive types can",
    GrammarCode.ARRAY_WITHOUT_BRACKETS: "the value of an array stands in brackets: `[{0}]`",
    GrammarCode.ARRAY_ELEMENTS: "`{0}` can't be split into its elements; quote each string: `['a', 'b']`",
    GrammarCode.ARRAY_TOO_LONG: "`{0}` takes at most {1} elements, not {2}",
    GrammarCode.ARRAY_LENGTH: "`{0}` takes exactly {1} elements, not {2}",
    GrammarCode.NO_BOOL: "`{0}` is no `bool`: write `true` or `false`",
    GrammarCode.NO_INTEGER: "`{0}` is no `{1}`: {2} to {3}",
    GrammarCode.NO_FLOAT: "`{0}` is no `{1}`: write it like `1.5` or `1e-3`",
    GrammarCode.QUOTE_IN_STRING: (
        "write a quote inside the string as `\\{0}`, or use the other kind of quotes around it"
    ),
    GrammarCode.STRING_TOO_LONG: "the string has {0} characters; `{1}` takes {2}",
    GrammarCode.UNIT_OVER_LINES: (
        "rosidl takes `[{0}` and the next line for a unit, and generates an .idl file with a broken string from it; "
        "keep what stands in brackets on one line, or use parentheses"
    ),
    GrammarCode.BACKSLASH_IN_COMMENT: (
        "rosidl decodes `{0}` in a comment as an escape: the build stops with a UnicodeDecodeError or a syntax "
        "error; double the backslash, or do without it"
    ),
}

TITLES = {
    GrammarCode.LEADING_BLANK: "remove the blanks",
    GrammarCode.SIGN_AT_END: "remove the `{0}`",
    GrammarCode.BACKSLASH_IN_COMMENT: "double the backslash",
}


def sentence_of(problem: GrammarProblem) -> str:
    first = problem.details[0] if problem.details else ""
    return SENTENCES[problem.code].format(
        *problem.details, separators=SEPARATORS.get(first, ""), parts=PARTS.get(first, "")
    )


def title_of(problem: GrammarProblem) -> str:
    """Return the title of the repair: what it writes, where nothing else describes it better."""
    return TITLES.get(problem.code, f"write `{problem.repair}`").format(*problem.details)
