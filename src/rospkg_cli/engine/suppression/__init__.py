"""What sets findings aside: comments, the config, a baseline."""
