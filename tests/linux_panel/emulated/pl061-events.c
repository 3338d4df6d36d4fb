/* SPDX-License-Identifier: MIT */
/*
 * Reads QEMU's trace of its PL061 GPIO block (-trace pl061_set_output -msg timestamp=on) from stdin and writes the
 * event stream that the panel model reads (tests/panel/panel.h). Lines of the block: 0 clock, 1 data, 2 select, 4 D/C,
 * 5 reset, 6 backlight.
 *
 * Times: without -icount the emulated board's clock runs with the host's, so the trace's host time is the board's but
 * for where it began. It is in microseconds: events within one are spread over it evenly, in their order, so that a
 * delay is right within 1 us. Writes of a bit-banged line take longer than that.
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#define MOST_AT_ONCE 1000 /* events within a microsecond */

static const char *const signals[8] = {"sck", "mosi", "cs", NULL, "dc", "reset", "backlight", NULL};

typedef struct event {
    unsigned line, level;
} event;

static void write_events(uint64_t us, const event *events, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const char *name = signals[events[i].line];
        if (name != NULL) {
            printf("%" PRIu64 " %s %u\n", us * 1000 + i * UINT64_C(1000) / count, name, events[i].level);
        }
    }
}

/* "1234@1795823104.060042:pl061_set_output /machine/... setting output 0 to 1" */
static bool read_event(const char *text, uint64_t *us, event *out)
{
    uint64_t seconds = 0, micros = 0;
    /* NOLINTNEXTLINE(cert-err34-c): QEMU's own numbers fit */
    return sscanf(text, "%*d@%" SCNu64 ".%6" SCNu64 ":pl061_set_output %*s setting output %1u to %1u", &seconds,
                  &micros, &out->line, &out->level) == 4 &&
           out->line < 8 && out->level < 2 && ((*us = seconds * 1000000 + micros), true);
}

int main(void)
{
    static event events[MOST_AT_ONCE];
    char text[256];
    uint64_t now_us = 0, us = 0;
    unsigned count = 0, back = 0;
    while (fgets(text, sizeof text, stdin) != NULL) {
        event one;
        if (!read_event(text, &us, &one)) {
            fprintf(stderr, "pl061-events: not an event: %s", text);
            return EXIT_FAILURE;
        }
        if (us < now_us) { /* the host's clock was set back: no time passes */
            us = now_us;
            back++;
        }
        if (us != now_us || count == MOST_AT_ONCE) {
            write_events(now_us, events, count);
            count = 0;
            now_us = us;
        }
        events[count++] = one;
    }
    write_events(now_us, events, count);
    if (back > 0) {
        fprintf(stderr, "pl061-events: the host's clock was set back, %u events by less than they seem\n", back);
    }
    return EXIT_SUCCESS;
}
