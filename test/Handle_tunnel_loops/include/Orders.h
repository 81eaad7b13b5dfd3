#ifndef HTL_TEST_ORDERS_H
#define HTL_TEST_ORDERS_H

#include "Host_executor.h"

#include <gtest/gtest.h>

#include <string>

using Order = CGAL::Handle_tunnel_loops::internal::Host_executor::Order;

/// the orders in which what is written for the device runs on the processor, for tests with a
/// parameter.
inline auto all_orders() {
  return testing::Values(Order::FORWARD, Order::SHUFFLED, Order::THREADS);
}

inline std::string name_of_order(const testing::TestParamInfo<Order>& info) {
  return info.param == Order::FORWARD ? "forward"
                                      : (info.param == Order::SHUFFLED ? "shuffled" : "threads");
}

#endif // HTL_TEST_ORDERS_H
