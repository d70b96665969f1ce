#include "murosimf/viewer/window/gui.h"

#include <array>
#include <filesystem>

#include <backends/imgui_impl_opengl3.h>

namespace murosimf::viewer {
namespace {

struct TextKey {
  const char* name;
  ImGuiKey key;
};
/// Keys for editing text.
constexpr std::array text_keys{TextKey{"Tab", ImGuiKey_Tab},
                               TextKey{"Left", ImGuiKey_LeftArrow},
                               TextKey{"Right", ImGuiKey_RightArrow},
                               TextKey{"Up", ImGuiKey_UpArrow},
                               TextKey{"Down", ImGuiKey_DownArrow},
                               TextKey{"PageUp", ImGuiKey_PageUp},
                               TextKey{"PageDown", ImGuiKey_PageDown},
                               TextKey{"Home", ImGuiKey_Home},
                               TextKey{"End", ImGuiKey_End},
                               TextKey{"Delete", ImGuiKey_Delete},
                               TextKey{"Backspace", ImGuiKey_Backspace},
                               TextKey{"Enter", ImGuiKey_Enter},
                               TextKey{"Escape", ImGuiKey_Escape},
                               TextKey{"A", ImGuiKey_A},
                               TextKey{"C", ImGuiKey_C},
                               TextKey{"V", ImGuiKey_V},
                               TextKey{"X", ImGuiKey_X},
                               TextKey{"Y", ImGuiKey_Y},
                               TextKey{"Z", ImGuiKey_Z}};

void feed_key(const KeyInput& input) {
  ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(ImGuiMod_Ctrl, input.chord.ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, input.chord.shift);
  io.AddKeyEvent(ImGuiMod_Alt, input.chord.alt);
  for (const TextKey& key : text_keys) {
    if (input.chord.key == key.name) io.AddKeyEvent(key.key, input.pressed);
  }
#else
  io.KeyCtrl = input.chord.ctrl;
  io.KeyShift = input.chord.shift;
  io.KeyAlt = input.chord.alt;
  for (std::size_t i = 0; i < text_keys.size(); ++i) {
    if (input.chord.key == text_keys[i].name) io.KeysDown[i] = input.pressed;
  }
#endif
}

void number_keys() {
#if IMGUI_VERSION_NUM < 18700
  for (std::size_t i = 0; i < text_keys.size(); ++i) ImGui::GetIO().KeyMap[text_keys[i].key] = static_cast<int>(i);
#endif
}

/// The first font that is installed; ImGui's own has no letters besides ASCII.
void choose_letters(float size) {
  ImGuiIO& io = ImGui::GetIO();
  for (const char* file :
       {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"}) {
    std::error_code none;
    if (std::filesystem::exists(file, none) && io.Fonts->AddFontFromFileTTF(file, size)) return;
  }
  ImFontConfig config;
  config.SizePixels = size;
  io.Fonts->AddFontDefault(&config);
}

void choose_style(float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  ImGui::StyleColorsDark();
  style.WindowRounding = 0;
  style.WindowBorderSize = 0;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.TabRounding = 3;
  style.WindowPadding = {8, 6};
  style.ItemSpacing = {6, 4};
  style.FramePadding = {6, 3};
  style.ScrollbarSize = 12;
  style.Colors[ImGuiCol_WindowBg] = {0.11F, 0.12F, 0.13F, 0.96F};
  style.Colors[ImGuiCol_PopupBg] = {0.14F, 0.15F, 0.17F, 0.98F};
  style.ScaleAllSizes(scale);
}

}  // namespace

Gui::Gui(double scale) : letters_scale_(scale), scale_(scale) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // no files are written unasked
  ImGui::GetIO().LogFilename = nullptr;
  number_keys();
  choose_letters(static_cast<float>(usual_letters * scale));
  choose_style(static_cast<float>(scale));
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Gui::set_scale(double scale) {
  if (scale == std::exchange(scale_, scale)) return;
  choose_style(static_cast<float>(scale));
  ImGui::GetIO().FontGlobalScale = static_cast<float>(scale / letters_scale_);
}

void Gui::feed(const Input& input) {
  if (const auto* key = std::get_if<KeyInput>(&input)) feed_key(*key);
  if (const auto* letter = std::get_if<TextInput>(&input)) ImGui::GetIO().AddInputCharacter(letter->letter);
  if (const auto* move = std::get_if<MoveInput>(&input)) mouse_ = move->place;
  if (const auto* button = std::get_if<ButtonInput>(&input))
    buttons_[static_cast<std::size_t>(button->button)] = button->pressed;
  if (const auto* wheel = std::get_if<WheelInput>(&input)) wheel_ += wheel->clicks;
}

/// The state of the mouse once in each frame; steps of the wheel add up since the frame before.
void Gui::feed_pointer() {
  ImGuiIO& io = ImGui::GetIO();
  const ImVec2 place = vec2(mouse_);
  const auto clicks = static_cast<float>(std::exchange(wheel_, 0));
#if IMGUI_VERSION_NUM >= 18700
  io.AddMousePosEvent(place.x, place.y);
  for (std::size_t i = 0; i < buttons_.size(); ++i) io.AddMouseButtonEvent(static_cast<int>(i), buttons_[i]);
  if (clicks != 0) io.AddMouseWheelEvent(0, clicks);
#else
  io.MousePos = place;
  for (std::size_t i = 0; i < buttons_.size(); ++i) io.MouseDown[i] = buttons_[i];
  io.MouseWheel = clicks;
#endif
}

/// At least 0.1 ms: ImGui refuses a frame that takes no time.
void Gui::begin(int width, int height, double wall) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = vec2(width, height);
  io.DeltaTime = static_cast<float>(std::max(1e-4, wall));
  feed_pointer();
  last_places_ = std::exchange(places_, {});
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Gui::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Gui::remember(const std::string& name) {
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  places_.emplace(name, Pixel{0.5 * (low.x + high.x), 0.5 * (low.y + high.y)});
}

std::optional<Pixel> Gui::place_of(const std::string& name) const {
  for (const auto* places : {&places_, &last_places_}) {
    if (const auto found = places->find(name); found != places->end()) return found->second;
  }
  return std::nullopt;
}

std::vector<std::string> Gui::names() const {
  std::vector<std::string> all;
  for (const auto& [name, place] : places_) all.push_back(name);
  return all;
}

bool Gui::button(const std::string& name) {
  const bool pressed = ImGui::Button(name.c_str());
  remember(name);
  return pressed;
}

bool Gui::checkbox(const std::string& name, bool& value) {
  const bool changed = ImGui::Checkbox(name.c_str(), &value);
  remember(name);
  return changed;
}

bool Gui::selectable(const std::string& name, bool selected) {
  const bool pressed = ImGui::Selectable(name.c_str(), selected);
  remember(name);
  return pressed;
}

std::optional<std::size_t> Gui::choice(const std::string& name, const std::string& now,
                                       const std::vector<std::string>& names) {
  std::optional<std::size_t> chosen;
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), now.c_str());
  remember(name);
  if (!open) return chosen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (selectable(names[i], names[i] == now)) chosen = i;
  }
  ImGui::EndCombo();
  return chosen;
}

}  // namespace murosimf::viewer
