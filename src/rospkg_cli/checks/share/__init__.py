"""Share directories as code and other packages name them: `get_package_share_directory`, `$(find-pkg-share)`."""
