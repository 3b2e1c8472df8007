"""What rosidl says of interface files: kinds, primitive types, names, and words that generated code can't use.

Sources: rosidl_adapter/parser.py and its templates (Humble to Rolling read the same grammar), OMG IDL 4.2 table 7-6,
the C++20 and Python 3 keyword lists, ros2/rosidl_python#96 and ros2/rosidl#272 for what becomes of keywords.
"""

from __future__ import annotations

import keyword
from functools import lru_cache

from ..lazy_regex import regex
from .read_table import pairs, words

KINDS = ("msg", "srv", "action")
"""The folders, and the suffixes of the files in them."""

SEPARATORS = {"msg": 0, "srv": 1, "action": 2}
"""How many lines `---` a file of a kind has."""

SECTIONS = {"msg": ("",), "srv": ("_Request", "_Response"), "action": ("_Goal", "_Result", "_Feedback")}

INTEGERS = {
    **{f"int{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in (8, 16, 32, 64)},
    **{f"uint{bits}": (0, 2**bits - 1) for bits in (8, 16, 32, 64)},
    "byte": (0, 255),
    "char": (0, 255),
}
"""Each integer type with its smallest and its largest value."""

FLOATS = frozenset({"float32", "float64"})
STRINGS = frozenset({"string", "wstring"})
PRIMITIVES = frozenset({"bool", *INTEGERS, *FLOATS, *STRINGS})

ROS1_TYPES = {
    "time": "builtin_interfaces/Time",
    "duration": "builtin_interfaces/Duration",
    "Header": "std_msgs/Header",
}
"""What ROS 1 knew without a package. rosidl reads the first two, and has nothing to generate for them."""

FOREIGN_TYPES = pairs("interface_words.txt", "foreign types")
"""Types of C, Python, and std_msgs that people write where rosidl has its own name."""

PACKAGE_NAME = regex(r"(?!.*__)(?!.*_\Z)[a-z][a-z0-9_]*")
FIELD_NAME = PACKAGE_NAME
INTERFACE_NAME = regex(r"[A-Z][A-Za-z0-9]*")
CONSTANT_NAME = regex(r"[A-Z](?:_?[A-Z0-9])*")
"""The same words as rosidl's own pattern, which takes exponential time on long ones that it refuses."""

GENERATED_PREFIX = "Sample_"
GENERATED_SUFFIXES = ("_Request", "_Response", "_Goal", "_Result", "_Feedback")
"""What rosidl strips, in this order, before it judges the name of an interface."""

PYTHON_KEYWORDS = frozenset(keyword.kwlist)

CPP_KEYWORDS = words("interface_words.txt", "C++")
IDL_KEYWORDS = words("interface_words.txt", "IDL")


def valid_interface_name(name: str) -> bool:
    """Return whether rosidl takes a name: CamelCase, after it took off what it adds itself."""
    name = name.removeprefix(GENERATED_PREFIX)
    for suffix in GENERATED_SUFFIXES:
        name = name.removesuffix(suffix)
    return INTERFACE_NAME.fullmatch(name) is not None


OF_INTERFACES = regex(r"[a-z]\w*_(?:msgs|srvs|actions|interfaces)")
"""What packages of interfaces are called, and nothing else."""

GROUP = "rosidl_interface_packages"
"""The group that every package with interfaces is a member of."""

GENERATORS = ("rosidl_default_generators", "rosidl_core_generators")
"""What such a package builds with: the first for all, the second for those that the first is built on."""

RUNTIMES = ("rosidl_default_runtime", "rosidl_core_runtime")


WORD_START, WORD_END = regex(r"(.)([A-Z][a-z]+)"), regex(r"([a-z0-9])([A-Z])")


@lru_cache(maxsize=4096)
def header_name(name: str) -> str:
    """Return the name of the header that rosidl generates for an interface: `set_mode` for `SetMode`."""
    return WORD_END.sub(r"\1_\2", WORD_START.sub(r"\1_\2", name)).lower()
