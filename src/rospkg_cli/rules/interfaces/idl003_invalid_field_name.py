"""IDL003 invalid-field-name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from ...checks.interfaces.member_names import is_valid, language_of, repeated, suggestion
from ...checks.interfaces.package_interfaces import InterfaceInPackage
from ...example import Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...package.interfaces.interface_file import Member
from ...rule import rule

HARM = {
    "Python": "importing the generated Python module ends with a SyntaxError",
    "C++": "the generated header does not compile",
    "OMG IDL": "rosidl takes it, but tools of DDS vendors may refuse the generated .idl file",
}


@rule(
    "IDL003",
    "invalid-field-name",
    over=InterfaceInPackage,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "rosidl may read the file, under a condition or from a list that is not known",
        Severity.INFO: "the name is a keyword of OMG IDL only",
    },
    examples=(
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "float32 «batteryLevel»\n"},
            good={"msg/Status.msg": "float32 battery_level\n"},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "uint8 «idle»=0\n"},
            good={"msg/Status.msg": "uint8 IDLE=0\n"},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "string label\nint32 «label»\n"},
            good={"msg/Status.msg": "string label\nint32 count\n"},
        ),
        Example(
            on="interfaces",
            bad={"srv/SetMode.srv": "string «from»\n---\nbool success\n"},
            good={"srv/SetMode.srv": "string source\n---\nbool success\n"},
        ),
        Example(
            on="interfaces",
            bad={"srv/SetMode.srv": "int32 count\n---\nint32[] «sequence»\n"},
            good={"srv/SetMode.srv": "int32 count\n---\nint32[] numbers\n"},
        ),
    ),
)
def invalid_field_name(scope: InterfaceInPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds fields and constants whose names are malformed, duplicate or keywords.
    Fields are lowercase with single `_` between words, constants are uppercase. Keywords of Python, C++ and OMG IDL
    count.

    ## Why is this bad?
    rosidl refuses the names and stops the build. Keywords it takes: then the generated Python module can't be
    imported, or the generated header does not compile.

    ## When it is quiet
    Where nothing reads the file: it is not in `rosidl_generate_interfaces`, or setup.py builds the package.

    ## Fix safety
    The new name is used elsewhere, in code that is not looked at.
    """
    interface = scope.interface
    path = interface.path
    if not scope.generation.may_read(path):
        return
    level = None if scope.generation.surely_reads(path) else Severity.WARNING
    for section in interface.sections:
        names = Counter(map(suggestion, section.members))
        for member in section.members:
            language = language_of(member)
            if not is_valid(member):
                yield Hit(path, member.name_span, refusal(member), level, fix=rename(path, member, names))
            elif language:
                advice = "" if language == "OMG IDL" else "; rename it"
                message = f"`{member.name}` is a keyword of {language}: {HARM[language]}{advice}"
                yield Hit(path, member.name_span, message, Severity.INFO if language == "OMG IDL" else level)
        for member, first in repeated(section):
            what = "constant" if member.is_constant else "field"
            message = f"the {what} `{member.name}` is here twice: rosidl stops the build; rename one"
            related = (Related(path, first.name_span, "the first one"),)
            yield Hit(path, member.name_span, message, level, related=related)


def refusal(member: Member) -> str:
    if not member.is_constant:
        return f"rosidl refuses the field `{member.name}`: lowercase letters, digits and single `_`, a letter first"
    message = f"rosidl refuses the constant `{member.name}`: uppercase letters, digits and single `_`"
    return f"{message}; a default value is written without `=`: `{member.type.text} {member.name.lower()} …`"


def rename(path: str, member: Member, names: Counter[str | None]) -> Fix | None:
    """Return the fix; None where another member has that name, or would get it."""
    better = suggestion(member)
    if better is None or names[better] > 1:
        return None
    return Fix(f"rename it to `{better}`", (Edit(path, member.name_span, better),), Safety.UNSAFE)
