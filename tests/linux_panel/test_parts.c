/* SPDX-License-Identifier: MIT */
/*
 * The parts of glint-panel that touch no device: command line, buttons, rows that changed, tolerances, the second
 * thread.
 */
#include "tests/linux_panel/check.h"

#include <glint/glint.h>

#include "examples/linux_panel/buttons.h"
#include "examples/linux_panel/changes.h"
#include "examples/linux_panel/meter.h"
#include "examples/linux_panel/options.h"
#include "examples/linux_panel/sender.h"
#include "examples/linux_panel/view.h"

/* -------------------------------------------------------------------------------------------------------- command line
 */

static failure why;

/* Words with a space between them. */
static int parse(const char *line, options *out)
{
    static char text[400];
    static char *words[40];
    int count = 1;
    words[0] = (char *)(uintptr_t) "glint-panel";
    (void)snprintf(text, sizeof text, "%s", line);
    for (char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " ")) {
        words[count++] = word;
    }
    words[count] = NULL;
    memset(&why, 0, sizeof why);
    return options_parse(count, words, out, &why);
}

static void command_line_in_full(void **state)
{
    (void)state;
    options o;
    assert_int_equal(
        parse("sphere-10x6 --controller st7789 --spi /dev/spidev1.2 --chip gpiochip4 --dc GPIO25 --reset 24 "
              "--backlight 18 --button 5 --button 6 --button 13 --buttons-high --size 135x240 --offset 52,40 "
              "--rotate 270 --speed 40000000 --frames 7 --fps --ask --tolerance 2.5 --dump a.ppm",
              &o),
        0);
    assert_string_equal(o.demo->name, "sphere-10x6");
    assert_ptr_equal(o.controller, screen_controller_named("st7789"));
    assert_string_equal(o.spi, "/dev/spidev1.2");
    assert_string_equal(o.chip, "gpiochip4");
    assert_string_equal(o.dc, "GPIO25");
    assert_string_equal(o.reset, "24");
    assert_string_equal(o.backlight, "18");
    assert_int_equal(o.button_count, 3);
    assert_string_equal(o.buttons[2], "13");
    assert_true(o.buttons_high && o.fps && o.ask && !o.help);
    assert_int_equal(o.glass.width_px, 135);
    assert_int_equal(o.glass.height_px, 240);
    assert_int_equal(o.glass.x_px, 52);
    assert_int_equal(o.glass.y_px, 40);
    assert_int_equal(o.glass.quarter_turns, 3);
    assert_int_equal(o.speed_hz, 40000000);
    assert_int_equal(o.frames, 7);
    assert_int_equal(o.tolerance, 40);
    assert_string_equal(o.dump, "a.ppm");
}

static void command_line_defaults(void **state)
{
    (void)state;
    options o;
    assert_int_equal(parse("--controller ili9341 --dc 25", &o), 0);
    assert_string_equal(o.demo->name, "teapot");
    assert_string_equal(o.spi, "/dev/spidev0.0");
    assert_string_equal(o.chip, "gpiochip0");
    assert_null(o.reset);
    assert_null(o.backlight);
    assert_null(o.dump);
    assert_int_equal(o.button_count, 0);
    assert_int_equal(o.glass.width_px, 240);
    assert_int_equal(o.glass.height_px, 320);
    assert_int_equal(o.speed_hz, 10000000);
    assert_int_equal(o.tolerance, 16);
    assert_int_equal(o.frames, 0);
    assert_int_equal(parse("--controller st7789 --dc 25 --tolerance exact", &o), 0);
    assert_int_equal(o.speed_hz, 32000000);
    assert_int_equal(o.tolerance, 0);
    assert_int_equal(parse("--help", &o), 0);
    assert_true(o.help);
}

static void command_line_refused(void **state)
{
    (void)state;
    static const struct {
        const char *line, *says;
    } cases[] = {
        {"", "--controller is missing"},
        {"--controller st7789", "--dc is missing"},
        {"--controller st7735 --dc 1", "--controller st7735: expected st7789 or ili9341"},
        {"--controller st7789 --dc", "--dc: a value is missing"},
        {"--controller st7789 --dc 1 --volume 11", "--volume: no such option"},
        {"--controller st7789 --dc 1 teapot knot", "knot: only one scene"},
        {"--controller st7789 --dc 1 no-such-scene", "no-such-scene: no built-in scene"},
        {"--controller st7789 --dc 1 --size 240", "--size 240: expected WxH"},
        {"--controller st7789 --dc 1 --size 0x240", "--size 0x240: expected WxH"},
        {"--controller st7789 --dc 1 --size 240x240x2", "expected WxH"},
        {"--controller st7789 --dc 1 --size -1x2", "expected WxH"},
        {"--controller st7789 --dc 1 --size 320x240", "beyond the controller's memory, 240x320"},
        {"--controller st7789 --dc 1 --size 240x240 --offset 0,81", "beyond the controller's memory"},
        {"--controller st7789 --dc 1 --offset 1x1", "--offset 1x1: expected X,Y"},
        {"--controller st7789 --dc 1 --rotate 45", "--rotate 45: expected 0, 90, 180 or 270"},
        {"--controller st7789 --dc 1 --rotate 360", "--rotate 360: expected 0, 90, 180 or 270"},
        {"--controller st7789 --dc 1 --speed 0", "--speed 0: expected a whole number, 1000..200000000"},
        {"--controller st7789 --dc 1 --speed 1e6", "--speed 1e6: expected a whole number"},
        {"--controller st7789 --dc 1 --frames 0", "--frames 0: expected a whole number, 1..4294967295"},
        {"--controller st7789 --dc 1 --frames 99999999999", "expected a whole number"},
        {"--controller st7789 --dc 1 --tolerance 0.5", "--tolerance 0.5: expected codes"},
        {"--controller st7789 --dc 1 --tolerance 16", "--tolerance 16: expected codes"},
        {"--controller st7789 --dc 1 --tolerance nan", "--tolerance nan: expected codes"},
        {"--controller st7789 --dc 1 --tolerance 1x", "--tolerance 1x: expected codes"},
        {"--controller st7789 --dc 1 --button 1 --button 2 --button 3 --button 4", "--button 4: there are 3 already"},
    };
    options o;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        if (parse(cases[i].line, &o) != -1) {
            fail_msg("taken: %s", cases[i].line);
        }
        assert_says(why.text, cases[i].says);
    }
}

/* ------------------------------------------------------------------------------------------------------------- buttons
 */

static button_action edge(buttons *b, unsigned number, bool pressed, unsigned ms)
{
    const gpio_edge e = {.pressed = pressed, .at_ns = ms * UINT64_C(1000000)};
    return buttons_edge(b, number, &e);
}

static void several_buttons_act_when_they_go_down(void **state)
{
    (void)state;
    buttons b = {.count = 3};
    assert_int_equal(edge(&b, 0, true, 1), BUTTON_TURN);
    assert_int_equal(edge(&b, 0, false, 100), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 1, true, 101), BUTTON_TOLERANCE);
    assert_int_equal(edge(&b, 2, true, 102), BUTTON_TURN_BACK);
    assert_int_equal(edge(&b, 1, false, 5000), BUTTON_NOTHING);
}

static void one_button_tells_long_from_short(void **state)
{
    (void)state;
    buttons b = {.count = 1};
    assert_int_equal(edge(&b, 0, false, 1), BUTTON_NOTHING); /* it was down from the start */
    assert_int_equal(edge(&b, 0, true, 100), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 0, false, 200), BUTTON_TURN);
    assert_int_equal(edge(&b, 0, true, 300), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 0, false, 799), BUTTON_TURN);
    assert_int_equal(edge(&b, 0, true, 1000), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 0, false, 1500), BUTTON_TOLERANCE);
}

static void contacts_bounce(void **state)
{
    (void)state;
    buttons b = {.count = 2};
    assert_int_equal(edge(&b, 0, true, 100), BUTTON_TURN);
    assert_int_equal(edge(&b, 0, false, 101), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 0, true, 102), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 1, true, 102), BUTTON_TOLERANCE); /* another button's own affair */
    assert_int_equal(edge(&b, 0, false, 200), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 0, true, 219), BUTTON_NOTHING);
    assert_int_equal(edge(&b, 0, true, 221), BUTTON_TURN);
    buttons one = {.count = 1};
    (void)edge(&one, 0, true, 100);
    (void)edge(&one, 0, false, 110); /* lost in the bouncing */
    assert_int_equal(edge(&one, 0, true, 5000), BUTTON_NOTHING);
    assert_int_equal(edge(&one, 0, false, 5100), BUTTON_TURN); /* not a press of five seconds */
}

static void tolerances_go_round(void **state)
{
    (void)state;
    static const uint8_t round[] = {GLINT_CODES(4), GLINT_CODES(15), 0, GLINT_CODES(1), GLINT_CODES(4)};
    view v = {.tolerance = GLINT_CODES(1)};
    for (size_t i = 0; i < sizeof round; i++) {
        view_switch_tolerance(&v);
        assert_int_equal(v.tolerance, round[i]);
    }
    v.tolerance = GLINT_CODES(2.5);
    view_switch_tolerance(&v);
    assert_int_equal(v.tolerance, GLINT_CODES(4));
    v.tolerance = 255;
    view_switch_tolerance(&v);
    assert_int_equal(v.tolerance, 0);
}

/* ---------------------------------------------------------------------------------------------------- rows that
 * changed
 */

static void only_changed_rows_are_taken(void **state)
{
    (void)state;
    static uint8_t rows[6][4]; /* a band of rows 2..7 */
    const glint_band band = {.pixels = rows, .bytes = sizeof rows, .stride_bytes = 4, .y_px = 2, .height_px = 6};
    changes c;
    sender_job job;
    memset(&c, 0, sizeof c);
    assert_int_equal(changes_open(&c, 4, 10), 0);
    assert_true(changes_take(&c, &band, &job)); /* black, but what the panel holds is not known */
    assert_int_equal(job.y_px, 2);
    assert_int_equal(job.height_px, 6);
    assert_false(changes_take(&c, &band, &job));
    rows[1][3] = 1;
    rows[4][0] = 1;
    assert_true(changes_take(&c, &band, &job));
    assert_int_equal(job.y_px, 3);
    assert_int_equal(job.height_px, 4);
    assert_int_equal(job.bytes, 16);
    assert_ptr_equal(job.pixels, rows[1]);
    assert_false(changes_take(&c, &band, &job));
    rows[5][0] = 9;
    assert_true(changes_take(&c, &band, &job));
    assert_int_equal(job.y_px, 7);
    assert_int_equal(job.height_px, 1);
    rows[0][0] = 9;
    assert_true(changes_take(&c, &band, &job));
    assert_int_equal(job.y_px, 2);
    assert_int_equal(job.height_px, 1);
    changes_close(&c);
}

/* --------------------------------------------------------------------------------------------------- the second thread
 */

typedef struct job_log {
    unsigned count;
    uint16_t rows[200];
    unsigned fail_at;
} job_log;

static int note(void *context, const sender_job *job, failure *f)
{
    job_log *l = context;
    l->rows[l->count++] = job->y_px;
    return l->count == l->fail_at ? fail_with(f, "job %u failed", l->count) : 0;
}

static void jobs_are_sent_in_order(void **state)
{
    (void)state;
    static job_log l;
    sender s;
    unsigned told = 0;
    uint64_t ns = 0;
    memset(&l, 0, sizeof l);
    assert_int_equal(sender_start(&s, note, &l, &why), 0);
    for (uint16_t i = 0; i < 200; i++) {
        const sender_job job = {.bytes = i % 3 == 0 ? 0 : 1, .y_px = i};
        assert_int_equal(sender_put(&s, &job, &why), 0);
    }
    while (told < 200) {
        told += sender_wait(&s);
    }
    assert_int_equal(told, 200);
    assert_int_equal(sender_wait(&s), 0); /* nothing is under way */
    assert_int_equal(sender_took(&s, &ns, &why), 0);
    sender_end(&s);
    assert_int_equal(l.count, 133); /* those with something to send */
    for (unsigned i = 1; i < l.count; i++) {
        assert_true(l.rows[i] > l.rows[i - 1]);
    }
}

static void nothing_is_sent_after_a_failure(void **state)
{
    (void)state;
    static job_log l;
    sender s;
    uint64_t ns = 0;
    unsigned put = 0;
    const sender_job job = {.bytes = 1};
    memset(&l, 0, sizeof l);
    l.fail_at = 3;
    assert_int_equal(sender_start(&s, note, &l, &why), 0);
    while (put < 100 && sender_put(&s, &job, &why) == 0) {
        put++;
    }
    assert_in_range(put, 3, 5); /* it is told by the put after the slots that were full */
    while (sender_wait(&s) > 0) {
    }
    assert_int_equal(l.count, 3);
    memset(&why, 0, sizeof why);
    assert_int_equal(sender_took(&s, &ns, &why), -1);
    assert_string_equal(why.text, "job 3 failed");
    sender_end(&s);
}

/* --------------------------------------------------------------------------------------------------------------- meter
 */

static void a_line_a_second(void **state)
{
    (void)state;
    char text[400] = "";
    FILE *out = fmemopen(text, sizeof text, "w");
    meter m = {.start_ns = 5000000000};
    const show_frame frame = {.draw_ns = 10000000, .send_ns = 30000000, .bands = 15, .bands_sent = 3};
    assert_non_null(out);
    for (uint64_t i = 1; i <= 25; i++) {
        meter_second(&m, out, &frame, 5000000000 + i * 40000000, false);
    }
    assert_string_equal(text, "fps 25.0: drawing 10.0 ms, sending 30.0 ms a frame, 20 % of the bands\n");
    meter_second(&m, out, &frame, 6500000000, true);
    assert_says(text, "fps 2.0: drawing 10.0 ms");
    (void)fclose(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(command_line_in_full),
        cmocka_unit_test(command_line_defaults),
        cmocka_unit_test(command_line_refused),
        cmocka_unit_test(several_buttons_act_when_they_go_down),
        cmocka_unit_test(one_button_tells_long_from_short),
        cmocka_unit_test(contacts_bounce),
        cmocka_unit_test(tolerances_go_round),
        cmocka_unit_test(only_changed_rows_are_taken),
        cmocka_unit_test(jobs_are_sent_in_order),
        cmocka_unit_test(nothing_is_sent_after_a_failure),
        cmocka_unit_test(a_line_a_second),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
