#include "murosimf/robot_formats/proto/proto_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/proto/proto_parser.h"
#include "murosimf/robot_formats/proto/proto_schema.h"

namespace murosimf::robot_formats::proto {
namespace {

constexpr int most_files_inside = 16;

class ProtoFiles {
 public:
  ProtoFiles(ProtoFile& result, std::filesystem::path folder, bool lenient)
      : result_(result), folder_(std::move(folder)), lenient_(lenient) {}

  std::vector<NodePtr> read(const std::filesystem::path& file, const std::vector<Field>& values, bool outermost) {
    MUROSIMF_ASSERT(outermost == (depth_ == 0));
    ProtoParser parser(file, values, budget_, [&](const Node& node, const std::vector<ExternProto>& externs) {
      return expand(node, externs);
    });
    std::vector<NodePtr> nodes = parser.parse();
    if (outermost) {
      result_.name = parser.name();
      result_.year = parser.year();
    }
    return nodes;
  }

 private:
  std::optional<Node> expand(const Node& node, const std::vector<ExternProto>& externs) {
    if (is_base_node(node.type)) return std::nullopt;
    const auto file = find(node, externs);
    if (!file) return std::nullopt;
    const auto known = whole_.find(*file);
    // A PROTO with defaults alone is the same wherever it is used; it is read once.
    if (node.fields.empty() && known != whole_.end()) return *known->second;
    if (depth_ >= most_files_inside) node.fail(fmt::format("PROTO {} is inside itself; open the circle", node.type));
    ++depth_;
    const NodePtr expanded = read_inside(node, *file);
    --depth_;
    MUROSIMF_ASSERT(depth_ >= 0);
    if (!expanded) return std::nullopt;
    if (node.fields.empty()) whole_[*file] = expanded;
    return *expanded;
  }

  /// Reads the file of a node. Null: it cannot be read, which a lenient reader notes.
  NodePtr read_inside(const Node& node, const std::filesystem::path& file) {
    try {
      return with_context(node.where, [&] { return read(file, node.fields, false)[0]; });
    } catch (const SetupError& error) {
      if (!lenient_) throw;
      note(node.where, fmt::format("{} is left out: {}", node.type, error.what()));
      return nullptr;
    }
  }

  /// Finds the file of the node's PROTO.
  std::optional<std::filesystem::path> find(const Node& node, const std::vector<ExternProto>& externs) {
    const std::filesystem::path folder = node.file->parent_path();
    for (const ExternProto& line : externs) {
      if (std::filesystem::path(line.url).stem() != node.type) continue;
      const bool elsewhere =
          line.url.find("://") != std::string::npos;  // nothing is fetched: runs are repeatable without a network
      if (!elsewhere) {
        if (auto file = files::find_spelled(folder, line.url)) return file;
      }
      note(line.where, fmt::format("EXTERNPROTO '{}' is not {}", line.url, elsewhere ? "fetched" : "there"));
    }
    const std::string name = node.type + ".proto";
    for (const std::filesystem::path& place : places(folder)) {
      if (auto file = files::find_spelled(place, name)) return file;
    }
    return std::nullopt;
  }

  /// The folder of the file, that of the outermost one, and the folders in these, as Webots before R2022b searched.
  const std::vector<std::filesystem::path>& places(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path>& all = places_[folder];
    if (!all.empty()) return all;
    for (const std::filesystem::path& outer : {folder, folder_}) {
      all.push_back(outer);
      std::vector<std::filesystem::path> inner;
      std::error_code ignored;
      std::filesystem::directory_iterator entry(outer.empty() ? "." : outer, ignored);
      for (; entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
        if (entry->is_directory(ignored)) inner.push_back(entry->path());
      }
      std::ranges::sort(inner);  // directories list in any order: the same file must be found on every machine
      all.insert(all.end(), inner.begin(), inner.end());
    }
    return all;
  }

  void note(const std::string& where, const std::string& message) {
    if (said_.insert(message).second) result_.notes.emplace_back(where, files::one_line(message));
  }

  ProtoFile& result_;
  std::filesystem::path folder_;  ///< of the outermost file
  bool lenient_;
  ProtoBudget budget_;
  std::map<std::filesystem::path, NodePtr> whole_;  ///< PROTOs with defaults alone
  std::map<std::filesystem::path, std::vector<std::filesystem::path>> places_;
  std::set<std::string> said_;
  int depth_ = 0;
};

}  // namespace

ProtoFile read_proto_file(const std::filesystem::path& file, bool lenient) {
  ProtoFile result;
  result.nodes = ProtoFiles(result, file.parent_path(), lenient).read(file, {}, true);
  return result;
}

}  // namespace murosimf::robot_formats::proto
