/* SPDX-License-Identifier: MIT */
/*
 * Everything between the command line and the exit status.
 */
#ifndef EXAMPLES_LINUX_PANEL_PROGRAM_H
#define EXAMPLES_LINUX_PANEL_PROGRAM_H

#include <stdio.h>

#include "failure.h"
#include "options.h"

/*
 * Draws until the frames asked for are shown, which leaves the last one on the panel, or until a signal comes or
 * something fails, which leaves the panel blanked. Lines and device are released in each case. Returns 0, or -1 and
 * why.
 */
int program_run(const options *o, FILE *out, failure *f);

#endif
