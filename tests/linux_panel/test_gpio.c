/* SPDX-License-Identifier: MIT */
/*
 * Lines of GPIO, with each version of libgpiod: how they are found, requested and released, and what is said when that
 * fails.
 */
#include "tests/linux_panel/check.h"

#include <errno.h>

#include "examples/linux_panel/gpio.h"
#include "tests/linux_panel/fake_board.h"

static failure why;
static gpio_chip *chip;

static int begin(void **state)
{
    (void)state;
    fake_board_begin();
    memset(&why, 0, sizeof why);
    chip = gpio_chip_open("gpiochip0", &why);
    return chip == NULL;
}

static int end(void **state)
{
    (void)state;
    gpio_chip_close(chip);
    const int left = (int)(the_board.chips_open + the_board.lines_held);
    fake_board_end();
    return left;
}

static void chips_are_named_as_people_do(void **state)
{
    (void)state;
    const char *const names[] = {"gpiochip0", "0", "/dev/gpiochip0"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        gpio_chip *again = gpio_chip_open(names[i], &why);
        assert_non_null(again);
        gpio_chip_close(again);
    }
    char longer_than_any[200];
    memset(longer_than_any, '1', sizeof longer_than_any);
    longer_than_any[sizeof longer_than_any - 1] = '\0';
    assert_null(gpio_chip_open(longer_than_any, &why));
    assert_says(why.text, "no such GPIO chip");
}

static void refuse_chip(int error, const char *expected)
{
    the_board.chip_error = error;
    assert_null(gpio_chip_open("gpiochip0", &why));
    assert_says(why.text, "/dev/gpiochip0");
    assert_says(why.text, expected);
}

static void no_such_chip(void **state)
{
    (void)state;
    assert_null(gpio_chip_open("gpiochip4", &why));
    assert_says(why.text, "/dev/gpiochip4: no such GPIO chip");
    assert_says(why.text, "one of: gpiochip0 gpiochip1");
    refuse_chip(ENODEV, "one of: gpiochip0 gpiochip1");
    refuse_chip(ENOTTY, "one of: gpiochip0 gpiochip1");
    the_board.chips[0] = NULL;
    refuse_chip(ENOENT, "nor any other");
    refuse_chip(EMFILE, strerror(EMFILE));
}

static void chip_without_permission(void **state)
{
    (void)state;
    the_board.group = "gpio";
    refuse_chip(EACCES, "sudo usermod -aG gpio $USER");
    the_board.group = NULL;
    refuse_chip(EPERM, "run as root");
}

static void output_by_name_and_by_number(void **state)
{
    (void)state;
    gpio_line *dc = gpio_output(chip, "DC", false, &why);
    gpio_line *reset = gpio_output(chip, "5", true, &why);
    assert_non_null(dc);
    assert_non_null(reset);
    assert_true(the_board.lines[FAKE_DC].output);
    assert_false(the_board.lines[FAKE_DC].level);
    assert_true(the_board.lines[FAKE_RESET].level);
    assert_string_equal(the_board.lines[FAKE_DC].consumer, "glint-panel");
    assert_int_equal(gpio_set(dc, true, &why), 0);
    assert_true(the_board.lines[FAKE_DC].level);
    assert_true(the_board.lines[FAKE_RESET].level);
    gpio_release(dc);
    assert_int_equal(the_board.lines_held, 1);
    gpio_release(reset);
    gpio_release(NULL);
}

static void refuse_line(const char *line, const char *expected)
{
    assert_null(gpio_output(chip, line, false, &why));
    assert_says(why.text, expected);
    assert_null(gpio_button(chip, line, true, &why));
    assert_says(why.text, expected);
}

static void no_such_line(void **state)
{
    (void)state;
    refuse_line("GPIO25", "line \"GPIO25\": no line of /dev/gpiochip0 has this name");
    refuse_line("8", "line 8: /dev/gpiochip0 has lines 0..7 only");
    refuse_line("99999999999999999999", "has lines 0..7 only");
    refuse_line("", "no line of /dev/gpiochip0 has this name");
}

static void line_in_use(void **state)
{
    (void)state;
    refuse_line("SCK", "line SCK of /dev/gpiochip0 is in use by \"spi0 SCK\"");
    the_board.lines[0].consumer = NULL;
    refuse_line("0", "line 0 of /dev/gpiochip0 is in use by the kernel or a program that gives no name");
    gpio_line *dc = gpio_output(chip, "DC", false, &why);
    refuse_line("4", "in use by another glint-panel");
    gpio_release(dc);
}

static void line_refused_otherwise(void **state)
{
    (void)state;
    the_board.lines[FAKE_DC].request_error = EPERM;
    refuse_line("DC", "line DC of /dev/gpiochip0: no permission");
    the_board.lines[FAKE_DC].request_error = EINVAL;
    refuse_line("DC", strerror(EINVAL));
}

static void line_lost(void **state)
{
    (void)state;
    gpio_line *dc = gpio_output(chip, "DC", false, &why);
    the_board.fail_set = 1;
    assert_int_equal(gpio_set(dc, true, &why), -1);
    assert_says(why.text, "line DC: cannot set it");
    gpio_release(dc);
    gpio_line *button = gpio_button(chip, "KEY1", true, &why);
    gpio_edge edge;
    the_board.fail_read = 1;
    assert_int_equal(gpio_read_edge(button, &edge, &why), -1);
    assert_says(why.text, "line KEY1: cannot read it");
    gpio_release(button);
}

static void button_to(bool ground)
{
    gpio_edge edge = {0};
    gpio_line *button = gpio_button(chip, "KEY1", ground, &why);
    assert_non_null(button);
    const fake_line *line = &the_board.lines[FAKE_BUTTON];
    assert_true(line->edges);
    assert_false(line->output);
    assert_int_equal(line->active_low, ground);
    assert_int_equal(line->pull, ground ? FAKE_PULL_UP : FAKE_PULL_DOWN);
    assert_true(gpio_button_fd(button) >= 0);
    the_board.now_ns = 12345678901;
    for (int level = 0; level < 2; level++) {
        the_board.lines[FAKE_BUTTON].level = level != 0;
        assert_int_equal(gpio_read_edge(button, &edge, &why), 0);
        assert_int_equal(edge.pressed, (level != 0) != ground);
        assert_true(edge.at_ns == 12345678901);
    }
    gpio_release(button);
}

static void buttons_tell_of_both_edges(void **state)
{
    (void)state;
    button_to(true);
    button_to(false);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(chips_are_named_as_people_do), TEST(no_such_chip), TEST(chip_without_permission),
        TEST(output_by_name_and_by_number), TEST(no_such_line), TEST(line_in_use),
        TEST(line_refused_otherwise),       TEST(line_lost),    TEST(buttons_tell_of_both_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
