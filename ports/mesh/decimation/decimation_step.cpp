#include "decimation_step.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "collapse_checks.hpp"

namespace discmc::meshing {
namespace {

constexpr std::uint32_t block_triangles = 10'000;
constexpr std::uint64_t collapses_per_check = 4096;

}  // namespace

DecimationStep::DecimationStep(const DecimatedSurface& from, const OriginalSurface& original,
                               double distance, std::uint64_t triangles,
                               const std::function<void()>& check)
    : original_(original),
      distance_(distance),
      wanted_(triangles),
      check_(check),
      mesh_(from.points, from.triangles),
      left_(from.left),
      placing_(mesh_),
      tree_(boxes_of(mesh_.triangle_slots(),
                     [this](std::uint32_t triangle) { return mesh_.corners(triangle); })),
      changes_(from.points.size()),
      is_refused_(from.points.size()) {}

void DecimationStep::collapse_in_blocks() {
  find_blocks();
  std::vector<std::vector<std::uint32_t>> vertices(mesh_.triangle_slots() / block_triangles + 1);
  for (std::uint32_t vertex = 0; vertex < mesh_.vertex_slots(); ++vertex)
    if (mesh_.has_vertex(vertex) && block_of_[vertex] != everywhere)
      vertices[block_of_[vertex]].push_back(vertex);
  for (block_ = 0; block_ < vertices.size(); ++block_) {
    for (const std::uint32_t vertex : vertices[block_]) add_edges(vertex);
    collapse_queued();
  }
  block_ = everywhere;
  collapse_all();
}

// A vertex is in a block if all its triangles are.
void DecimationStep::find_blocks() {
  constexpr std::uint32_t unseen = everywhere - 1;
  block_of_.assign(mesh_.vertex_slots(), unseen);
  for (std::uint32_t triangle = 0; triangle < mesh_.triangle_slots(); ++triangle) {
    const std::uint32_t block = tree_.order_of(triangle) / block_triangles;
    for (const std::uint32_t vertex : mesh_.triangle(triangle)) {
      std::uint32_t& owner = block_of_[vertex];
      owner = owner == unseen || owner == block ? block : everywhere;
    }
  }
}

// Skips edges within a block, which were tried with the block.
void DecimationStep::collapse_all() {
  for (std::uint32_t vertex = 0; vertex < mesh_.vertex_slots(); ++vertex)
    if (mesh_.has_vertex(vertex)) add_edges(vertex);
  collapse_queued();
}

// Adds each edge from its lower vertex.
void DecimationStep::add_edges(std::uint32_t vertex) {
  mesh_.for_each_edge(vertex, [&](std::uint32_t other) {
    if (vertex < other && !is_settled(vertex, other)) add(vertex, other);
  });
}

void DecimationStep::add(std::uint32_t a, std::uint32_t b) {
  if (mesh_.is_fixed(a) || mesh_.is_fixed(b) || !is_in_block(a, b)) return;
  const auto placed = placing_.placed(std::min(a, b), std::max(a, b));
  if (!placed) return refuse(a, b);
  const std::uint32_t low = std::min(a, b), high = std::max(a, b);
  heap_.push_back({placed->cost, low, high, changes_[low], changes_[high]});
  std::push_heap(heap_.begin(), heap_.end());
}

bool DecimationStep::is_current(const Entry& entry) const {
  return mesh_.has_vertex(entry.low) && mesh_.has_vertex(entry.high) &&
         entry.changes_of_low == changes_[entry.low] &&
         entry.changes_of_high == changes_[entry.high];
}

// A cost may have grown since it was computed; the edge then returns to the queue.
void DecimationStep::collapse_queued() {
  constexpr double rounding = 1 + 1e-7;
  std::uint64_t tried = 0;
  while (!heap_.empty() && mesh_.triangle_count() > wanted_) {
    if (check_ && ++tried % collapses_per_check == 0) check_();
    std::pop_heap(heap_.begin(), heap_.end());
    Entry entry = heap_.back();
    heap_.pop_back();
    if (!is_current(entry)) continue;
    const std::optional<EdgePlacing::PlacedVertex> placed = placing_.placed(entry.low, entry.high);
    if (placed && placed->cost > entry.cost * rounding) {
      entry.cost = placed->cost;
      heap_.push_back(entry);
      std::push_heap(heap_.begin(), heap_.end());
      continue;
    }
    if (placed) mesh_.describe(entry.low, entry.high, placed->at, collapse_);
    if (placed && is_allowed())
      carry_out();
    else
      refuse(entry.low, entry.high);
  }
  heap_.clear();
}

bool DecimationStep::is_allowed() {
  return mesh_.keeps_topology(collapse_) && keeps_shape(collapse_, mesh_) &&
         left_.are_near(collapse_, original_.points(), distance_) &&
         original_.is_near(collapse_, distance_) && keeps_apart(collapse_, mesh_, tree_);
}

void DecimationStep::carry_out() {
  left_.carry_out(collapse_);
  mesh_.carry_out(collapse_);
  const std::uint32_t kept = collapse_.kept;
  for (const std::uint32_t removed : collapse_.removed) tree_.replace(removed, {});
  for (const Collapse::Moved& moved : collapse_.moved)
    tree_.replace(moved.triangle, Box(moved.after));
  ++changes_[kept];
  is_refused_[kept] = false;

  ring_.clear();
  mesh_.for_each_edge(kept, [&](std::uint32_t other) { ring_.push_back(other); });
  placing_.update(kept);
  for (const std::uint32_t other : ring_) placing_.update(other);
  for (const std::uint32_t other : ring_) add(kept, other);
  // Refused edges may be collapsible now.
  for (const std::uint32_t other : ring_) {
    if (!is_refused_[other]) continue;
    is_refused_[other] = false;
    mesh_.for_each_edge(other, [&](std::uint32_t far) {
      if (far != kept && is_refused_[far]) add(other, far);
    });
  }
  drop_outdated();
}

void DecimationStep::drop_outdated() {
  constexpr std::size_t max_per_triangle = 12, few = 1000;
  if (heap_.size() <= max_per_triangle * mesh_.triangle_count() + few) return;
  heap_.erase(std::remove_if(heap_.begin(), heap_.end(),
                             [this](const Entry& entry) { return !is_current(entry); }),
              heap_.end());
  std::make_heap(heap_.begin(), heap_.end());
}

DecimatedSurface DecimationStep::result() {
  DecimatedSurface result{{}, {}, std::move(left_)};
  std::vector<std::uint32_t> vertices, triangles, number(mesh_.vertex_slots());
  for (std::uint32_t vertex = 0; vertex < mesh_.vertex_slots(); ++vertex) {
    if (!mesh_.has_vertex(vertex)) continue;
    number[vertex] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(vertex);
    result.points.push_back(mesh_.point(vertex));
  }
  for (std::uint32_t triangle = 0; triangle < mesh_.triangle_slots(); ++triangle) {
    if (!mesh_.has_triangle(triangle)) continue;
    triangles.push_back(triangle);
    const Triangle& old_numbers = mesh_.triangle(triangle);
    result.triangles.push_back(
        {number[old_numbers[0]], number[old_numbers[1]], number[old_numbers[2]]});
  }
  result.left.renumber(vertices, triangles);
  return result;
}

}  // namespace discmc::meshing
