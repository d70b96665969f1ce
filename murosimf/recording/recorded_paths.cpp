#include "murosimf/recording/recorded_paths.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"

namespace murosimf::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view program = "/program", user = "/user", elsewhere = "/elsewhere/";

fs::path whole(const fs::path& file) { return fs::absolute(file).lexically_normal(); }

/// The home folder; empty if there is no usable one.
fs::path home() {
  const char* folder = std::getenv("HOME");
  const fs::path path = folder ? fs::path(folder).lexically_normal() : fs::path{};
  return path.is_absolute() && path != "/" ? (path.has_filename() ? path : path.parent_path()) : fs::path{};
}

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

/// A home folder, or a top-level one: folders of different areas are unrelated.
fs::path area_of(const fs::path& folder) {
  if (!home().empty() && is_below(folder, home())) return home();
  auto part = folder.begin();
  fs::path area = *part;
  if (++part == folder.end()) return area;
  area /= *part;
  if (area != "/home" && area != "/Users") return area;
  return ++part == folder.end() ? area : area / *part;
}

fs::path common(const fs::path& a, const fs::path& b) {
  fs::path both;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end() && *i == *j; ++i, ++j) both /= *i;
  return both;
}

/// The parts of a key of files::look_up_key.
struct LookUp {
  std::string name, kind, extension, folder;
};

/// The inverse of the key's text: parts are separated by line ends.
LookUp parse_key(const std::string& key) {
  LookUp look_up;
  std::string* const fields[] = {&look_up.name, &look_up.kind, &look_up.extension, &look_up.folder};
  std::size_t field = 0;
  for (const char c : key) {
    if (c == '\n' && field < 3) {
      ++field;
    } else {
      *fields[field] += c;
    }
  }
  return look_up;
}

/// Packages of ROS are found by the names of their folders, which therefore must be kept.
bool is_in_package(const std::vector<fs::path>& files, const fs::path& folder) {
  return std::ranges::any_of(files, [&](const fs::path& file) {
    return file.extension() == ".urdf" && is_below(whole(file), folder);
  });
}

bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("._-~/").find(c) != std::string_view::npos;
}

/// Replaces `folder` by `name` at the beginning of every file name in the text.
std::string with_name(const std::string& text, const std::string& folder, const std::string& name) {
  std::string changed;
  std::size_t done = 0;
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at + 1)) {
    const std::size_t end = at + folder.size();
    const bool begins = at == 0 || !is_of_name(text[at - 1]);
    const bool ends = end == text.size() || text[end] == '/' || !is_of_name(text[end]);
    if (!begins || !ends || at < done) continue;
    changed += text.substr(done, at - done) + name;
    done = end;
  }
  return changed + text.substr(done);
}

}  // namespace

RecordedPaths::RecordedPaths() {
  for (const fs::path& folder : files::data_folders()) add(whole(folder), std::string(program));
}

RecordedPaths::RecordedPaths(const std::vector<fs::path>& files, const files::FoundNames& names) : RecordedPaths() {
  extend(files, names);
}

void RecordedPaths::extend(const std::vector<fs::path>& files, const files::FoundNames& names) {
  std::vector<std::pair<fs::path, fs::path>> areas;  // with the common folder of its files
  const auto meet = [&](const fs::path& folder) {
    if (folder.empty() || !reduced(folder).starts_with(elsewhere)) return;
    const fs::path area = area_of(folder);
    const auto known = std::ranges::find(areas, area, &std::pair<fs::path, fs::path>::first);
    if (known == areas.end()) {
      areas.emplace_back(area, folder);
    } else {
      known->second = common(known->second, folder);
    }
  };
  for (const fs::path& file : files) meet(whole(file).parent_path());
  for (const auto& [key, found] : names) {
    meet(parse_key(key).folder);
    if (!found.empty()) meet(fs::path(found).parent_path());
  }
  for (const auto& [area, folder] : areas) {
    std::string name = areas_ == 0 ? std::string(user) : fmt::format("{}_{}", user, areas_ + 1);
    ++areas_;
    if (folder != area && is_in_package(files, folder)) name += "/" + folder.filename().string();
    add(folder, name);
  }
}

void RecordedPaths::add(const fs::path& folder, const std::string& name) {
  if (folder == "/") return;
  const std::string path = folder.has_filename() ? folder.string() : folder.parent_path().string();
  if (std::ranges::find(roots_, path, &std::pair<std::string, std::string>::first) != roots_.end()) return;
  roots_.emplace_back(path, name);
  // longer folders first: the innermost one gives the shortest name
  std::ranges::stable_sort(roots_, std::greater{}, [](const auto& root) { return root.first.size(); });
}

/// The first root that contains the file: roots are ordered from the innermost one.
std::string RecordedPaths::reduced(const fs::path& file) const {
  const fs::path path = whole(file);
  for (const auto& [folder, name] : roots_) {
    if (!is_below(path, folder)) continue;
    const fs::path inner = path.lexically_relative(folder);
    return inner == "." ? name : name + "/" + inner.string();
  }
  return std::string(elsewhere) + path.filename().string();
}

std::string RecordedPaths::in_text(const std::string& text) const {
  std::string changed = text;
  for (const auto& [folder, name] : roots_) changed = with_name(changed, folder, name);
  return home().empty() ? changed : with_name(changed, home().string(), "~");
}

/// Paths within a command line may be quoted or part of an option.
std::string RecordedPaths::in_command_line(const std::string& line) const {
  const std::string text = in_text(line);
  const auto ends = [](char c) { return std::string_view(" '\"=:,;[]()").find(c) != std::string_view::npos; };
  std::string changed;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && !ends(text[end])) ++end;
    std::string word = text.substr(begin, end - begin);
    const bool is_known = is_below(word, program) || is_below(word, user) || word.starts_with("/user_");
    if (begin == 0 || (word.starts_with('/') && !is_known)) word = word.substr(word.rfind('/') + 1);
    changed += word;
    if (end < text.size()) changed += text[end++];
    begin = end;
  }
  return changed;
}

RunDescription RecordedPaths::in_description(RunDescription run) const {
  for (auto* texts : {&run.overrides, &run.events, &run.pushes}) {
    for (std::string& text : *texts) text = in_text(text);
  }
  for (std::string& plugin : run.plugins) plugin = fs::path(plugin).filename().string();
  files::FoundNames names;
  for (const auto& [key, found] : run.names) {
    const LookUp look_up = parse_key(key);
    const std::string folder = look_up.folder.empty() ? "" : reduced(look_up.folder);
    const std::string file = found.empty() ? "" : reduced(found);
    // names in files are recorded unchanged, those in the description are reduced: both forms must be found
    for (const std::string& name : {look_up.name, in_text(look_up.name)}) {
      const std::string now = files::look_up_key(name, look_up.kind, look_up.extension, folder);
      names[name == look_up.name ? files::hidden_key(now) : now] = file;
    }
  }
  run.names = std::move(names);
  run.scene = in_text(run.scene);
  return run;
}

TextMap RecordedPaths::folders() const {
  TextMap all;
  std::error_code error;
  const fs::path here = fs::current_path(error);
  for (const auto& [folder, name] : roots_) {
    if (!name.starts_with(user)) continue;
    const auto seen_from = [from = fs::path(folder)](const fs::path& above) {
      return from.lexically_relative(above).string() + "\n";
    };
    if (!home().empty() && is_below(folder, home())) {
      all[name] += "~/" + seen_from(home());
    } else if (!error && here != "/" && is_below(folder, here)) {
      all[name] += seen_from(here);  // not below a home folder: the path would reveal its name
    }
  }
  return all;
}

std::vector<fs::path> places_of(const fs::path& reduced, const fs::path& recording, const TextMap& folders) {
  std::vector<fs::path> places;
  const std::string text = reduced.string();
  if (text.starts_with(program)) {
    for (const fs::path& folder : files::data_folders()) places.push_back(folder / reduced.lexically_relative(program));
    return places;
  }
  if (!text.starts_with(user)) return {reduced};  // recordings of older versions
  fs::path inner = reduced.relative_path();
  inner = inner.lexically_relative(*inner.begin());
  for (const auto& [name, lines] : folders) {
    if (!text.starts_with(name + "/")) continue;
    std::istringstream all(lines);
    for (std::string line; std::getline(all, line);) {
      const fs::path folder = line.starts_with("~/") ? home() / line.substr(2) : fs::path(line);
      places.push_back(folder / reduced.lexically_relative(name));
    }
  }
  std::error_code error;
  for (fs::path folder : {fs::absolute(recording).parent_path(), fs::current_path(error)}) {
    for (; folder.has_relative_path(); folder = folder.parent_path()) places.push_back(folder / inner);
  }
  for (const fs::path& folder : files::data_folders()) places.push_back(folder / inner);
  return places;
}

}  // namespace murosimf::recording
