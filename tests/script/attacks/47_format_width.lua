-- MUST: error:invalid conversion | format width is limited to two digits
-- SPDX-License-Identifier: MIT
string.format("%99999d", 1)
