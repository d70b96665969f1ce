/// live_scene.h - what all clients of a server share of a running scene: looks, poses, state, numbers, pictures.
///
/// One thread, the server's, asks for it and hands it on; the simulation's thread is visited about ten times per wall second, as long as
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

/// What clients want besides poses and state. All of it is counted anew in every look.
struct Requests {
  int clients = 0;
  bool contacts = false;
  std::vector<std::string> numbers;  ///< paths as of logs, each means one (watched_numbers.h)
  std::vector<std::string> cameras;  ///< "blue1.camera"
};

/// Somebody who looks on.
class Subscriber {
 public:
  virtual ~Subscriber() = default;
  /// Adds what this one wants.
  virtual void add(Requests& requests) const = 0;
};

/// Messages that were new in the last look. Null bytes: there was none.
struct News {
  Message poses, poses_with_contacts;
  Message state, lines, values, drawings;
  std::map<std::string, Message> pictures,
      camera_notes;  ///< by camera; a note says whose picture it is, or why there is none
};

class LiveScene {
 public:
  /// `poses`: of the scene's simulation; `game`: null if nobody referees; `others`: null if no other program draws. All must outlive it.
  LiveScene(session::Session& session, PoseFeed& poses, const CameraSubscriptions& cameras,
            const league::GameTask* game, const drawing::DebugDrawSource* others = nullptr)
      : session_(session), poses_(poses), cameras_(cameras), game_(game), others_(others) {}

  void join(const Subscriber& subscriber) { subscribers_.push_back(&subscriber); }
  void leave(const Subscriber& subscriber) { std::erase(subscribers_, &subscriber); }

  /// Asks for what they want, and takes what has come.
  void look();

  [[nodiscard]] const News& news() const { return news_; }
  [[nodiscard]] session::Session& session() { return session_; }
  /// Cameras that somebody looks through.
  [[nodiscard]] const std::set<std::string>& wanted_cameras() const { return wanted_cameras_; }

  /// The scene document as a message, and how often it has changed; 0: there is none yet.
  [[nodiscard]] const Message& document() const { return document_message_; }
  [[nodiscard]] std::uint64_t documents() const { return documents_; }
  /// The last of each, for who comes now.
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
  int changes_ = -1;  // that the document shows (SceneParts::changes_to_see)

  std::shared_ptr<PoseReader> reader_;
  PoseRequest request_;
  bool is_new_reader_ = false;
  Duration shown_{};  // of the last poses
  std::shared_ptr<Visit> visit_;
  std::future<void> visited_;
  std::chrono::steady_clock::time_point next_visit_{};
  std::set<std::string> wanted_cameras_;
  std::map<std::string, std::uint64_t> told_pictures_;  // numbers (SeenPicture)
  std::string state_, lines_;                           // that clients have
  std::vector<std::string> teams_;                      // of entities
  std::vector<drawing::Drawn> drawn_;                   // by robots
  std::uint64_t drawn_by_others_ = 0;                   // changes that clients have
  bool is_drawn_ = false;                               // anything
};

}  // namespace murosimf::web
