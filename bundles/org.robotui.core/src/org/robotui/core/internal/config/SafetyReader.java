package org.robotui.core.internal.config;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Problem;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.config.model.StopCall;
import org.robotui.data.MotionLimits;

/** Reads how robots are kept safe, by name of the robot. */
final class SafetyReader {
  private static final ValueType SPEED = new ValueType.Num(0, Double.POSITIVE_INFINITY, "m/s");
  private static final ValueType TURN = new ValueType.Num(0, Double.POSITIVE_INFINITY, "rad/s");
  private static final Schema STOP_CALL = Schema.of(
      Setting.required("interface", new ValueType.Text(), "id of the robot interface"),
      Setting.of("port", new ValueType.Text(), "services", "its call port"),
      Setting.required("service", new ValueType.Text(), "the robot's name of the service"));
  private static final Schema SAFETY = Schema.of(
      Setting.of("max_linear", SPEED, Double.POSITIVE_INFINITY, "no motion command is faster"),
      Setting.of("max_angular", TURN, Double.POSITIVE_INFINITY, "no motion command turns faster"),
      Setting.of("lease", new ValueType.Flag(), true, "whether commands need the lease"),
      Setting.optional("stop_call", new ValueType.Section(STOP_CALL), "what the robot is asked when it is stopped"));

  private final List<Problem> problems;

  SafetyReader(List<Problem> problems) {
    this.problems = problems;
  }

  Map<String, SafetyConfig> read(YamlValue.Section section, Collection<String> robots) {
    Map<String, SafetyConfig> read = new LinkedHashMap<>();
    Shape.onlyKeys(section, robots, "is no robot of this RUIC", problems);
    for (YamlValue.Entry entry : section.entries()) {
      Shape.section(entry.value(), "the safety of '" + entry.key() + "'", problems)
          .ifPresent(s -> read.put(entry.key(), safety(new ValueReader(problems).settings(s, SAFETY))));
    }
    return read;
  }

  private static SafetyConfig safety(Settings settings) {
    MotionLimits limits = new MotionLimits(settings.number("max_linear"), settings.number("max_angular"));
    Optional<StopCall> call =
        settings.has("stop_call") ? stopCall(settings.section("stop_call")) : Optional.empty();
    return new SafetyConfig(limits, call, settings.flag("lease"));
  }

  private static Optional<StopCall> stopCall(Settings settings) {
    if (!settings.has("interface") || !settings.has("service")) {
      return Optional.empty();
    }
    SourceId port = new SourceId(settings.text("interface"), settings.text("port"));
    return Optional.of(new StopCall(port, new ServiceRequest(settings.text("service"), Map.of())));
  }
}
