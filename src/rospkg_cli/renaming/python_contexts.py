"""The texts of a Python file that stand for a package: by the call, the keyword or the variable that takes them."""

from __future__ import annotations

import ast
from collections.abc import Container, Iterable, Iterator

from ..languages.python.nodes import defaults_of, nodes_of
from ..lazy_regex import regex

PACKAGE = regex(r"(?i)(?:^|_)(?:pkg|package)s?(?:$|_)|package(?:s|_?name)?$|^pkg|pkg$")
"""Names of what holds a package: `package`, `pkg_name`, `description_package`."""
LOOKUP = regex(r"(?i)package|pkg|^importorskip$|^import_module$|^get_resource$|^has_resource$")
SHARED = ("share", "lib")
RUNNERS = ("run", "launch")


def named_texts(tree: ast.Module, name: str, is_setup: bool) -> Iterator[ast.Constant]:
    """Yield the texts that are a name and mean the package; in the package's own setup.py all are taken."""
    nodes = list(nodes_of(tree))
    variables = names_looked_up(nodes)
    for node in nodes:
        for holder, text in held_texts(node, variables):
            if text.value == name and (is_setup or holder):
                yield text
    if is_setup:
        for node in nodes:
            match node:
                case ast.List(elts=texts) | ast.Tuple(elts=texts):
                    yield from (each for each in texts if isinstance(each, ast.Constant) and each.value == name)


def names_looked_up(nodes: Iterable[ast.AST]) -> frozenset[str]:
    """Return the variables that calls take for a package."""
    found = set()
    for node in nodes:
        if isinstance(node, ast.Call):
            given = [each.value for each in node.keywords if PACKAGE.search(each.arg or "")]
            given += node.args[:1] if LOOKUP.search(called(node)) else []
            found |= {each.id for each in given if isinstance(each, ast.Name)}
    return frozenset(found)


def held_texts(node: ast.AST, variables: frozenset[str]) -> Iterator[tuple[bool, ast.Constant]]:
    """Yield the texts that a node holds, with whether it says that they are packages."""
    match node:
        case ast.Call():
            yield from in_call(node, variables)
        case ast.Assign(targets=[*targets], value=ast.Constant() as text):
            yield any(is_package(spelled(each), variables) for each in targets), text
        case ast.AnnAssign(target=target, value=ast.Constant() as text):
            yield is_package(spelled(target), variables), text
        case ast.Dict(keys=keys, values=values):
            for key, value in zip(keys, values, strict=True):
                if isinstance(key, ast.Constant):
                    yield False, key
                    if isinstance(value, ast.Constant):
                        yield isinstance(key.value, str) and is_package(key.value, variables), value
        case ast.arguments():
            for argument, default in defaults_of(node):
                if isinstance(default, ast.Constant):
                    yield is_package(argument.arg, variables), default
        case ast.List(elts=items) | ast.Tuple(elts=items):
            yield from behind(items, RUNNERS)


def in_call(call: ast.Call, variables: frozenset[str]) -> Iterator[tuple[bool, ast.Constant]]:
    name, is_lookup = called(call), bool(LOOKUP.search(called(call)))
    for each in call.args:
        if isinstance(each, ast.Constant):
            yield is_lookup, each
        elif is_lookup and isinstance(each, ast.List | ast.Tuple):
            yield from ((True, inner) for inner in each.elts if isinstance(inner, ast.Constant))
    if name in ("join", "PathJoinSubstitution", "joinpath", "Path"):
        lists = [each.elts for each in call.args if isinstance(each, ast.List)]
        yield from behind(lists[0] if lists else call.args, SHARED)
    first = call.args[0].value if call.args and isinstance(call.args[0], ast.Constant) else ""
    if not first:
        first = next(
            (k.value.value for k in call.keywords if k.arg == "name" and isinstance(k.value, ast.Constant)), ""
        )
    is_argument = isinstance(first, str) and is_package(first, frozenset())
    for keyword in call.keywords:
        if isinstance(keyword.value, ast.Constant):
            holds = is_package(keyword.arg or "", frozenset()) or (is_argument and keyword.arg == "default_value")
            yield holds, keyword.value
        elif isinstance(keyword.value, ast.List | ast.Tuple):
            names = is_package(keyword.arg or "", frozenset())
            yield from ((names, each) for each in keyword.value.elts if isinstance(each, ast.Constant))


def behind(items: Iterable[ast.expr], words: tuple[str, ...]) -> Iterator[tuple[bool, ast.Constant]]:
    """Yield the texts that follow one that ends with a word: `"share", "OLD"`, `"run", "OLD"`."""
    before = ""
    for each in items:
        if isinstance(each, ast.Constant) and isinstance(each.value, str):
            yield before.rpartition("/")[2] in words, each
            before = each.value
        else:
            before = ""


def executables(tree: ast.Module, package: str, names: Container[str]) -> Iterator[ast.Constant]:
    """Yield the executables with some names of nodes whose package has a name."""
    nodes = list(nodes_of(tree))
    variables = set(names_bound_to(nodes, package))
    for call in nodes:
        if isinstance(call, ast.Call):
            given = {each.arg: each.value for each in call.keywords}
            found = given.get("executable")
            if isinstance(found, ast.Constant) and found.value in names:
                match given.get("package"):
                    case ast.Constant(value=value) if value == package:
                        yield found
                    case ast.Name(id=variable) if variable in variables:
                        yield found


def run_by_command(tree: ast.Module, package: str, name: str) -> Iterator[ast.Constant]:
    """Yield an executable in lists of words: `["ros2", "run", PACKAGE, NAME]`."""
    for node in nodes_of(tree):
        match node:
            case ast.List(elts=items) | ast.Tuple(elts=items):
                words = [each.value if isinstance(each, ast.Constant) else None for each in items]
                for at in range(3, len(items)):
                    found = items[at]
                    if words[at - 2 : at + 1] == ["run", package, name] and isinstance(found, ast.Constant):
                        yield found


def names_bound_to(nodes: Iterable[ast.AST], text: str) -> Iterator[str]:
    """Yield the variables that are given a text somewhere."""
    for node in nodes:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Constant(value=value)) if value == text:
                yield name


def is_package(name: str, variables: frozenset[str]) -> bool:
    return name in variables or PACKAGE.search(name) is not None


def spelled(node: ast.expr) -> str:
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
        case _:
            return ""


def called(call: ast.Call) -> str:
    return spelled(call.func)
