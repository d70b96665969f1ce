#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "arrays.h"
#include "handles.h"
#include "module.h"
#include "open_scene.h"
#include "pictures.h"
#include "scene_ref.h"

namespace murosimf::python {
namespace {

using Triple = std::array<double, 3>;

nb::bytes save(SceneRef& ref) {
  const Use use(*ref.state);
  const std::vector<std::byte> state = [&] {
    const nb::gil_scoped_release unlocked;
    return ref.state->scene.save();
  }();
  return nb::bytes(state.data(), state.size());
}

void load(SceneRef& ref, const nb::bytes& state) {
  const Use use(*ref.state, WebPage::Use::jump);
  const std::span bytes(static_cast<const std::byte*>(state.data()), state.size());
  const nb::gil_scoped_release unlocked;
  ref.state->scene.load(bytes);
}

void reset(SceneRef& ref, std::optional<std::uint64_t> seed) {
  const Use use(*ref.state, WebPage::Use::jump);
  const nb::gil_scoped_release unlocked;
  seed ? ref.state->scene.reset(*seed) : ref.state->scene.reset();
}

SceneRef copy(SceneRef& ref) {
  const Use use(*ref.state);
  const nb::gil_scoped_release unlocked;
  return {ref.state->scene.copy(), ref.state->threads};
}

/// The address of the page.
std::string show(SceneRef& ref, const std::string& address, std::optional<double> pace) {
  ref.state->close_page();
  const Use use(*ref.state);
  ref.state->threads = true;
  auto page = std::make_unique<WebPage>(ref.state->scene, WebPageOptions{address, pace.value_or(1)});
  std::string shown = page->address();
  ref.state->pace = pace;
  ref.state->page = std::move(page);
  return shown;
}

RobotRef add_robot(SceneRef& ref, NewRobot robot, const Triple& position) {
  const Use use(*ref.state);
  robot.position = vector_of(position);
  const nb::gil_scoped_release unlocked;
  return {ref.state, ref.state->scene.add(robot)};
}

EntityRef add_body(SceneRef& ref, const std::string& name, int shape, const Triple& size, double mass,
                   const std::string& material, const Triple& position, double heading, const Triple& velocity) {
  const Use use(*ref.state);
  return {ref.state, ref.state->scene.add(NewBody{.name = name,
                                                  .shape = static_cast<NewBody::Shape>(shape),
                                                  .size = vector_of(size),
                                                  .mass = mass,
                                                  .material = material,
                                                  .position = vector_of(position),
                                                  .heading = heading,
                                                  .velocity = vector_of(velocity)})};
}

/// Names (a, object, b, object) and (n, 10): point, normal, force, depth.
nb::tuple contacts(SceneRef& ref) {
  const Use use(*ref.state);
  std::vector<std::tuple<std::string, std::string, std::string, std::string>> names;
  std::vector<double> numbers;
  for (Contact& contact : ref.state->scene.contacts()) {
    names.emplace_back(std::move(contact.a), std::move(contact.a_object), std::move(contact.b),
                       std::move(contact.b_object));
    for (const Vector3& v : {contact.point, contact.normal, contact.force})
      numbers.insert(numbers.end(), {v.x, v.y, v.z});
    numbers.push_back(contact.depth);
  }
  const std::size_t count = names.size();
  return nb::make_tuple(std::move(names), array_of(std::move(numbers), {count, 10}));
}

using Hit = std::tuple<std::string, std::string, double, Triple, Triple>;

std::optional<Hit> cast(SceneRef& ref, const Triple& origin, const Triple& direction, double range,
                        const std::string& without) {
  const Use use(*ref.state);
  const auto hit = ref.state->scene.cast(vector_of(origin), vector_of(direction), range, without);
  if (!hit) return std::nullopt;
  return Hit{hit->entity, hit->object, hit->distance, array_of(hit->point), array_of(hit->normal)};
}

nb::tuple picture(SceneRef& ref, const Triple& eye, const Triple& look_at, double field_of_view, int width,
                  int height) {
  Image image = [&] {
    const Use use(*ref.state);
    ref.state->threads = true;  // what draws cannot be used in a forked child
    const nb::gil_scoped_release unlocked;
    return ref.state->scene.picture({vector_of(eye), vector_of(look_at), field_of_view, width, height});
  }();
  return layers_of(std::move(image));
}

std::vector<std::pair<double, std::string>> events(SceneRef& ref) {
  const Use use(*ref.state);
  std::vector<std::pair<double, std::string>> events;
  for (RunEvent& event : ref.state->scene.events()) events.emplace_back(event.time, std::move(event.text));
  return events;
}

}  // namespace

void bind_scenes(nb::module_& module) {
  const nb::arg name("name"), seed("seed");
  nb::class_<SceneRef>(module, "Scene")
      .def("name",
           [](SceneRef& ref) {
             const Use use(*ref.state);
             return ref.state->scene.name();
           })
      .def("time",
           [](SceneRef& ref) {
             const Look look(*ref.state);
             return ref.state->scene.time();
           })
      .def("nanoseconds",
           [](SceneRef& ref) {
             const Look look(*ref.state);
             return ref.state->scene.nanoseconds();
           })
      .def("step_length",
           [](SceneRef& ref) {
             const Use use(*ref.state);
             return ref.state->scene.step_length();
           })
      .def("step", &SceneRef::step, nb::arg("steps"))
      .def("run", &SceneRef::run, nb::arg("seconds"))
      .def("show", &show, nb::arg("address"), nb::arg("pace").none())
      .def("hide", [](SceneRef& ref) { ref.state->close_page(); })
      .def("reset", &reset, nb::arg("seed").none())
      .def("save", &save)
      .def("load", &load, nb::arg("state"))
      .def("copy", &copy)
      .def("state_hash",
           [](SceneRef& ref) {
             const Use use(*ref.state);
             return ref.state->scene.state_hash();
           })
      .def(
          "change",
          [](SceneRef& ref, const std::vector<std::string>& assignments) {
            const Use use(*ref.state);
            const nb::gil_scoped_release unlocked;
            ref.state->scene.change(assignments);
          },
          nb::arg("assignments"))
      .def("robots",
           [](SceneRef& ref) {
             const Use use(*ref.state);
             return ref.state->scene.robots();
           })
      .def("entities",
           [](SceneRef& ref) {
             const Use use(*ref.state);
             return ref.state->scene.entities();
           })
      .def(
          "robot",
          [](SceneRef& ref, const std::string& of) {
            const Use use(*ref.state);
            return RobotRef(ref.state, ref.state->scene.robot(of));
          },
          name)
      .def(
          "entity",
          [](SceneRef& ref, const std::string& of) {
            const Use use(*ref.state);
            return EntityRef{ref.state, ref.state->scene.entity(of)};
          },
          name)
      .def(
          "add_robot",
          [](SceneRef& ref, const std::string& of, const std::string& model, const std::string& level,
             const std::string& controller, const std::string& team, const Triple& position, double heading) {
            return add_robot(ref, {of, model, level, controller, team, {}, heading}, position);
          },
          name, nb::arg("model"), nb::arg("level"), nb::arg("controller"), nb::arg("team"), nb::arg("position"),
          nb::arg("heading"))
      .def("add_body", &add_body, name, nb::arg("shape"), nb::arg("size"), nb::arg("mass"), nb::arg("material"),
           nb::arg("position"), nb::arg("heading"), nb::arg("velocity"))
      .def(
          "leave",
          [](SceneRef& ref, const std::string& of) {
            const Use use(*ref.state);
            ref.state->scene.leave(of);
          },
          name)
      .def(
          "enter",
          [](SceneRef& ref, const std::string& of) {
            const Use use(*ref.state);
            ref.state->scene.enter(of);
          },
          name)
      .def("contacts", &contacts)
      .def("cast", &cast, nb::arg("origin"), nb::arg("direction"), nb::arg("range"), nb::arg("without"))
      .def(
          "distance",
          [](SceneRef& ref, const std::string& a, const std::string& b) {
            const Use use(*ref.state);
            return ref.state->scene.distance(a, b);
          },
          nb::arg("a"), nb::arg("b"))
      .def("events", &events)
      .def("ended",
           [](const SceneRef& ref) {
             const Look look(*ref.state);
             return ref.state->scene.ended();
           })
      .def("warnings",
           [](SceneRef& ref) {
             const Use use(*ref.state);
             return ref.state->scene.warnings();
           })
      .def("picture", &picture, nb::arg("eye"), nb::arg("look_at"), nb::arg("field_of_view"), nb::arg("width"),
           nb::arg("height"));
  bind_opening(module);
}

}  // namespace murosimf::python
