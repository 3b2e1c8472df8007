"""Which packages a path means, and what lies around them."""
