"""What rcl makes of a scalar, and what PyYAML makes of it: they differ, and both read parameter files.

Sources: get_value() of rcl_yaml_param_parser/src/parse.c (strtoll with base 0, then strtod); PyYAML's resolvers, which
are those of YAML 1.1.
"""

from __future__ import annotations

import re
from typing import Literal

from ...languages.yaml.nodes import ScalarNode
from ...lazy_regex import regex

ValueType = Literal["bool", "int", "double", "string"]

TRUE = frozenset("Y y yes Yes YES true True TRUE on On ON".split())
FALSE = frozenset("N n no No NO false False FALSE off Off OFF".split())
STRING_TAG = "tag:yaml.org,2002:str"

INTEGER = regex(r"[+-]?(?:0[xX][0-9a-fA-F]+|0[0-7]*|[1-9][0-9]*)")
DOUBLE = regex(
    r"[+-]?(?:(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
    r"|0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)(?:[pP][+-]?[0-9]+)?"
    r"|inf|infinity|nan(?:\(\w*\))?)",
    re.IGNORECASE,
)
SPECIAL = regex(r"\.(?:nan|NaN|NAN)|[+-]?\.(?:inf|Inf|INF)")

YAML_INTEGER = regex(
    r"[-+]?0b[0-1_]+|[-+]?0[0-7_]+|[-+]?(?:0|[1-9][0-9_]*)|[-+]?0x[0-9a-fA-F_]+|[-+]?[1-9][0-9_]*(?::[0-5]?[0-9])+"
)
YAML_DOUBLE = regex(
    r"[-+]?(?:[0-9][0-9_]*)\.[0-9_]*(?:[eE][-+][0-9]+)?|\.[0-9][0-9_]*(?:[eE][-+][0-9]+)?"
    r"|[-+]?[0-9][0-9_]*(?::[0-5]?[0-9])+\.[0-9_]*|[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN)"
)


def type_of(scalar: ScalarNode) -> ValueType:
    """Return the type of the parameter that rcl makes of a scalar."""
    text = scalar.text
    if scalar.is_quoted or scalar.tag == STRING_TAG:
        return "string"
    if text in TRUE or text in FALSE:
        return "bool"
    if INTEGER.fullmatch(text) and -(2**63) <= integer(text) < 2**63:
        return "int"
    if SPECIAL.fullmatch(text) or (DOUBLE.fullmatch(text) and is_finite(text)):
        return "double"
    return "string"


def integer(text: str) -> int:
    """Return what strtoll makes of it: a leading zero means octal."""
    sign, digits = (-1 if text[0] == "-" else 1), text.lstrip("+-")
    if digits[:2] in ("0x", "0X"):
        return sign * int(digits[2:], 16)
    return sign * (int(digits, 8) if digits[0] == "0" else int(digits[:40]))


def is_finite(text: str) -> bool:
    """Return whether strtod takes it without an overflow or an underflow."""
    bare = text.lower().lstrip("+-")
    if bare.startswith(("inf", "nan", "0x")):
        return True
    number = float(text)
    mantissa = re.split("[eE]", bare)[0]
    return abs(number) != float("inf") and (abs(number) >= 2.3e-308 or not mantissa.strip("0."))


def yaml_type(text: str) -> ValueType:
    """Return what PyYAML makes of a plain scalar, as far as numbers go; everything else is a string here."""
    if YAML_DOUBLE.fullmatch(text):
        return "double"
    return "int" if YAML_INTEGER.fullmatch(text) else "string"
