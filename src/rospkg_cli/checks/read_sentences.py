"""The sentences on files that can't be read, and on syntax that readers refuse."""

from __future__ import annotations

from collections.abc import Sequence

from ..languages.syntax_problem import SyntaxProblem
from ..package.install_table import UnknownPart
from ..read_problem import ReadProblem
from ..unreadable import Unreadable

NOT_CMAKE = {
    ReadProblem.CMAKE_CONFLICT: "`{0}` is left from a merge conflict",
    ReadProblem.CMAKE_SAME_LINE: "`{0}` follows a command in the same line: CMake wants a new line for each command",
    ReadProblem.CMAKE_CLOSES_NOTHING: "`)` closes nothing",
    ReadProblem.CMAKE_NO_COMMAND: "`{0}` is where a command should begin",
    ReadProblem.CMAKE_OPEN_QUOTE: '`"` is never closed',
    ReadProblem.CMAKE_OPEN_QUOTE_BEFORE: '`"` is never closed: the string goes on into the next command',
    ReadProblem.CMAKE_OPEN_BRACKET: "`{0}` is never closed",
    ReadProblem.CMAKE_CHARACTER: "`{0}` is not a character that CMake allows here",
    ReadProblem.CMAKE_NO_PARENTHESIS: "`{0}` is followed by no `(`: a command is `name(arguments)`",
    ReadProblem.CMAKE_OPEN_PARENTHESIS: "`{0}(` is never closed: a `)` is missing",
    ReadProblem.CMAKE_NO_BLANK: "a blank is missing before this argument",
    ReadProblem.CMAKE_OUTSIDE: "`{0}` is outside of any `{1}`",
    ReadProblem.CMAKE_WRONG_END: "`{0}` is where `{1}` should close `{2}`",
    ReadProblem.CMAKE_OPEN_BLOCK: "`{0}` is never closed: `{1}()` is missing",
}
NOT_XML = {
    ReadProblem.XML_OPEN: "`<{0}>` is never closed",
    ReadProblem.XML_EMPTY: "the file is empty",
    ReadProblem.XML_MISMATCH: "`<{0}>` is closed by `</{1}>`",
    ReadProblem.XML_AFTER_ROOT: "something follows after the end of the root element",
    ReadProblem.XML_DECLARATION: "the `<?xml …?>` line must be the very first of the file",
    ReadProblem.XML_AMPERSAND: "a lone `&`; write `&amp;`",
    ReadProblem.XML_LESS_THAN: "a `<` that begins no tag, inside `<{0}>`; write `&lt;`",
    ReadProblem.XML_OTHER: "{0}",
    ReadProblem.XML_OTHER_INSIDE: "{0}, inside `<{1}>`",
    ReadProblem.XML_NUL: "it holds a NUL character; save it as UTF-8",
    ReadProblem.XML_PREFIX: "the prefix of `{0}` is declared nowhere (`xmlns:{1}`)",
}
SKIPPED = {
    ReadProblem.PYTHON_LENGTH: "it has more than {0} tokens; leave generated files out with `exclude`",
    ReadProblem.PYTHON_DEPTH: "its code is nested deeper than {0} levels; spread it over several statements",
    ReadProblem.XML_LENGTH: "it has more than {0} elements; leave generated files out with `exclude`",
    ReadProblem.XML_ATTRIBUTES: "`<{0}>` has more than {1} attributes",
    ReadProblem.LAUNCH_LENGTH: "the launch files of the package have more than {0} characters together",
    ReadProblem.CFG_LENGTH: "it has more than {0} characters",
    ReadProblem.CFG_BLANKS: "it has a line with more than 200 blanks in a row; take them out",
}
NOT_CFG = {
    ReadProblem.CFG_NO_SECTION: "an option before the first `[section]`",
    ReadProblem.CFG_LINE: "neither a `[section]` nor an `option = value`",
    ReadProblem.CFG_OPTION_TWICE: "`{0}` stands twice in `[{1}]`",
    ReadProblem.CFG_SECTION_TWICE: "`[{0}]` stands twice",
    ReadProblem.CFG_OTHER: "{0}",
}
SENTENCES = {
    **{code: f"`{{path}}` is not valid CMake: {why}" for code, why in NOT_CMAKE.items()},
    **{code: f"`{{path}}` is not well-formed XML: {why}" for code, why in NOT_XML.items()},
    **{code: f"`{{path}}` is skipped: {why}" for code, why in SKIPPED.items()},
    **{code: f"`{{path}}` can't be read: {why}; setuptools stops there" for code, why in NOT_CFG.items()},
    ReadProblem.ENCODING: "`{path}` is not valid {0} (byte {1}); save it as UTF-8",
    ReadProblem.UNDECODABLE: "`{path}`: {0}",
    ReadProblem.SKIPPED: "{0}",
    ReadProblem.NO_ACCESS: "`{path}` can't be read: {0}",
    ReadProblem.LFS_POINTER: "`{path}` is a pointer of Git LFS, not the file itself: `git lfs pull` fetches that",
    ReadProblem.GIT_CRYPT: "`{path}` is encrypted by git-crypt: `git-crypt unlock` makes it readable",
    ReadProblem.READER_CRASH: "the reader of {0} failed",
    ReadProblem.CMAKE_LENGTH: (
        "`{path}` is not read: it has more than {0} characters; split what is generated in it off"
    ),
    ReadProblem.PYTHON_TOO_DEEP: "`{path}` is nested too deeply to be read",
    ReadProblem.PYTHON_VALUE: "`{path}` is not Python: {0}",
    ReadProblem.PYTHON_SYNTAX: "`{path}` is not valid Python: {0}",
    ReadProblem.XML_CONFLICT: "`{path}` holds a merge conflict (`{0}`); resolve it",
    ReadProblem.XML_DOCTYPE: "`{path}` has a DOCTYPE; entities and document types are not read: remove it",
    ReadProblem.XML_DEPTH: "`{path}` is nested deeper than {0} elements",
    ReadProblem.YAML_TAB: "`{path}` is not valid YAML: a tab; YAML is indented with spaces",
    ReadProblem.YAML_SYNTAX: "`{path}` is not valid YAML: {0}",
    ReadProblem.YAML_UNREADABLE: "`{path}` is not valid YAML: it can't be read",
    ReadProblem.YAML_DEPTH: "`{path}` is nested deeper than {0} levels",
    ReadProblem.YAML_DOCUMENTS: "`{path}` is not one YAML document: another one begins here",
    ReadProblem.YAML_SIZE: "`{path}` is nested too deeply, or too large",
    ReadProblem.YAML_ALIAS: "`{path}` is not valid YAML: found undefined alias '{0}'",
    ReadProblem.CONDITION_TOKEN: "`{0}` is not expected",
    ReadProblem.CONDITION_DEPTH: "more than {0} parentheses",
    ReadProblem.CONDITION_PARENTHESIS: "`)` is missing",
    ReadProblem.CONDITION_COMPARISON: "a comparison (`==`, `!=`, `<`, `<=`, `>`, `>=`) is missing",
    ReadProblem.CONDITION_VALUE: "a `$VARIABLE` or a value is missing",
    ReadProblem.NO_PACKAGE: "`{path}` describes no package: its root element is `<{0}>`, not `<package>`",
    ReadProblem.INTERFACE_LENGTH: "`{path}` is not read: it has more than {0} characters",
    ReadProblem.LAUNCH_KEYS: "a YAML launch file has one key at its top: `launch:`",
    ReadProblem.LAUNCH_ENTRY: "an entry of a launch description is `- name:` with its attributes below",
    ReadProblem.LAUNCH_TWO_IN_ONE: (
        "`{0}` and `{1}` are in one list entry; indent it below, or begin a new one with `-`"
    ),
    ReadProblem.SUBSTITUTION_DEPTH: "more than {0} substitutions inside of each other",
    ReadProblem.SUBSTITUTION_NAME: "`$(` wants the name of a substitution right behind it",
    ReadProblem.SUBSTITUTION_OPEN: "`$({0}` is never closed",
    ReadProblem.SUBSTITUTION_CHARACTER: "`{0}` is not allowed inside of `$({1} …)`: quote it",
    ReadProblem.SUBSTITUTION_QUOTE: "the quote {0} is never closed",
    ReadProblem.SUBSTITUTION_ARGUMENT: "an argument is missing: exactly one blank separates two",
}


def what_is_wrong(file: Unreadable) -> str:
    """Return why a file can't be read, or is not."""
    return written(file.code, file.details, file.path)


def syntax_sentence(problem: SyntaxProblem) -> str:
    """Return what is wrong with a text that is a part of a file."""
    return written(problem.code, problem.details, "")


def why_unknown(part: UnknownPart) -> str:
    return part.why if isinstance(part.why, str) else what_is_wrong(part.why)


def written(code: ReadProblem, details: Sequence[str], path: str) -> str:
    return SENTENCES[code].format(*details, path=path)
