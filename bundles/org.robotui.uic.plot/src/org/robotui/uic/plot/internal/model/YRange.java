package org.robotui.uic.plot.internal.model;

import java.util.List;

/** Which values a scale shows. */
public sealed interface YRange {
  String AUTO = "auto";
  String HOLD = "hold";

  /** As a setting holds it. */
  Object toSetting();

  /** Reads what a setting holds; checked by its type already, but for the order of the limits. */
  static YRange ofSetting(Object value) {
    if (value instanceof List<?> limits && limits.size() == 2) {
      double low = ((Number) limits.get(0)).doubleValue();
      double high = ((Number) limits.get(1)).doubleValue();
      return low < high && Double.isFinite(high - low) ? new Fixed(low, high) : new Auto();
    }
    return HOLD.equals(value) ? new Hold() : new Auto();
  }

  /** What is seen, with some room. */
  record Auto() implements YRange {
    @Override
    public Object toSetting() {
      return AUTO;
    }
  }

  /** As auto, but never less than before. */
  record Hold() implements YRange {
    @Override
    public Object toSetting() {
      return HOLD;
    }
  }

  /** Always the same. */
  record Fixed(double low, double high) implements YRange {
    @Override
    public Object toSetting() {
      return List.of(low, high);
    }
  }
}
