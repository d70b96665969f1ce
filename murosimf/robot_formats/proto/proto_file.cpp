#include "murosimf/robot_formats/proto/proto_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/files/xml_element.h"
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
    const auto known = whole_.find(*file);
    if (node.fields.empty() && known != whole_.end()) return *known->second;
    if (depth_ >= most_files_inside) node.fail(fmt::format("PROTO {} is inside itself; open the circle", node.type));
    ++depth_;
    const NodePtr written_out = read_inside(node, *file);
    --depth_;
    if (!written_out) return std::nullopt;
    if (node.fields.empty()) whole_[*file] = written_out;
    return *written_out;
  }

  /// Null: it cannot be read, which a lenient reader notes.
  NodePtr read_inside(const Node& node, const std::filesystem::path& file) {
    try {
      return with_context(node.where, [&] { return read(file, node.fields, false)[0]; });
    } catch (const SetupError& error) {
      if (!lenient_) throw;
      note(node.where, fmt::format("{} is left out: {}", node.type, error.what()));
      return nullptr;
    }
  }

  /// The file of the node's PROTO.
  std::optional<std::filesystem::path> find(const Node& node, const std::vector<ExternProto>& externs) {
    const std::filesystem::path folder = node.file->parent_path();
    for (const ExternProto& line : externs) {
      if (std::filesystem::path(line.url).stem() != node.type) continue;
      const bool elsewhere = line.url.find("://") != std::string::npos;
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

  /// The folder of the file, that of the outermost one, and the folders in these: where Webots before R2022b looked, too.
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
      std::ranges::sort(inner);  // the same file is found everywhere
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
  std::map<std::filesystem::path, NodePtr> whole_;  ///< PROTOs without other values than their defaults
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
