#ifndef HTL_TEST_SAME_EVENTS_H
#define HTL_TEST_SAME_EVENTS_H

#include <CGAL/Handle_tunnel_loops/Front_event.h>

#include <ostream>

// Events of fronts are compared to the last bit of the lengths.

namespace CGAL::Handle_tunnel_loops {

inline bool operator==(const Front_event::Front& a, const Front_event::Front& b) {
  return a.layer == b.layer && a.length == b.length;
}
inline bool operator==(const Front_event& a, const Front_event& b) {
  return a.type == b.type && a.step == b.step && a.vertex == b.vertex && a.before == b.before &&
         a.after == b.after;
}
inline std::ostream& operator<<(std::ostream& os, const Front_event& event) {
  return os << front_event_name(event.type) << " at vertex " << event.vertex << " in step "
            << event.step;
}

} // namespace CGAL::Handle_tunnel_loops

#endif // HTL_TEST_SAME_EVENTS_H
