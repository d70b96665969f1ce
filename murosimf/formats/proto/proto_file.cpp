#include "murosimf/formats/proto/proto_file.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/formats/proto/proto_parser.h"
#include "murosimf/formats/proto/proto_schema.h"
#include "murosimf/model/error.h"

namespace murosimf::formats::proto {
namespace {

constexpr int most_files_inside = 16;

class ProtoFiles {
 public:
  explicit ProtoFiles(ProtoFile& result) : result_(result) {}

  std::vector<NodePtr> read(const std::filesystem::path& file, const std::vector<Field>& values, bool outermost) {
    ProtoParser parser(file, values, budget_, [&](const Node& node, const std::vector<ExternProto>& externs) {
      return write_out(node, externs);
    });
    std::vector<NodePtr> nodes = parser.parse();
    if (outermost) {
      result_.name = parser.name();
      result_.year = parser.year();
    }
    return nodes;
  }

 private:
  std::optional<Node> write_out(const Node& node, const std::vector<ExternProto>& externs) {
    if (is_base_node(node.type)) return std::nullopt;
    const auto file = find(node, externs);
    if (!file) return std::nullopt;
    if (++depth_ > most_files_inside) node.fail(fmt::format("PROTO {} is inside itself; open the circle", node.type));
    const auto nodes = with_context(node.where, [&] { return read(*file, node.fields, false); });
    --depth_;
    return *nodes[0];
  }

  std::optional<std::filesystem::path> find(const Node& node, const std::vector<ExternProto>& externs) {
    const std::filesystem::path folder = node.file->parent_path();
    for (const ExternProto& line : externs) {
      if (std::filesystem::path(line.url).stem() != node.type) continue;
      const bool elsewhere = line.url.find("://") != std::string::npos;
      if (!elsewhere) {
        if (auto file = files::find_spelled(folder, line.url)) return file;
      }
      if (said_.insert(line.url).second) {
        result_.notes.emplace_back(line.where,
                                   files::one_line(fmt::format("EXTERNPROTO '{}' {}", line.url,
                                                               elsewhere ? "is not fetched" : "is not there")));
      }
    }
    for (const char* place : {"", "protos/"}) {
      if (auto file = files::find_spelled(folder, place + node.type + ".proto")) return file;
    }
    return std::nullopt;
  }

  ProtoFile& result_;
  ProtoBudget budget_;
  std::set<std::string> said_;
  int depth_ = 0;
};

}  // namespace

ProtoFile read_proto_file(const std::filesystem::path& file) {
  ProtoFile result;
  result.nodes = ProtoFiles(result).read(file, {}, true);
  return result;
}

}  // namespace murosimf::formats::proto
