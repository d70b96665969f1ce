/// murosimf_controller.h - what a shared library has to offer to be the control software of simulated robots.
///
/// Plain C, and nothing else is needed: no other header, no library to link. The simulator loads the library by
///
///     controller = "library"
///     library = "build/libwalk.so"
///     [robots.options]
///     speed = 0.2
///
/// and asks `murosimf_controller_entry` for its functions. For every robot with this library it makes one instance by `create`, and
/// calls `step` at the instance's rate of simulated time, always between two steps of the simulation: nothing moves meanwhile.
///
/// All names are looked up in `create`; afterwards reading and setting is an access to memory. Units are SI: m, rad, s, N, N m.
/// docs/library.md lists the names and has examples.
#ifndef MUROSIMF_CONTROLLER_H
#define MUROSIMF_CONTROLLER_H
#pragma once

// NOLINTBEGIN(modernize-*): C is C
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header. A program takes libraries of its own version and of all before:
 *   3  pictures of cameras; drawings
 *   2  messages between the robots of a team
 *   1  the first one */
#define MUROSIMF_CONTROLLER_ABI 3u

/* Flags of a library. Instances of one library share its global variables, so they are called one after the other, in the order
 * of the robots. A library without such variables may say that its instances can be called at the same time. */
#define MUROSIMF_INDEPENDENT_INSTANCES 1u

/* A row of numbers to read, up to date in every step. */
typedef struct murosimf_signal {
  const double* values;
  size_t count;
  int64_t time;     /* [ns] of simulated time, at which they were measured */
  uint64_t samples; /* that have come so far: a new one changes it; 0: there was none yet */
} murosimf_signal;

/* A row of numbers to set. They hold until they are set again. What is not finite or out of range is refused and counted: what held
 * before stands there again after the step. */
typedef struct murosimf_command {
  double* values;
  size_t count;
} murosimf_command;

/* The last picture of a camera, up to date in every step. Rows from the top without gaps; numbers of several bytes in this machine's
 * order. Formats, in ROS's words: "rgb8"; "bayer_rggb8" and the like; "32FC1", [m] along the optical axis, infinite where nothing is;
 * "16UC1", what is seen. */
typedef struct murosimf_picture {
  const void* bytes; /* stay to the end of the step; null: there was none yet */
  size_t size;       /* of them */
  uint32_t width, height;
  const char* format;
  double period;   /* [s] of simulated time from one picture to the next */
  int64_t time;    /* [ns] of simulated time, at which the exposure of its first row began */
  uint64_t number; /* of pictures that have come so far: a new one changes it */
} murosimf_picture;

/* What a robot of the team has sent. */
typedef struct murosimf_message {
  const void* bytes;
  size_t size;
  const char* sender; /* name of the robot; "" if the message comes from outside of the simulation */
  int64_t sent;       /* [ns] of simulated time */
} murosimf_message;

/* What `draw` draws. Points are x, y, z [m]; colors are red, green, blue from 0 to 1; `size` [m] is the radius of circles and spheres,
 * the width of lines and dots, the height of texts; 0: as small as can be seen. */
typedef struct murosimf_shape {
  uint32_t kind;
  const double* points;
  size_t count; /* of points */
  double size;
  double color[3];
  double opacity;   /* from 0 to 1 */
  const char* text; /* null: none */
} murosimf_shape;

enum {
  MUROSIMF_CIRCLE,  /* around the first point, normal to z */
  MUROSIMF_LINE,    /* through all points */
  MUROSIMF_POINTS,  /* a dot at each */
  MUROSIMF_SPHERE,  /* around the first point */
  MUROSIMF_POLYGON, /* filled; points on its border */
  MUROSIMF_TEXT     /* at the first point */
};

/* The robot of an instance; valid as long as the instance. Functions get the robot as their first argument. */
typedef struct murosimf_robot {
  void* simulator; /* not yours */
  const char* name;
  const char* team;  /* "" if it has none */
  const char* model; /* "kid21" */
  double period;     /* [s] of simulated time from one step to the next */
  uint64_t seed;     /* of this run */

  /* In `create` only. Null if there is nothing of that name; if `create` then returns null, the simulator says which name that was,
   * and the nearest one. A library that can do without goes on. */
  const murosimf_signal* (*signal)(const struct murosimf_robot* robot, const char* name);
  murosimf_command* (*command)(const struct murosimf_robot* robot, const char* name);
  /* What number i of a signal or a command is: the joint, or "x"; null if there is no such number. */
  const char* (*label)(const struct murosimf_robot* robot, const char* name, size_t i);

  /* In `create` only: options of the scene, [robots.options]. True (the text: not null) if it is given. What is given with another
   * type, and what is given and never asked for, is refused. */
  int (*number_option)(const struct murosimf_robot* robot, const char* name, double* value);
  int (*truth_option)(const struct murosimf_robot* robot, const char* name, int* value);
  int (*vector_option)(const struct murosimf_robot* robot, const char* name, double value[3]);
  const char* (*text_option)(const struct murosimf_robot* robot, const char* name);

  /* Any time, from the thread that calls the library: a line for the report of the run, with the time. */
  void (*say)(const struct murosimf_robot* robot, const char* text);

  /* Since version 2. */

  /* In `create` only: from now on this instance sends and gets messages. False if it cannot: its robot is in no team. If `create` then
   * returns null, the simulator says so. */
  int (*use_messages)(const struct murosimf_robot* robot);
  /* In `start` and `step`: a message to all other robots of the team. False, and counted in the report, if it is longer than the scene
   * allows, or if there were too many within a second. Whether and when it arrives is up to the scene ([communication]). */
  int (*send)(const struct murosimf_robot* robot, const void* bytes, size_t size);
  /* In `step`: the oldest message that has arrived and was not read yet. False if there is none. What `message` then points at stays
   * until the next call, or to the end of the step. */
  int (*receive)(const struct murosimf_robot* robot, murosimf_message* message);

  /* Since version 3. */

  /* In `create` only: "camera.color", "camera.depth", "camera.labels", as its camera has them. It draws from then on. Null as of
   * `signal`. */
  const murosimf_picture* (*picture)(const struct murosimf_robot* robot, const char* name);
  /* In `start` and `step`: debug shapes for observers, as a group of that name, replacing the previous one; without shapes that is
   * gone. `of_robot`: points are in the frame of the robot's base and move with it; else in that of the world. False if that is too much
   * (docs/library.md), or numbers are not finite. */
  int (*draw)(const struct murosimf_robot* robot, const char* group, int of_robot, const murosimf_shape* shapes,
              size_t count);
} murosimf_robot;

/* What a library offers. Functions that may be null say so. C++ exceptions may leave any of them: they end the instance, and the run
 * reports what() they say. */
typedef struct murosimf_controller {
  uint32_t abi;   /* MUROSIMF_CONTROLLER_ABI of the header with which it was compiled */
  uint32_t flags; /* MUROSIMF_INDEPENDENT_INSTANCES, or 0 */
  double rate;    /* [Hz] of its steps, if the scene says none; 0: 100 */

  /* A new instance for a robot. Null: it cannot be made; why may be written to `error`, which has room for `size` bytes. */
  void* (*create)(const murosimf_robot* robot, char* error, size_t size);
  void (*destroy)(void* instance);

  /* The run begins, or begins again. Commands that are set here hold before the first step. Null: the simulator makes a new
   * instance instead. */
  void (*start)(void* instance);
  /* One cycle at the simulated time `now` [ns]. */
  void (*step)(void* instance, int64_t now);

  /* The state of an instance as bytes, for saved runs and for libraries that are exchanged while they run. `save` writes at most
   * `size` bytes and returns how many there are; `load` returns false if it does not know them. Both null: it keeps its state to itself. */
  size_t (*save)(void* instance, void* bytes, size_t size);
  int (*load)(void* instance, const void* bytes, size_t size);
} murosimf_controller;

/* The one symbol that the simulator looks for. What it returns stays valid as long as the library is loaded. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const murosimf_controller*
murosimf_controller_entry(void);

#ifdef __cplusplus
}
#endif
// NOLINTEND(modernize-*)

#endif
