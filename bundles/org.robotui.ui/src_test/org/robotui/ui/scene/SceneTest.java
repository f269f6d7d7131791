package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class SceneTest {
  private static final class Spot implements Entity {
    private final Bounds bounds;
    private int disposed;

    Spot(double x, double y) {
      bounds = Bounds.around(x, y, 1);
    }

    @Override
    public void paint(Painter painter) {
      throw new AssertionError("nothing is painted here");
    }

    @Override
    public Optional<Bounds> bounds() {
      return Optional.of(bounds);
    }

    @Override
    public Optional<Description> describeAt(double x, double y, double tolerance) {
      return bounds.contains(x, y) ? Optional.of(new Description("spot", 0)) : Optional.empty();
    }

    @Override
    public void dispose() {
      disposed++;
    }
  }

  private final Scene scene = new Scene();
  private final Spot low = new Spot(0, 0);
  private final Spot high = new Spot(1, 0);

  @Test
  void layersLieInTheirOrderWhateverComesFirst() {
    fill();
    assertEquals(List.of("low", "high"), scene.layers().stream().map(Layer::id).toList());
  }

  @Test
  void theTopmostIsFoundFirst() {
    fill();
    assertEquals(List.of("high", "low"), scene.at(0.5, 0, 0.1).stream().map(h -> h.layer().id()).toList());
  }

  @Test
  void hiddenLayersCountForNothing() {
    fill();
    scene.find("high").orElseThrow().show(false);
    assertEquals(Optional.of(new Bounds(-1, -1, 1, 1)), scene.bounds());
    assertEquals(1, scene.at(0.5, 0, 0.1).size());
  }

  @Test
  void whatIsRemovedIsReleasedOnTheDisplayThreadOnce() {
    fill();
    scene.remove("low");
    scene.remove("low");
    assertEquals(0, low.disposed);
    scene.dispose();
    assertEquals(1, low.disposed);
    assertEquals(1, high.disposed);
  }

  @Test
  void anIdIsTakenOnlyOnce() {
    fill();
    assertThrows(IllegalArgumentException.class, () -> scene.add(new Layer("low", 0, "", low)));
    assertTrue(scene.find("nothing").isEmpty());
  }

  private void fill() {
    scene.add(new Layer("high", 5, "High", high));
    scene.add(new Layer("low", 1, "Low", low));
  }
}
