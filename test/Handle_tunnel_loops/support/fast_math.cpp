// Is compiled with -ffast-math, or rather is not.

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
