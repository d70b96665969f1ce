#include "murosimf/studies/inertial_recorder.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::studies {
namespace {

std::span<const double> output_of(const sensors::Reading& reading, std::string_view name) {
  const bool has = std::ranges::count(reading.info->outputs, name, &sensors::Output::name) > 0;
  return has ? reading.output(name) : std::span<const double>{};
}

}  // namespace

InertialRecorder::InertialRecorder(Setup& setup, double longest) : gravity_(norm(setup.world().gravity)) {
  MUROSIMF_ASSERT(longest >= 0);
  for (const sensors::Reading* reading : sensors::readings_of(setup.entity())) {
    const Source source{reading, output_of(*reading, "accelerometer"), output_of(*reading, "gyroscope"),
                        reading->samples};
    if (source.force.empty() && source.rate.empty()) continue;
    sources_.push_back(source);
    InertialRecord& record = records_.emplace_back();
    record.name = reading->info->name;
    record.accelerometer = !source.force.empty();
    record.gyroscope = !source.rate.empty();
    // Room for all samples: step() must not allocate.
    record.samples.reserve(static_cast<std::size_t>(longest / seconds(reading->info->period)) + 2);
  }
}

void InertialRecorder::step(const Instant&) noexcept {
  MUROSIMF_ASSERT(records_.size() == sources_.size());
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    Source& source = sources_[i];
    // Sensors may be slower than steps.
    if (source.reading->samples == source.seen) continue;
    source.seen = source.reading->samples;
    InertialSample sample{seconds(source.reading->time)};
    if (!source.force.empty()) sample.force = norm(sensors::vector_of(source.force)) - gravity_;
    if (!source.rate.empty()) sample.rate = norm(sensors::vector_of(source.rate));
    records_[i].samples.push_back(sample);
  }
}

}  // namespace murosimf::studies
