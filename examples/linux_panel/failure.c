/* SPDX-License-Identifier: MIT */
#include "failure.h"

#include <grp.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/stat.h>

int fail_with(failure *f, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(f->text, sizeof f->text, format, arguments);
    va_end(arguments);
    return -1;
}

int fail_permission(failure *f, const char *path)
{
    struct stat device;
    const struct group *group = NULL;
    if (stat(path, &device) == 0 && device.st_gid != 0 && (device.st_mode & S_IWGRP) != 0) {
        group = getgrgid(device.st_gid);
    }
    if (group == NULL) {
        return fail_with(
            f,
            "%s: no permission, and no group of users has it: run as root, or give the device to a group with "
            "a udev rule (see README.md)",
            path);
    }
    return fail_with(
        f, "%s: no permission: join the group that has it with `sudo usermod -aG %s $USER`, then log in again", path,
        group->gr_name);
}
