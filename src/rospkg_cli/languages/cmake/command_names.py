"""Names of commands that have the same effect on the variables of their caller."""

from __future__ import annotations

FIRST_IS_OUTPUT = ("find_program", "find_library", "find_path", "find_file", "get_target_property", "get_property",
                   "get_directory_property", "get_source_file_property", "get_test_property", "try_compile",
                   "try_run", "cmake_host_system_information", "aux_source_directory")  # fmt: skip
"""Commands whose first argument names a variable that gets a value."""

HARMLESS = frozenset(
    """
    add_compile_definitions add_compile_options add_custom_command add_custom_target add_definitions
    add_dependencies add_test cmake_minimum_required cmake_policy configure_file enable_language enable_testing
    export include_directories include_guard install link_directories link_libraries mark_as_advanced
    set_directory_properties set_property set_source_files_properties set_target_properties set_tests_properties
    source_group target_compile_definitions target_compile_features target_compile_options
    target_include_directories target_link_directories target_link_libraries target_link_options
    target_precompile_headers target_sources ament_package ament_auto_package ament_target_dependencies
    ament_export_dependencies ament_export_targets ament_export_libraries ament_export_include_directories
    ament_export_interfaces ament_python_install_package ament_auto_add_executable ament_auto_add_library
    ament_auto_find_build_dependencies ament_environment_hooks ament_lint_auto_find_test_dependencies
    ament_add_gtest ament_add_gmock ament_add_pytest_test ament_auto_add_gtest rclcpp_components_register_node
    rclcpp_components_register_nodes rosidl_generate_interfaces pluginlib_export_plugin_description_file
    generate_parameter_library generate_parameter_module rosidl_target_interfaces
""".split()
)
"""Commands that set no variable of the caller."""

QT_WRAPPERS = tuple(f"qt{version}_{what}" for version in ("4", "5", "6", "") for what in ("wrap_cpp", "wrap_ui"))
