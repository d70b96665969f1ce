#include "murosimf/dataset/randomisation.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <variant>

#include "murosimf/files/data_path.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/model/error.h"
#include "murosimf/render/light.h"

namespace murosimf::dataset {
namespace {

/// Where a key goes; the bounds are of every number in it.
struct Key {
  std::string_view name;
  std::variant<double*, Range*, std::string*, std::vector<std::string>*, std::vector<Color>*> to;
  double lowest = 0, highest = 1;
  bool whole = false;  ///< no fractions
};
struct Section {
  std::string_view name;
  std::vector<Key> keys;
};

std::vector<Section> look_sections(Randomisation& r) {
  return {{"picture",
           {{"format", &r.picture.format},
            {"jpeg_quality", &r.picture.jpeg_quality, 1, 100},
            {"samples", &r.picture.samples, 1, 8, true},
            {"validation", &r.picture.validation},
            {"least_pixels", &r.picture.least_pixels, 1, 1e6, true}}},
          {"light",
           {{"presets", &r.light.presets},
            {"brightness", &r.light.brightness, 0, 100},
            {"elevation_deg", &r.light.elevation_deg, 1, 90},
            {"warmth", &r.light.warmth, -0.9, 0.9},
            {"shadows", &r.light.shadows},
            {"other_colors", &r.light.other_colors},
            {"wall_distance", &r.light.wall_distance, 0.1, 100},
            {"wall_height", &r.light.wall_height, 2, 100}}},
          {"field",
           {{"hue_deg", &r.field.hue_deg, 0, 360},
            {"saturation", &r.field.saturation},
            {"value", &r.field.value},
            {"paint", &r.field.paint},
            {"stripe_width", &r.field.stripe_width, 0.05, 10},
            {"stripe_contrast", &r.field.stripe_contrast, 0, 0.5}}},
          {"sensor",
           {{"exposure", &r.sensor.exposure, 0.01, 100},
            {"white_balance", &r.sensor.white_balance, -0.9, 0.9},
            {"vignetting", &r.sensor.vignetting},
            {"blur", &r.sensor.blur, 0, 20},
            {"shot_noise", &r.sensor.shot_noise},
            {"read_noise", &r.sensor.read_noise},
            {"motion_blur", &r.sensor.motion_blur},
            {"exposure_time", &r.sensor.exposure_time, 0, 1},
            {"turning", &r.sensor.turning, 0, 100}}}};
}

std::vector<Section> place_sections(Randomisation& r) {
  return {{"ball",
           {{"present", &r.ball.present},
            {"in_view", &r.ball.in_view},
            {"distance", &r.ball.distance, 0.1, 100},
            {"colors", &r.ball.colors},
            {"any_color", &r.ball.any_color},
            {"panels", &r.ball.panels},
            {"in_air", &r.ball.in_air},
            {"height", &r.ball.height, 0, 100}}},
          {"robots",
           {{"present", &r.robots.present},
            {"in_view", &r.robots.in_view},
            {"distance", &r.robots.distance, 0.1, 100},
            {"standing", &r.robots.standing, 0, 1e3},
            {"moving", &r.robots.moving, 0, 1e3},
            {"down", &r.robots.down, 0, 1e3},
            {"joint_jitter", &r.robots.joint_jitter, -pi, pi},
            {"team_colors", &r.robots.team_colors},
            {"recorded", &r.robots.recorded, 0, 1e4}}},
          {"people",
           {{"count", &r.people.count, 0, 1000, true},
            {"present", &r.people.present},
            {"on_field", &r.people.on_field},
            {"in_view", &r.people.in_view},
            {"things", &r.people.things, 0, 1000, true},
            {"thing_present", &r.people.thing_present}}}};
}

std::vector<Section> camera_sections(Randomisation& r) {
  return {{"camera",
           {{"of_robot", &r.camera.of_robot},
            {"pan_deg", &r.camera.pan_deg, -180, 180},
            {"tilt_deg", &r.camera.tilt_deg, -90, 90},
            {"roll_deg", &r.camera.roll_deg, -180, 180},
            {"height", &r.camera.height, 0.05, 100},
            {"margin", &r.camera.margin, 0, 100}}},
          {"lens",
           {{"count", &r.lens.count, 1, 1000, true},
            {"perspective", &r.lens.perspective, 0, 1e3},
            {"plumb_bob", &r.lens.plumb_bob, 0, 1e3},
            {"equidistant", &r.lens.equidistant, 0, 1e3},
            {"fov_deg", &r.lens.fov_deg, 5, 200},
            {"k1", &r.lens.k1, -2, 2},
            {"k2", &r.lens.k2, -2, 2},
            {"p", &r.lens.p, -0.1, 0.1}}}};
}

/// Reads one key of a table.
struct Reader {
  const files::TomlTable& table;
  const Key& key;

  [[noreturn]] void refuse(const std::string& message) const {
    throw SetupError(fmt::format("{}: '{}' {}", table.where(key.name), key.name, message));
  }
  void check(double number) const {
    if (!(number >= key.lowest && number <= key.highest)) {
      refuse(fmt::format("is {:g}: must be {:g} to {:g}", number, key.lowest, key.highest));
    }
    if (key.whole && number != std::floor(number)) refuse(fmt::format("is {:g}: must be a whole number", number));
  }
  void operator()(double* to) const {
    table.read(key.name, *to);
    check(*to);
  }
  void operator()(Range* to) const {
    const auto numbers = files::numbers_of(*table.find(key.name));
    if (!numbers || numbers->empty() || numbers->size() > 2) refuse("must be [lowest, highest], or one number");
    *to = {numbers->front(), numbers->back()};
    check(to->low);
    check(to->high);
    if (to->low > to->high) refuse("must begin with the lower number");
  }
  void operator()(std::string* to) const { table.read(key.name, *to); }
  void operator()(std::vector<std::string>* to) const {
    const toml::array* list = table.find(key.name)->as_array();
    if (!list || list->empty() || !list->is_homogeneous<std::string>()) refuse("must be a list of names");
    to->clear();
    for (const toml::node& one : *list) to->push_back(one.value_or(std::string()));
  }
  void operator()(std::vector<Color>* to) const {
    const toml::array* list = table.find(key.name)->as_array();
    if (!list || list->empty()) refuse("must be a list of colors [red, green, blue]");
    to->clear();
    for (const toml::node& one : *list) {
      const auto numbers = files::numbers_of(one);
      if (!numbers || numbers->size() != 3) refuse("must be a list of colors [red, green, blue]");
      for (const double number : *numbers) check(number);
      to->push_back({(*numbers)[0], (*numbers)[1], (*numbers)[2]});
    }
  }
};

void read_section(const toml::table& node, const Section& section) {
  std::vector<std::string_view> names;
  for (const Key& key : section.keys) names.push_back(key.name);
  const files::TomlTable table(node, names);
  for (const Key& key : section.keys) {
    if (table.find(key.name)) std::visit(Reader{table, key}, key.to);
  }
}

/// Checks of several keys of one section, or of names. Defaults pass all of them: what is refused was set by the file.
class Checker {
 public:
  Checker(const toml::table& document, const Randomisation& randomisation) : document_(document), r_(randomisation) {}

  void check() const {
    check_picture();
    check_presets();
    check_weights("robots", {{"standing", r_.robots.standing}, {"moving", r_.robots.moving}, {"down", r_.robots.down}});
    check_weights("lens", {{"perspective", r_.lens.perspective},
                           {"plumb_bob", r_.lens.plumb_bob},
                           {"equidistant", r_.lens.equidistant}});
    if (r_.lens.perspective + r_.lens.plumb_bob > 0 && r_.lens.fov_deg.high > 150) {
      refuse(node("lens", "fov_deg"), "'fov_deg' above 150: only an equidistant lens sees that");
    }
  }

 private:
  struct Weight {
    std::string_view name;
    double value;
  };

  /// Null if the file does not set it.
  [[nodiscard]] const toml::node* node(std::string_view section, std::string_view key) const {
    const toml::table* table = document_[section].as_table();
    return table ? table->get(key) : nullptr;
  }
  [[noreturn]] void refuse(const toml::node* at, const std::string& message) const {
    files::fail_at(at ? at->source() : document_.source(), message);
  }

  void check_picture() const {
    const std::string& format = r_.picture.format;
    if (format != "png" && format != "jpeg")
      refuse(node("picture", "format"), unknown_name("format", format, {"png", "jpeg"}));
    const double n = r_.picture.samples;
    if (n != 1 && n != 2 && n != 4 && n != 8)
      refuse(node("picture", "samples"), fmt::format("'samples' is {:g}: must be 1, 2, 4 or 8", n));
  }

  void check_presets() const {
    std::vector<std::string_view> lights;
    for (const render::NamedLight& light : render::lights()) lights.push_back(light.name);
    for (std::size_t i = 0; i < r_.light.presets.size(); ++i) {
      const std::string& name = r_.light.presets[i];
      if (std::ranges::find(lights, name) != lights.end()) continue;
      const toml::node* list = node("light", "presets");
      refuse(list && list->is_array() ? list->as_array()->get(i) : list, unknown_name("light", name, lights));
    }
  }

  /// Reported at the first of them that the file sets.
  void check_weights(std::string_view section, std::initializer_list<Weight> weights) const {
    std::string names;
    const toml::node* first = nullptr;
    for (const Weight& one : weights) {
      if (one.value > 0) return;
      names += fmt::format("{}{}", names.empty() ? "" : ", ", one.name);
      if (!first) first = node(section, one.name);
    }
    refuse(first, fmt::format("{}: all weights are 0", names));
  }

  const toml::table& document_;
  const Randomisation& r_;
};

}  // namespace

Randomisation read_randomisation(const std::filesystem::path& name) {
  const auto file = files::find_data_file(name.string(), "datasets", ".toml");
  const toml::table document = files::parse_toml_file(file);
  Randomisation result;
  std::vector<Section> sections = look_sections(result);
  for (Section& section : place_sections(result)) sections.push_back(std::move(section));
  for (Section& section : camera_sections(result)) sections.push_back(std::move(section));
  std::vector<std::string_view> names;
  for (const Section& section : sections) names.push_back(section.name);
  const files::TomlTable table(document, names);
  for (const Section& section : sections) {
    if (const toml::table* inside = table.table(section.name)) read_section(*inside, section);
  }
  Checker(document, result).check();
  result.text = files::read_input_file(file, files::most_toml_bytes);
  return result;
}

}  // namespace murosimf::dataset
