/* SPDX-License-Identifier: MIT */
/*
 * The first lines of a program that counts on a target:
 *
 *     calibration KNOWN COUNTED     instructions or cycles, and the steps that the counter took for them
 *     unit instructions|cycles
 */
#ifndef TOOLS_COST_CALIBRATE_H
#define TOOLS_COST_CALIBRATE_H

void cost_calibrate(void);

#endif
