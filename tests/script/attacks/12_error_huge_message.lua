-- MUST: error: | the report of a 512 KiB error message is cut, control characters are removed
-- SPDX-License-Identifier: MIT
error(("\27[2J\0\r\n"):rep(80000))
