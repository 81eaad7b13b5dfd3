#ifndef HTL_TEST_CONTRACTED_H
#define HTL_TEST_CONTRACTED_H

#include "Numbers_of_answers.h"
#include "Numbers_of_passes.h"

// Compiled for the processor of this machine, with multiply-adds wherever they can be made. In a
// library of their own: in one program, there would be one of each inline function.
namespace contracted {

__attribute__((visibility("default"))) Numbers_of_passes
numbers_of_passes(const CGAL::Handle_tunnel_loops::internal::Flat_mesh& mesh);

__attribute__((visibility("default"))) Numbers_of_answers numbers_of_answers(const Soup& soup);

} // namespace contracted

#endif // HTL_TEST_CONTRACTED_H
