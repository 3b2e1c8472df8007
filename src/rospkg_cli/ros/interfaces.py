"""What rosidl says of interface files: kinds, primitive types, names, and words that generated code can't use.

Sources: rosidl_adapter/parser.py and its templates (Humble to Rolling read the same grammar), OMG IDL 4.2 table 7-6,
the C++20 and Python 3 keyword lists, ros2/rosidl_python#96 and ros2/rosidl#272 for what becomes of keywords.
"""

from __future__ import annotations

import keyword
import re

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

FOREIGN_TYPES = {
    "int": "int32", "uint": "uint32", "long": "int64", "short": "int16", "unsigned": "uint32", "float": "float32",
    "double": "float64", "boolean": "bool", "Bool": "bool", "str": "string", "String": "string", "float_t": "float32",
    "int8_t": "int8", "int16_t": "int16", "int32_t": "int32", "int64_t": "int64", "uint8_t": "uint8",
    "uint16_t": "uint16", "uint32_t": "uint32", "uint64_t": "uint64", "Int32": "int32", "Float32": "float32",
    "Float64": "float64", "Int64": "int64", "Int8": "int8", "Int16": "int16", "UInt8": "uint8", "UInt16": "uint16",
    "UInt32": "uint32", "UInt64": "uint64",
}  # fmt: skip
"""Types of C, Python, and std_msgs that people write where rosidl has its own name."""

PACKAGE_NAME = re.compile(r"(?!.*__)(?!.*_\Z)[a-z][a-z0-9_]*")
FIELD_NAME = PACKAGE_NAME
INTERFACE_NAME = re.compile(r"[A-Z][A-Za-z0-9]*")
CONSTANT_NAME = re.compile(r"[A-Z](?:_?[A-Z0-9])*")
"""The same words as rosidl's own pattern, which takes exponential time on long ones that it refuses."""

GENERATED_PREFIX = "Sample_"
GENERATED_SUFFIXES = ("_Request", "_Response", "_Goal", "_Result", "_Feedback")
"""What rosidl strips, in this order, before it judges the name of an interface."""

PYTHON_KEYWORDS = frozenset(keyword.kwlist)

CPP_KEYWORDS = frozenset(
    """alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class
    compl concept const consteval constexpr constinit const_cast continue co_await co_return co_yield decltype default
    delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline int long
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register
    reinterpret_cast requires return short signed sizeof static static_assert static_cast struct switch template this
    thread_local throw true try typedef typeid typename union unsigned using virtual void volatile wchar_t while xor
    xor_eq""".split()
)

IDL_KEYWORDS = frozenset(
    """abstract any alias attribute bitfield bitmask bitset boolean case char component connector const consumes
    context custom default double emits enum eventtype exception factory finder fixed float getraises getter home
    import in inout interface local long manages map mirrorport module multiple native object octet oneway out port
    porttype primarykey private provides public publishes raises readonly sequence setraises setter short string
    struct supports switch truncatable typedef typeid typename typeprefix union unsigned uses valuebase valuetype void
    wchar wstring int8 uint8 int16 int32 int64 uint16 uint32 uint64""".split()
)


def valid_interface_name(name: str) -> bool:
    """Return whether rosidl takes a name: CamelCase, after it took off what it adds itself."""
    name = name.removeprefix(GENERATED_PREFIX)
    for suffix in GENERATED_SUFFIXES:
        name = name.removesuffix(suffix)
    return INTERFACE_NAME.fullmatch(name) is not None


GROUP = "rosidl_interface_packages"
"""The group that every package with interfaces is a member of."""

GENERATORS = ("rosidl_default_generators", "rosidl_core_generators")
"""What such a package builds with: the first for all, the second for those that the first is built on."""

RUNTIMES = ("rosidl_default_runtime", "rosidl_core_runtime")
