
-- Fields that filters know, and values of any width.

local devc = Proto(PROTOCOL, NAME .. " (devc)")

local ways = { { 1, "as the capture shows, or by default", 0 } }
for number, it in ipairs(CONFIGURATIONS) do
    ways[#ways + 1] = { number + 1, it.name, number }
end
devc.prefs.configuration = Pref.enum("Process data", 0, "Which PDOs are assigned, and what is mapped to them", ways)
devc.prefs.stations = Pref.string("Stations", "",
    "Addresses of the devices, such as 0x1001, 0x1002; without any, those that do not say they are another device")
devc.prefs.outputs = Pref.string("Logical address of outputs", "",
    "For a capture that begins when the FMMUs are set up already, with one station")
devc.prefs.inputs = Pref.string("Logical address of inputs", "", "As for outputs")

local fields = {}

local function add_field(name, make, title, ...)
    fields[name] = make(PROTOCOL .. "." .. name, title, ...)
end

local function field_of(kind, bits, name, title, is_word)
    if kind == "bool" then
        add_field(name, ProtoField.bool, title)
    elseif kind == "int" then
        add_field(name, bits > 32 and ProtoField.int64 or ProtoField.int32, title, base.DEC)
    elseif kind == "uint" and is_word then
        local make = bits > 16 and ProtoField.uint32 or bits > 8 and ProtoField.uint16 or ProtoField.uint8
        add_field(name, make, title, base.HEX)
    elseif kind == "uint" then
        add_field(name, bits > 32 and ProtoField.uint64 or ProtoField.uint32, title, base.DEC)
    elseif kind == "real" then
        add_field(name, bits > 32 and ProtoField.double or ProtoField.float, title)
    elseif kind == "text" then
        add_field(name, ProtoField.string, title)
    else
        add_field(name, ProtoField.bytes, title)
    end
end

add_field("station", ProtoField.uint16, "Station", base.HEX)
add_field("mismatch", ProtoField.string, "Other process data than described")
add_field("sdo.index", ProtoField.uint16, "Index", base.HEX)
add_field("sdo.subindex", ProtoField.uint8, "Subindex", base.DEC)
add_field("sdo.what", ProtoField.string, "SDO")
add_field("sdo.name", ProtoField.string, "Object")
add_field("sdo.value", ProtoField.string, "Value")
add_field("sdo.abort", ProtoField.uint32, "Abort code", base.HEX)
add_field("sdo.reason", ProtoField.string, "Reason")
add_field("emergency.code", ProtoField.uint16, "Error code", base.HEX)
add_field("emergency.name", ProtoField.string, "Error")
add_field("emergency.register", ProtoField.uint8, "Error register", base.HEX)
add_field("emergency.data", ProtoField.bytes, "Of the vendor")
add_field("al.requested", ProtoField.string, "State requested")
add_field("al.state", ProtoField.string, "State")
add_field("al.code", ProtoField.uint16, "AL status code", base.HEX)
add_field("al.reason", ProtoField.string, "Reason")

-- The name of an entry, with that of its object.
local function name_of(index, subindex)
    local object, entry = OBJECTS[index], ENTRIES[index * 256 + subindex]
    if not object then return entry and entry[1] or "not in the description" end
    if not entry then return object end
    return entry[1] == object and object or object .. ", " .. entry[1]
end

local function add_bits(entry, list)
    for _, bits in ipairs(list) do
        local kind = bits[1] == bits[2] and "bool" or "uint"
        field_of(kind, 32, entry.filter .. "." .. bits[3], bits[4])
    end
end

for key, entry in pairs(ENTRIES) do
    if entry.filter then
        local title = name_of(math.floor(key / 256), key % 256)
        field_of(entry[2], entry[3], entry.filter, title, entry.word ~= nil)
        local word = entry.word and WORDS[entry.word]
        if word then
            add_bits(entry, word)
            for _, bits in pairs(word.modes) do add_bits(entry, bits) end
        end
        if entry.word == "statusword" then
            add_field(entry.filter .. ".state", ProtoField.string, "State")
        end
    end
end

local list = {}
for _, field in pairs(fields) do list[#list + 1] = field end
devc.fields = list

-- The name that a number has in a list of ranges.
local function named(values, number)
    for _, it in ipairs(values or {}) do
        if number >= it[1] and number <= it[2] then return it[3] end
    end
end

-- Bits of a number.
local function bits_of(number, low, high)
    return math.floor(number / 2 ^ low) % math.floor(2 ^ (high - low + 1))
end

-- At most 32 bits of bytes, from a bit on.
local function number_at(bytes, bit, bits)
    local value, got = 0, 0
    while got < bits do
        local byte, low = math.floor((bit + got) / 8), (bit + got) % 8
        local take = math.min(8 - low, bits - got)
        value = value + bits_of(bytes(byte, 1):uint(), low, low + take - 1) * math.floor(2 ^ got)
        got = got + take
    end
    return value
end

-- The bytes that some bits lie in.
local function around(bytes, bit, bits)
    local first = math.floor(bit / 8)
    return bytes(first, math.floor((bit + bits + 7) / 8) - first)
end

-- A whole number of more than 32 bits, in the class that Wireshark has for it.
local function long_at(kind, bytes, bit, bits)
    local low = number_at(bytes, bit, math.min(bits, 32))
    local high = bits > 32 and number_at(bytes, bit + 32, bits - 32) or 0
    if kind == "uint" then return UInt64.new(low, high) end
    if number_at(bytes, bit + bits - 1, 1) == 1 then
        if bits < 32 then low = low + math.floor(2 ^ 32 - 2 ^ bits) end
        high = high + math.floor(2 ^ 32 - 2 ^ math.max(bits - 32, 0))
    end
    return Int64.new(low, high)
end

-- A number of IEEE 754 that does not begin with a byte.
local function real_at(bytes, bit, bits)
    local fraction, exponent = bits == 64 and 52 or 23, bits == 64 and 11 or 8
    local low = number_at(bytes, bit, math.min(fraction, 32))
    local high = fraction > 32 and number_at(bytes, bit + 32, fraction - 32) or 0
    local part = (high * 2 ^ 32 + low) / 2 ^ fraction
    local power = number_at(bytes, bit + fraction, exponent)
    local sign = number_at(bytes, bit + bits - 1, 1) == 1 and -1 or 1
    local bias = 2 ^ (exponent - 1) - 1
    if power == 2 ^ exponent - 1 then return part == 0 and sign * math.huge or 0 / 0 end
    if power == 0 then return sign * part * 2 ^ (1 - bias) end
    return sign * (1 + part) * 2 ^ (power - bias)
end

-- The bytes of a value that does not begin with a byte, each as two digits.
local function digits_at(bytes, bit, bits)
    local digits = {}
    for at = 0, bits - 1, 8 do
        digits[#digits + 1] = string.format("%02x", number_at(bytes, bit + at, math.min(8, bits - at)))
    end
    return table.concat(digits)
end

-- A value as Wireshark takes it for a field of so many bits, and as a number of Lua where 32 bits are enough.
local function value_at(kind, width, bytes, bit, bits)
    if kind == "text" then
        local text = {}
        for digits in digits_at(bytes, bit, bits):gmatch("%x%x") do
            local code = tonumber(digits, 16)
            if code == 0 then break end
            text[#text + 1] = code >= 32 and code < 127 and string.char(code) or "?"
        end
        return table.concat(text)
    elseif kind == "real" then
        local is_whole = bit % 8 == 0
        return is_whole and around(bytes, bit, bits):le_float() or real_at(bytes, bit, bits)
    elseif kind == "bytes" or bits > 64 then
        return ByteArray.new(digits_at(bytes, bit, bits))
    elseif width > 32 then
        return long_at(kind, bytes, bit, bits)
    end
    local number = number_at(bytes, bit, math.min(bits, 32))
    if kind == "bool" then return number ~= 0, number end
    if kind == "int" and bits_of(number, bits - 1, bits - 1) == 1 then
        number = number - math.floor(2 ^ bits)
    end
    return number, number
end

-- The state that a statusword shows.
local function state_of(word)
    for _, state in ipairs(STATES) do
        if bit.band(word, state[1]) == state[2] then return state[3] end
    end
end

-- What a value means: a state, or what its entry says.
local function meaning(entry, number)
    if entry.word == "statusword" then return state_of(number) end
    return named(entry.values, number)
end
