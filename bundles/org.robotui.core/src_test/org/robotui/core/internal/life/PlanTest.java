package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.Descriptor;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Layout;
import org.robotui.core.internal.config.SchemaCheck;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;

class PlanTest {
  private final SchemaCheck check = new SchemaCheck();
  private final Registry registry = new Registry();

  /** A type with a map and a camera. */
  private record Base() implements RuicType {
    @Override
    public List<UicSpec> uics(Settings settings) {
      return List.of(new UicSpec("map", "map"), new UicSpec("camera", "camera"));
    }

    @Override
    public Layout layout(Settings settings) {
      return new Layout.Tabs(List.of("map", "camera"));
    }

    @Override
    public Descriptor descriptor() {
      return new Descriptor("base", "Base", "", Schema.EMPTY, List.of());
    }
  }

  private RuicConfig config(String type, Optional<Layout> layout, ComponentConfig... uics) {
    return new RuicConfig("r", "f.yaml", 1, 1, type, check.nothing(), List.of(), List.of(), List.of(uics), List.of(),
        layout,
        Map.of(), Map.of(), List.of(), false);
  }

  private ComponentConfig uic(String id, String type) {
    return new ComponentConfig(id, type, "", "", check.nothing(), "f.yaml", 5, 3);
  }

  private Plan plan(RuicConfig config) {
    return assertInstanceOf(Plan.Outcome.Made.class, Plan.of(config, registry, check)).plan();
  }

  @Test
  void viewsOfTheTypeAreConfiguredReplacedAndJoined() {
    registry.add(new Base(), "org.robotui.ruic.base");
    Plan plan = plan(config("base", Optional.empty(), uic("map", ""), uic("camera", "stereo"), uic("log", "text"),
        uic("status", "")));
    assertEquals(List.of("map", "stereo", "text", "status"), plan.uics().stream().map(ComponentConfig::type).toList());
    assertEquals(5, plan.uics().getFirst().line(), "settings are those of the file");
    assertEquals(new Layout.Tabs(List.of("map", "camera")), plan.layout());
  }

  @Test
  void writtenLayoutReplacesThatOfTheType() {
    registry.add(new Base(), "org.robotui.ruic.base");
    Layout own = new Layout.View("map");
    assertEquals(own, plan(config("base", Optional.of(own))).layout());
  }

  @Test
  void withoutTypeTheFileNamesAll() {
    assertEquals(new Layout.Tabs(List.of("log")), plan(config("", Optional.empty(), uic("log", "text"))).layout());
  }

  @Test
  void missingTypeIsTheReason() {
    assertEquals(new Plan.Outcome.Impossible("type 'base' is not installed; none is"),
        Plan.of(config("base", Optional.empty()), registry, check));
  }

  @Test
  void ruicWhoseTypeVanishesFailsAndRecovers(@TempDir Path folder) {
    try (CoreBench bench = new CoreBench(folder)) {
      Base base = new Base();
      FakeView map = new FakeView("map");
      bench.registry.add(new FakeRobot("fake"), "org.robotui.rfic.fake");
      bench.registry.add(map, "org.robotui.uic.map");
      bench.registry.add(new FakeView("camera"), "org.robotui.uic.camera");
      bench.registry.add(base, "org.robotui.ruic.base");
      bench.load("ruics:\n  r:\n    type: base\n    rfics:\n      b: {type: fake}\n");
      assertEquals(RuicState.INITIALIZED, bench.ruic().snapshot().state());
      bench.registry.remove(base);
      Await.until("it fails", () -> bench.ruic().snapshot().state() == RuicState.FAILED);
      assertTrue(bench.ruic().snapshot().reason().contains("bundle org.robotui.ruic.base"));
      assertEquals(1, map.closed.get());
      bench.registry.add(base, "org.robotui.ruic.base");
      Await.until("it runs", () -> bench.ruic().snapshot().state() == RuicState.INITIALIZED);
      assertEquals(2, map.contexts.size());
    }
  }
}
