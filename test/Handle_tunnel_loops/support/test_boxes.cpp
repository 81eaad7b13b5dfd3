// Trees of boxes find all that they should, by comparison with all there is.

#include <CGAL/Handle_tunnel_loops/internal/solid/Face_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Placed_boxes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_boxes {

using namespace CGAL::Handle_tunnel_loops::internal;

using Place = std::array<double, 3>;

class Random_places
{
public:
  explicit Random_places(unsigned seed)
      : random_(seed) {}

  std::size_t number(std::size_t below) { return random_() % below; }
  Place operator()(const Place& middle, double extent) {
    std::uniform_real_distribution<double> off(-extent, extent);
    return {middle[0] + off(random_), middle[1] + off(random_), middle[2] + off(random_)};
  }

private:
  std::mt19937 random_;
};

Box<3> box_around(const std::vector<Place>& places) {
  Box<3> box = Box<3>::empty();
  for(const Place& p : places)
    box.extend({p, p});
  return box;
}

/// some triangles, needles among them.
std::vector<Triangle> triangles(Random_places& place) {
  std::vector<Triangle> triangles(1 + place.number(3000));
  for(Triangle& t : triangles) {
    const Place middle = place({}, 1.);
    for(int k = 0; k < 3; ++k)
      t[k] = place(middle, 0.05);
    if(place.number(10) == 0)
      t[1] = place(t[0], 1e-4);
  }
  return triangles;
}

template <typename Function> void for_triangles(const Function& f) {
  for(unsigned seed = 0; seed < 40; ++seed) {
    Random_places place(seed);
    const std::vector<Triangle> all = triangles(place);
    f(all, Face_boxes(Execution(), all.size(), [&](Index i) { return all[i]; }), place);
  }
}

/// how many are said to meet a box; all that do are.
std::size_t
number_met(const std::vector<Triangle>& all, const Face_boxes& boxes, const Box<3>& box) {
  std::set<Index> met;
  EXPECT_FALSE(boxes.any_meeting(box, [&](Index f) {
    met.insert(f);
    return false;
  }));
  for(Index f = 0; f < all.size(); ++f)
    for(const Place& corner : all[f])
      EXPECT_TRUE(met.count(f) == 1 || !box.meets({corner, corner}));
  return met.size();
}

TEST(Face_boxes, FindAllThatMeetABox) {
  for_triangles(
      [](const std::vector<Triangle>& all, const Face_boxes& boxes, Random_places& place) {
        for(int i = 0; i < 20; ++i) {
          const Place p = place({}, 1.);
          Box<3> box = box_around({p, place(p, 0.2)});
          if(i % 4 == 0) // a ray
            box.high[2] = std::numeric_limits<double>::infinity();
          number_met(all, boxes, box);
        }
      });
}

TEST(Face_boxes, AreOfAnySize) {
  for(const double scale : {1e-307, 1e-150, 1e-20, 1e20, 1e150, 1e307}) {
    Random_places place(1);
    std::vector<Triangle> all = triangles(place);
    for(Triangle& t : all)
      for(Place& p : t)
        p = scale * p;
    const Face_boxes boxes(Execution(), all.size(), [&](Index i) { return all[i]; });
    for(int i = 0; i < 100; ++i) {
      const Place p = place({}, 1.);
      const Box<3> box = box_around({scale * p, scale * place(p, 0.2)});
      EXPECT_LT(2 * number_met(all, boxes, box), all.size());
    }
  }
}

TEST(Face_boxes, AreNotNearAPlaceThatIsNone) {
  for_triangles(
      [](const std::vector<Triangle>& all, const Face_boxes& boxes, Random_places& place) {
        for(std::size_t d = 0; d < 3; ++d) {
          Place p = place(all.front()[0], 0.1);
          p[d] = std::numeric_limits<double>::quiet_NaN();
          boxes.for_each_nearer(p, 1., [](Index) {
            ADD_FAILURE();
            return 1.;
          });
        }
      });
}

TEST(Face_boxes, EndWithTheFirstThatHolds) {
  for_triangles(
      [](const std::vector<Triangle>& all, const Face_boxes& boxes, Random_places& place) {
        for(int i = 0; i < 20; ++i) {
          const Index wanted = static_cast<Index>(place.number(all.size()));
          const Box<3> box = box_around({place(all[wanted][0], 0.1), all[wanted][0]});
          bool is_found = false;
          EXPECT_TRUE(boxes.any_meeting(box, [&](Index f) {
            EXPECT_FALSE(is_found);
            is_found = f == wanted;
            return is_found;
          }));
        }
      });
}

TEST(Face_boxes, FindAllThatAreNearer) {
  for_triangles(
      [](const std::vector<Triangle>& all, const Face_boxes& boxes, Random_places& place) {
        for(int i = 0; i < 20; ++i) {
          const Place p = place({}, 1.2);
          const double limit = 0.01 * double(1 + place.number(10));
          std::set<Index> found;
          boxes.for_each_nearer(p, limit, [&](Index f) {
            found.insert(f);
            return limit;
          });
          for(Index f = 0; f < all.size(); ++f)
            for(const Place& corner : all[f])
              EXPECT_TRUE(found.count(f) == 1 || !(dot(corner - p, corner - p) < limit));
        }
      });
}

TEST(Face_boxes, FindAllThatAreOnAWay) {
  for_triangles([](const std::vector<Triangle>& all, const Face_boxes& boxes,
                   Random_places& place) {
    for(int i = 0; i < 100; ++i) {
      const Index f = static_cast<Index>(place.number(all.size()));
      const Place middle = (1. / 3.) * (all[f][0] + all[f][1] + all[f][2]), from = place({}, 1.);
      const double way = norm(middle - from);
      Place direction = (1. / way) * (middle - from);
      if(i % 4 == 0) { // along an axis
        direction = {0., 0., 1.};
        direction[2] = middle[2] < from[2] ? -1. : 1.;
      }
      const Place start = middle - way * direction;
      bool is_found = false;
      boxes.for_each_on_way(start, direction, std::numeric_limits<double>::infinity(),
                            [&](Index g) {
                              is_found = is_found || f == g;
                              return std::numeric_limits<double>::infinity();
                            });
      EXPECT_TRUE(is_found);
    }
  });
}

std::vector<Box<3>> boxes_of(const std::vector<Triangle>& triangles) {
  std::vector<Box<3>> boxes;
  for(const Triangle& t : triangles)
    boxes.push_back(box_around({t[0], t[1], t[2]}));
  return boxes;
}

TEST(Placed_boxes, AskOnceForEachPair) {
  for(unsigned seed = 0; seed < 20; ++seed) {
    Random_places place(seed);
    const std::vector<Box<3>> boxes = boxes_of(triangles(place));
    const auto box = [&](std::size_t i) { return boxes[i]; };
    std::map<std::pair<Index, Index>, int> asked;
    EXPECT_FALSE(Placed_boxes(Execution(), boxes.size(), box).any_pair(box, [&](Index i, Index j) {
      ++asked[std::minmax(i, j)];
      return false;
    }));
    std::map<std::pair<Index, Index>, int> meeting;
    for(Index i = 0; i < boxes.size(); ++i)
      for(Index j = i + 1; j < boxes.size(); ++j)
        if(boxes[i].meets(boxes[j]))
          meeting[{i, j}] = 1;
    EXPECT_EQ(asked, meeting);
  }
}

TEST(Box_tree, FindsAllFromANumberOn) {
  for(unsigned seed = 0; seed < 20; ++seed) {
    Random_places place(seed);
    const std::vector<Box<3>> boxes = boxes_of(triangles(place));
    const Box_tree<3> tree(boxes);
    for(int i = 0; i < 20; ++i) {
      const Place p = place({}, 1.);
      const Box<3> around = box_around({p, place(p, 0.5)});
      const std::size_t first = place.number(boxes.size() + 1);
      std::vector<Index> found, expected;
      tree.any_meeting_from(first, around, [&](Index b, const Box<3>&) {
        found.push_back(b);
        return false;
      });
      for(std::size_t b = first; b < boxes.size(); ++b)
        if(boxes[b].meets(around))
          expected.push_back(static_cast<Index>(b));
      EXPECT_EQ(found, expected);
    }
  }
}

} // namespace test_boxes
