package org.robotui.uic.map.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.scene.Layer;
import org.robotui.uic.map.internal.DemoRoom;
import org.robotui.uic.map.internal.LayerKinds;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.MapPorts;

/** What the user does with the list of layers. */
class LayerListTest {
  private final FakeUicContext context = new FakeUicContext("map", MapOptions.schema());
  private final MapModel model;
  private long now = System.nanoTime();

  LayerListTest() {
    DemoRoom.fill(context, now);
    model = new MapModel(context, () -> LayerKinds.ALL);
    tick();
  }

  @Test
  void movedDownALayerIsPaintedBelowTheOther() {
    assertTrue(order("scan:base.scan") > order("sonar:base.sonar"));
    model.layers().list().move("scan:base.scan", 1);
    tick();
    assertTrue(order("scan:base.scan") < order("sonar:base.sonar"));
    assertTrue(model.scene().find("scan:base.scan").orElseThrow().visible());
  }

  @Test
  void whatComesAfterTheFirstChangeIsShownInItsPlace() {
    model.layers().list().change("scan:base.scan", spec -> spec.show(false));
    context.input(MapPorts.SCAN).put(new SourceId("base", "rear"), DemoRoom.scan(), now, Optional.empty());
    tick();
    assertFalse(model.scene().find("scan:base.scan").orElseThrow().visible());
    assertTrue(model.scene().find("scan:base.rear").orElseThrow().visible());
    assertTrue(order("scan:base.rear") > order("sonar:base.sonar") && order("scan:base.rear") < order("robot"));
  }

  @Test
  void whatIsRemovedStaysAwayUntilTheListIsTakenBack() {
    model.layers().list().remove("sonar:base.sonar");
    tick();
    tick();
    assertTrue(model.scene().find("sonar:base.sonar").isEmpty());
    model.layers().list().automatic();
    tick();
    assertTrue(model.scene().find("sonar:base.sonar").isPresent());
  }

  @Test
  void aNewOneLiesOnTop() {
    String id = model.layers().list().add("scan", "base/scan");
    tick();
    assertEquals(id, model.scene().layers().getLast().id());
    assertTrue(model.scene().find(id).orElseThrow().visible());
  }

  @Test
  void olderSettingsSayHowLayersBegin() {
    context.settings().set(MapOptions.show("sonar"), false);
    context.settings().set("trail_length", 3.0);
    context.settings().set("robot_radius", 0.4);
    tick();
    assertFalse(model.scene().find("sonar:base.sonar").orElseThrow().visible());
    assertEquals(3.0, settings("trail:base.odom").get("length"));
    assertEquals(0.4, settings("robot").get("radius"));
  }

  private Map<String, Object> settings(String id) {
    return model.layers().rows().stream().filter(r -> r.spec().id().equals(id)).findFirst().orElseThrow().settings()
        .orElseThrow().values();
  }

  private int order(String id) {
    List<String> ids = model.scene().layers().stream().map(Layer::id).toList();
    return ids.indexOf(id);
  }

  private void tick() {
    now += 33_000_000;
    model.tick(now, MapOptions.of(context.settings().current()));
  }
}
