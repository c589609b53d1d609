/* SPDX-License-Identifier: MIT
   Numbers of the resources, for the resource compiler and for C++: hence macros. */
#pragma once

#define HYRAX_ICON 1 /* The lowest number: Explorer shows the first icon. */
#define HYRAX_ABOUT 2
#define HYRAX_LICENCES 3      /* The text. */
#define HYRAX_LICENCES_BOX 10 /* The field that shows it. */
