/// live_scene.h - data of a running scene shared by all clients of a server: appearance, poses, state, numbers, pictures.
///
/// Requested and distributed by one thread, the server's; the simulation's thread is visited about ten times per wall second, while
/// there are clients, and copies poses.
#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/drawing/drawn.h"
#include "murosimf/runtime/pose_feed.h"
#include "murosimf/session/session.h"
#include "murosimf/web/camera_subscriptions.h"
#include "murosimf/web/outbox.h"
#include "murosimf/web/scene_document.h"

namespace murosimf::league {
class GameTask;
}

namespace murosimf::web {

/// Data requested by clients in addition to poses and state. Counted again in every look.
struct Requests {
  int clients = 0;
  bool contacts = false;
  std::vector<std::string> numbers;  ///< paths as of logs, each denotes one number (watched_numbers.h)
  std::vector<std::string> cameras;  ///< "blue1.camera"
};

/// An observer.
class Subscriber {
 public:
  virtual ~Subscriber() = default;
  /// Adds its requests.
  virtual void add(Requests& requests) const = 0;
};

/// New messages of the last look. Null bytes: none.
struct News {
  Message poses, poses_with_contacts;
  Message state, lines, values, drawings;
  std::map<std::string, Message> pictures,
      camera_notes;  ///< by camera; a note has the source of the picture, or the reason why there is none
};

class LiveScene {
 public:
  /// `poses`: of the scene's simulation; `game`: null if there is no referee; `others`: null if no other program draws. All must outlive it.
  LiveScene(session::Session& session, PoseFeed& poses, const CameraSubscriptions& cameras,
            const league::GameTask* game, const drawing::DebugDrawSource* others = nullptr)
      : session_(session), poses_(poses), cameras_(cameras), game_(game), others_(others) {}

  void join(const Subscriber& subscriber) { subscribers_.push_back(&subscriber); }
  void leave(const Subscriber& subscriber) { std::erase(subscribers_, &subscriber); }

  /// Requests data for subscribers, and receives earlier requests.
  void look();

  [[nodiscard]] const News& news() const { return news_; }
  [[nodiscard]] session::Session& session() { return session_; }
  /// Cameras with observers.
  [[nodiscard]] const std::set<std::string>& wanted_cameras() const { return wanted_cameras_; }

  /// The scene document as a message, and the number of its versions; 0: none yet.
  [[nodiscard]] const Message& document() const { return document_message_; }
  [[nodiscard]] std::uint64_t documents() const { return documents_; }
  /// The last message of each kind, for new clients.
  [[nodiscard]] const News& last() const { return last_; }

 private:
  struct Visit;
  void read_poses(const Requests& requests);
  void take(const Visit& visit);
  void take_drawings(const Visit& visit);
  void take_pictures(const Requests& requests);
  void ask(const Requests& requests);
  void subscribe(const Requests& requests);

  session::Session& session_;
  PoseFeed& poses_;
  const CameraSubscriptions& cameras_;
  const league::GameTask* game_;
  const drawing::DebugDrawSource* others_;
  std::vector<const Subscriber*> subscribers_;
  News news_, last_;
  std::shared_ptr<const SceneDocument> scene_;
  Message document_message_;
  std::uint64_t documents_ = 0;
  int changes_ = -1;  // shown by the document (SceneParts::changes_to_see)

  std::shared_ptr<PoseReader> reader_;
  PoseRequest request_;
  bool is_new_reader_ = false;
  Duration shown_{};  // of the last poses
  std::shared_ptr<Visit> visit_;
  std::future<void> visited_;
  std::chrono::steady_clock::time_point next_visit_{};
  std::set<std::string> wanted_cameras_;
  std::map<std::string, std::uint64_t> told_pictures_;  // numbers (SeenPicture)
  std::string state_, lines_;                           // last messages sent
  std::vector<std::string> teams_;                      // of entities
  std::vector<drawing::Drawn> drawn_;                   // by robots
  std::uint64_t drawn_by_others_ = 0;                   // changes sent
  bool is_drawn_ = false;                               // whether there are drawings
};

}  // namespace murosimf::web
