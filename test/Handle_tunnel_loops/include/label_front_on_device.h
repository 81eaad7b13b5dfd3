#ifndef HTL_TEST_LABEL_FRONT_ON_DEVICE_H
#define HTL_TEST_LABEL_FRONT_ON_DEVICE_H

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <vector>

namespace front_labels {

// `label_front()` on the current CUDA device.
std::vector<CGAL::Handle_tunnel_loops::internal::Index>
label_front_on_device(const CGAL::Handle_tunnel_loops::internal::Flat_mesh& mesh,
                      const std::vector<CGAL::Handle_tunnel_loops::internal::Time>& times,
                      CGAL::Handle_tunnel_loops::internal::Time level);

} // namespace front_labels

#endif // HTL_TEST_LABEL_FRONT_ON_DEVICE_H
