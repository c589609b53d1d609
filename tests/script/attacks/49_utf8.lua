-- MUST: kill | utf8 functions are O(n) per call: a loop of them is charged by bytes
-- SPDX-License-Identifier: MIT
local s = ("\u{20AC}"):rep(300000)
assert(utf8.len(s) == 300000)
assert(not utf8.len("\xff\xfe\xfd\xfc\xfb\xfa"))
for i = 1, 1e7 do utf8.offset(s, -1, 1) utf8.len(s) end
