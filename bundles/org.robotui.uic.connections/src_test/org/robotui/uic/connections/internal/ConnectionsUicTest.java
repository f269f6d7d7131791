package org.robotui.uic.connections.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeRuicView;
import org.robotui.testkit.FakeUicContext;
import org.robotui.uic.connections.internal.model.Robots;

class ConnectionsUicTest {
  private final FakeUicContext context =
      new FakeUicContext("connections", new ConnectionsType(FakeBridges.NONE).schema());
  private final FakeRuicView keira = new FakeRuicView(new FakeAuthority("Keira"));
  private final FakeRuicView natalie = new FakeRuicView(new FakeAuthority("Natalie"));
  private final ConnectionsUic uic = new ConnectionsUic(context, List::of);

  @Test
  void looksAtAllRobotsOfTheWorkbenchAndTellsNews() {
    assertTrue(uic.tick(0));
    assertFalse(uic.tick(0), "nothing new");
    context.ruics(List.of(keira, natalie));
    assertTrue(uic.tick(0));
    natalie.snapshot(Robots.plain("Natalie", Robots.DOWN));
    assertTrue(uic.tick(0));
  }

  @Test
  void connectsInTheRobotThatWasMeant() {
    context.ruics(List.of(keira, natalie));
    SourceId port = new SourceId("camera", "image");
    SourceId peer = new SourceId("base", "/rear/image");
    uic.connect("Natalie", port, peer);
    uic.connect("Gone", port, peer);
    assertEquals(List.of(), keira.connects());
    assertEquals(List.of(new FakeRuicView.Connect(port, peer)), natalie.connects());
  }

  @Test
  void whatIsListedIsKept() {
    uic.problems(true);
    uic.robot("Natalie");
    assertEquals(Map.of(ConnectionsType.PROBLEMS, true, ConnectionsType.ROBOT, "Natalie"),
        context.settings().current().values());
  }
}
