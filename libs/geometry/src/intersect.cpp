#include "roomgraph/geometry/intersect.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace roomgraph {
namespace {

using Fast = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Kernel>
typename Kernel::Segment_2 segment(Point a, Point b) {
  return {typename Kernel::Point_2(a.x, a.y), typename Kernel::Point_2(b.x, b.y)};
}

double fractionOf(const Exact::Point_2& meeting, Point p, Point q) {
  const Exact::Point_2 from(p.x, p.y), to(q.x, q.y);
  // The longer coordinate, so that the divisor is not 0.
  const bool useX = std::abs(q.x - p.x) >= std::abs(q.y - p.y);
  const Exact::FT done = useX ? meeting.x() - from.x() : meeting.y() - from.y();
  const Exact::FT all = useX ? to.x() - from.x() : to.y() - from.y();
  return all == 0 ? 0.0 : CGAL::to_double(done / all);
}

}  // namespace

std::vector<double> intersect(Point p, Point q, Point a, Point b) {
  if (!CGAL::do_intersect(segment<Fast>(p, q), segment<Fast>(a, b))) return {};
  // What CGAL returns is a variant of Boost before CGAL 6, and one of C++ since; both become this.
  const CGAL::Object meeting = CGAL::intersection(segment<Exact>(p, q), segment<Exact>(a, b));
  if (const auto* point = CGAL::object_cast<Exact::Point_2>(&meeting))
    return {fractionOf(*point, p, q)};
  const auto shared = CGAL::object_cast<Exact::Segment_2>(meeting);
  double first = fractionOf(shared.source(), p, q), last = fractionOf(shared.target(), p, q);
  if (shared.is_degenerate()) return {first};
  if (first > last) std::swap(first, last);
  return {first, last};
}

}  // namespace roomgraph
