"""What leaves the program and comes into it: tables and pictures."""
