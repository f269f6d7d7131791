package org.robotui.bridge.internal.carry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeRuic;

class ParameterWayTest {
  private static final Principal USER = new Principal("u", "Ulla", Principal.Kind.WINDOW);
  private static final SourceId GRAPH = new SourceId("base", "graph");

  private final TwoRobots robots = new TwoRobots();
  private final Map<String, Object> natalie = new ConcurrentHashMap<>(Map.of("/base/speed", 0.5));
  private final Map<String, Object> keira = new ConcurrentHashMap<>(Map.of("drive/max", 0.1, "fixed", 1L));

  @BeforeEach
  void begin() {
    browse(robots.natalie, natalie);
    browse(robots.keira, keira);
  }

  @AfterEach
  void end() {
    robots.close();
  }

  private static void browse(FakeRuic robot, Map<String, Object> values) {
    robot.offering(new PortStatus(GRAPH, PortKind.BROWSE, "", false, 0, 0, Double.NaN, false, 0, "", ""));
    robot.ports().browse(GRAPH, new Parameters(values));
  }

  private record Parameters(Map<String, Object> values) implements Browser {
    @Override
    public List<Item> list(Kind kind) {
      return values.keySet().stream().sorted().map(name -> new Item(kind, name, "")).toList();
    }

    @Override
    public Description describe(Item item) throws CallException {
      throw new CallException("nobody asks for it");
    }

    @Override
    public Optional<Object> parameter(String name) {
      return Optional.ofNullable(values.get(name));
    }

    @Override
    public void setParameter(String name, Object value) throws CallException {
      if (name.equals("fixed")) {
        throw new CallException("fixed is read-only");
      }
      values.put(name, value);
    }

    @Override
    public List<Tunable> tunables(Item item) throws CallException {
      throw new CallException("nobody asks for it");
    }

    @Override
    public List<Tunable> setTunables(Item item, Map<String, Object> changed) throws CallException {
      throw new CallException("nobody asks for it");
    }
  }

  private void keeps(String to, boolean both) {
    robots.bridge("base/speed", to, Map.of("kind", "parameter", "both", both));
  }

  @Test
  void whatAParameterBecomesIsSetAtTheOtherRobotUnderTheLease() {
    keeps("drive/max", false);
    TwoRobots.await(() -> keira.get("drive/max").equals(0.5), () -> robots.status().toString());
    assertEquals(Optional.of("Bridge test"), robots.keira.authority().holder().map(Principal::label));
    natalie.put("/base/speed", 0.7);
    TwoRobots.await(() -> keira.get("drive/max").equals(0.7));
    keira.put("drive/max", 9.0);
    TwoRobots.await(() -> keira.get("drive/max").equals(0.7), () -> "it is set again where it was changed there");
    TwoRobots.await(() -> robots.status().state() == State.CARRYING && robots.status().counts().passed() == 3);
    assertEquals("both have 0.7", robots.status().text());
  }

  @Test
  void bothWaysTheOneThatIsChangedIsRight() {
    keeps("drive/max", true);
    TwoRobots.await(() -> keira.get("drive/max").equals(0.5));
    TwoRobots.await(() -> robots.statuses().stream().allMatch(each -> each.text().equals("both have 0.5")));
    keira.put("drive/max", 0.3);
    TwoRobots.await(() -> natalie.get("/base/speed").equals(0.3));
    natalie.put("/base/speed", 0.4);
    TwoRobots.await(() -> keira.get("drive/max").equals(0.4));
  }

  @Test
  void whatIsRefusedIsSaidAndTriedAgain() {
    robots.keira.authority().take(USER, false);
    keeps("drive/max", false);
    robots.awaitText("Ulla has control of Keira");
    assertEquals(0.1, keira.get("drive/max"));
    robots.keira.authority().giveBack(USER);
    TwoRobots.await(() -> keira.get("drive/max").equals(0.5));
  }

  @Test
  void whatTheRobotRefusesIsSaidInItsWords() {
    keeps("fixed", false);
    robots.awaitText("fixed is read-only");
    assertEquals(State.REFUSED, robots.status().state());
  }

  @Test
  void aParameterThatIsNotSetIsWaitedFor() {
    natalie.clear();
    keeps("drive/max", false);
    robots.awaitText("Natalie.base.base/speed is not set");
    assertNull(natalie.get("/base/speed"));
    natalie.put("/base/speed", 2L);
    TwoRobots.await(() -> keira.get("drive/max").equals(2L));
  }
}
