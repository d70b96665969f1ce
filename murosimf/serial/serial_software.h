/// serial_software.h - control software behind a virtual serial line: the robot's bus of servos, and its IMU, at the end of a pseudo
/// terminal.
///
/// The line is served in every step (usually 1 ms of simulated time): received packets are executed and
/// answered. At the speed 1 (Clock) that is a bus with a latency of a millisecond; as fast as possible, simulated time continues
/// while the client computes. A client that disconnects, is killed, sends garbage or does not read has no effect on the run.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/control_software/control_software.h"
#include "murosimf/model/servo.h"
#include "murosimf/runtime/external_input_history.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/serial/bus_layout.h"
#include "murosimf/serial/dynamixel/bus_line.h"
#include "murosimf/serial/dynamixel/imu_board.h"
#include "murosimf/serial/dynamixel/servo_device.h"
#include "murosimf/serial/pseudo_terminal.h"

namespace murosimf::serial {

struct SerialOptions {
  int protocol = 2;       ///< of servos of the MX series, and of the IMU
  std::string bus;        ///< file for read_layout; empty: usual_layout
  double baud_rate = 0;   ///< [bit/s] initial rate of all devices; 0: usual_rate, and bytes take no time
  bool torque = false;    ///< torque of all servos is enabled at the start
  std::string imu;        ///< sensor on the bus; empty: 'imu' if there is one
  int imu_id = 200;       ///< its id, as that of boards of real robots
  bool imu_ping = false;  ///< whether it answers broadcast pings

  static constexpr double usual_rate = 1e6;  ///< [bit/s] of many robots; the factory setting of servos differs
  [[nodiscard]] double first_rate() const { return baud_rate > 0 ? baud_rate : usual_rate; }
};

class SerialSoftware final : public control_software::ControlSoftware {
 public:
  /// `folder` contains the link to the terminal, named as the robot, from the first step on; empty, or if input is
  /// repeated: there is no terminal. Throws SetupError.
  SerialSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say,
                 std::vector<ServoPlace> layout, SerialOptions options, const std::filesystem::path& folder,
                 const ExternalInputOptions& outside = {});

  [[nodiscard]] control_software::CallOutcome start() override;
  [[nodiscard]] control_software::CallOutcome step(Duration now) noexcept override;
  void state(StateArchive& archive) override;
  [[nodiscard]] bool repeats_itself() const override { return true; }

  /// Null: there is none.
  [[nodiscard]] const PseudoTerminal* terminal() const { return terminal_.get(); }

  static constexpr double rate_hz = 1000;

 private:
  using WallClock = std::chrono::steady_clock;

  struct Joint {
    ServoPlace place;
    dynamixel::ServoOptions options;
    int object = 0;
    Vec3d range;                              // [rad | m] of the joint: x to y
    bool turns = false;                       // controlled by velocity
    const Servo* own = nullptr;               // the simulated one; null: the joint has none
    dynamixel::ServoDevice* servo = nullptr;  // on the bus
  };
  void add_joint(const Model& model, const ServoPlace& place);
  void find_imu(const Setup& setup, control_software::RobotPort& port);
  void switch_on();
  void sense(double now);
  /// Input of a step.
  struct Heard {
    std::optional<double> rate{};  // [bit/s] chosen by the client
    dynamixel::Bytes bytes{};      // at that rate
    bool fell_silent = false;      // within a packet
    std::optional<bool> client{};  // has connected, or disconnected
  };
  [[nodiscard]] Heard listen(double now);
  [[nodiscard]] Heard repeat(Duration now);
  /// Input of an instant that is repeated from the history.
  [[nodiscard]] Heard remember();
  [[nodiscard]] Heard heard_at(Duration now);
  [[nodiscard]] bool remembers() const { return memory_ && memory_->repeats(); }
  void write_down(const Heard& heard);
  void exchange_bytes(Duration now);
  void send();
  void look_after(bool client);
  void command();
  void tune(const Joint& joint);
  [[nodiscard]] double angle_of(const Joint& joint, double q) const;

  control_software::SayLine say_;
  SerialOptions options_;
  double period_;  // [s]
  std::vector<Joint> joints_;
  std::vector<double> rest_;  // [rad | m] of all joints at the start
  const murosimf_signal *position_, *velocity_, *torque_;
  const murosimf_signal *gyroscope_ = nullptr, *accelerometer_ = nullptr;  // null: no IMU
  murosimf_command *target_, *enabled_, *position_gain_, *velocity_gain_, *torque_limit_, *led_, *rate_ = nullptr;
  std::span<const double> voltage_, temperature_;  // by object; NaN while not simulated
  std::unique_ptr<dynamixel::Bus> bus_;
  std::optional<dynamixel::BusLine> line_;
  dynamixel::ImuBoard* imu_ = nullptr;
  std::unique_ptr<PseudoTerminal> terminal_;
  std::filesystem::path link_place_;
  std::optional<TerminalLink> link_;
  bool client_ = false, told_of_loss_ = false;
  WallClock::time_point last_byte_;
  dynamixel::Bytes to_send_;
  std::shared_ptr<ExternalInputLog> notes_;  // the pen's
  ExternalInputRecorder pen_;
  std::shared_ptr<const ExternalInputLog> repeated_;  // null: live
  ExternalInputReader reader_;
  std::shared_ptr<ExternalInputHistory> remembered_;  // the channel's
  ExternalInputHistory::Channel* memory_ = nullptr;   // null: time does not jump
  bool jumped_ = false;                               // a state was loaded since the last step that was live
  Duration next_{-1};                                 // of the step after that one
};

}  // namespace murosimf::serial
