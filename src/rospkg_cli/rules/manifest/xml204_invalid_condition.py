"""XML204 invalid-condition."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.read_sentences import syntax_sentence
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...languages.rep149_syntax import Comparison, Operand, parse_condition
from ...languages.syntax_problem import SyntaxProblemError
from ...languages.xml.elements import Attribute
from ...package.manifest import Manifest
from ...ros.manifest import ENVIRONMENT
from ...rule import rule
from ...source import Span
from ...suggest import did_you_mean, near_names

PREFIX = "ROS_"
GOOD = manifest('  <exec_depend condition="$ROS_DISTRO == jazzy">tf2_ros</exec_depend>\n')


@rule(
    "XML204",
    "invalid-condition",
    over=Manifest,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the condition can be read, and does not mean what it seems to",
        Severity.INFO: "it asks for a variable that no ROS environment has, and that users must set",
    },
    examples=(
        Example(
            bad={"package.xml": GOOD.replace("== jazzy", "«=» jazzy")},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": GOOD.replace("$ROS_DISTRO ==", "«ROS_DISTRO» ==")},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": GOOD.replace("$ROS_DISTRO ==", "«$ROS_DISTR» ==")},
            good={"package.xml": GOOD},
        ),
    ),
)
def invalid_condition(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds invalid or misleading `condition` attributes (REP-149).
    A condition is made of comparisons (`==`, `!=`, `<`, `<=`, `>`, `>=`) of `$VARIABLE`s and values, `and`, `or`, and
    parentheses. Misleading are a variable without `$`, one that is spelled nearly like `$ROS_DISTRO`, and numbers
    compared by size.

    ## Why is this bad?
    colcon prints a traceback for a condition that it can't read, then builds the folder as a plain package and ends
    with success. A name without `$` is a string like any other and never equal to `jazzy`; all values are compared as
    strings, so that `10` is less than `9`.

    ## When it is quiet
    Conditions may ask for any variable of the environment: one of your own is an info, once a package.

    ## References
    - [REP-149, condition](https://ros.org/reps/rep-0149.html)
    """
    own: dict[str, list[Span]] = {}
    for attribute in manifest.conditions:
        try:
            condition = parse_condition(attribute.value)
        except SyntaxProblemError as error:
            why = syntax_sentence(error.problem)
            message = (
                f"`{attribute.value}` is no condition: {why}; colcon builds the folder as a plain "
                f'package; write it as in `condition="$ROS_VERSION == 2"`'
            )
            yield Hit(manifest.path, place(manifest, attribute, error.problem.span.start), message)
            continue
        for comparison in condition.comparisons():
            if found := misleading_part(comparison):
                at, length, message = found
                span = place(manifest, attribute, at, length)
                yield Hit(manifest.path, span, message, Severity.WARNING)
            for each in own_variables(comparison):
                own.setdefault(each.text, []).append(place(manifest, attribute, each.at, len(each.text) + 1))
    for name, spans in own.items():
        message = f"`${name}` is no variable of a ROS environment: whoever builds must set it; say so in the README"
        others = tuple(Related(manifest.path, span, "and here") for span in spans[1:])
        yield Hit(manifest.path, spans[0], message, Severity.INFO, others)


def place(manifest: Manifest, attribute: Attribute, at: int, length: int = 0) -> Span:
    """Return the span of a part of an attribute's value; all of it where references make the value another one."""
    if not attribute.value or manifest.source.slice(attribute.value_span) != attribute.value:
        return attribute.value_span if attribute.value else attribute.span
    at = min(at, len(attribute.value) - 1)
    length = length or len(attribute.value[at:].split()[0] if attribute.value[at:].strip() else " ")
    start = attribute.value_span.start + at
    return Span(start, start + length)


def own_variables(comparison: Comparison) -> Iterator[Operand]:
    """Yield the variables of a comparison that only the users of a package can set."""
    for each in (comparison.left, comparison.right):
        if each.is_variable and each.text not in ENVIRONMENT and not is_near_miss(each):
            yield each


def is_near_miss(operand: Operand) -> bool:
    """Return whether a variable is written nearly like one of a ROS environment."""
    is_other = operand.is_variable and operand.text not in ENVIRONMENT
    edits = 2 if operand.text.startswith(PREFIX) else 1  # GZ_VERSION is another one than ROS_VERSION
    return is_other and bool(near_names(operand.text, ENVIRONMENT, edits))


def misleading_part(comparison: Comparison) -> tuple[int, int, str] | None:
    """Return the offset and length of what is misleading in a comparison, and why; None where nothing is."""
    operands = (comparison.left, comparison.right)
    for each in operands:
        if not each.is_variable and not each.is_quoted and each.text in ENVIRONMENT:
            why = f"`{each.text}` is a string here, not the variable; write `${each.text}`"
            return each.at, len(each.text), why
        if is_near_miss(each):
            why = f"`${each.text}` is no variable of a ROS environment{did_you_mean(each.text, ENVIRONMENT)}"
            return each.at, len(each.text) + 1, f"{why}; where it is not set, the condition compares with nothing"
    numbers = [each for each in operands if not each.is_variable and each.text.replace(".", "").isdecimal()]
    if numbers and "<" not in comparison.operator and ">" not in comparison.operator:
        return None
    for each in numbers:
        if len(each.text) > 1:
            why = f"`{comparison.operator}` compares strings, not numbers: `10` comes before `9`; compare with `==`"
            return each.at, len(each.text), why
    return None
