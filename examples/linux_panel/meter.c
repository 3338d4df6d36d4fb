/* SPDX-License-Identifier: MIT */
#include "meter.h"

#include <inttypes.h>

static double ms(uint64_t ns)
{
    return (double)ns / 1e6;
}

void meter_frame(FILE *out, uint32_t number, const view *v, const show_frame *frame)
{
    (void)fprintf(out, "frame %" PRIu32 ": turned %.1f degrees, ", number, v->turn16 * (360.0 / 65536));
    if (v->tolerance == 0) {
        (void)fprintf(out, "exact");
    } else {
        (void)fprintf(out, "tolerance %g", v->tolerance / 16.0);
    }
    (void)fprintf(out, ": drawn in %.1f ms, %u of %u bands sent in %.1f ms, together %.1f ms\n", ms(frame->draw_ns),
                  frame->bands_sent, frame->bands, ms(frame->send_ns), ms(frame->whole_ns));
    (void)fflush(out);
}

void meter_second(meter *m, FILE *out, const show_frame *frame, uint64_t now_ns, bool last)
{
    m->frames++;
    m->draw_ns += frame->draw_ns;
    m->send_ns += frame->send_ns;
    m->bands += frame->bands;
    m->bands_sent += frame->bands_sent;
    const uint64_t passed_ns = now_ns - m->start_ns;
    if (passed_ns < 1000000000u && !last) {
        return;
    }
    const double frames = m->frames;
    (void)fprintf(out, "fps %.1f: drawing %.1f ms, sending %.1f ms a frame, %.0f %% of the bands\n",
                  frames * 1e9 / (double)(passed_ns + 1), ms(m->draw_ns) / frames, ms(m->send_ns) / frames,
                  100.0 * m->bands_sent / m->bands);
    (void)fflush(out);
    *m = (meter){.start_ns = now_ns};
}
