#include <discmc/polygon.hpp>

namespace discmc {

namespace {

bool is_before(const Vertex& a, const Vertex& b) {
  if (a.z != b.z) return a.z < b.z;
  if (a.y != b.y) return a.y < b.y;
  return a.x < b.x;
}

// Lets order[root] sink in the heap of the first `count` entries.
void sink_down(const Vertex* vertices, uint32_t* order, uint32_t root, uint32_t count) {
  for (;;) {
    uint32_t largest = root;
    for (uint32_t child = 2 * root + 1; child <= 2 * root + 2 && child < count; ++child)
      if (is_before(vertices[order[largest]], vertices[order[child]])) largest = child;
    if (largest == root) return;
    const uint32_t moved = order[root];
    order[root] = order[largest];
    order[largest] = moved;
    root = largest;
  }
}

// Heapsort: in place and without recursion (J. W. J. Williams, 1964).
void sort_by_vertex(const Vertex* vertices, uint32_t* order, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) order[i] = i;
  for (uint32_t root = count / 2; root-- > 0;) sink_down(vertices, order, root, count);
  for (uint32_t last = count; last-- > 1;) {
    const uint32_t largest = order[0];
    order[0] = order[last];
    order[last] = largest;
    sink_down(vertices, order, 0, last);
  }
}

// Gives each vertex a number that its recurrences share. Returns false if no vertex recurs.
bool number_vertices(const Vertex* vertices, uint32_t* order, uint32_t* number, uint32_t count) {
  sort_by_vertex(vertices, order, count);
  bool recurs = false;
  for (uint32_t i = 0; i < count; ++i) {
    const bool is_same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    number[order[i]] = is_same ? number[order[i - 1]] : order[i];
    recurs = recurs || is_same;
  }
  return recurs;
}

}  // namespace

void ring_vertices(Incidence incidence, const Vertex& start, const Run* runs, uint32_t count,
                   Vertex* vertices) {
  Vertex vertex = start;
  for (uint32_t i = 0; i < count; ++i) {
    const Vertex step = direction_vector(incidence, runs[i].direction());
    for (uint32_t link = runs[i].length(); link > 0; --link) {
      *vertices++ = vertex;
      vertex = vertex + step;
    }
  }
}

int64_t twice_area(Incidence incidence, const Vertex* vertices, uint32_t count) {
  if (count == 0) return 0;
  const Vertex n = incidence_normal(incidence);
  const Vertex origin = vertices[0];
  int64_t sum = 0;
  for (uint32_t i = 1; i + 1 < count; ++i) {
    const Vertex a = vertices[i] - origin;
    const Vertex b = vertices[i + 1] - origin;
    sum += n.x * (int64_t{a.y} * b.z - int64_t{a.z} * b.y) +
           n.y * (int64_t{a.z} * b.x - int64_t{a.x} * b.z) +
           n.z * (int64_t{a.x} * b.y - int64_t{a.y} * b.x);
  }
  return sum;
}

void split_ring(Vertex* vertices, uint32_t count, uint32_t* scratch, const RingSink& sink) {
  uint32_t* const depth = scratch;  // by number: the vertex's position in the path, from 1; 0 for
                                    // none
  uint32_t* const number = scratch + count;
  if (count < 3) return;
  if (!number_vertices(vertices, scratch, number, count))
    return sink.accept(sink.context, vertices, count);
  for (uint32_t i = 0; i < count; ++i) depth[i] = 0;
  // No vertex repeats in the path so far. The path overwrites vertices that have been read.
  uint32_t length = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t recurrence = depth[number[i]];
    if (recurrence != 0) {
      const uint32_t loop = length - (recurrence - 1);
      if (loop >= 3) sink.accept(sink.context, vertices + recurrence - 1, loop);
      for (; length > recurrence; --length) depth[number[length - 1]] = 0;
    } else {
      vertices[length] = vertices[i];
      number[length] = number[i];
      depth[number[i]] = ++length;
    }
  }
  if (length >= 3) sink.accept(sink.context, vertices, length);
}

bool is_corner(const Vertex* vertices, uint32_t count, uint32_t i) {
  const Vertex& before = vertices[i > 0 ? i - 1 : count - 1];
  const Vertex& after = vertices[i + 1 < count ? i + 1 : 0];
  return vertices[i] - before != after - vertices[i];
}

}  // namespace discmc
