package org.robotui.entity.wrench.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.Wrench;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Rgba;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;

class WrenchDisplayTest implements Places {
  private static final FrameId SENSOR = new FrameId("Keira", "wrist");

  private final Map<String, Object> values = new HashMap<>();
  private final WrenchDisplay display = new WrenchDisplay();
  private boolean linked = true;

  WrenchDisplayTest() {
    WrenchType.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
  }

  private DisplayResult update(Data... arrived) {
    List<Envelope<? extends Data>> envelopes = Arrays.stream(arrived).<Envelope<? extends Data>>map(
        v -> new Envelope<>(v, new SourceId("base", "wrench"), 1, Optional.empty(), 0, Optional.empty())).toList();
    return display.update(new DisplayTick(envelopes, new InputState.Live(10, 0), this,
        new Settings(WrenchType.SCHEMA, values), Rgba.WHITE, 0, false));
  }

  private static Wrench wrench(Vector3 force, Vector3 torque) {
    return new Wrench(SENSOR, force, torque);
  }

  @Test
  void arrowsPointAlongForceAndTorqueAndAreAsLongAsTheyAreStrong() {
    DisplayResult result = update(wrench(new Vector3(0, 0, -50), new Vector3(0, 2, 0)));
    assertEquals(List.of("force", "torque", "ring"),
        result.parts().stream().map(part -> part.key().toString()).toList());
    assertEquals(new DisplayStatus.Shown("50.00 N, 2.00 Nm"), result.status());
    Wrench down = wrench(new Vector3(0, 0, -50), Vector3.ZERO);
    Vector3 tip =
        Arrow.of(down.force(), 0.02, 3).turn().apply(new Vector3(Arrow.of(down.force(), 0.02, 3).length(), 0, 0));
    assertEquals(-1, tip.z(), 1e-9);
    assertEquals(0, tip.x(), 1e-9);
    Box3 ring = result.parts().getLast().shape().bounds().orElseThrow();
    assertEquals(0.12, ring.center().y(), 1e-3);
  }

  @Test
  void nothingIsDrawnWithoutForceAndTheSameShapeWithoutNews() {
    assertEquals(List.of(), update(wrench(Vector3.ZERO, Vector3.ZERO)).parts());
    DisplayResult first = update(wrench(new Vector3(1, 2, 3), Vector3.ZERO));
    assertSame(first.parts().getFirst().shape(), update().parts().getFirst().shape());
  }

  @Test
  void whatIsTooLongIsCutAndSaid() {
    DisplayResult result = update(wrench(new Vector3(900, 0, 0), Vector3.ZERO));
    assertTrue(
        assertInstanceOf(DisplayStatus.Partly.class, result.status()).words().contains("the force would be longer"));
    assertTrue(result.parts().getFirst().bounds().orElseThrow().high().x() < 7);
  }

  @Test
  void whatIsNoNumberAndWhatIsNotLinkedIsSaid() {
    assertInstanceOf(DisplayStatus.NoData.class, update().status());
    DisplayResult broken = update(wrench(new Vector3(Double.NaN, 0, 0), Vector3.ZERO));
    assertInstanceOf(DisplayStatus.Unfit.class, broken.status());
    assertEquals(List.of(), broken.parts());
    linked = false;
    DisplayResult apart = update(wrench(new Vector3(1, 0, 0), Vector3.ZERO));
    assertInstanceOf(DisplayStatus.NoFrame.class, apart.status());
    assertEquals(List.of(), apart.parts());
  }

  @Test
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void looksAsItDid() {
    try (ScenePictures pictures = new ScenePictures()) {
      pictures.assertLike(WrenchDisplayTest.class, "wrench", ScenePictures.request(
          update(wrench(new Vector3(20, 10, 30), new Vector3(0, -8, 3))).parts(),
          ScenePictures.eye(new Vector3(1.2, -1.6, 1), new Vector3(0.1, -0.2, 0.25))));
    }
  }

  @Override
  public FrameId fixed() {
    return new FrameId("Keira", "map");
  }

  @Override
  public Place at(FrameId frame, Optional<Stamp> stamp) {
    return linked ? new Place.At(RigidTransform.IDENTITY) : new Place.Missing("no transform links wrist and map");
  }

  @Override
  public List<FrameId> all() {
    return List.of(SENSOR);
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return Optional.empty();
  }
}
