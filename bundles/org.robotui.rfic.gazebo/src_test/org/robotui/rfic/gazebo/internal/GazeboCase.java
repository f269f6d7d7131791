package org.robotui.rfic.gazebo.internal;

import java.util.HashMap;
import java.util.Map;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.config.Settings;

/** What tests of robot interfaces to simulators share. */
final class GazeboCase {
  private GazeboCase() {}

  static Settings settings(Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    GazeboSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    return new Settings(GazeboSettings.SCHEMA, values);
  }

  static Rfic rfic(RficContext context, Map<String, Object> written) {
    return new GazeboRficType().create(context, settings(written));
  }
}
