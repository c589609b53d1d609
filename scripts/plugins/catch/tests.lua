-- SPDX-License-Identifier: MIT
-- hyrax-headless --test scripts/plugins/catch
local scores = require "scores"
local test = hyrax.test

return function(game)
  test.case("the best rounds are kept in order", function()
    hyrax.store.set("best", nil)
    test.equal(scores.text(), "Throw a hyrax in!")
    test.equal(scores.add(3), 1)
    test.equal(scores.add(9), 1)
    test.equal(scores.add(5), 2)
    test.equal(scores.add(0), nil)
    test.equal(scores.text(), "Best: 9, 5, 3")
    for _ = 1, 5 do scores.add(7) end
    test.equal(scores.text(), "Best: 9, 7, 7, 7, 7")
    test.equal(scores.add(1), nil)
    hyrax.store.set("best", nil)
  end)

  test.case("the basket and the balls come, and the basket walks", function()
    game.set_up()
    test.equal(#hyrax.pets{ kind = "basket" }, 1)
    test.equal(game.basket().kind, "catch/basket")
    test.equal(#hyrax.pets{ tag = "ball" }, hyrax.config.balls)
    test.advance(3)
    local x = game.basket().x
    test.advance(1)
    test.expect(math.abs(game.basket().x - x) > 30, "it stands still")
  end)

  test.case("a ball that falls into the basket counts, and flies out again", function()
    game.set_up()
    test.advance(3)
    local ball, basket = hyrax.pets{ tag = "ball" }[1], game.basket()
    ball:move_to(basket.x + basket.w / 2 - ball.w / 2, basket.y - 400)
    test.advance(0.1)
    game.throw(ball)
    local points = game.points()
    for _ = 1, 40 do
      test.advance(0.05)
      if game.points() > points then break end
    end
    test.equal(game.points(), points + 1)
    test.expect(ball.vy < 0, "it does not fly out")
  end)

  test.case("one that hits the basket from the side does not count", function()
    game.set_up()
    test.advance(3)
    local ball, basket = hyrax.pets{ tag = "ball" }[1], game.basket()
    ball:move_to(basket.x - ball.w - 60, basket.y)
    ball:fling(900, 0)
    game.throw(ball)
    local points = game.points()
    test.advance(0.5)
    test.equal(game.points(), points)
  end)
end
