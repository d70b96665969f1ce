#include "murosimf/geometry/qhull_faces.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace murosimf::geometry {
namespace {

using Face = std::vector<std::uint32_t>;

/// What qhull writes goes to memory.
class Log {
 public:
  Log() : file_(open_memstream(&text_, &size_)) {}
  ~Log() {
    std::fclose(file_);
    std::free(text_);  // NOLINT: open_memstream allocates so
  }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  [[nodiscard]] FILE* file() const { return file_; }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  FILE* file_;
};

/// One run of qhull. Points are numbers of the caller's list.
class Run {
 public:
  Run(std::vector<double>& coordinates, std::string options) {
    qh_zero(&qh_, log_.file());
    ok_ = qh_new_qhull(&qh_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False, options.data(),
                       nullptr, log_.file()) == 0;
  }
  ~Run() {
    qh_freeqhull(&qh_, !qh_ALL);
    int long_blocks = 0, long_bytes = 0;
    qh_memfreeshort(&qh_, &long_blocks, &long_bytes);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Faces by numbers of points, corners in order; nothing if qhull gave up or a face has no simple outline.
  std::optional<std::vector<Face>> faces() {
    if (!ok_) return std::nullopt;
    std::vector<Face> result;
    for (facetT* facet = qh_.facet_list; facet && facet->next; facet = facet->next) {
      Face face = outline(*facet);
      if (face.size() < 3) return std::nullopt;
      result.push_back(std::move(face));
    }
    return result;
  }

 private:
  std::uint32_t number(const vertexT* vertex) { return static_cast<std::uint32_t>(qh_pointid(&qh_, vertex->point)); }

  template <class T, class F>
  static void for_each(setT* set, const F& f) {
    if (!set) return;
    for (setelemT* element = &set->e[0]; element->p; ++element) f(static_cast<T*>(element->p));
  }

  /// Corners in a row, in either direction.
  Face outline(const facetT& facet) {
    Face corners;
    if (facet.simplicial) {
      for_each<vertexT>(facet.vertices, [&](vertexT* v) { corners.push_back(number(v)); });
      return corners;
    }
    std::map<std::uint32_t, Face> next;
    for_each<ridgeT>(facet.ridges, [&](ridgeT* ridge) {
      const std::uint32_t a = number(static_cast<vertexT*>(ridge->vertices->e[0].p));
      const std::uint32_t b = number(static_cast<vertexT*>(ridge->vertices->e[1].p));
      next[a].push_back(b);
      next[b].push_back(a);
    });
    return loop(next);
  }

  /// The one loop through all vertices; empty if there is none.
  static Face loop(const std::map<std::uint32_t, Face>& next) {
    if (std::ranges::any_of(next, [](const auto& entry) { return entry.second.size() != 2; })) return {};
    Face corners;
    if (next.empty()) return corners;
    const std::uint32_t start = next.begin()->first;
    std::uint32_t before = start, here = start;
    do {
      corners.push_back(here);
      const Face& both = next.at(here);
      const std::uint32_t ahead = both[0] == before ? both[1] : both[0];
      before = here;
      here = ahead;
    } while (here != start && corners.size() <= next.size());
    return corners.size() == next.size() ? corners : Face{};
  }

  Log log_;
  qhT qh_{};
  bool ok_ = false;
};

}  // namespace

std::optional<std::vector<std::vector<std::uint32_t>>> qhull_faces(std::vector<double>& coordinates,
                                                                   const std::string& options) {
  return Run(coordinates, options).faces();
}

}  // namespace murosimf::geometry
