"""What the pages, scripts and containers of a repository say: how it is built and started, for whom, with what."""
