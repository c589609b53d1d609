-- SPDX-License-Identifier: MIT
-- Clock: at the full hour as many hyraxes as it strikes drop in, jump one after the other, and leave.

local time = require "time"

local STRIKE = 0.8                 -- seconds from one strike to the next

local function line_up(count)
  local room = hyrax.monitors()[1].work
  for _, monitor in ipairs(hyrax.monitors()) do
    if monitor.primary then room = monitor.work end
  end
  local ringers = {}
  for i = 1, count do
    local x = room.x + room.w * i / (count + 1)
    ringers[i] = hyrax.spawn{ tag = "ringer", x = x - 54, y = room.y + room.h * 0.6 }
  end
  return ringers
end

local function strike(hour)
  local count = time.strikes(hour)
  hyrax.log.info("it is %d o'clock", hour)
  local ringers = line_up(count)
  hyrax.wait(3)
  for i, ringer in ipairs(ringers) do
    if ringer.valid then
      ringer:fling(0, -520)
      ringer:say(i == count and ("%s %d!"):format(hyrax.config.bell, count) or hyrax.config.bell, STRIKE * 1.5)
    end
    hyrax.wait(STRIKE)
  end
  hyrax.wait(4)
  for _, ringer in ipairs(ringers) do ringer:remove() end
end

local function keep_time()
  while true do
    hyrax.wait(time.until_full_hour(os.time()))
    local hour = time.local_hour(os.time() + 1)
    if not time.is_quiet(hour, hyrax.config.quiet_from, hyrax.config.quiet_to) then strike(hour) end
    hyrax.wait(1)
  end
end

if hyrax.test then
  require "tests" (strike)
else
  hyrax.task(keep_time)
end
