#include "schema.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::link {

namespace {

template <class T>
struct Kind;
#define KIND(Type, text)                      \
  template <>                                 \
  struct Kind<Type> {                         \
    static constexpr const char* name = text; \
  }
KIND(char, "char");
KIND(std::uint8_t, "u8");
KIND(std::uint16_t, "u16");
KIND(std::uint32_t, "u32");
KIND(std::uint64_t, "u64");
KIND(std::int32_t, "i32");
KIND(std::int64_t, "i64");
KIND(float, "f32");
KIND(double, "f64");
KIND(Name, "Name");
KIND(Text, "Text");
KIND(Header, "Header");
KIND(Histogram, "Histogram");
KIND(JointState, "JointState");
KIND(ImuState, "ImuState");
KIND(ForceTorqueState, "ForceTorqueState");
KIND(FrameData, "FrameData");
KIND(StateFrame, "StateFrame");
KIND(LoopStatistics, "LoopStatistics");
KIND(StateSegment, "StateSegment");
KIND(JointCommand, "JointCommand");
KIND(CommandData, "CommandData");
KIND(CommandSlot, "CommandSlot");
KIND(ThreadStatistics, "ThreadStatistics");
KIND(PluginStatistics, "PluginStatistics");
KIND(HostSegment, "HostSegment");
KIND(MasterData, "MasterData");
KIND(MasterSegment, "MasterSegment");
KIND(JointEntry, "JointEntry");
KIND(ChainEntry, "ChainEntry");
KIND(PluginEntry, "PluginEntry");
KIND(HostEntry, "HostEntry");
KIND(BoardData, "BoardData");
KIND(BoardSegment, "BoardSegment");
#undef KIND

// Texts are structs of their own; an atomic number is laid out as the number.
template <class T>
struct Field {
  static SchemaField of(const char* name, std::size_t offset) { return {name, Kind<T>::name, offset, 1, sizeof(T)}; }
};
template <class T>
struct Field<std::atomic<T>> : Field<T> {};
template <class T, std::size_t N>
struct Field<std::array<T, N>> {
  static SchemaField of(const char* name, std::size_t offset) {
    SchemaField field = Field<T>::of(name, offset);
    field.count = N;
    return field;
  }
};
template <>
struct Field<Name> {
  static SchemaField of(const char* name, std::size_t offset) { return {name, "Name", offset, 1, sizeof(Name)}; }
};
template <>
struct Field<Text> {
  static SchemaField of(const char* name, std::size_t offset) { return {name, "Text", offset, 1, sizeof(Text)}; }
};

#define FIELD(member) Field<decltype(T::member)>::of(#member, offsetof(T, member))

template <class T>
SchemaStruct make(std::vector<SchemaField> fields) {
  return {Kind<T>::name, sizeof(T), std::move(fields)};
}

SchemaStruct header() {
  using T = Header;
  return make<T>(
      {FIELD(magic), FIELD(version), FIELD(segment), FIELD(generation), FIELD(created_ns), FIELD(pid), FIELD(size)});
}

SchemaStruct histogram() {
  using T = Histogram;
  return make<T>({FIELD(count), FIELD(max_ns), FIELD(buckets)});
}

SchemaStruct jointState() {
  using T = JointState;
  return make<T>({FIELD(link_position), FIELD(motor_position), FIELD(link_velocity), FIELD(motor_velocity),
                  FIELD(effort), FIELD(position_reference), FIELD(velocity_reference), FIELD(effort_reference),
                  FIELD(stiffness), FIELD(damping), FIELD(temperature_motor), FIELD(temperature_driver), FIELD(fault),
                  FIELD(clamped), FIELD(rejected), FIELD(owner), FIELD(mode), FIELD(control)});
}

SchemaStruct imuState() {
  using T = ImuState;
  return make<T>({FIELD(orientation), FIELD(angular_velocity), FIELD(linear_acceleration)});
}

SchemaStruct forceTorqueState() {
  using T = ForceTorqueState;
  return make<T>({FIELD(force), FIELD(torque)});
}

SchemaStruct frameData() {
  using T = FrameData;
  return make<T>({FIELD(cycle), FIELD(sensed_ns), FIELD(hal_status), FIELD(switched), FIELD(joints), FIELD(imus),
                  FIELD(force_torques)});
}

SchemaStruct stateFrame() {
  using T = StateFrame;
  return make<T>({FIELD(sequence), FIELD(data)});
}

SchemaStruct loopStatistics() {
  using T = LoopStatistics;
  return make<T>({FIELD(period_ns), FIELD(priority), FIELD(core), FIELD(cycles), FIELD(overruns), FIELD(sense_failures),
                  FIELD(move_failures), FIELD(missed_commands), FIELD(allocations), FIELD(page_faults), FIELD(wake_up),
                  FIELD(period), FIELD(busy)});
}

SchemaStruct stateSegment() {
  using T = StateSegment;
  return make<T>({FIELD(header), FIELD(newest), FIELD(bell), FIELD(joints), FIELD(imus), FIELD(force_torques),
                  FIELD(loop), FIELD(frames)});
}

SchemaStruct jointCommand() {
  using T = JointCommand;
  return make<T>(
      {FIELD(position), FIELD(velocity), FIELD(effort), FIELD(stiffness), FIELD(damping), FIELD(plugin), FIELD(mode)});
}

SchemaStruct commandData() {
  using T = CommandData;
  return make<T>({FIELD(cycle), FIELD(written_ns), FIELD(joints)});
}

SchemaStruct commandSlot() {
  using T = CommandSlot;
  return make<T>({FIELD(sequence), FIELD(data)});
}

SchemaStruct threadStatistics() {
  using T = ThreadStatistics;
  return make<T>({FIELD(name), FIELD(period_ns), FIELD(priority), FIELD(core), FIELD(inside), FIELD(cycles),
                  FIELD(overruns), FIELD(allocations), FIELD(page_faults), FIELD(wake_up), FIELD(busy)});
}

SchemaStruct pluginStatistics() {
  using T = PluginStatistics;
  return make<T>({FIELD(state), FIELD(thread), FIELD(cycles), FIELD(last_busy_ns), FIELD(busy)});
}

SchemaStruct hostSegment() {
  using T = HostSegment;
  return make<T>({FIELD(header), FIELD(bell), FIELD(threads), FIELD(slots), FIELD(thread_statistics), FIELD(plugins)});
}

SchemaStruct masterData() {
  using T = MasterData;
  return make<T>({FIELD(valid_until_ns), FIELD(joints)});
}

SchemaStruct masterSegment() {
  using T = MasterSegment;
  return make<T>({FIELD(header), FIELD(sequence), FIELD(data)});
}

SchemaStruct jointEntry() {
  using T = JointEntry;
  return make<T>({FIELD(name), FIELD(id), FIELD(type), FIELD(lower), FIELD(upper), FIELD(velocity), FIELD(effort)});
}

SchemaStruct chainEntry() {
  using T = ChainEntry;
  return make<T>({FIELD(name), FIELD(joints), FIELD(joint)});
}

SchemaStruct pluginEntry() {
  using T = PluginEntry;
  return make<T>({FIELD(name), FIELD(type), FIELD(host), FIELD(thread), FIELD(state), FIELD(respawns), FIELD(io),
                  FIELD(error), FIELD(status)});
}

SchemaStruct hostEntry() {
  using T = HostEntry;
  return make<T>({FIELD(name), FIELD(pid), FIELD(respawns), FIELD(threads), FIELD(error)});
}

SchemaStruct boardData() {
  using T = BoardData;
  return make<T>({FIELD(joints), FIELD(imus), FIELD(force_torques), FIELD(hosts), FIELD(plugins), FIELD(real_time),
                  FIELD(hal_respawns), FIELD(hal_pid), FIELD(chains), FIELD(robot), FIELD(hal), FIELD(joint),
                  FIELD(imu), FIELD(force_torque), FIELD(host), FIELD(plugin), FIELD(chain)});
}

SchemaStruct boardSegment() {
  using T = BoardSegment;
  return make<T>({FIELD(header), FIELD(owners), FIELD(grants), FIELD(sequence), FIELD(data)});
}

#undef FIELD

std::vector<SchemaStruct> all() {
  return {{"Name", sizeof(Name), {{"text", "char", 0, kNameLength, 1}}},
          {"Text", sizeof(Text), {{"text", "char", 0, kTextLength, 1}}},
          header(),
          histogram(),
          jointState(),
          imuState(),
          forceTorqueState(),
          frameData(),
          stateFrame(),
          loopStatistics(),
          stateSegment(),
          jointCommand(),
          commandData(),
          commandSlot(),
          threadStatistics(),
          pluginStatistics(),
          hostSegment(),
          masterData(),
          masterSegment(),
          jointEntry(),
          chainEntry(),
          pluginEntry(),
          hostEntry(),
          boardData(),
          boardSegment()};
}

const SchemaStruct* find(std::string_view name) {
  for (const SchemaStruct& each : schema()) {
    if (each.name == name) return &each;
  }
  return nullptr;
}

template <class T>
T at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

// As Java and YAML write them, with all digits.
std::string realText(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

std::string numberText(std::string_view type, const char* bytes) {
  if (type == "u8") return std::to_string(at<std::uint8_t>(bytes));
  if (type == "u16") return std::to_string(at<std::uint16_t>(bytes));
  if (type == "u32") return std::to_string(at<std::uint32_t>(bytes));
  if (type == "u64") return std::to_string(at<std::uint64_t>(bytes));
  if (type == "i32") return std::to_string(at<std::int32_t>(bytes));
  if (type == "i64") return std::to_string(at<std::int64_t>(bytes));
  return realText(type == "f32" ? static_cast<double>(at<float>(bytes)) : at<double>(bytes));
}

void describeStruct(std::ostream& out, const std::string& prefix, const SchemaStruct& type, const char* bytes);

void describeOne(std::ostream& out, const std::string& path, const SchemaField& field, const char* bytes) {
  if (field.type == "Name" || field.type == "Text") {
    if (*bytes != '\0') out << path << ' ' << bytes << '\n';
  } else if (const SchemaStruct* const nested = find(field.type)) {
    describeStruct(out, path + '.', *nested, bytes);
  } else if (const std::string number = numberText(field.type, bytes); number != "0") {
    out << path << ' ' << number << '\n';
  }
}

void describeStruct(std::ostream& out, const std::string& prefix, const SchemaStruct& type, const char* bytes) {
  for (const SchemaField& field : type.fields) {
    for (std::size_t i = 0; i < field.count; ++i) {
      const std::string index = field.count == 1 ? "" : '[' + std::to_string(i) + ']';
      describeOne(out, prefix + field.name + index, field, bytes + field.offset + i * field.size);
    }
  }
}

}  // namespace

const std::vector<SchemaStruct>& schema() {
  static const std::vector<SchemaStruct> structs = all();
  return structs;
}

std::string schemaText() {
  std::ostringstream out;
  out << "# The layout of the shared memory (include/robotui/rt/link/layout.h), checked by the tests of every language "
         "that reads it.\n"
         "# struct NAME BYTES, then its fields: NAME TYPE OFFSET COUNT BYTES_OF_ONE; bytes that no field names are "
         "zero.\n"
      << "version " << kLayoutVersion << "\nmagic " << kMagic << "\nconstant joints " << kMaxJoints
      << "\nconstant imus " << kMaxImus << "\nconstant force_torques " << kMaxForceTorques << "\nconstant hosts "
      << kMaxHosts << "\nconstant threads " << kMaxThreads << "\nconstant plugins " << kMaxPlugins
      << "\nconstant frames " << kFrames << "\nconstant buckets " << kBuckets << "\nconstant nobody " << kNobody
      << '\n';
  for (const SchemaStruct& each : schema()) {
    out << "struct " << each.name << ' ' << each.size << '\n';
    for (const SchemaField& field : each.fields) {
      out << "  " << field.name << ' ' << field.type << ' ' << field.offset << ' ' << field.count << ' ' << field.size
          << '\n';
    }
  }
  return out.str();
}

std::string describeBytes(std::string_view type, const void* bytes) {
  std::ostringstream out;
  out << "struct " << type << '\n';
  describeStruct(out, "", *find(type), static_cast<const char*>(bytes));
  return out.str();
}

}  // namespace robotui::rt::link
