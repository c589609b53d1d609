-- MUST: kill | logging is rate limited (HOST: at most 100 lines reach the log)
-- SPDX-License-Identifier: MIT
while true do print(("x"):rep(1000)) end
