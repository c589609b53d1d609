-- SPDX-License-Identifier: MIT
-- hyrax-headless --test scripts/plugins/clock
local time = require "time"
local test = hyrax.test

return function(strike)
  test.case("dates", function()
    local function date(days) return ("%d-%d-%d"):format(time.date(days)) end
    test.equal(date(0), "1970-1-1")
    test.equal(date(59), "1970-3-1")
    test.equal(date(11016), "2000-2-29")
    test.equal(date(20783), "2026-11-26")
  end)

  test.case("hours", function()
    test.equal(time.strikes(0), 12)
    test.equal(time.strikes(1), 1)
    test.equal(time.strikes(12), 12)
    test.equal(time.strikes(23), 11)
    test.expect(time.until_full_hour(os.time()) <= 3600)
    test.expect(math.abs(time.zone(os.time())) <= 14 * 3600)
  end)

  test.case("the night is quiet, also past midnight", function()
    test.expect(time.is_quiet(23, 22, 8))
    test.expect(time.is_quiet(0, 22, 8))
    test.expect(not time.is_quiet(8, 22, 8))
    test.expect(not time.is_quiet(21, 22, 8))
    test.expect(time.is_quiet(1, 1, 2))
    test.expect(not time.is_quiet(5, 7, 7))
  end)

  test.case("three o'clock: three come, jump and go", function()
    hyrax.task(strike, 15)
    test.advance(1)
    test.equal(#hyrax.pets{ tag = "ringer" }, 3)
    test.advance(2.1)
    test.expect(hyrax.pets{ tag = "ringer" }[1].vy < 0, "the first one does not jump")
    test.advance(10)
    test.equal(#hyrax.pets{ tag = "ringer" }, 0)
  end)
end
