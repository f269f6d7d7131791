package org.robotui.entity.tf.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.config.Settings;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;

class TfDisplayTest implements Places {
  private final Map<String, RigidTransform> frames = new LinkedHashMap<>();
  private final Map<String, String> carriers = new HashMap<>();
  private final Map<String, Object> values = new HashMap<>();
  private final TfDisplay display = new TfDisplay();

  TfDisplayTest() {
    TfType.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    frames.put("map", RigidTransform.IDENTITY);
    put("map", "base_link", RigidTransform.planar(1, 0.5, 0.4));
    put("base_link", "laser", RigidTransform.planar(1.5, 0.7, 0.4));
  }

  private void put(String parent, String child, RigidTransform at) {
    frames.put(child, at);
    carriers.put(child, parent);
  }

  private static FrameId id(String name) {
    return new FrameId("Keira", name);
  }

  private DisplayResult update() {
    return display.update(new DisplayTick(List.of(), new InputState.Live(0, 0), this,
        new Settings(TfType.SCHEMA, values), Rgba.WHITE, 0, false));
  }

  private static Part part(DisplayResult result, Object key) {
    return result.parts().stream().filter(p -> p.key().equals(key)).findFirst().orElseThrow();
  }

  @Test
  void everyFrameHasAxesANameAndALineToItsCarrier() {
    DisplayResult result = update();
    assertEquals(new DisplayStatus.Shown("3 frames"), result.status());
    assertEquals(3, part(result, "axes").shape().elements());
    assertEquals(2, part(result, "links").shape().elements());
    assertEquals(5, result.parts().size());
    Properties words = part(result, "axes").describer().describe(2, Vector3.ZERO);
    assertEquals("laser", words.title());
    assertTrue(words.entries().contains(new Properties.Entry("parent", "base_link")));
    assertEquals("base_link", part(result, id("base_link")).describer().describe(0, Vector3.ZERO).title());
  }

  @Test
  void whatDoesNotMoveIsTheSameShape() {
    DisplayResult first = update();
    DisplayResult second = update();
    assertSame(part(first, "axes").shape(), part(second, "axes").shape());
    assertSame(part(first, id("map")).shape(), part(second, id("map")).shape());
    put("base_link", "laser", RigidTransform.planar(2, 0, 0));
    DisplayResult third = update();
    assertNotSame(part(first, "axes").shape(), part(third, "axes").shape());
    assertSame(part(first, id("laser")).shape(), part(third, id("laser")).shape(), "a name only moves");
  }

  @Test
  void framesAreChosenByName() {
    values.put(TfType.FRAMES, List.of("Keira:base*", "laser"));
    assertEquals(new DisplayStatus.Shown("2 frames of 3"), update().status());
    values.put(TfType.HIDDEN, List.of("laser"));
    assertEquals(1, part(update(), "axes").shape().elements());
    values.put(TfType.FRAMES, List.of("none"));
    assertInstanceOf(DisplayStatus.NoData.class, update().status());
  }

  @Test
  void whatIsNotLinkedIsNamed() {
    frames.put("far", new RigidTransform(new Vector3(Double.NaN, 0, 0), RigidTransform.IDENTITY.rotation()));
    DisplayResult result = update();
    assertTrue(assertInstanceOf(DisplayStatus.Partly.class, result.status()).words().contains("between far and map"));
    values.put(TfType.FRAMES, List.of("far"));
    assertInstanceOf(DisplayStatus.NoFrame.class, update().status());
    frames.clear();
    assertInstanceOf(DisplayStatus.NoData.class, update().status());
  }

  @Test
  void thousandsAreBounded() {
    for (int i = 0; i < 3000; i++) {
      put("map", "f" + i, RigidTransform.planar(i, 0, 0));
    }
    DisplayResult result = update();
    assertEquals(TfDisplay.MOST, part(result, "axes").shape().elements());
    assertTrue(result.parts().size() <= 2 + TfDisplay.MOST_NAMES);
    assertInstanceOf(DisplayStatus.Partly.class, result.status());
  }

  @Test
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void looksAsItDid() {
    values.put(TfType.SIZE, 0.4);
    try (ScenePictures pictures = new ScenePictures()) {
      pictures.assertLike(TfDisplayTest.class, "frames", ScenePictures.request(update().parts(),
          ScenePictures.eye(new Vector3(-0.6, -1.2, 1.4), new Vector3(0.8, 0.4, 0))));
    }
  }

  @Override
  public FrameId fixed() {
    return id("map");
  }

  @Override
  public Place at(FrameId frame, Optional<Stamp> stamp) {
    return Optional.ofNullable(frames.get(frame.name())).filter(at -> at.translation().isFinite())
        .<Place>map(Place.At::new)
        .orElseGet(() -> new Place.Missing("a transform between " + frame.name() + " and map is missing"));
  }

  @Override
  public List<FrameId> all() {
    return frames.keySet().stream().map(TfDisplayTest::id).toList();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return Optional.ofNullable(carriers.get(frame.name())).map(TfDisplayTest::id);
  }
}
