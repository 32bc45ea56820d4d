/* Drives what STruC++ makes: located variables by its own table, the clock in __CURRENT_TIME_NS, each task per scan. */
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "program.hpp"
#include "wiring.h"

static uint8_t image_i[IMAGE_I], image_q[IMAGE_Q], told[READ_COUNT + 1];
static int16_t words[WORD_COUNT + 1];
static int16_t written[WRITTEN_COUNT + 1];

using namespace strucpp;
static CONFIGURATION_TYPE *configuration;

static void host_power_on() { configuration = new CONFIGURATION_TYPE(); }

static void host_scan(uint64_t now_ms) {
  __CURRENT_TIME_NS = static_cast<int64_t>(now_ms) * 1000000;
  for (uint32_t k = 0; k < locatedVarsCount; k++) {
    const LocatedVar &v = locatedVars[k];
    if (v.area == LocatedArea::Input)
      *static_cast<bool *>(v.pointer) = v.byte_index < IMAGE_I && (image_i[v.byte_index] >> v.bit_index & 1);
  }
#define SET(k, name, type) configuration->PROGRAM_INSTANCE.name = static_cast<type##_t>(written[k]);
  WRITTEN(SET)
  for (size_t r = 0; r < configuration->get_resource_count(); r++) {
    ResourceInstance &resource = configuration->get_resources()[r];
    for (size_t t = 0; t < resource.task_count; t++)
      for (size_t p = 0; p < resource.tasks[t].program_count; p++) resource.tasks[t].programs[p]->run();
  }
  for (uint32_t k = 0; k < locatedVarsCount; k++) {
    const LocatedVar &v = locatedVars[k];
    if (v.area == LocatedArea::Output && *static_cast<bool *>(v.pointer) && v.byte_index < IMAGE_Q)
      image_q[v.byte_index] |= 1u << v.bit_index;
  }
#define GET(k, name) told[k] = static_cast<bool>(configuration->PROGRAM_INSTANCE.name);
  READ(GET)
#define SAY(k, name) words[k] = static_cast<int16_t>(configuration->PROGRAM_INSTANCE.name);
  WORDS(SAY)
}

#include "host.h"
