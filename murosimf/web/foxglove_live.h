/// foxglove_live.h - a running scene as messages for Foxglove and Lichtblick: those of recordings (recording/frame_writer.h), as they come.
///
/// Pictures of cameras (foxglove_pictures.h) come while somebody has subscribed to them, of any camera (camera_subscriptions.h).
///
/// In the server's thread; pictures are encoded in another. As long as somebody is connected, the simulation's thread is visited up to 30 times per wall second, and copies
/// what recordings would have of that instant.
#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/session/session.h"
#include "murosimf/web/camera_subscriptions.h"
#include "murosimf/web/foxglove_pictures.h"

namespace murosimf::web {

struct FoxgloveChannel {
  std::uint16_t id = 0;
  std::string topic, schema_name, schema;  ///< schema: a FileDescriptorSet
};

class FoxgloveLive final : private recording::MessageSink {
 public:
  /// `others`: null if no other program draws. All must outlive it.
  FoxgloveLive(session::Session& session, const CameraSubscriptions& cameras,
               const drawing::DebugDrawSource* others = nullptr);
  ~FoxgloveLive() override;

  using Packet = FoxglovePacket;

  void join() { ++clients_; }
  void leave() { --clients_; }
  /// A client wants a channel, or no longer.
  void subscribe(std::uint16_t channel, bool on);
  void look();

  /// Those whose pictures somebody wants.
  [[nodiscard]] std::set<std::string> wanted_cameras() const;
  /// Why there is no picture on a channel, in one line; empty: all is well, or it is not one of pictures.
  [[nodiscard]] std::string trouble_of(std::uint16_t channel) const;

  [[nodiscard]] session::Session& session() { return session_; }
  [[nodiscard]] const std::string& scene_name() const { return scene_name_; }
  [[nodiscard]] const std::vector<FoxgloveChannel>& channels() const { return channels_; }
  /// Of the last look, in the order of time.
  [[nodiscard]] const std::vector<Packet>& news() const { return news_; }
  /// The last message of a channel, for who subscribes now; null bytes: there is none.
  [[nodiscard]] Packet last(std::uint16_t channel) const;
  [[nodiscard]] Duration time() const { return time_; }
  /// Of robots, as they were in the last visit: "blue1.level", with its value.
  [[nodiscard]] const std::map<std::string, std::string>& parameters() const { return parameters_; }
  /// One of them has changed; the next visit sees it.
  void parameter_became(const std::string& name, const std::string& value) {
    if (parameters_.contains(name)) parameters_[name] = value;
  }
  /// Lines are to be sent all; of other channels the newest is enough.
  [[nodiscard]] bool is_of_lines(std::uint16_t channel) const;

 private:
  struct Visit;
  [[nodiscard]] std::uint16_t add_schema(const std::string& name, const std::string& encoding,
                                         std::string data) override;
  [[nodiscard]] std::uint16_t add_channel(const std::string& topic, const std::string& encoding, std::uint16_t schema,
                                          recording::TextMap metadata) override;
  void write(std::uint16_t channel, Duration time, std::string_view data) override;
  void take(Visit& visit);
  void renew_writers(Visit& visit);
  void put(const Packet& packet);
  void take_pictures();

  session::Session& session_;
  const CameraSubscriptions& camera_subscriptions_;
  const drawing::DebugDrawSource* others_;
  int clients_ = 0;
  std::string scene_name_;
  std::vector<std::pair<std::string, std::string>> schemas_;  // name, descriptors
  std::vector<FoxgloveChannel> channels_;
  std::map<std::uint16_t, Packet> last_;
  std::vector<Packet> news_;
  std::map<std::string, std::string> parameters_;
  Duration time_{};

  std::shared_ptr<Visit> visit_;
  std::future<void> visited_;
  std::chrono::steady_clock::time_point next_visit_{};
  std::unique_ptr<recording::FrameWriter> writer_;
  std::unique_ptr<recording::DrawingWriter> drawings_;
  std::unique_ptr<FoxglovePictures> pictures_;
  std::map<std::uint16_t, int> subscribers_;  // by channel
  std::uint64_t setups_ = 0, jumps_ = 0;      // that the writer was made for
};

}  // namespace murosimf::web
