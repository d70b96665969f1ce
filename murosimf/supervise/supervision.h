/// supervision.h - control of a run from other programs and computers, over TCP (docs/supervise.md).
///
///     session::Session session(scene);
///     const auto supervision = supervise::supervise(session, {.address = {"127.0.0.1", 5001}});
///     say(supervision->token());               // clients without it are refused
///     session.run(60s);                        // controlled by supervisors
///
/// Each supervisor has a thread of its own: it cannot disturb the run or the other supervisors.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/network/socket.h"
#include "murosimf/session/session.h"

namespace murosimf::supervise {

/// A supervisor's request for another scene.
struct SceneRequest {
  std::string scene;                   ///< a name or a file; not to be trusted (scene/requested_scene.h)
  std::vector<std::string> overrides;  ///< PATH=VALUE, likewise
  std::optional<std::uint64_t> seed;   ///< replaces the scene's
  bool paused = false;                 ///< starts paused
};

struct SupervisionOptions {
  network::Address address;
  std::string token{};  ///< at least shortest_token characters; empty: a random one
  std::function<void(const std::string& line)>
      say{};  ///< clients that were refused or dropped, one line each; called by other threads
  std::function<std::string(scene::Scene&)>
      save{};  ///< the state for supervisors; called between two steps; none: the bytes of Scene::save
  std::function<void(scene::Scene&, const std::string& bytes)>
      load{};  ///< puts a state into the scene, or throws SetupError and changes nothing; likewise; none: bytes of Scene::save
  /// Checks whether the run can change to another scene, and stores the request, or throws SetupError; likewise. Then the session is finished, and
  /// its owner starts the next one (Supervision::steer). None: the run keeps its scene.
  std::function<void(const SceneRequest&)> exchange{};
  double hello_limit = 5;  ///< [s] of wall time in which supervisors must send the token
  double patience = 10;    ///< [s] of wall time in which they must receive an answer
};

inline constexpr std::size_t shortest_token = 8;                      // characters
inline constexpr std::size_t most_supervisors = 8;                    // at a time
inline constexpr std::size_t longest_state = std::size_t{256} << 20;  // [byte] that a supervisor may send

class Supervision {
 public:
  virtual ~Supervision() = default;
  /// Address that it listens at.
  [[nodiscard]] virtual network::Address address() const = 0;
  [[nodiscard]] virtual const std::string& token() const = 0;
  /// The session has ended, and another one will follow: supervisors stay connected, and wait. Returns when the session is no longer used.
  virtual void leave() = 0;
  /// After leave(): supervisors control this session from now on.
  virtual void steer(session::Session& session) = 0;
};

/// The session must outlive it, or leave() be called before. Throws SetupError: the port is in use, the token is too short; this program was built without TCP.
[[nodiscard]] std::unique_ptr<Supervision> supervise(session::Session& session, const SupervisionOptions& options);

}  // namespace murosimf::supervise
