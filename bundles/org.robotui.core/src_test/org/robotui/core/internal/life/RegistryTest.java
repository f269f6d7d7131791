package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;

class RegistryTest {
  private final Registry registry = new Registry();

  @Test
  void typesComeAndGoAndAreTold() {
    AtomicInteger told = new AtomicInteger();
    CompletableFuture<Void> takenUp = new CompletableFuture<>();
    registry.listen(() -> {
      told.incrementAndGet();
      return takenUp;
    });
    FakeView map = new FakeView("map");
    registry.add(map, "org.robotui.uic.map");
    assertSame(map, registry.uic("map").orElseThrow());
    assertTrue(registry.rfic("map").isEmpty());
    CompletableFuture<Void> removal = registry.remove(map);
    assertTrue(registry.uic("map").isEmpty());
    assertEquals(2, told.get());
    assertFalse(removal.isDone());
    takenUp.complete(null);
    assertTrue(removal.isDone());
  }

  @Test
  void missingTypeIsNamedWithItsBundleOrWithWhatThereIs() {
    FakeView map = new FakeView("map");
    registry.add(map, "org.robotui.uic.map");
    registry.add(new FakeView("camera"), "org.robotui.uic.camera");
    assertEquals("type 'mop' is not installed; installed are camera, map", registry.missingUic("mop"));
    registry.remove(map);
    assertEquals("type 'map' is not there; install or start bundle org.robotui.uic.map", registry.missingUic("map"));
    assertEquals("type 'ros' is not installed; none is", registry.missingRfic("ros"));
  }

  @Test
  void secondOfOneIdStepsInWhenTheFirstGoes() {
    FakeView first = new FakeView("map");
    FakeView second = new FakeView("map");
    registry.add(first, "one");
    registry.add(second, "two");
    assertSame(first, registry.uic("map").orElseThrow());
    assertEquals(List.of("map"), registry.uicIds());
    registry.remove(first);
    assertSame(second, registry.uic("map").orElseThrow());
  }

  @Test
  void originNamesBundleAndClass() {
    FakeRobot robot = new FakeRobot("ros");
    registry.add(robot, "org.robotui.rfic.ros");
    assertEquals("bundle org.robotui.rfic.ros, class java.lang.String", registry.origin(robot, "instance"));
  }
}
