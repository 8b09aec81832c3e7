-- Turns its entity around an axis, and faster while the space bar is held.

axis = vec3(0, 1, 0)
speed = 1 -- radians per second

function update(dt)
    local factor = input.down("space") and 4 or 1
    local turn = quat.axis_angle(axis, speed * factor * dt)
    self.transform.rotation = (turn * self.transform.rotation):normalize()
end
