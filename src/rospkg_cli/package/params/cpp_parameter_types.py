"""The types that parameters declared in C++ get: from a template argument, a default value or a variable."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from ...lazy_regex import regex
from ...source import Source

MAX_LENGTH = 500
"""Of a name, a type or a value, in characters; a longer one is unknown."""
NUMBER = regex(r"-?\s*(?:[0-9]+\.[0-9]*|\.[0-9]+|[0-9]+[eE])[0-9eE.+-]*[fFlL]?|-?\s*[0-9]+[eE.]?[fF]")
WHOLE = regex(r"-?\s*(?:0[xX][0-9a-fA-F]+|[0-9']+)[uUlLzZ]*")
TEXT = regex(r'(?:R?"[^"]*"\s*)+s?|std::string\s*[({].*[)}]')
OUTER = regex(r"(?:rclcpp::)?ParameterValue\s*[({](?P<inside>.*)[)}]", re.DOTALL)
CAST = regex(r"(?:static_cast\s*<\s*(?P<cast>[^<>]+)>|(?P<plain>double|float|int|bool|std::string))\s*[({].*[)}]")
VECTOR = regex(r"(?P<type>std::vector\s*<.*?>)\s*[({].*[)}]", re.DOTALL)
NAMED_TYPE = regex(r"(?:rclcpp::)?(?:ParameterType::)?PARAMETER_(?P<type>[A-Z_]+)")
VARIABLE = regex(r"(?:[A-Za-z_]\w*\s*(?:\.|->|::)\s*)*(?P<name>[A-Za-z_]\w*)")
TYPE = (
    r"b(?<!\wb)ool|d(?<!\wd)ouble|f(?<!\wf)loat|i(?<!\wi)nt\d*(?:_t)?|u(?<!\wu)int\d*(?:_t)?"
    r"|s(?<!\ws)(?:ize_t|td::(?:string|size_t|u?int\d*(?:_t)?|vector\s*<[\w:\s]*>))"
)
"""The type of a variable, a word of its own; alternatives begin with a literal, so that `re` skips ahead."""
TYPES = {"bool": "bool", "double": "double", "float": "double", "std::string": "string", "string": "string"}
WHOLE_TYPES = regex(
    r"(?:std::)?(?:u?int(?:8|16|32|64)?(?:_t)?|size_t)|(?:unsigned |signed )?(?:long )*(?:int|long)|unsigned"
)
LIST = regex(r"std::vector<(.*)>")
RCL_TYPES = {
    "BOOL": "bool", "INTEGER": "int", "DOUBLE": "double", "STRING": "string", "BOOL_ARRAY": "bool[]",
    "INTEGER_ARRAY": "int[]", "DOUBLE_ARRAY": "double[]", "STRING_ARRAY": "string[]",
}  # fmt: skip
VALUE = regex(
    r"""(?:(?:rclcpp::)?ParameterValue\s*[({]\s*)?(?:std::string\s*[({]\s*)?"""
    r"""(?:"(?P<text>[^"\\]*)"|(?P<word>true|false|-?\d+(?:\.\d*)?(?:[eE]-?\d+)?))[fFs]?(?:\s*[)}]){0,2}"""
)
TypeOf = Callable[[str], str]
"""The type of a variable by its name, "" where it is unknown."""


def plain_value(text: str) -> str:
    """Return a literal value, also within `rclcpp::ParameterValue(…)`; "" for any other."""
    found = VALUE.fullmatch(text.strip())
    return (found["text"] if found["text"] is not None else found["word"]) if found else ""


def typed(text: str) -> str:
    """Return the type of parameter that a C++ type becomes."""
    bare = re.sub(r"\bconst\b|&", "", " ".join(text[: MAX_LENGTH + 1].split())).strip()
    if found := LIST.fullmatch(bare.replace(" ", "") if "unsigned" not in bare else bare):
        inside = typed(found.group(1))
        return f"{inside}[]" if inside and "[" not in inside else ""
    return TYPES.get(bare) or ("int" if WHOLE_TYPES.fullmatch(bare) else "")


def inferred(text: str, type_of: TypeOf) -> str:
    """Return the type of a default value, "" where it is unknown."""
    if len(text) > MAX_LENGTH:
        return ""
    if found := OUTER.fullmatch(text):
        return inferred(found.group("inside").strip(), type_of)
    if text in ("true", "false"):
        return "bool"
    if NUMBER.fullmatch(text):
        return "double"
    if WHOLE.fullmatch(text):
        return "int"
    if TEXT.fullmatch(text):
        return "string"
    if found := NAMED_TYPE.fullmatch(text):
        return RCL_TYPES.get(found.group("type"), "")
    if found := VECTOR.fullmatch(text) or CAST.fullmatch(text):
        return typed(next(group for group in found.groups() if group))
    found = VARIABLE.fullmatch(text)
    return type_of(found.group("name")) if found else ""


def variables_of(texts: Iterable[Source], names: Iterable[str]) -> dict[str, str]:
    """Return the types of the variables of these names, if all files declare them with one type."""
    wanted = "|".join(sorted(set(names)))
    if not wanted:
        return {}
    pattern = re.compile(rf"({TYPE})[\s&]+({wanted})\b")
    found: dict[str, set[str]] = {}
    for source in texts:
        for match in pattern.finditer(source.text):
            found.setdefault(match.group(2), set()).add(typed(match.group(1)))
    return {name: types.pop() for name, types in found.items() if len(types) == 1}
