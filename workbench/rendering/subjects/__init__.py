"""What can be run: a module for each kind of subject, and the registry that finds them."""
