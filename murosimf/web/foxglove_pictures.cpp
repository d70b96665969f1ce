#include "murosimf/web/foxglove_pictures.h"

#include <algorithm>
#include <chrono>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::web {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view of_cameras = "/cameras/";

}  // namespace

std::string camera_of(const std::string& topic) {
  const std::size_t end = topic.rfind('/');
  if (!topic.starts_with(of_cameras) || end <= of_cameras.size()) return {};
  std::string camera = topic.substr(of_cameras.size(), end - of_cameras.size());
  std::ranges::replace(camera, '/', '.');
  return camera;
}

std::uint16_t FoxglovePictures::Sink::add_schema(const std::string& name, const std::string&, std::string data) {
  schemas.emplace_back(name, std::move(data));
  return static_cast<std::uint16_t>(schemas.size() - 1);
}

std::uint16_t FoxglovePictures::Sink::add_channel(const std::string& topic, const std::string&, std::uint16_t schema,
                                                  recording::TextMap) {
  channels.emplace_back(topic, schema);
  return static_cast<std::uint16_t>(channels.size() - 1);
}

void FoxglovePictures::Sink::write(std::uint16_t channel, Duration time, std::string_view data) {
  packets.push_back({.channel = channel, .time = time, .bytes = std::make_shared<const std::string>(data)});
}

FoxglovePictures::FoxglovePictures(Infos infos, std::vector<recording::RecordedCamera> cameras)
    : infos_(std::move(infos)), cameras_(std::move(cameras)) {
  work_ = std::async(std::launch::async, [this] { writer_.emplace(sink_, frames_, cameras_); });
}

/// An error of the thread is kept as a text, so that it is told to the clients.
bool FoxglovePictures::is_free() {
  if (!work_.valid()) return true;
  if (work_.wait_for(0s) != std::future_status::ready) return false;
  try {
    work_.get();
  } catch (const SetupError& error) {
    trouble_ = error.what();
  }
  return true;
}

std::vector<FoxglovePacket> FoxglovePictures::take(const AddChannel& add) {
  if (!writer_) return {};
  for (std::size_t i = channels_.size(); i < sink_.channels.size(); ++i) {
    const auto& [topic, schema] = sink_.channels[i];
    MUROSIMF_ASSERT(schema < sink_.schemas.size());
    channels_.push_back(add(topic, sink_.schemas[schema].first, sink_.schemas[schema].second));
  }
  std::vector<FoxglovePacket> packets = std::exchange(sink_.packets, {});
  for (FoxglovePacket& packet : packets) {
    MUROSIMF_ASSERT(packet.channel < channels_.size());
    packet.channel = channels_[packet.channel];
  }
  return packets;
}

void FoxglovePictures::make(const CameraSubscriptions& subscriber, const std::set<std::string>& wanted) {
  if (!writer_ || !trouble_.empty()) return;
  recording::RecordedFrame frame;
  for (std::size_t i = 0; i < cameras_.size() && !wanted.empty(); ++i) {
    const std::string camera = camera_of(cameras_[i].topic + "/image");
    const auto seen = wanted.contains(camera) ? subscriber.seen(camera) : std::nullopt;
    if (!seen || !seen->frame || std::exchange(told_[camera], seen->number) == seen->number) continue;
    frame.time = seen->frame->time;
    frame.pictures.push_back(
        {.camera = i, .taken = seen->frame->time, .color = seen->frame->color, .mosaic = seen->frame->mosaic});
  }
  if (frame.pictures.empty()) return;
  work_ = std::async(std::launch::async, [this, frame = std::move(frame)] { writer_->write(frame); });
}

}  // namespace murosimf::web
