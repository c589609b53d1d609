-- SPDX-License-Identifier: MIT
-- The time of day from os.time, which tells seconds since 1970 in UTC.
local time = {}

local HOUR, DAY = 3600, 86400

-- Year, month and day of a day since 1970-01-01: Howard Hinnant, "chrono-compatible low-level date
-- algorithms", civil_from_days.
function time.date(days)
  local z = days + 719468
  local era = z // 146097
  local doe = z - era * 146097
  local yoe = (doe - doe // 1460 + doe // 36524 - doe // 146096) // 365
  local doy = doe - (365 * yoe + yoe // 4 - yoe // 100)
  local mp = (5 * doy + 2) // 153
  local month = mp < 10 and mp + 3 or mp - 9
  return yoe + era * 400 + (month <= 2 and 1 or 0), month, doy - (153 * mp + 2) // 5 + 1
end

-- How far the local clock is ahead of UTC [s]: os.time takes a date for a local one.
function time.zone(now)
  local year, month, day = time.date(now // DAY)
  local seconds = now % DAY
  return now - os.time{ year = year, month = month, day = day, hour = seconds // HOUR,
                        min = seconds % HOUR // 60, sec = seconds % 60 }
end

function time.local_hour(now) return (now + time.zone(now)) % DAY // HOUR end

function time.until_full_hour(now) return HOUR - (now + time.zone(now)) % HOUR end

-- Twelve at noon and at midnight.
function time.strikes(hour) return (hour + 11) % 12 + 1 end

-- From `from` up to `to`, past midnight where need be; never if they are the same.
function time.is_quiet(hour, from, to)
  return (hour - from) % 24 < (to - from) % 24
end

return time
