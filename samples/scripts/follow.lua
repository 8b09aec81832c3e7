-- Comes after the entity called "Leader", and calls out when it has reached it.

speed = 2    -- metres per second
distance = 1 -- how near it comes

function start()
    leader = scene.find("Leader")
    near = false
end

function update(dt)
    if not (leader and leader:alive()) then return end
    local way = leader.transform.translation - self.transform.translation
    local left = way:length() - distance
    if left > 0 then
        local step = way:normalize() * math.min(left, speed * dt)
        self.transform.translation = self.transform.translation + step
    end
    local arrived = left <= speed * dt
    if arrived and not near then scene.send("reached", leader) end
    near = arrived
end

function event(name, entity)
    if name == "stop" then leader = nil end
end
