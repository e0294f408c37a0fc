// Reads a configuration as ethercat_driver_ros2 documents it, with the library that it uses and the types that it asks for,
// and prints what it is told.
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <yaml-cpp/yaml.h>

static int bits(const std::string &type)
{
    if (type == "bool") { return 1; }
    if (type == "int8" || type == "uint8") { return 8; }
    if (type == "int16" || type == "uint16") { return 16; }
    if (type == "int32" || type == "uint32") { return 32; }
    if (type == "int64" || type == "uint64") { return 64; }
    if (type.rfind("bit", 0) == 0) { return std::stoi(type.substr(3)); }
    throw std::runtime_error("unknown type " + type);
}

static void pdos(const YAML::Node &list, const char *name, const char *interface)
{
    for (const auto &pdo : list) {
        std::cout << name << ' ' << pdo["index"].as<uint16_t>() << '\n';
        for (const auto &channel : pdo["channels"]) {
            const std::string type = channel["type"].as<std::string>();
            std::cout << "channel " << channel["index"].as<uint16_t>() << ' '
                      << channel["sub_index"].as<int>() << ' ' << bits(type) << ' ' << type << ' ';
            std::cout << (channel[interface] ? channel[interface].as<std::string>() : "-") << ' ';
            std::cout << (channel["default"] && std::isnan(channel["default"].as<double>()) ? "nan" : "-") << ' ';
            std::cout.precision(17);
            std::cout << (channel["factor"] ? channel["factor"].as<double>() : 1.0) << '\n';
        }
    }
}

int main(int, char **arguments)
{
    const YAML::Node slave = YAML::LoadFile(arguments[1]);
    std::cout << "identity " << slave["vendor_id"].as<uint32_t>() << ' ' << slave["product_id"].as<uint32_t>() << '\n';
    std::cout << "clocks " << (slave["assign_activate"] ? slave["assign_activate"].as<uint32_t>() : 0) << '\n';
    for (const auto &sdo : slave["sdo"]) {
        std::cout << "sdo " << sdo["index"].as<uint16_t>() << ' ' << sdo["sub_index"].as<int>() << ' '
                  << bits(sdo["type"].as<std::string>()) << ' ' << sdo["value"].as<int>() << '\n';
    }
    pdos(slave["rpdo"], "rpdo", "command_interface");
    pdos(slave["tpdo"], "tpdo", "state_interface");
    for (const auto &manager : slave["sm"]) {
        std::cout << "sm " << manager["index"].as<int>() << ' ' << manager["type"].as<std::string>() << ' '
                  << (manager["pdo"].IsNull() ? "-" : manager["pdo"].as<std::string>()) << ' '
                  << manager["watchdog"].as<std::string>() << '\n';
    }
    return 0;
}
