package org.robotui.uic.body.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.status.BodyState;
import org.robotui.data.status.Diagnostics;

/** Bodies for tests and for the gallery. */
public final class Bodies {
  private Bodies() {}

  /** A boat whose compass points somewhere, and whose motor may have failed. */
  public static BodyState boat(double heading, boolean failed) {
    return new BodyState(List.of(
        part("compass", Diagnostics.Level.OK, "running", "",
            saying("heading", 0.05, "heading", heading, "rate", -0.25)),
        part("gps", Diagnostics.Level.OK, "running", "",
            saying("position", 0.12, "latitude", 43.660123, "longitude", 10.2401)),
        part("motor", failed ? Diagnostics.Level.ERROR : Diagnostics.Level.OK, failed ? "failed" : "running",
            failed ? "IllegalStateException: no fuel" : "", saying("power", failed ? 7.5 : 0.1, "throttle", 0.6)),
        part("wind", Diagnostics.Level.STALE, "silent", "no beacon of it comes any more",
            saying("wind", 12.0, "speed", 5.5, "angle", 44))));
  }

  private static BodyState.Part part(String name, Diagnostics.Level level, String state, String reason,
      BodyState.Saying says) {
    return new BodyState.Part(name, level, state, reason, 0.2, state.equals("failed") ? 3 : 0, 1000, 4,
        List.of(says));
  }

  private static BodyState.Saying saying(String name, double age, Object... fields) {
    Map<String, FieldValue> all = new LinkedHashMap<>();
    for (int i = 0; i < fields.length; i += 2) {
      double value = ((Number) fields[i + 1]).doubleValue();
      all.put((String) fields[i], new FieldValue.Num(value, Double.toString(value)));
    }
    return new BodyState.Saying(name, age, new MapRecord(name, all));
  }
}
