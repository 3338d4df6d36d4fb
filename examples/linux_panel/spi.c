/* SPDX-License-Identifier: MIT */
#include "spi.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

/* What the driver takes at once is a parameter of its module, and what it is by default if that cannot be read. */
#define BUFFER_PARAMETER "/sys/module/spidev/parameters/bufsiz"
#define DEFAULT_BUFFER_BYTES 4096
#define LEAST_BYTES                                                                                                    \
    64 /* no driver's buffer is as short: a shorter transfer that is refused is refused for its own sake */

static size_t buffer_bytes(void)
{
    unsigned long bytes = 0;
    FILE *parameter = fopen(BUFFER_PARAMETER, "r");
    if (parameter != NULL) {
        if (fscanf(parameter, "%9lu", &bytes) != 1) { /* NOLINT(cert-err34-c): 9 digits fit */
            bytes = 0;
        }
        (void)fclose(parameter);
    }
    return bytes >= LEAST_BYTES ? bytes : DEFAULT_BUFFER_BYTES;
}

static int fail_open(failure *f, const char *path, int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return fail_permission(f, path);
    case ENOENT:
    case ENODEV:
    case ENXIO:
        return fail_with(
            f,
            "%s: no such device: SPI is not enabled, or has another number (ls /dev/spidev*). On a Raspberry Pi "
            "write dtparam=spi=on into /boot/firmware/config.txt and restart; on other boards enable the SPI "
            "overlay, with a spidev node",
            path);
    case EBUSY:
        return fail_with(f, "%s: in use by another program, or by a kernel driver of a panel: end that first", path);
    default:
        return fail_with(f, "%s: cannot open the SPI device: %s", path, strerror(error));
    }
}

static int fail_setting(failure *f, const char *path, const char *what, int error)
{
    if (error == ENOTTY) {
        return fail_with(f, "%s: is not an SPI device: give --spi one of /dev/spidev*", path);
    }
    return fail_with(f, "%s: the SPI controller refuses %s: %s", path, what, strerror(error));
}

int spi_open(spi_device *out, const char *path, uint32_t speed_hz, failure *f)
{
    uint8_t mode = SPI_MODE_0, bits = 8;
    char speed[32];
    int result = -1;
    const int file = open(path, O_RDWR | O_CLOEXEC);
    if (file < 0) {
        return fail_open(f, path, errno);
    }
    (void)snprintf(speed, sizeof speed, "%u Hz", (unsigned)speed_hz);
    if (ioctl(file, SPI_IOC_WR_MODE, &mode) < 0) {
        result = fail_setting(f, path, "SPI mode 0", errno);
    } else if (ioctl(file, SPI_IOC_WR_BITS_PER_WORD, &bits) < 0) {
        result = fail_setting(f, path, "words of 8 bits", errno);
    } else if (ioctl(file, SPI_IOC_WR_MAX_SPEED_HZ, &speed_hz) < 0) {
        result = fail_setting(f, path, speed, errno);
    } else {
        *out = (spi_device){.path = path, .speed_hz = speed_hz, .most_bytes = buffer_bytes(), .file = file};
        return 0;
    }
    (void)close(file);
    return result;
}

void spi_close(spi_device *spi)
{
    (void)close(spi->file);
}

static int transfer(const spi_device *spi, struct spi_ioc_transfer *one)
{
    int result;
    do {
        result = ioctl(spi->file, SPI_IOC_MESSAGE(1), one);
    } while (result < 0 && errno == EINTR);
    return result;
}

static int fail_transfer(const spi_device *spi, size_t bytes, int error, failure *f)
{
    if (error == EMSGSIZE) {
        return fail_with(
            f,
            "%s: the driver refuses even %zu bytes at once: make its buffer greater, with spidev.bufsiz=65536 "
            "on the kernel's command line",
            spi->path, bytes);
    }
    return fail_with(f, "%s: sending %zu bytes failed: %s", spi->path, bytes, strerror(error));
}

int spi_write(spi_device *spi, const uint8_t *bytes, size_t count, failure *f)
{
    while (count > 0) {
        const size_t now = count < spi->most_bytes ? count : spi->most_bytes;
        struct spi_ioc_transfer one = {
            .tx_buf = (uintptr_t)bytes, .len = (uint32_t)now, .speed_hz = spi->speed_hz, .bits_per_word = 8};
        if (transfer(spi, &one) >= 0) {
            bytes += now;
            count -= now;
        } else if (errno == EMSGSIZE && now > LEAST_BYTES) {
            spi->most_bytes = now / 2; /* the buffer is smaller than its parameter says: halve until it fits */
        } else {
            return fail_transfer(spi, now, errno, f);
        }
    }
    return 0;
}

int spi_write_selected(spi_device *spi, uint8_t byte, uint32_t speed_hz, failure *f)
{
    struct spi_ioc_transfer one = {
        .tx_buf = (uintptr_t)&byte, .len = 1, .speed_hz = speed_hz, .bits_per_word = 8, .cs_change = 1};
    return transfer(spi, &one) >= 0 ? 0 : fail_transfer(spi, 1, errno, f);
}

int spi_read(spi_device *spi, uint8_t *bytes, size_t count, uint32_t speed_hz, failure *f)
{
    struct spi_ioc_transfer one = {
        .rx_buf = (uintptr_t)bytes, .len = (uint32_t)count, .speed_hz = speed_hz, .bits_per_word = 8};
    return transfer(spi, &one) >= 0
               ? 0
               : fail_with(f, "%s: reading %zu bytes failed: %s", spi->path, count, strerror(errno));
}
