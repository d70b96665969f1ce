/// foxglove_pictures.h - pictures of cameras as messages for Foxglove and Lichtblick: those of recordings (recording/recorded_picture.h).
///
/// Created in separate threads: calibrations and pictures take longer than the server may block.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/recorded_picture.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/web/camera_subscriptions.h"

namespace murosimf::web {

/// A message.
struct FoxglovePacket {
  std::uint16_t channel = 0;
  Duration time{};
  std::shared_ptr<const std::string> bytes{};
};

/// "blue1.camera" of "/cameras/blue1/camera/image"; empty: no camera.
[[nodiscard]] std::string camera_of(const std::string& topic);

/// All calls by one thread.
class FoxglovePictures {
 public:
  using Infos = std::shared_ptr<std::deque<sensors::CameraFrame>>;
  /// `infos`: the targets of `cameras`.
  FoxglovePictures(Infos infos, std::vector<recording::RecordedCamera> cameras);

  /// Whether no work is pending.
  [[nodiscard]] bool is_free();
  /// Reason why there will be no more pictures, in one line; empty: no error.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  /// Returns the number of a new channel, by topic, name of the schema and schema.
  using AddChannel = std::function<std::uint16_t(const std::string&, const std::string&, const std::string&)>;
  /// Messages since the last call, for channels that were added. While it is free.
  [[nodiscard]] std::vector<FoxglovePacket> take(const AddChannel& add);
  /// Starts encoding new pictures of these cameras. While it is free.
  void make(const CameraSubscriptions& subscriber, const std::set<std::string>& wanted);
  /// The camera has no subscription any more: later ones get the picture of that time.
  void forget(const std::string& camera) { told_.erase(camera); }

 private:
  /// Its channels have numbers of their own.
  struct Sink final : recording::MessageSink {
    std::uint16_t add_schema(const std::string& name, const std::string& encoding, std::string data) override;
    std::uint16_t add_channel(const std::string& topic, const std::string& encoding, std::uint16_t schema,
                              recording::TextMap metadata) override;
    void write(std::uint16_t channel, Duration time, std::string_view data) override;
    std::vector<std::pair<std::string, std::string>> schemas;     // name, descriptors
    std::vector<std::pair<std::string, std::uint16_t>> channels;  // topic, schema
    std::vector<FoxglovePacket> packets;
  };

  Infos infos_;
  std::vector<recording::RecordedCamera> cameras_;
  std::vector<recording::RecordedEntity> no_entities_;
  std::vector<recording::RecordedSensor> no_sensors_;
  Sink sink_;
  recording::FrameWriter frames_{sink_, no_entities_, no_sensors_, nullptr, {}};
  std::optional<recording::PictureWriter> writer_;
  std::vector<std::uint16_t> channels_;        // numbers of the server, by number of the sink
  std::map<std::string, std::uint64_t> told_;  // numbers (SeenPicture)
  std::string trouble_;
  std::future<void> work_;  // its destructor waits
};

}  // namespace murosimf::web
