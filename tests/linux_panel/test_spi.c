/* SPDX-License-Identifier: MIT */
/*
 * The SPI device: how long writes are split, and what is said when the kernel refuses something.
 */
#include "tests/linux_panel/check.h"

#include <errno.h>
#include <linux/spi/spidev.h>
#include <stdlib.h>

#include "examples/linux_panel/spi.h"
#include "tests/linux_panel/fake_board.h"

static failure why;
static spi_device spi;
static uint8_t bytes[10000];

static int begin(void **state)
{
    (void)state;
    fake_board_begin();
    memset(&why, 0, sizeof why);
    return 0;
}

static int end(void **state)
{
    (void)state;
    const int left = (int)the_board.files_open;
    fake_board_end();
    return left;
}

static void open_it(void)
{
    assert_int_equal(spi_open(&spi, "/dev/spidev0.0", 32000000, &why), 0);
}

static void refuse_open(int error, const char *expected)
{
    the_board.spi_error = error;
    assert_int_equal(spi_open(&spi, "/dev/spidev0.0", 32000000, &why), -1);
    assert_says(why.text, "/dev/spidev0.0: ");
    assert_says(why.text, expected);
}

static void not_enabled(void **state)
{
    (void)state;
    refuse_open(ENOENT, "SPI is not enabled");
    assert_says(why.text, "dtparam=spi=on");
    refuse_open(ENODEV, "SPI is not enabled");
    refuse_open(ENXIO, "SPI is not enabled");
    refuse_open(EBUSY, "in use by another program");
    refuse_open(EMFILE, strerror(EMFILE));
    the_board.group = "spi";
    refuse_open(EACCES, "sudo usermod -aG spi $USER");
    the_board.group = NULL;
    refuse_open(EACCES, "run as root");
}

static void refuse_setting(unsigned long setting, int error, const char *expected)
{
    the_board.refused_setting = setting;
    the_board.refusal = error;
    assert_int_equal(spi_open(&spi, "/dev/spidev0.0", 32000000, &why), -1);
    assert_says(why.text, expected);
    assert_int_equal(the_board.files_open, 0);
}

static void settings_refused(void **state)
{
    (void)state;
    refuse_setting(SPI_IOC_WR_MODE, EINVAL, "refuses SPI mode 0");
    refuse_setting(SPI_IOC_WR_BITS_PER_WORD, EINVAL, "refuses words of 8 bits");
    refuse_setting(SPI_IOC_WR_MAX_SPEED_HZ, EINVAL, "refuses 32000000 Hz");
    refuse_setting(SPI_IOC_WR_MODE, ENOTTY, "is not an SPI device");
}

static void most_at_once(const char *parameter, size_t expected)
{
    the_board.buffer_parameter = parameter;
    open_it();
    assert_int_equal(spi.most_bytes, expected);
    spi_close(&spi);
}

static void buffer_is_read_from_the_module(void **state)
{
    (void)state;
    most_at_once("65536\n", 65536);
    most_at_once("512\n", 512);
    most_at_once(NULL, 4096);
    most_at_once("words\n", 4096);
    most_at_once("0\n", 4096);
}

static void long_writes_are_split(void **state)
{
    (void)state;
    open_it();
    assert_int_equal(spi_write(&spi, bytes, sizeof bytes, &why), 0);
    assert_int_equal(the_board.messages, 3); /* 4096, 4096, 1808 */
    assert_int_equal(the_board.bytes, sizeof bytes);
    assert_int_equal(spi_write(&spi, bytes, 4096, &why), 0);
    assert_int_equal(the_board.messages, 4);
    assert_int_equal(the_board.longest_bytes, 4096);
    assert_int_equal(spi_write(&spi, bytes, 0, &why), 0);
    assert_int_equal(the_board.messages, 4);
    spi_close(&spi);
}

static void splits_further_where_the_parameter_is_wrong(void **state)
{
    (void)state;
    open_it();
    the_board.takes_bytes = 1500;
    assert_int_equal(spi_write(&spi, bytes, sizeof bytes, &why), 0);
    assert_int_equal(the_board.bytes, sizeof bytes);
    assert_int_equal(the_board.longest_bytes, 1024);
    const unsigned before = the_board.messages;
    assert_int_equal(spi_write(&spi, bytes, 1024, &why), 0);
    assert_int_equal(the_board.messages, before + 1); /* it has learnt */
    the_board.takes_bytes = 1;
    assert_int_equal(spi_write(&spi, bytes, sizeof bytes, &why), -1);
    assert_says(why.text, "spidev.bufsiz=65536");
    spi_close(&spi);
}

static void interrupted_transfer_is_repeated(void **state)
{
    (void)state;
    open_it();
    the_board.interrupt_message = 2;
    assert_int_equal(spi_write(&spi, bytes, sizeof bytes, &why), 0);
    assert_int_equal(the_board.bytes, sizeof bytes);
    assert_int_equal(the_board.messages, 4);
    spi_close(&spi);
}

static void transfer_fails(void **state)
{
    (void)state;
    uint8_t answer = 0;
    open_it();
    the_board.fail_error = EIO;
    the_board.fail_message = 2;
    assert_int_equal(spi_write(&spi, bytes, sizeof bytes, &why), -1);
    assert_says(why.text, "sending 4096 bytes failed");
    assert_int_equal(the_board.messages, 2);
    the_board.fail_message = 3;
    assert_int_equal(spi_write_selected(&spi, 0, 1000000, &why), -1);
    assert_says(why.text, "sending 1 bytes failed");
    the_board.fail_message = 4;
    assert_int_equal(spi_read(&spi, &answer, 1, 1000000, &why), -1);
    assert_says(why.text, "reading 1 bytes failed");
    spi_close(&spi);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(not_enabled),
        TEST(settings_refused),
        TEST(buffer_is_read_from_the_module),
        TEST(long_writes_are_split),
        TEST(splits_further_where_the_parameter_is_wrong),
        TEST(interrupted_transfer_is_repeated),
        TEST(transfer_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
