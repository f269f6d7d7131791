package org.robotui.core.internal.config;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.RficType;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Settings;
import org.robotui.api.host.Problem;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Port;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.FixedWords;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.config.model.StopCall;
import org.robotui.core.internal.config.model.TypeLookup;
import org.robotui.data.command.MotionLimits;

/** Reads how robots are kept safe, by name of the robot. */
final class SafetyReader {
  private static final String INTERFACE = "interface";

  private final TypeLookup types;
  private final List<Problem> problems;

  SafetyReader(TypeLookup types, List<Problem> problems) {
    this.types = types;
    this.problems = problems;
  }

  Map<String, SafetyConfig> read(YamlValue.Section section, List<ComponentConfig> rfics) {
    Map<String, SafetyConfig> read = new LinkedHashMap<>();
    Shape.onlyKeys(section, rfics.stream().map(ComponentConfig::robot).distinct().toList(), "is no robot of this RUIC",
        problems);
    for (YamlValue.Entry entry : section.entries()) {
      Shape.section(entry.value(), "the safety of '" + entry.key() + "'", problems)
          .ifPresent(s -> read.put(entry.key(),
              safety(entry, new ValueReader(problems).settings(s, FixedWords.SAFETY), rfics)));
    }
    return read;
  }

  private SafetyConfig safety(YamlValue.Entry robot, Settings settings, List<ComponentConfig> rfics) {
    MotionLimits limits = new MotionLimits(limit(settings, "max_linear", MotionLimits.NONE.linear()),
        limit(settings, "max_angular", MotionLimits.NONE.angular()));
    Optional<StopCall> call =
        settings.has("stop_call") ? stopCall(robot, settings.section("stop_call"), rfics) : Optional.empty();
    return new SafetyConfig(limits, call, settings.flag("lease"));
  }

  private static double limit(Settings settings, String name, double none) {
    return settings.has(name) ? settings.number(name) : none;
  }

  private Optional<StopCall> stopCall(YamlValue.Entry entry, Settings settings, List<ComponentConfig> rfics) {
    if (!settings.has(INTERFACE) || !settings.has("service")) {
      return Optional.empty();
    }
    String robot = entry.key();
    Placed written = settings.placed(INTERFACE);
    Place at = Place.of(written, entry.place().robot());
    String id = written.value().toString();
    List<ComponentConfig> own = rfics.stream().filter(c -> c.robot().equals(robot)).toList();
    Optional<ComponentConfig> callee = own.stream().filter(c -> c.id().equals(id)).findFirst();
    if (callee.isEmpty()) {
      List<String> ids = own.stream().map(ComponentConfig::id).toList();
      boolean foreign = rfics.stream().anyMatch(c -> c.id().equals(id));
      problems.add(at.error((foreign ? "the robot interface '" + id + "' does not speak to '" + robot + "'"
          : "there is no robot interface '" + id + "'") + ", so the stop of '" + robot + "' would not call it"
          + NearestWord.hint(id, ids)));
      return Optional.empty();
    }
    Placed port = settings.placed("port");
    types.rfic(callee.get().type()).ifPresent(type -> hasPort(type, port, at));
    return Optional.of(new StopCall(new SourceId(id, port.value().toString()),
        new ServiceRequest(settings.text("service"), Map.of())));
  }

  /** A type that has ports for services has no others; one that has none may still offer some while it runs. */
  private void hasPort(RficType type, Placed port, Place at) {
    List<String> known = type.ports().stream().filter(SafetyReader::takesServices).map(Port::name).toList();
    Place place = port.file().isEmpty() ? at : Place.of(port, at.robot());
    String name = port.value().toString();
    if (known.isEmpty()) {
      problems.add(place.warning(
          "no robot interface of the type '" + type.id() + "' is known to call services: unless it offers the port '"
              + name + "' while it runs, the stop does not reach the robot this way"));
    } else if (!known.contains(name)) {
      problems.add(place.error("robot interfaces of the type '" + type.id() + "' have no port '" + name
          + "' that calls services, so the stop would not reach the robot" + NearestWord.hint(name, known)));
    }
  }

  private static boolean takesServices(Port port) {
    return port instanceof CallPort<?, ?> call && call.request() == ServiceRequest.class;
  }
}
