// In which order handles are tried, and which are removed together.

#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loop_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loops_anew.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_rounds.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Ways_tried.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_removal_rounds {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using impl::Index;
using impl::Removal_effort;
using impl::Removal_task;
using State = Removal_task::State;
using Arrays = CGAL::Handle_tunnel_loops::Triangle_arrays<Mesh::Point>;

// A surface under surgery, and a task for each of its handles.
struct Handles
{
  Handles(const char* kind, std::size_t faces, std::size_t genus)
      : input(mesh_of({kind, {faces, genus, 0}})) {
    const auto vertex_index = get(CGAL::vertex_index, input);
    const auto face_index = get(CGAL::face_index, input);
    const impl::Triangle_reader<Mesh, std::decay_t<decltype(face_index)>> reader(input, face_index);
    double unit = 1.;
    mesh =
        impl::surgery_mesh_of(reader.read(impl::Execution(), vertex_index, input.points()), unit);
    Pairs pairs;
    CGAL::handle_tunnel_loops(input, std::back_inserter(pairs));
    for(const auto& pair : pairs) {
      tasks.emplace_back();
      tasks.back().pair = tasks.size() - 1;
      for(const auto* loop : {&pair.handle(), &pair.tunnel()})
        tasks.back().choices.push_back(impl::loop_choice(*loop, input, vertex_index));
      tasks.back().divide_lengths(unit);
    }
  }

  void remove(Removal_effort effort, bool force = false) {
    remove_handles(impl::Execution(), mesh, tasks, effort, force, [](double) {});
  }

  std::ptrdiff_t euler_characteristic() const {
    std::ptrdiff_t vertices = 0, faces = 0;
    for(Index v = 0; v < mesh.vertex_bound(); ++v)
      vertices += mesh.outgoing(v) != impl::no_index;
    for(Index f = 0; f < mesh.face_bound(); ++f)
      faces += mesh.is_alive(f);
    return vertices - faces / 2;
  }

  Mesh input;
  impl::Surgery_mesh mesh;
  std::vector<Removal_task> tasks;
};

// Faces are numbered in the order in which they are put in.
TEST(Handles_that_come_first, AreRemovedBeforeAllOthers) {
  generators::Random random(1);
  const Handles handles("multi-torus", 3000, 8);
  for(int run = 0; run < 8; ++run) {
    Handles some = handles;
    for(Removal_task& task : some.tasks)
      task.comes_first = random.below(2) == 0;
    some.remove(Removal_effort::ALL_LOOPS);
    Index last_of_first = 0, first_of_others = (std::numeric_limits<Index>::max)();
    for(const Removal_task& task : some.tasks) {
      ASSERT_EQ(task.state, State::REMOVED);
      if(task.comes_first)
        last_of_first = (std::max)(last_of_first, task.end_of_faces);
      else
        first_of_others = (std::min)(first_of_others, task.end_of_faces);
    }
    EXPECT_LT(last_of_first, first_of_others) << run;
  }
}

// A loop that stays at a vertex has no region, which is known before any caps are made.
TEST(Handles_that_come_first, LetOthersBeTriedWhenTheyFail) {
  generators::Random random(2);
  const Handles handles("multi-torus", 1500, 4);
  for(int run = 0; run < 8; ++run) {
    Handles some = handles;
    const std::size_t number_lost = 1 + random.below(3);
    for(std::size_t i = 0; i < number_lost; ++i) {
      some.tasks[i].comes_first = true;
      for(impl::Loop_choice& loop : some.tasks[i].choices) {
        const Index v = loop.places.front().source, w = loop.places.front().target;
        loop.places.assign(3, {v, w, 0.});
      }
    }
    random.shuffle(some.tasks);
    some.remove(Removal_effort::GIVEN_LOOPS);
    for(const Removal_task& task : some.tasks)
      EXPECT_EQ(task.state, task.comes_first ? State::REFUSED : State::REMOVED) << run;
  }
}

// What has failed before, alone, is no reason to leave a region alone that holds it as well.
TEST(Handles_that_failed, AreTakenOutTogetherWithOthers) {
  using Choice = impl::Region_choice;
  const Handles handles("sponge", 500, 12);
  const auto number = static_cast<std::ptrdiff_t>(handles.tasks.size());
  std::ptrdiff_t most_together = 0;
  for(std::size_t first = 0; first < handles.tasks.size(); ++first)
    for(std::size_t loop : {0, 1})
      for(int rings : {3, 6, 10}) {
        Handles some = handles;
        for(Removal_task& task : some.tasks) {
          task.state = State::REFUSED;
        }
        some.tasks[first].state = State::OPEN;
        some.tasks[first].region = Choice{Choice::WHOLE, loop, rings};
        some.remove(Removal_effort::GIVEN_LOOPS, true);
        const auto left = static_cast<std::ptrdiff_t>(number_left(some.tasks));
        EXPECT_EQ(some.euler_characteristic(), 2 - 2 * left);
        most_together = (std::max)(most_together, number - left);
      }
  EXPECT_GT(most_together, 1);
}

// What is left of a surface, as a file would have it.
Arrays written(const impl::Surgery_mesh& mesh) {
  std::vector<Index> number(mesh.vertex_bound());
  std::vector<Arrays::Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(Index v = 0; v < mesh.vertex_bound(); ++v)
    if(mesh.outgoing(v) != impl::no_index) {
      number[v] = static_cast<Index>(points.size());
      points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    }
  for(Index f = 0; f < mesh.face_bound(); ++f)
    if(mesh.is_alive(f))
      triangles.push_back(
          {number[mesh.corners(f)[0]], number[mesh.corners(f)[1]], number[mesh.corners(f)[2]]});
  return {std::move(points), triangles};
}

// ... after others were removed: nothing is known of what was tried before.
TEST(Handles_that_failed, AreTriedAgainAsInTheResultOnceItIsRead) {
  generators::Random random(3);
  for(const char* kind : {"multi-torus", "chain", "gyroid"}) {
    Handles handles(kind, 4000, 5);
    for(Removal_task& task : handles.tasks)
      if(random.below(2) == 0)
        task.state = State::KEPT;
    handles.remove(Removal_effort::GIVEN_LOOPS);
    for(Removal_task& task : handles.tasks)
      if(task.state == State::KEPT) {
        task.state = State::REFUSED;
        task.comes_first = true;
        task.region = impl::Region_choice{impl::Region_choice::WHOLE, 0, 3};
      }
    handles.mesh.forget_order();
    impl::Loops_anew(impl::Execution(), handles.mesh).give_to(handles.tasks);
    std::vector<CGAL::Handle_tunnel_pair<Arrays>> pairs;
    const Arrays result = written(handles.mesh);
    CGAL::handle_tunnel_loops(result, std::back_inserter(pairs));
    std::vector<double> expected;
    for(const auto& pair : pairs)
      expected.push_back((std::min)(pair.handle().length(), pair.tunnel().length()));
    std::sort(expected.begin(), expected.end());
    std::vector<double> lengths;
    for(const Removal_task& task : handles.tasks)
      if(task.state != State::REMOVED) {
        EXPECT_EQ(task.state, State::OPEN);
        lengths.push_back(task.choices.front().length);
        EXPECT_FALSE(task.comes_first || task.region);
      }
    EXPECT_FALSE(lengths.empty() || lengths.size() == handles.tasks.size());
    EXPECT_EQ(lengths, expected) << kind;
  }
}

TEST(Ways_that_hardly_ever_do, AreGivenUpBetweenRounds) {
  using Choice = impl::Region_choice;
  const Choice whole{Choice::WHOLE, 0, 3}, other_loop{Choice::WHOLE, 1, 3},
      more_rings{Choice::WHOLE, 0, 4};
  impl::Ways_tried ways;
  const auto fail = [&](const Choice& choice, int times) {
    for(int i = 0; i < times; ++i)
      ways.note_failure(choice);
  };
  fail(whole, 64);
  EXPECT_FALSE(ways.is_given_up(whole));
  ways.give_up_what_is_in_vain();
  EXPECT_TRUE(ways.is_given_up(whole));
  EXPECT_TRUE(ways.is_given_up(other_loop));
  EXPECT_FALSE(ways.is_given_up(more_rings));
  ways.note_success(whole);
  ways.give_up_what_is_in_vain();
  EXPECT_FALSE(ways.is_given_up(whole));
  fail(whole, 64);
  ways.give_up_what_is_in_vain();
  EXPECT_TRUE(ways.is_given_up(whole));
}

TEST(Ways_that_hardly_ever_do, AreStillTriedIfTheySayWhy) {
  using Choice = impl::Region_choice;
  const Choice strip{Choice::STRIP, 0, 0}, strip_that_crosses{Choice::STRIP, 0, 0, true};
  impl::Ways_tried ways;
  for(int i = 0; i < 1000; ++i) {
    ways.note_failure(strip);
    ways.note_failure(strip_that_crosses);
  }
  ways.give_up_what_is_in_vain();
  EXPECT_FALSE(ways.is_given_up(strip));
  EXPECT_TRUE(ways.is_given_up(strip_that_crosses));
}

// Most ways are given up there before they were tried for all handles.
TEST(Handles_of_a_surface_that_crosses_itself_all_over, AreEachRefusedForAReason) {
  const Handles handles("random", 12000, 120);
  Handles one = handles, many = handles;
  one.remove(Removal_effort::MORE_LOOPS);
  remove_handles(impl::Execution::parallel(), many.mesh, many.tasks, Removal_effort::MORE_LOOPS,
                 false, [](double) {});
  std::ptrdiff_t left = 0;
  for(std::size_t i = 0; i < one.tasks.size(); ++i) {
    EXPECT_EQ(one.tasks[i].state, many.tasks[i].state);
    EXPECT_EQ(one.tasks[i].reasons, many.tasks[i].reasons);
    if(one.tasks[i].state == State::REMOVED)
      continue;
    ++left;
    ASSERT_EQ(one.tasks[i].state, State::REFUSED);
    for(const std::string& why : one.tasks[i].reasons)
      EXPECT_TRUE(!why.empty() && why != "no loop") << why;
  }
  EXPECT_GT(left, 100);
  EXPECT_EQ(one.euler_characteristic(), 2 - 2 * left);
}

} // namespace test_removal_rounds
