"""The config: rospkg.toml, `[tool.rospkg]` of pyproject.toml, and the user's own."""
