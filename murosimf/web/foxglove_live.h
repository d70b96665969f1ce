/// foxglove_live.h - a running scene as messages for Foxglove and Lichtblick: those of recordings (recording/frame_writer.h), in real time.
///
/// Pictures of any camera (camera_subscriptions.h, foxglove_pictures.h) are sent while there are subscriptions to them.
///
/// In the server's thread; pictures are encoded in another. While clients are connected, the simulation's thread is visited up to 30 times per wall second, and copies
/// the data that recordings would have of that instant.
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
  /// A client subscribes to a channel, or unsubscribes.
  void subscribe(std::uint16_t channel, bool on);
  void look();

  /// Cameras with subscriptions.
  [[nodiscard]] std::set<std::string> wanted_cameras() const;
  /// Reason why there is no picture on a channel, in one line; empty: no error, or no channel of pictures.
  [[nodiscard]] std::string trouble_of(std::uint16_t channel) const;

  [[nodiscard]] session::Session& session() { return session_; }
  [[nodiscard]] const std::string& scene_name() const { return scene_name_; }
  [[nodiscard]] const std::vector<FoxgloveChannel>& channels() const { return channels_; }
  /// Messages of the last look, ordered by time.
  [[nodiscard]] const std::vector<Packet>& news() const { return news_; }
  /// The last message of a channel, for new subscriptions; null bytes: none.
  [[nodiscard]] Packet last(std::uint16_t channel) const;
  [[nodiscard]] Duration time() const { return time_; }
  /// Parameters of robots at the last visit: "blue1.level", with its value.
  [[nodiscard]] const std::map<std::string, std::string>& parameters() const { return parameters_; }
  /// One of them was changed; the next visit shows it.
  void parameter_became(const std::string& name, const std::string& value) {
    if (parameters_.contains(name)) parameters_[name] = value;
  }
  /// Whether all messages must be sent; of other channels the newest is sufficient.
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
  std::uint64_t setups_ = 0, jumps_ = 0;      // valid for the present writer
};

}  // namespace murosimf::web
