"""PRM009 invalid-parameter-library."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.library_definitions import library_faults
from ...edits.fault_hits import hits
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...package.params.parameter_library import ParameterLibrary
from ...rule import rule

GOOD = """\
my_pkg:
  rate:
    type: double
    default_value: 10.0
    validation:
      gt<>: [0.0]
  names:
    type: string_array
    default_value: ["left", "right"]
"""
FILES = {
    "CMakeLists.txt": CMAKE.replace(
        "ament_package",
        "find_package(generate_parameter_library REQUIRED)\n"
        "generate_parameter_library(parameters src/parameters.yaml)\nament_package",
    ),
    "package.xml": manifest("  <depend>generate_parameter_library</depend>\n", "ament_cmake"),
}


def example(bad: str, good: str) -> Example:
    return Example(
        on="ament_cmake",
        bad={**FILES, "src/parameters.yaml": GOOD.replace(good, bad)},
        good={"src/parameters.yaml": GOOD},
    )


@rule(
    "PRM009",
    "invalid-parameter-library",
    over=ParameterLibrary,
    severity=Severity.ERROR,
    examples=(
        example("type: «float»", "type: double"),
        example("default_value: «1e-3»", "default_value: 10.0"),
        example('default_value: «"left"»', 'default_value: ["left", "right"]'),
        example("«greater_than<>»: [0.0]", "gt<>: [0.0]"),
        example("«default»: 10.0", "default_value: 10.0"),
        example("«gt<>»: [0.0, 1.0]", "gt<>: [0.0]"),
    ),
)
def invalid_parameter_library(library: ParameterLibrary) -> Iterator[Hit]:
    """
    ## What it does
    Finds invalid definitions for `generate_parameter_library`.
    Every parameter has a type that exists, a default of that type (as PyYAML reads it: `1e-3` is a string, `1.0e-3` a
    number), fields and validators that exist, these with as many arguments as they take. The same holds for
    `generate_parameter_module`.

    ## Why is this bad?
    The generator stops the build with a traceback, or writes a header that does not compile.

    ## When it is quiet
    Only files that CMakeLists.txt or setup.py hand to the generator are judged. Types and validators of your own, with
    a namespace, are believed.

    ## References
    https://github.com/PickNikRobotics/generate_parameter_library
    """
    yield from hits(library.path, library_faults(library))
