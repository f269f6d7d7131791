package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.robotui.testkit.FakeSettings;

class PlotCodecTest {
  private final FakeSettings settings = new FakeSettings(PlotOptions.schema());

  @Test
  void withoutSettingsThereIsNothingYet() {
    PlotSpec spec = PlotCodec.read(settings.current());
    assertTrue(spec.isEmpty());
    assertEquals(60, spec.window());
    assertTrue(spec.byStamp() && spec.linked());
  }

  @Test
  void whatIsWrittenIsReadAgain() {
    TraceSpec full = new TraceSpec("derivative(a.b:c)", Optional.of("jerk"), Optional.of("m/s"), OptionalInt.of(3),
        Optional.of(LineStyle.STEP), true, true);
    List<AxisSpec> axes = List.of(
        new AxisSpec(List.of(TraceSpec.of("a.b:c"), full), new YRange.Fixed(-1.5, 2), new YRange.Hold()),
        new AxisSpec(List.of(TraceSpec.of("a.b:y")), new YRange.Auto(), new YRange.Auto(), Optional.of("a.b:x"),
            new YRange.Fixed(-1, 1)),
        AxisSpec.EMPTY);
    settings.set(PlotOptions.AXES, PlotCodec.write(axes));
    assertEquals(axes, PlotCodec.read(settings.current()).axes());
  }

  @Test
  void whatIsAsUsualIsNotWritten() {
    assertEquals(List.of(Map.of("traces", List.of("a.b:c"))),
        PlotCodec.write(List.of(AxisSpec.EMPTY.with(List.of(TraceSpec.of("a.b:c"))))));
  }

  @Test
  void sourcePathAndFunctionsMakeASignal() {
    assertEquals("base./odom:linear.x", signal(Map.of("source", "base./odom", "path", "linear.x")));
    assertEquals("derivative(base./odom:x)",
        signal(Map.of("source", "base./odom", "path", "x", "derive", "derivative")));
    assertEquals("scale(average(base./odom:x, 0.5), 2, 1)",
        signal(Map.of("source", "base./odom", "path", "x", "derive", List.of("average(0.5)", "scale(2, 1)"))));
  }

  @Test
  void aRangeTheWrongWayRoundIsAutomatic() {
    settings.set(PlotOptions.AXES, List.of(Map.of("range", List.of(2L, 1L))));
    assertEquals(new YRange.Auto(), PlotCodec.read(settings.current()).axes().getFirst().left());
  }

  @Test
  void newTracesGetColoursThatAreFree() {
    PlotSpec spec = PlotCodec.read(settings.current()).plus(0, TraceSpec.of("a.b:x")).plus(0, TraceSpec.of("a.b:y"))
        .plus(0, TraceSpec.of("a.b:z")).without(new TraceRef(0, 1)).plus(0, TraceSpec.of("a.b:w"));
    assertEquals(List.of(0, 2, 1),
        List.of(spec.axes().getFirst().colour(0), spec.axes().getFirst().colour(1), spec.axes().getFirst().colour(2)));
  }

  @Test
  void aSignalIsOnAnAxisOnlyOnce() {
    PlotSpec spec = PlotCodec.read(settings.current()).plus(0, TraceSpec.of("a.b:x")).plus(0, TraceSpec.of("a.b:x"));
    assertEquals(1, spec.axes().getFirst().traces().size());
    assertEquals(2, spec.plus(1, TraceSpec.of("a.b:x")).axes().size());
  }

  @Test
  void anAxisGoesWithItsLastTrace() {
    PlotSpec spec = PlotCodec.read(settings.current()).plus(0, TraceSpec.of("a.b:x")).plus(1, TraceSpec.of("a.b:y"));
    assertEquals(1, spec.without(new TraceRef(0, 0)).axes().size());
    assertEquals(List.of("a.b:y", "a.b:x"), spec.moved(new TraceRef(0, 0), 1).signals().toList());
    assertEquals(1, spec.moved(new TraceRef(0, 0), 1).axes().size());
    assertEquals(2, spec.moved(new TraceRef(0, 0), 2).axes().size());
    assertEquals(spec, spec.without(new TraceRef(7, 0)));
  }

  @Test
  void partsThatMakeNoSignalOrRangeTogetherAreFaults() {
    assertEquals(List.of(), PlotCodec.faults(settings.current()));
    settings.set(PlotOptions.AXES, List.of(
        Map.of("traces", List.of("a.b:c", Map.of("source", "a.b")), "range", List.of(3.0, 1.0), "range_right",
            List.of(1.0, 2.0)),
        Map.of("range", List.of(1.0))));
    List<String> faults = PlotCodec.faults(settings.current());
    assertEquals(3, faults.size(), faults.toString());
    assertTrue(faults.getFirst().startsWith("'a.b:' is no signal; write SOURCE:PATH"), faults.getFirst());
    assertEquals(List.of("'range' must be [low, high], the lower number first, not [3.0, 1.0]",
        "'range' must be [low, high], the lower number first, not [1.0]"), faults.subList(1, 3));
  }

  @Test
  void namesMeanWhatStandsBeforeThem() {
    settings.set(PlotOptions.SIGNALS, List.of(Map.of("name", "speed", "signal", "base./odom:linear.x", "unit", "m/s"),
        Map.of("name", "fast", "signal", "speed * 3.6")));
    settings.set(PlotOptions.AXES,
        List.of(Map.of("x", "speed", "traces", List.of("derivative(fast)", "fast - speed"))));
    assertEquals(List.of(), PlotCodec.faults(settings.current()));
    PlotSpec spec = PlotCodec.read(settings.current());
    assertEquals(settings.current().list(PlotOptions.SIGNALS).size(), PlotCodec.writeNames(spec.names()).size());
    settings.set(PlotOptions.SIGNALS, List.of(Map.of("name", "fast", "signal", "speed * 3.6"),
        Map.of("name", "speed", "signal", "fast"), Map.of("name", "fast", "signal", "a.b:c")));
    List<String> faults = PlotCodec.faults(settings.current());
    assertEquals("'fast': 'speed' is no signal; write SOURCE:PATH, for example base./odom:linear.x, or a function of it"
        + " (column 1)", faults.getFirst());
    assertTrue(faults.stream().anyMatch(f -> f.startsWith("the name 'fast' is given twice")), faults.toString());
    assertTrue(faults.stream().anyMatch(f -> f.startsWith("x: 'speed' is no signal")), faults.toString());
  }

  private String signal(Map<String, Object> trace) {
    settings.set(PlotOptions.AXES, List.of(Map.of("traces", List.of(trace))));
    return PlotCodec.read(settings.current()).axes().getFirst().traces().getFirst().signal();
  }
}
