/// scene.h - a scene, built and ready to run.
///
///     murosimf::Scene scene("walk", {.set = {"walker.level=simplified_dynamics"}});
///     scene.run(5.0);
///     const murosimf::Vector3 head = scene.robot("walker").pose("head").position;
///
/// A scene is for one thread at a time; several scenes run at the same time in several threads. The same scene, seed and calls give
/// the same states, bit for bit, for any number of threads. All calls throw as error.h says; a call that throws an InputError has changed nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/error.h"
#include "murosimf/robot.h"

namespace murosimf {
inline namespace v0 {

struct SceneOptions {
  int threads = 1;
  std::optional<std::uint64_t> seed;  ///< instead of the scene's
  std::vector<std::string> set;       ///< PATH=VALUE, as for `murosimf run --set`
  std::vector<std::string> events;    ///< TIME:PATH=VALUE, as for --at
  std::vector<std::string> pushes;    ///< `OBJECT=FORCE@BEGIN..END`, as for --push
  bool libraries = false;  ///< control software that the file names may be loaded; it has all rights of the program
  bool lenient = false;    ///< unknown elements of robot files are warnings
  bool cameras = true;     ///< false: nothing is drawn for cameras
};

/// A robot to be added to a scene.
struct NewRobot {
  std::string name;
  std::string model;  ///< a file, or the name of a model of the library
  std::string level = "articulated_dynamics";
  std::string controller = "none";
  std::string team;    ///< of the scene; empty: none
  Vector3 position;    ///< [m] x and y of the base; z of its lowest point
  double heading = 0;  ///< [rad]
};

/// A body to be added to a scene.
struct NewBody {
  std::string name;
  enum class Shape { sphere, box, capsule, cylinder } shape = Shape::sphere;
  /// [m] sphere: radius in x; box: edges; capsule and cylinder: radius in x, length (of the straight part) in z.
  Vector3 size{0.05, 0.05, 0.05};
  double mass = 0.1;  ///< [kg]
  std::string material = "plastic";
  Vector3 position;    ///< [m] x and y of its middle, z of its lowest point
  double heading = 0;  ///< [rad]
  Vector3 velocity;    ///< [m/s] world
};

/// An event at simulated time `time` [s].
struct RunEvent {
  double time = 0;
  std::string text;
};

/// A viewpoint for pictures.
struct Viewpoint {
  Vector3 eye{0, -4, 2}, look_at{0, 0, 0.3};  ///< [m] world
  double field_of_view = 1.0;                 ///< [rad] from the left to the right border
  int width = 640, height = 480;              ///< [px]
};

class MUROSIMF_API Scene {
 public:
  /// `name`: a file, or the name of a scene of the library (`murosimf list scenes`).
  explicit Scene(const std::string& name, const SceneOptions& options = {});
  /// The text of a scene file (TOML, docs/scenes.md). Files that it names are looked for here and among those of the library; errors
  /// name places as of a file "scene.toml".
  [[nodiscard]] static Scene of_text(const std::string& toml, const SceneOptions& options = {});
  /// A robot alone on the ground, called "robot", at `articulated_dynamics` and without controller, unless
  /// options.set says otherwise.
  [[nodiscard]] static Scene of_robot(const std::string& model, const SceneOptions& options = {});
  /// A copy that continues from the present state. Controllers of the program (Robot::set_controller) stay with the original.
  [[nodiscard]] Scene copy() const;
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Title of the scene.
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] double time() const;               ///< [s] simulated
  [[nodiscard]] std::int64_t nanoseconds() const;  ///< the same, exactly
  [[nodiscard]] double step_length() const;        ///< [s]

  void step(int steps = 1);
  /// Runs for so many simulated seconds, rounded up to whole steps.
  void run(double seconds);
  /// Runs until condition(), which is called before every step, is true, but at most so many seconds. Returns whether it became true.
  template <class Condition>
  bool run_until(Condition&& condition, double at_most) {
    for (const double end = time() + at_most; !condition(); step()) {
      if (time() >= end) return false;
    }
    return true;
  }

  /// Back to the start, without building the scene anew; with this seed, if given.
  void reset();
  void reset(std::uint64_t seed);
  /// The whole state of the run. load() continues from it, bit for bit, also in another process with the same scene
  /// and options.
  [[nodiscard]] std::vector<std::byte> save();
  void load(std::span<const std::byte> state);
  /// Why an algorithm of the scene file has ended the run, "NAME: reason" (docs/python.md); empty: none has. run() steps no further then,
  /// step() does.
  [[nodiscard]] std::string ended() const;
  /// Equal states have equal hashes.
  [[nodiscard]] std::uint64_t state_hash() const;

  /// PATH=VALUE as of events (docs/levels.md): "blue1.level=full_dynamics". All of them at once, or none.
  void change(const std::string& assignment);
  void change(const std::vector<std::string>& assignments);

  /// Names, in the order of the scene.
  [[nodiscard]] std::vector<std::string> robots() const;
  [[nodiscard]] std::vector<std::string> entities() const;
  [[nodiscard]] Robot robot(std::string_view name) const;
  [[nodiscard]] EntityHandle entity(std::string_view name) const;
  /// The first robot of the file.
  [[nodiscard]] Robot robot() const;

  Robot add(const NewRobot& robot);
  EntityHandle add(const NewBody& body);
  /// Robots, ball and bodies leave, and come back as at their start; their handles stay valid (docs/embedding.md).
  void leave(std::string_view entity);
  void enter(std::string_view entity);

  /// Contacts of the last step, each once.
  [[nodiscard]] std::vector<Contact> contacts() const;
  /// Along `direction` (any length but 0) from `origin` [m] up to `range` [m]; `without`: an entity that the ray ignores.
  [[nodiscard]] std::optional<RayHit> cast(const Vector3& origin, const Vector3& direction,
                                           double range = std::numeric_limits<double>::infinity(),
                                           std::string_view without = {}) const;
  /// [m] Between two entities, negative where they overlap; nothing if one of them has no shapes that collide.
  [[nodiscard]] std::optional<double> distance(std::string_view a, std::string_view b) const;

  [[nodiscard]] std::vector<RunEvent> events() const;
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// The scene as seen from a viewpoint. Throws InputError where MUROSIMF_RENDERER asks for OpenGL and there is none.
  [[nodiscard]] Image picture(const Viewpoint& from = {}) const;

 private:
  friend class Recorder;
  friend class Session;
  friend class WebPage;
  friend class Batch;
  explicit Scene(std::shared_ptr<api::SceneInside> inside);
  [[nodiscard]] api::SceneInside& inside() const;
  std::shared_ptr<api::SceneInside> inside_;
};

}  // namespace v0
}  // namespace murosimf
