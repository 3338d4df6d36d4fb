/* SPDX-License-Identifier: MIT */
/*
 * An SPI device through the kernel's spidev. Functions that can fail return -1 and tell why in `f`.
 */
#ifndef EXAMPLES_LINUX_PANEL_SPI_H
#define EXAMPLES_LINUX_PANEL_SPI_H

#include <stddef.h>
#include <stdint.h>

#include "failure.h"

typedef struct spi_device {
    const char *path;
    uint32_t speed_hz;
    size_t most_bytes; /* that the driver takes at once; longer writes are split */
    int file;
} spi_device;

/* Mode 0, 8 bits a word. `path` is to stay. */
int spi_open(spi_device *out, const char *path, uint32_t speed_hz, failure *f);
void spi_close(spi_device *spi);

/* Sends bytes; they have left when it returns. */
int spi_write(spi_device *spi, const uint8_t *bytes, size_t count, failure *f);

/* Sends a byte and stays selected, so that spi_read() gets the answer to it. */
int spi_write_selected(spi_device *spi, uint8_t byte, uint32_t speed_hz, failure *f);
int spi_read(spi_device *spi, uint8_t *bytes, size_t count, uint32_t speed_hz, failure *f);

#endif
