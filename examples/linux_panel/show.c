/* SPDX-License-Identifier: MIT */
#include "show.h"

#include <string.h>

#include "clock.h"
#include "stop.h"

#define BAND_PX 16

/* High byte first on the wire, whatever the processor's order. */
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define WIRE_FORMAT GLINT_RGB565_SWAPPED
#else
#define WIRE_FORMAT GLINT_RGB565
#endif

enum { FLUSH_FAILED = 2 }; /* why is in the show's failure */

static int send_job(void *context, const sender_job *job, failure *f)
{
    const show *s = context;
    return screen_send(s->screen, job->pixels, job->bytes, job->y_px, s->display.width_px, job->height_px, f);
}

/* What the panel holds, as a picture. */
static void mirror_rows(show *s, const sender_job *job)
{
    const glint_display display = panel_display(&s->mirror, 0, GLINT_DITHER_NONE, 1);
    const glint_band rows = {.pixels = job->pixels,
                             .bytes = job->bytes,
                             .stride_bytes = s->changes.row_bytes,
                             .y_px = job->y_px,
                             .width_px = s->display.width_px,
                             .height_px = job->height_px};
    (void)display.flush(display.context, &rows);
}

static int flush_band(void *context, const glint_band *band)
{
    show *s = context;
    sender_job job;
    if (stop_asked()) {
        return SHOW_STOPPED;
    }
    s->frame.bands++;
    if (!changes_take(&s->changes, band, &job)) {
        /* Nothing to send, but transfers end in the order in which they began: by their number the library knows which
         * buffer is free. */
        job = (sender_job){.bytes = 0};
    } else {
        s->frame.bands_sent++;
        s->frame.bytes_sent += job.bytes;
        if (s->dump != NULL) {
            mirror_rows(s, &job);
        }
    }
    return sender_put(&s->sender, &job, s->failure) == 0 ? 0 : FLUSH_FAILED;
}

static void wait_for_transfer(void *context)
{
    show *s = context;
    const uint64_t start_ns = clock_ns();
    for (unsigned done = sender_wait(&s->sender); done > 0; done--) {
        glint_flush_done(&s->transfers);
    }
    s->waited_ns += clock_ns() - start_ns;
}

int show_open(show *s, screen *on, const demo_scene *demo, uint8_t tolerance, uint16_t width_px, uint16_t height_px,
              const char *dump, failure *f)
{
    memset(s, 0, sizeof *s);
    s->screen = on;
    s->dump = dump;
    s->display = (glint_display){.width_px = width_px,
                                 .height_px = height_px,
                                 .band_px = BAND_PX,
                                 .format = WIRE_FORMAT,
                                 .buffer_count = 2,
                                 .flush = flush_band,
                                 .context = s,
                                 .transfers = &s->transfers,
                                 .wait = wait_for_transfer};
    if (changes_open(&s->changes, glint_row_bytes(WIRE_FORMAT, width_px), height_px) != 0) {
        show_close(s);
        return fail_with(f, "out of memory");
    }
    if (dump != NULL) {
        if (picture_create(&s->picture, width_px, height_px, f->text, sizeof f->text) != 0) {
            show_close(s);
            return -1;
        }
        s->mirror = (panel){.rgb = s->picture.rgb, .width_px = width_px, .height_px = height_px, .format = WIRE_FORMAT};
    }
    if (view_open(&s->view, demo, tolerance, &s->display, f) != 0 || sender_start(&s->sender, send_job, s, f) != 0) {
        show_close(s);
        return -1;
    }
    s->sending = true;
    return 0;
}

int show_draw(show *s, show_frame *took, failure *f)
{
    uint64_t send_ns = 0;
    memset(&s->frame, 0, sizeof s->frame);
    s->waited_ns = 0;
    s->failure = f;
    const uint64_t start_ns = clock_ns();
    const int result = view_draw(&s->view, &s->display, NULL, f);
    s->frame.whole_ns = clock_ns() - start_ns;
    const int sent = sender_took(&s->sender, &send_ns, f);
    s->frame.draw_ns = s->frame.whole_ns - s->waited_ns;
    s->frame.send_ns = send_ns;
    *took = s->frame;
    if (sent != 0 || (result != 0 && result != SHOW_STOPPED)) {
        return -1;
    }
    if (result == 0 && s->dump != NULL && picture_write(s->dump, &s->picture, f->text, sizeof f->text) != 0) {
        return -1;
    }
    return result;
}

void show_close(show *s)
{
    if (s->sending) {
        sender_end(&s->sender);
    }
    view_close(&s->view);
    picture_free(&s->picture);
    changes_close(&s->changes);
    s->sending = false;
}
