"""Define and call functions and macros; run `block`."""

from __future__ import annotations

from ...lazy_regex import regex
from ...light_dataclasses import replace
from .call_stack import FunctionDefinition, LeaveError
from .command_blocks import Block
from .evaluated_command import EvaluatedCommand
from .interpreter import Interpreter
from .list_text import as_value
from .values import UNKNOWN, Value
from .variable_scope import VariableScope

AGAIN = regex(r"\$\{|\\")
"""What a macro evaluates once more where it uses an argument."""


def run_block(interpreter: Interpreter, block: Block) -> None:
    """Run `block()` in a new scope; the variables named by PROPAGATE are set outside of it too."""
    words = [word.text for word in interpreter.words(block.command)]
    names = words[words.index("PROPAGATE") + 1 :] if "PROPAGATE" in words else []
    inner = interpreter.scope = VariableScope(interpreter.scope)
    try:
        interpreter.body(block.branches[0].body)
    finally:
        interpreter.scope = inner.around or inner
    for name in names:
        interpreter.scope.set(name, inner.variables.get(name, ()))


def define_function(interpreter: Interpreter, block: Block) -> None:
    """Remember a function or a macro."""
    words = [word.text for word in interpreter.words(block.command)]
    if words and UNKNOWN not in words[0]:
        macro = block.command.name == "macro"
        function = FunctionDefinition(block.command, block.branches[0].body, interpreter.frame.path, words[1:], macro)
        interpreter.functions[words[0].lower()] = function


def call_function(interpreter: Interpreter, function: FunctionDefinition, call: EvaluatedCommand) -> None:
    """Run a function in a new scope, or a macro in the scope of its caller."""
    bound = parameter_values(interpreter, function, call)
    frame = interpreter.frame
    name = function.command.arguments[0].text
    inner = replace(frame, path=function.path, depth=frame.depth + 1, inside=name)
    inner = replace(inner, bindings=bound if function.is_macro else {})
    scope = interpreter.scope
    if not function.is_macro:
        interpreter.scope = VariableScope(scope, dict(bound))
    try:
        with interpreter.enter_frame(inner):
            interpreter.body(function.body)
    except LeaveError as leave:
        if leave.how != "return" or function.is_macro:
            raise
    finally:
        interpreter.scope = scope


def parameter_values(
    interpreter: Interpreter, function: FunctionDefinition, call: EvaluatedCommand
) -> dict[str, Value]:
    """Return the parameters of a function, ARGN, ARGV, ARGC, and ARGV0 and so on, as a call sets them."""
    words, count = call.words, len(function.parameters)
    if function.is_macro:
        words = tuple(replace(word, text=UNKNOWN, quoted=False) if AGAIN.search(word.text) else word for word in words)
    whole = any(word.text == UNKNOWN or word.maybe for word in words[:count])
    bound: dict[str, Value] = {"ARGV": as_value(words)}
    bound["ARGN"] = interpreter.unknown() if whole else as_value(words[count:])
    for index, name in enumerate(function.parameters):
        bound[name] = interpreter.unknown() if whole else as_value(words[index : index + 1])
    for index, word in enumerate(words[:20]):
        bound[f"ARGV{index}"] = interpreter.unknown() if whole else as_value([word])
    bound["ARGC"] = interpreter.unknown() if whole or call.may_have_more else (interpreter.word(str(len(words))),)
    return bound
