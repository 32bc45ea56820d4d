/* The host of a compiled program: reads scans, sets inputs and clock, runs the task once for each, writes outputs.
   Standard input: the clock's milliseconds at power-on (8 bytes), then scans as tests/foreign/wiring.py lays them down;
   standard output: their outputs.  Included by host_matiec.c and host_strucpp.cpp after their host_* functions. */
static uint64_t number(const uint8_t *at, int bytes) {
  uint64_t n = 0;
  while (bytes-- > 0) n = n << 8 | at[bytes];
  return n;
}

int main(void) {
  uint8_t start[8], scan[4 + IMAGE_I + 2 * WRITTEN_COUNT + 1];
  uint64_t now_ms;
  int k;
  if (fread(start, 1, 8, stdin) != 8) return 2;
  now_ms = number(start, 8);
  host_power_on();
  for (;;) {
    size_t got = fread(scan, 1, sizeof scan - 1, stdin);
    if (got == 0) break;
    if (got != sizeof scan - 1) return 3;
    now_ms += number(scan, 4);
    memcpy(image_i, scan + 4, IMAGE_I);
    memset(image_q, 0, IMAGE_Q);
    for (k = 0; k < WRITTEN_COUNT; k++) written[k] = (int16_t)number(scan + 4 + IMAGE_I + 2 * k, 2);
    host_scan(now_ms);
    if (fwrite(image_q, 1, IMAGE_Q, stdout) != IMAGE_Q) return 4;
    if (fwrite(told, 1, READ_COUNT, stdout) != READ_COUNT) return 4;
    for (k = 0; k < WORD_COUNT; k++) {
      uint8_t word[2];
      word[0] = (uint16_t)words[k] & 0xFF, word[1] = (uint16_t)words[k] >> 8;
      if (fwrite(word, 1, 2, stdout) != 2) return 4;
    }
  }
  return fflush(stdout) ? 4 : 0;
}
