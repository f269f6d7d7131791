package org.robotui.rfic.foxglove.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.config.Settings;

/** What tests of robot interfaces to servers share. */
final class FoxgloveCase {
  private static final long PATIENCE_NANOS = 60_000_000_000L;

  private FoxgloveCase() {}

  static Rfic rfic(RficContext context, Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    FoxgloveSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    return new FoxgloveRficType().create(context, new Settings(FoxgloveSettings.SCHEMA, values));
  }

  static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }
}
