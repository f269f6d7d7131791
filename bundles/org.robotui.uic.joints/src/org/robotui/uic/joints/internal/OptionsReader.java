package org.robotui.uic.joints.internal;

import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.api.config.Settings;
import org.robotui.uic.joints.internal.model.JointOptions;
import org.robotui.uic.joints.internal.model.JointUnit;
import org.robotui.uic.joints.internal.model.Span;

/** Reads what is configured. */
final class OptionsReader {
  private OptionsReader() {}

  static JointOptions read(Settings settings) {
    Map<String, JointUnit> units = new LinkedHashMap<>();
    settings.map(JointsType.UNITS).forEach((joint, unit) -> units.put(joint.toString(), JointUnit.of(unit.toString())));
    Map<String, Span> limits = new LinkedHashMap<>();
    settings.map(JointsType.LIMITS).forEach((joint, span) -> limits.put(joint.toString(), span((Settings) span)));
    return new JointOptions(settings.flag(JointsType.DEGREES), units, limits);
  }

  /** Limits written the wrong way round are meant all the same. */
  private static Span span(Settings written) {
    double one = written.number(JointsType.MIN);
    double other = written.number(JointsType.MAX);
    return new Span(Math.min(one, other), Math.max(one, other), true);
  }
}
