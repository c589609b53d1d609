-- MUST: error:binary chunk | bytecode is refused whatever mode the script asks for
-- SPDX-License-Identifier: MIT
assert(load("\27Lua\x54\0\x19\x93\r\n\x1a\n", "x", "b"))
