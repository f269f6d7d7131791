package org.robotui.ros.reconfigure;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.ros.msgs.dynamic_reconfigure.BoolParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.ConfigDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.DoubleParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Group;
import org.robotui.ros.msgs.dynamic_reconfigure.GroupState;
import org.robotui.ros.msgs.dynamic_reconfigure.IntParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.ParamDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.StrParameter;

/** Between the messages and what they mean. */
final class Configs {

  static final int MAX_PARAMETERS = 10_000;

  private Configs() {}

  static ConfigValues values(Config config) {
    Map<String, ConfigValue> values = new LinkedHashMap<>();
    config.bools().forEach(each -> values.put(each.name(), new ConfigValue.Flag(each.value())));
    config.ints().forEach(each -> values.put(each.name(), new ConfigValue.Whole(each.value())));
    config.strs().forEach(each -> values.put(each.name(), new ConfigValue.Text(each.value())));
    config.doubles().forEach(each -> values.put(each.name(), new ConfigValue.Real(each.value())));
    Map<Integer, Boolean> groups = new HashMap<>();
    config.groups().forEach(each -> groups.put(each.id(), each.state()));
    return new ConfigValues(values, groups);
  }

  static Config message(Map<String, ConfigValue> values) {
    List<BoolParameter> flags = new ArrayList<>();
    List<IntParameter> wholes = new ArrayList<>();
    List<StrParameter> texts = new ArrayList<>();
    List<DoubleParameter> reals = new ArrayList<>();
    values.forEach((name, value) -> {
      switch (value) {
        case ConfigValue.Flag flag -> flags.add(new BoolParameter(name, flag.value()));
        case ConfigValue.Whole whole -> wholes.add(new IntParameter(name, whole.value()));
        case ConfigValue.Text text -> texts.add(new StrParameter(name, text.value()));
        case ConfigValue.Real real -> reals.add(new DoubleParameter(name, real.value()));
      }
    });
    return new Config(flags, wholes, texts, reals, List.<GroupState>of());
  }

  /** The description; empty if there are more parameters than anybody can mean. */
  static Optional<ServerDescription> description(ConfigDescription message) {
    long count = message.groups().stream().mapToLong(group -> 1 + group.parameters().size()).sum();
    if (count > MAX_PARAMETERS) {
      return Optional.empty();
    }
    Limits limits =
        new Limits(values(message.min()).values(), values(message.max()).values(), values(message.dflt()).values());
    return Optional.of(new ServerDescription(message.groups().stream().map(group -> group(group, limits)).toList()));
  }

  private static ConfigGroup group(Group group, Limits limits) {
    List<ConfigParameter> parameters =
        group.parameters().stream().flatMap(each -> parameter(each, limits).stream()).toList();
    return new ConfigGroup(group.name(), group.type(), group.id(), group.parent(), parameters);
  }

  /** A parameter; empty if it has a type that is not known. */
  private static Optional<ConfigParameter> parameter(ParamDescription each, Limits limits) {
    return ConfigKind.of(each.type()).map(kind -> {
      EditMethod method = EditMethod.read(each.editMethod(), kind);
      return new ConfigParameter(each.name(), kind, each.description(), each.level(), limits.lowest(each.name(), kind),
          limits.highest(each.name(), kind), limits.initial(each.name(), kind), method.choices(), method.description());
    });
  }

  /** What a description says beside the parameters. Numbers that mean "no limit" are none. */
  private record Limits(Map<String, ConfigValue> min, Map<String, ConfigValue> max, Map<String, ConfigValue> dflt) {

    Optional<ConfigValue> lowest(String name, ConfigKind kind) {
      return typed(min, name, kind).filter(value -> switch (value) {
        case ConfigValue.Whole whole -> whole.value() > Integer.MIN_VALUE;
        case ConfigValue.Real real -> Double.isFinite(real.value()) && real.value() > -Double.MAX_VALUE;
        default -> false;
      });
    }

    Optional<ConfigValue> highest(String name, ConfigKind kind) {
      return typed(max, name, kind).filter(value -> switch (value) {
        case ConfigValue.Whole whole -> whole.value() < Integer.MAX_VALUE;
        case ConfigValue.Real real -> Double.isFinite(real.value()) && real.value() < Double.MAX_VALUE;
        default -> false;
      });
    }

    Optional<ConfigValue> initial(String name, ConfigKind kind) {
      return typed(dflt, name, kind);
    }

    private static Optional<ConfigValue> typed(Map<String, ConfigValue> values, String name, ConfigKind kind) {
      return Optional.ofNullable(values.get(name)).flatMap(value -> ConfigValue.of(kind, value.toJava()));
    }
  }
}
