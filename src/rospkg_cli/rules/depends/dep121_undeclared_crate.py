"""DEP121 undeclared-crate."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.cargo_needs import CARGO, CargoNeeds
from ...checks.depends.name_source import is_unmet
from ...edits.brought_hits import comes_with
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

CRATE = """\
[package]
name = "my_pkg"
version = "1.0.0"
edition = "2021"

[{}dependencies]
«std_msgs» = "*"
"""
OTHERS = {"src/main.rs": "fn main() {}\n", "LICENSE": "Apache License, Version 2.0\n"}


def example(table: str, tag: str) -> Example:
    bad = {"package.xml": manifest("", "ament_cargo"), "Cargo.toml": CRATE.format(table), **OTHERS}
    good = {"package.xml": manifest(f"  <{tag}>std_msgs</{tag}>\n", "ament_cargo")}
    return Example(on="", bad=bad, good=good, fix=Safety.SAFE)


@rule(
    "DEP121",
    "undeclared-crate",
    over=CargoNeeds,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where a declared dependency brings or may bring it, an unreleased repository declares it in "
        "another package or installs it by apt, or package.xml has it in a comment or for older distributions alone"
    },
    examples=(example("", "depend"), example("dev-", "test_depend")),
)
def undeclared_crate(needs: CargoNeeds) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages of interfaces that Cargo.toml depends on and package.xml does not declare.
    These are crates of any version (`std_msgs = "*"`), which rosidl_generator_rs makes of messages, in packages of the
    build type `ament_cargo`. Those of `[dev-dependencies]` count too: cargo resolves them in every build.

    ## Why is this bad?
    No registry has such a crate. colcon shows cargo what is installed, and builds first what package.xml names: on a
    clean machine cargo stops with "no matching package named `std_msgs` found".

    ## When it is quiet
    A crate with a path, a repository or a registry of its own is left alone, and so is one that is optional, that is
    asked for in a certain version, or that `.cargo/config.toml` or `[patch]` may point elsewhere. What another package
    of the repository declares, or a list or a script of it installs (apt alone), is an info where nothing shows a
    release.

    ## References
    - https://github.com/ros2-rust/ros2_rust
    """
    declared = needs.declared
    for need in needs.missing():
        start = f"Cargo.toml depends on `{need.name}`, and package.xml does not declare it"
        fix = declaration(declared, need.tag, need.name)
        if bringer := declared.bringer([need.name], runs=False):
            yield Hit(CARGO, need.span, f"{start}: {comes_with(bringer)}; declare what you use", Severity.INFO, fix=fix)
            continue
        where = where_absent(declared, need.name, built=True)
        message = f"{start}: {where} cargo finds no such package; {advice(declared, need.tag, need.name)}"
        level = Severity.INFO if is_unmet(declared, need.name) else None
        yield Hit(CARGO, need.span, message, level, fix=fix)
