/* SPDX-License-Identifier: MIT
   Numbers of the resources, for the resource compiler and for C++: hence macros. */
#pragma once

#define HYRAX_ICON 1 /* The lowest number: Explorer shows the first icon. */
#define HYRAX_ABOUT 2
