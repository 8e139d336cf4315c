// Private. Metres by which objects of an arrangement can be apart at most, wherever they stand.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/world.h"

namespace trivet {

/// A graph of the objects that relations name. The outlines of two are no farther apart than a
/// chain of relations says, with the sizes of what is between: the triangle inequality.
class DistanceBounds {
 public:
  /// An object, wherever it is to stand.
  struct Node {
    std::string name;
    double size = 0;   // metres: no two points of it are farther from each other
    double loose = 0;  // of each point of its outline from one of its surface, seen from above
    double height = 0;
    double lower = 0, upper = 0;  // z
  };
  /// Outlines of two objects are no farther apart than `length`.
  struct Link {
    size_t to;
    double length;
    Sentence text;  // empty: both stand there
    const Relation* relation = nullptr;
  };
  struct Bound {
    double distance = kInfinity;
    size_t from = 0;  // the node before
    const Link* by = nullptr;
  };
  using Bounds = std::map<size_t, Bound>;  // by node

  explicit DistanceBounds(const World& world);

  const std::vector<Node>& nodes() const { return m_nodes; }
  size_t node_of(const std::string& name) const { return m_node_of.at(name); }
  /// Bounds between the outlines of all nodes and one, where they are no more than `most` [Dijkstra
  /// 1959].
  Bounds from(size_t start, double most) const;
  /// Metres between the surfaces of two objects whose outlines are so far apart, at most.
  double apart(const Node& a, const Node& b, double distance) const;
  /// One carries the other, or both may lie in the same: nothing is kept between them.
  bool touch(const std::string& a, const std::string& b) const;

 private:
  void add_nodes();
  void add_standing(const std::string& name);
  void add_thing(const ThingModel& thing);
  void set_range(Node& node, const ThingModel& thing);
  void add_links();
  void add_link(const std::string& a, const std::string& b, double length, const Sentence& text,
                const Relation* relation = nullptr);
  void link_standing();
  double reach_of(const Relation& r) const;
  const std::string* carrier(const std::string& thing) const;
  std::vector<std::string> containers(const std::string& thing) const;

  const World& m_world;
  double m_touching;          // metres between what touches, at most
  double m_total_height = 0;  // of all things
  std::vector<Node> m_nodes;
  std::map<std::string, size_t> m_node_of;
  std::vector<std::vector<Link>> m_links;           // #nodes
  std::map<std::string, std::string> m_pattern_of;  // supports of things in patterns
};

}  // namespace trivet
