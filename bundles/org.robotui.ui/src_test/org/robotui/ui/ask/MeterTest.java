package org.robotui.ui.ask;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

class MeterTest {
  private static final long MILLI = 1_000_000;

  private final Meter meter = new Meter();

  @Test
  void oneMessageHasNoRate() {
    meter.take(0, OptionalInt.of(7));
    Measure measure = meter.measure(10);
    assertTrue(Double.isNaN(measure.hertz()));
    assertEquals(1, measure.count());
  }

  @Test
  void periodsAreMeasured() {
    for (long at : new long[]{0, 100, 220, 300}) {
      meter.take(at * MILLI, OptionalInt.of(50));
    }
    Measure measure = meter.measure(310 * MILLI);
    assertEquals(10, measure.hertz(), 1e-6);
    assertEquals(0.08, measure.shortest(), 1e-9);
    assertEquals(0.12, measure.longest(), 1e-9);
    assertEquals(Math.sqrt(0.0008 / 3), measure.jitter(), 1e-9);
    assertEquals(500, measure.bytesPerSecond().orElseThrow(), 1e-6);
  }

  @Test
  void whatEndedHasNoRate() {
    for (int i = 0; i < 100; i++) {
      meter.take(i * 10 * MILLI, OptionalInt.of(50));
    }
    assertEquals(0, meter.measure(2500 * MILLI).hertz());
    assertEquals(0, meter.measure(60_000 * MILLI).hertz());
    assertEquals(100, meter.measure(60_000 * MILLI).count());
  }

  @Test
  void unknownSizesGiveNoBandwidth() {
    meter.take(0, OptionalInt.of(50));
    meter.take(MILLI, OptionalInt.empty());
    assertTrue(meter.measure(2 * MILLI).bytesPerSecond().isEmpty());
  }

  @Test
  void fastTopicsAreMeasuredOverWhatIsKept() {
    for (int i = 0; i < 3 * Meter.CAPACITY; i++) {
      meter.take(i * MILLI, OptionalInt.of(50));
    }
    assertEquals(1000, meter.measure(3L * Meter.CAPACITY * MILLI).hertz(), 1);
  }
}
