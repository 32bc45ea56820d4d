/* Drives what MATIEC makes: located variables by its own table, the clock in __CURRENT_TIME, config_run__ per scan. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "iec_std_lib.h"
#include "accessor.h"
#include "POUS.h"
#include "wiring.h"

static uint8_t image_i[IMAGE_I], image_q[IMAGE_Q], told[READ_COUNT + 1];
static int16_t words[WORD_COUNT + 1];
static int16_t written[WRITTEN_COUNT + 1];

TIME __CURRENT_TIME;
BOOL __DEBUG;
void config_init__(void);
void config_run__(unsigned long tick);
extern PROGRAM_TYPE PROGRAM_INSTANCE;

#define __LOCATED_VAR(type, name, ...) static type name##_cell; type *name = &name##_cell;
#include "LOCATED_VARIABLES.h"
#undef __LOCATED_VAR

static void host_power_on(void) {
  config_init__();
}

static void load_I(BOOL *cell, unsigned byte, unsigned bit) {
  *cell = byte < IMAGE_I ? image_i[byte] >> bit & 1 : 0;
}
static void load_Q(BOOL *cell, unsigned byte, unsigned bit) { (void)cell, (void)byte, (void)bit; }
static void store_I(BOOL *cell, unsigned byte, unsigned bit) { (void)cell, (void)byte, (void)bit; }
static void store_Q(BOOL *cell, unsigned byte, unsigned bit) {
  if (byte < IMAGE_Q && *cell) image_q[byte] |= 1u << bit;
}

static void host_scan(uint64_t now_ms) {
  static unsigned long tick;
  __CURRENT_TIME.tv_sec = now_ms / 1000;
  __CURRENT_TIME.tv_nsec = now_ms % 1000 * 1000000;
#define __LOCATED_VAR(type, name, area, size, byte, bit) load_##area(name, byte, bit);
#include "LOCATED_VARIABLES.h"
#undef __LOCATED_VAR
#define SET(k, name, type) PROGRAM_INSTANCE.name.value = (type)written[k];
  WRITTEN(SET)
  config_run__(tick++);
#define __LOCATED_VAR(type, name, area, size, byte, bit) store_##area(name, byte, bit);
#include "LOCATED_VARIABLES.h"
#undef __LOCATED_VAR
#define GET(k, name) told[k] = PROGRAM_INSTANCE.name.value;
  READ(GET)
#define SAY(k, name) words[k] = PROGRAM_INSTANCE.name.value;
  WORDS(SAY)
}

#include "host.h"
