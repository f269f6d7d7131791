package org.robotui.uic.map.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.display.DisplayRow;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Painter;
import org.robotui.uic.map.internal.LayerKinds;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.MapPorts;

/** A type of data that neither core nor the map knows, and a layer for it that comes and goes while the map runs. */
class UnknownTypeTest {
  private static final SourceId SPILL = new SourceId("base", "spill");
  private final FakeUicContext context = new FakeUicContext("map", MapOptions.schema());
  private final List<LayerType> kinds = new ArrayList<>(LayerKinds.ALL);
  private final MapModel model;
  private long now = System.nanoTime();

  UnknownTypeTest() {
    context.frames(new FakeFrames());
    model = new MapModel(context, () -> List.copyOf(kinds));
    context.input(MapPorts.DATA).candidates(List.of(new Input.Candidate(SPILL, "Spill")));
  }

  /** Oil on the floor. */
  public record Spill(FrameId frame, double x, double y) implements Data, Framed {
    @Override
    public Stream<FrameId> frames() {
      return Stream.of(frame);
    }
  }

  private static final class SpillLayer implements DataLayer {
    private final boolean fails;
    private Optional<Spill> seen = Optional.empty();

    SpillLayer(boolean fails) {
      this.fails = fails;
    }

    @Override
    public LayerResult update(LayerTick tick) {
      if (fails) {
        throw new IllegalStateException("no oil");
      }
      seen = tick.newest(Spill.class).map(e -> e.value()).or(() -> seen);
      return new LayerResult(true,
          seen.<LayerStatus>map(s -> new LayerStatus.Shown("oil")).orElse(new LayerStatus.NoData("none")));
    }

    @Override
    public void paint(Painter painter) {
      seen.ifPresent(s -> painter.disc(s.x(), s.y(), 5));
    }

    @Override
    public Optional<Bounds> bounds() {
      return seen.map(s -> Bounds.around(s.x(), s.y(), 1));
    }

    @Override
    public Optional<Description> describeAt(double x, double y, double tolerance) {
      return Optional.empty();
    }
  }

  private record SpillType(boolean fails) implements LayerType {
    @Override
    public String id() {
      return "spill";
    }

    @Override
    public String label() {
      return "Spill";
    }

    @Override
    public String help() {
      return "Shows oil on the floor.";
    }

    @Override
    public List<Class<? extends Data>> accepts() {
      return List.of(Spill.class);
    }

    @Override
    public int level() {
      return 150;
    }

    @Override
    public Schema schema() {
      return Schema.of();
    }

    @Override
    public DataLayer create(LayerContext context) {
      return new SpillLayer(fails);
    }
  }

  @Test
  void withoutALayerForItARobotIsNotAskedForIt() {
    tick();
    assertEquals(Set.of(), context.input(MapPorts.DATA).chosen());
  }

  @Test
  void aLayerThatComesIsShownAndOneThatGoesIsNot() {
    tick();
    SpillType type = new SpillType(false);
    kinds.add(type);
    tick();
    assertEquals(Set.of(SPILL), context.input(MapPorts.DATA).chosen());
    context.input(MapPorts.DATA).put(SPILL, new Spill(new FrameId("Keira", "yard"), 3, 4), now, Optional.empty());
    tick();
    assertTrue(model.scene().find("spill:base.spill").orElseThrow().visible());
    assertEquals("oil", row("spill:base.spill").words());
    assertEquals(Optional.of(new FrameId("Keira", "yard")), model.snapshot().fixed(), "its frame can be shown");
    kinds.remove(type);
    tick();
    assertTrue(model.scene().find("spill:base.spill").isEmpty());
    assertEquals(Set.of(), context.input(MapPorts.DATA).chosen());
  }

  @Test
  void aListedLayerWaitsForItsBundle() {
    context.settings().set("layers", List.of(Map.of("type", "spill")));
    tick();
    DisplayRow row = row("spill");
    assertEquals(Health.WAITING, row.health());
    assertEquals("waits for a bundle that brings layers of type 'spill'", row.words());
  }

  @Test
  void aLayerThatThrowsIsSwitchedOffAndTheOthersGoOn() {
    kinds.add(new SpillType(true));
    tick();
    tick();
    assertEquals(Health.BAD, row("spill:base.spill").health());
    assertTrue(row("spill:base.spill").words().contains("no oil"), row("spill:base.spill").words());
    assertFalse(model.scene().find("spill:base.spill").orElseThrow().visible());
    assertEquals(Health.OK, row("grid").health());
  }

  private DisplayRow row(String id) {
    return model.layers().rows().stream().filter(r -> r.spec().id().equals(id)).findFirst().orElseThrow();
  }

  private void tick() {
    now += 33_000_000;
    model.tick(now, MapOptions.of(context.settings().current()));
  }
}
