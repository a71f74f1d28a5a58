"""What leaves the program and comes into it: tables, pictures, SVG paths, lists of points, meshes."""
