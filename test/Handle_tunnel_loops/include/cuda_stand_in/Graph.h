#ifndef HTL_TEST_CUDA_STAND_IN_GRAPH_H
#define HTL_TEST_CUDA_STAND_IN_GRAPH_H

#include "Grid.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace cuda_stand_in {

class Graph;

struct Graph_node
{
  std::vector<const Graph_node*> after;
  std::function<void(Device&)> run;
  Graph* body; // null but for loops
};

// Work in an order that is only partly given.
class Graph
{
public:
  using Nodes = std::vector<const Graph_node*>;

  Graph_node* add(Nodes after, std::function<void(Device&)> run, Graph* body = nullptr) {
    nodes_.push_back(
        std::make_unique<Graph_node>(Graph_node{std::move(after), std::move(run), body}));
    return nodes_.back().get();
  }

  // A node that repeats a graph of its own while a condition is not zero.
  Graph_node* add_loop(Nodes after, const unsigned* condition) {
    bodies_.push_back(std::make_unique<Graph>());
    Graph* const body = bodies_.back().get();
    const auto run = [body, condition](Device& device) {
      while(*condition != 0)
        body->run(device);
    };
    return add(std::move(after), run, body);
  }

  // A number that is zero when the graph begins to run.
  unsigned* add_condition() {
    conditions_.push_back(std::make_unique<unsigned>(0));
    return conditions_.back().get();
  }
  bool contains(const unsigned* condition) const {
    return std::any_of(conditions_.begin(), conditions_.end(),
                       [condition](const auto& own) { return own.get() == condition; });
  }

  // Of the nodes that may come next, it is the turn of the one that was added last.
  void run(Device& device) const {
    for(const auto& condition : conditions_)
      *condition = 0;
    Nodes done;
    while(const Graph_node* const node = next(done)) {
      node->run(device);
      done.push_back(node);
    }
  }

private:
  const Graph_node* next(const Nodes& done) const {
    const auto is_done = [&](const Graph_node* node) {
      return std::find(done.begin(), done.end(), node) != done.end();
    };
    const auto found = std::find_if(nodes_.rbegin(), nodes_.rend(), [&](const auto& node) {
      return !is_done(node.get()) && std::all_of(node->after.begin(), node->after.end(), is_done);
    });
    return found == nodes_.rend() ? nullptr : found->get();
  }

  std::vector<std::unique_ptr<Graph_node>> nodes_;
  std::vector<std::unique_ptr<Graph>> bodies_;
  std::vector<std::unique_ptr<unsigned>> conditions_;
};

// A graph that is ready to run. It may outlive the one that it was made from.
class Executable_graph
{
public:
  explicit Executable_graph(std::shared_ptr<const Graph> graph)
      : graph_(std::move(graph)) {}
  void run(Device& device) const { graph_->run(device); }

private:
  std::shared_ptr<const Graph> graph_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_GRAPH_H
