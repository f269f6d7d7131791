package org.robotui.workbench.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.workbench.internal.model.Overview;
import org.robotui.workbench.internal.model.RobotRow;

class OverviewerTest {
  private final FakeRuic keira = new FakeRuic("Keira");
  private final FakeRuic natalie = new FakeRuic("Natalie");
  private final FakeHost host = new FakeHost();
  private final BlockingQueue<Runnable> display = new LinkedBlockingQueue<>();
  private final Overviewer overviewer = new Overviewer(host, display::add, () -> {});

  @AfterEach
  void close() {
    overviewer.close();
  }

  @Test
  void robotsAreLookedAtWhenSomebodyAsksAndTheDisplayIsTold() throws InterruptedException {
    host.add(keira);
    host.add(natalie);
    assertSame(Overview.NOTHING, overviewer.last());
    overviewer.request(Set.of("Natalie"));
    told();
    assertEquals(List.of("Keira", "Natalie"), overviewer.last().robots().stream().map(RobotRow::name).toList());
    assertEquals(Set.of("Natalie"), overviewer.last().details().keySet());
  }

  @Test
  void aRobotThatWasNotShownIsLookedAtAtOnce() throws InterruptedException {
    host.add(keira);
    overviewer.request(Set.of("Keira"));
    told();
    Overview now = overviewer.last();
    assertSame(now.detail(keira), now.detail(keira));
    assertNotSame(now.detail(natalie), now.detail(natalie));
    assertTrue(now.detail(natalie).status().left().startsWith("Natalie"));
  }

  @Test
  void afterTheEndNobodyLooks() {
    overviewer.close();
    overviewer.request(Set.of());
    assertSame(Overview.NOTHING, overviewer.last());
  }

  private void told() throws InterruptedException {
    Runnable task = display.poll(20, TimeUnit.SECONDS);
    assertTrue(task != null, "the display was told");
    task.run();
  }
}
