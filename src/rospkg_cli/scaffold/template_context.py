"""What every file of a template knows: the answers, and what follows from them."""

from __future__ import annotations

from functools import partial
from typing import Any

from .answers import Answers
from .cpp import OF_CMAKE_17, cmake_names, cpp_standard, is_library, packages_of, targets_of
from .launch_format import autostarted, launch_packages, unconfigured
from .plugin import plugin_packages
from .test_level import first_words, has_launch_test, has_linters, launch_test_packages, tested_logics


def template_context(answers: Answers) -> dict[str, Any]:
    """Return the values that a template may name."""
    computed = ("copyright", "interface_packages", "sections", "section_of", "robot")
    return {
        **vars(answers),
        **{name: getattr(answers, name) for name in computed},
        **in_cpp(answers),
        **in_python(answers),
        **in_plugins(answers),
        "linted": has_linters(answers),
        "launch_tested": has_launch_test(answers),
        "first_words": partial(first_words, answers),
        "launch_test_packages": launch_test_packages(answers),
        "launch_packages": list(launch_packages(answers)),
        "autostarted": autostarted(answers),
        "unconfigured": unconfigured(answers),
        **in_others(answers),
    }


def in_cpp(answers: Answers) -> dict[str, Any]:
    """Return what the C++ part of a package knows."""
    return {
        "cpp_nodes": answers.nodes_in("cpp"),
        "generated_cpp_nodes": [node for node in answers.nodes_in("cpp") if node.definitions],
        "cpp_logics": answers.logics_in("cpp"),
        "cpp_tests": tested_logics(answers, "cpp"),
        "cpp_messages": list(answers.messages_in("cpp")),
        "client_libraries": list(packages_of(answers.nodes_in("cpp"))),
        "build_depends": [key for key in answers.depends if is_library(key)],
        "run_depends": [key for key in answers.depends if not is_library(key)],
        "cmake_depends": cmake_names(answers.depends),
        "cpp_standard": cpp_standard(answers.distro),
        "targets_of": targets_of,
        "tf_suffix": "h" if answers.distro.name in OF_CMAKE_17 else "hpp",  # geometry2's headers after Kilted
    }


def in_plugins(answers: Answers) -> dict[str, Any]:
    """Return what a package of plugins knows."""
    return {
        "plugin_packages": plugin_packages(answers.plugins),
        "has_own_base": any(plugin.is_own for plugin in answers.plugins),
    }


def in_python(answers: Answers) -> dict[str, Any]:
    """Return what the Python part of a package knows."""
    nodes = answers.nodes_in("python")
    having = any(node.kind.parameters for node in nodes)
    declaring = any(node.declares for node in nodes)
    generated = [node for node in nodes if node.definitions]
    tested = bool(answers.sections) and answers.tests != "none"
    modules = [module for node in nodes for module in node.kind.modules]
    needs = ["rclpy", *answers.messages_in("python"), *modules, *(["rcl_interfaces"] if declaring else [])]
    needs += ["generate_parameter_library_py"] if generated else []
    return {
        "python_nodes": nodes,
        "generated_python_nodes": generated,
        "python_logics": answers.logics_in("python"),
        "python_needs": needs if nodes else [],
        "python_tests": [*tested_logics(answers, "python"), *(["params"] if having and tested else [])],
    }


def in_others(answers: Answers) -> dict[str, Any]:
    """Return what a package knows that starts others."""
    started = answers.started
    return {
        "starts": started.starts,
        "includes": started.includes,
        "started_packages": started.packages,
        "launch_arguments": started.arguments,
        "has_config": bool(started.starts and started.params) or any(include.params for include in started.includes),
    }
