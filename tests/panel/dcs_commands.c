/* SPDX-License-Identifier: MIT */
/*
 * The commands of the ST7789 (ST7789VW rev. 1.0, 9.1 and 9.2) and of the ILI9341 (V1.11, 8.1, with those that its
 * application notes add), and the limits of their serial interfaces. Pixels are not arguments: 255.
 */
#include <stddef.h>

#include "tests/panel/internal.h"

/* ST7789VW 7.4.2: TSCYCW 16 ns, TSHW and TSLW 7 ns (the older ST7789V: 66 ns and 15 ns); 7.4.5: TRW 10 us, TRT 5 ms. */
const panel_limits panel_limits_st7789 = {16, 7, 7, 10 * PANEL_US, 5 * PANEL_MS};
/* ILI9341 18.3.4: twc 100 ns, twrh and twrl 40 ns; 18.3.6: tRW 10 us, tRT 5 ms. */
const panel_limits panel_limits_ili9341 = {100, 40, 40, 10 * PANEL_US, 5 * PANEL_MS};

/* clang-format off */
#define COMMON                                                                                                         \
    {0x00, 0, 0, "NOP"}, {0x01, 0, 0, "SWRESET"}, {0x04, 0, 255, "RDDID"}, {0x09, 0, 255, "RDDST"},                    \
    {0x0a, 0, 255, "RDDPM"}, {0x0b, 0, 255, "RDDMADCTL"}, {0x0c, 0, 255, "RDDCOLMOD"}, {0x0d, 0, 255, "RDDIM"},        \
    {0x0e, 0, 255, "RDDSM"}, {0x0f, 0, 255, "RDDSDR"}, {0x10, 0, 0, "SLPIN"}, {0x11, 0, 0, "SLPOUT"},                  \
    {0x12, 0, 0, "?PTLON"}, {0x13, 0, 0, "NORON"}, {0x20, 0, 0, "INVOFF"}, {0x21, 0, 0, "INVON"},                      \
    {0x26, 1, 1, "GAMSET"}, {0x28, 0, 0, "DISPOFF"}, {0x29, 0, 0, "DISPON"}, {0x2a, 4, 4, "CASET"},                    \
    {0x2b, 4, 4, "RASET"}, {0x2c, 0, 255, "RAMWR"}, {0x2e, 0, 255, "RAMRD"}, {0x30, 4, 4, "PTLAR"},                    \
    {0x33, 6, 6, "VSCRDEF"}, {0x34, 0, 0, "TEOFF"}, {0x35, 1, 1, "TEON"}, {0x36, 1, 1, "MADCTL"},                      \
    {0x37, 2, 2, "VSCSAD"}, {0x38, 0, 0, "IDMOFF"}, {0x39, 0, 0, "?IDMON"}, {0x3a, 1, 1, "COLMOD"},                    \
    {0x3c, 0, 255, "RAMWRC"}, {0x3e, 0, 255, "RAMRDC"}, {0x44, 2, 2, "STE"}, {0x45, 0, 255, "GSCAN"},                  \
    {0x51, 1, 1, "WRDISBV"}, {0x52, 0, 255, "RDDISBV"}, {0x53, 1, 1, "WRCTRLD"}, {0x54, 0, 255, "RDCTRLD"},            \
    {0x55, 1, 1, "WRCACE"}, {0x56, 0, 255, "RDCABC"}, {0x5e, 1, 1, "WRCABCMB"}, {0x5f, 0, 255, "RDCABCMB"},            \
    {0xda, 0, 255, "RDID1"}, {0xdb, 0, 255, "RDID2"}, {0xdc, 0, 255, "RDID3"}

const panel_command panel_commands_st7789[] = {
    COMMON,
    {0x68, 0, 255, "RDABCSDR"}, {0xb0, 2, 2, "RAMCTRL"}, {0xb1, 3, 3, "RGBCTRL"}, {0xb2, 5, 5, "PORCTRL"},
    {0xb3, 3, 3, "FRCTRL1"}, {0xb5, 1, 1, "PARCTRL"}, {0xb7, 1, 1, "GCTRL"}, {0xb8, 4, 4, "GTADJ"},
    {0xba, 1, 1, "?DGMEN"}, {0xbb, 1, 1, "VCOMS"}, {0xbc, 1, 1, "POWSAVE"}, {0xbd, 1, 1, "DLPOFFSAVE"},
    {0xc0, 1, 1, "LCMCTRL"}, {0xc1, 3, 3, "IDSET"}, {0xc2, 1, 2, "VDVVRHEN"}, {0xc3, 1, 1, "VRHS"},
    {0xc4, 1, 1, "VDVSET"}, {0xc5, 1, 1, "VCMOFSET"}, {0xc6, 1, 1, "FRCTRL2"}, {0xc7, 1, 1, "CABCCTRL"},
    {0xc8, 1, 1, "REGSEL1"}, {0xca, 1, 1, "REGSEL2"}, {0xcc, 1, 1, "PWMFRSEL"}, {0xd0, 2, 2, "PWCTRL1"},
    {0xd2, 1, 1, "VAPVANEN"}, {0xdf, 4, 4, "CMD2EN"}, {0xe0, 14, 14, "PVGAMCTRL"}, {0xe1, 14, 14, "NVGAMCTRL"},
    {0xe2, 64, 64, "DGMLUTR"}, {0xe3, 64, 64, "DGMLUTB"}, {0xe4, 3, 3, "?GATECTRL"}, {0xe7, 1, 1, "?SPI2EN"},
    {0xe8, 1, 1, "PWCTRL2"}, {0xe9, 3, 3, "EQCTRL"}, {0xec, 1, 1, "PROMCTRL"}, {0xfa, 4, 4, "PROMEN"},
    {0xfc, 2, 2, "NVMSET"}, {0xfe, 2, 2, "PROMACT"},
    {0, 0, 0, NULL},
};

const panel_command panel_commands_ili9341[] = {
    COMMON,
    {0x2d, 128, 128, "?RGBSET"}, {0xb0, 1, 1, "?IFMODE"}, {0xb1, 2, 2, "FRMCTR1"}, {0xb2, 2, 2, "FRMCTR2"},
    {0xb3, 2, 2, "FRMCTR3"}, {0xb4, 1, 1, "INVTR"}, {0xb5, 4, 4, "PRCTR"}, {0xb6, 3, 4, "DISCTRL"},
    {0xb7, 1, 1, "ETMOD"}, {0xb8, 1, 1, "BLCTRL1"}, {0xb9, 1, 1, "BLCTRL2"}, {0xba, 1, 1, "BLCTRL3"},
    {0xbb, 1, 1, "BLCTRL4"}, {0xbc, 1, 1, "BLCTRL5"}, {0xbe, 1, 1, "BLCTRL7"}, {0xbf, 1, 1, "BLCTRL8"},
    {0xc0, 1, 1, "PWCTRL1"}, {0xc1, 1, 1, "PWCTRL2"}, {0xc5, 2, 2, "VMCTRL1"}, {0xc7, 1, 1, "VMCTRL2"},
    {0xcb, 5, 5, "PWCTRLA"}, {0xcf, 3, 3, "PWCTRLB"}, {0xd0, 2, 2, "NVMWR"}, {0xd1, 3, 3, "NVMPKEY"},
    {0xd2, 0, 255, "RDNVM"}, {0xd3, 0, 255, "RDID4"}, {0xe0, 15, 15, "PGAMCTRL"}, {0xe1, 15, 15, "NGAMCTRL"},
    {0xe2, 16, 16, "DGAMCTRL1"}, {0xe3, 64, 64, "DGAMCTRL2"}, {0xe8, 3, 3, "DTCTRLA"}, {0xe9, 3, 3, "DTCTRLA2"},
    {0xea, 2, 2, "DTCTRLB"}, {0xed, 4, 4, "PWSEQ"}, {0xf2, 1, 1, "EN3G"}, {0xf6, 3, 3, "IFCTL"}, {0xf7, 1, 1, "PRCTL"},
    {0, 0, 0, NULL},
};
/* clang-format on */
