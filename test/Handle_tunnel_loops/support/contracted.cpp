#include "contracted.h"

namespace contracted {

Numbers_of_passes numbers_of_passes(const CGAL::Handle_tunnel_loops::internal::Flat_mesh& mesh) {
  return ::numbers_of_passes(mesh);
}

Numbers_of_answers numbers_of_answers(const Soup& soup) { return ::numbers_of_answers(soup); }

} // namespace contracted
