package org.robotui.uic.connections.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.ui.Health;

class ConnectionsLookTest {
  private static final long SECOND = 1_000_000_000L;

  private final Survey survey = new Survey();

  @Test
  void listsRobotsTheirComponentsAndThePortsOfThose() {
    assertEquals(List.of(
        "0 Keira", "1 base \u00b7 ros", "2 /scan", "2 /sonar", "2 /amcl_pose", "2 /map", "2 /imu", "2 /diagnostics",
        "1 camera", "2 image \u00b7 Image", "1 map", "2 scan \u00b7 Image", "2 grid \u00b7 Image", "1 teleop",
        "2 cmd_vel \u00b7 Image"),
        names(look(Robots.keira()).lines(Filter.ALL, Set.of())));
  }

  @Test
  void everyPortSaysWhyItIsAsItIs() {
    ConnectionsLook look = look(Robots.keira());
    assertLine(look, "image \u00b7 Image", Health.WARNING, "ambiguous",
        "two ports fit; choose one of /front/image and /rear/image");
    assertLine(look, "scan \u00b7 Image", Health.OK, "connected", "base./scan");
    assertLine(look, "grid \u00b7 Image", Health.NONE, "pending", "map waits for a GridMap; base offers none");
    assertLine(look, "cmd_vel \u00b7 Image", Health.BAD, "refused",
        "teleop needs VelocityCommand on 'cmd_vel'; base offers LaserScan '/scan'");
    assertLine(look, "/diagnostics", Health.BAD, "failed",
        "10.0.0.7:45123 sends foo/Diag, expected diagnostic_msgs/DiagnosticArray");
    assertEquals("14 dropped", line(look, "/sonar").dropped());
    assertEquals("12\u00a0ms", line(look, "/scan").age());
  }

  @Test
  void aViewIsAsWellAsTheWorstOfItsPorts() {
    ConnectionsLook look = look(Robots.keira());
    assertLine(look, "camera", Health.WARNING, "view", "0 of 1 ports connected");
    assertLine(look, "map", Health.OK, "view", "1 of 2 ports connected");
    assertLine(look, "teleop", Health.BAD, "view", "0 of 1 ports connected");
  }

  @Test
  void onlyWhatMustBeDecidedOffersCandidates() {
    ConnectionsLook look = look(Robots.keira());
    assertEquals(2, line(look, "image \u00b7 Image").decision().orElseThrow().candidates().size());
    assertEquals(1, look.lines(Filter.ALL, Set.of()).stream().filter(line -> line.decision().isPresent()).count());
  }

  @Test
  void problemsAreListedBelowWhatTheyBelongTo() {
    assertEquals(List.of("0 Keira", "1 base \u00b7 ros", "2 /sonar", "2 /amcl_pose", "2 /map", "2 /diagnostics",
        "1 camera", "2 image \u00b7 Image", "1 teleop", "2 cmd_vel \u00b7 Image"),
        names(
            look(Robots.keira(), Robots.plain("Natalie", Robots.UP)).lines(Filter.of(true, "", ""), Set.of("Keira"))));
  }

  @Test
  void theSearchWantsAllWordsAnywhereAlsoInTheRobotsName() {
    ConnectionsLook look = look(Robots.keira(), Robots.plain("Natalie", Robots.UP));
    assertEquals(List.of("0 Natalie", "1 base \u00b7 ros", "2 /scan"),
        names(look.lines(Filter.of(false, "", "natalie LASERSCAN"), Set.of())));
    assertEquals(List.of("0 Keira", "1 base \u00b7 ros", "2 /diagnostics"),
        names(look.lines(Filter.of(false, "", "foo/Diag"), Set.of())));
    assertEquals(List.of(), names(look.lines(Filter.of(false, "", "nowhere"), Set.of())));
  }

  @Test
  void oneRobotAloneCanBeListed() {
    ConnectionsLook look = look(Robots.keira(), Robots.plain("Natalie", Robots.UP));
    assertEquals("Natalie", look.lines(Filter.of(false, "Natalie", ""), Set.of()).getFirst().name());
    assertEquals(5, look.lines(Filter.of(false, "Natalie", ""), Set.of()).size());
  }

  @Test
  void whatIsFoldedHidesWhatIsBelow() {
    ConnectionsLook look = look(Robots.plain("Keira", Robots.UP), Robots.plain("Natalie", Robots.UP));
    assertEquals(List.of("0 Keira", "0 Natalie", "1 base \u00b7 ros", "1 map", "2 scan \u00b7 Image"),
        names(look.lines(Filter.ALL, Set.of("Keira", "Natalie\nbase"))));
  }

  @Test
  void theSummaryCountsLinksAndDecisions() {
    assertEquals("4 links: 2 connected, 1 degraded, 1 failed; 1 port needs a decision; 1 view port is not connected",
        look(Robots.keira(), Robots.plain("B", Robots.UP), Robots.plain("C", Robots.DOWN),
            Robots.plain("D", new LinkState.Degraded("d:11311", "/scan has a wrong type"))).summary());
    assertEquals("1 link: 1 connected", look(Robots.plain("A", Robots.UP)).summary());
    assertEquals("0 links", look().summary());
  }

  @Test
  void aLinkSaysSinceWhenItIsSo() {
    assertEquals("", part(0, Robots.UP).since());
    assertEquals("> 5\u00a0s", part(5, Robots.UP).since(), "it may have been so for longer");
    assertEquals("now", part(6, Robots.DOWN).since());
    assertEquals("3\u00a0s", part(9, new LinkState.Connecting("10.0.0.7:11311")).since(),
        "an attempt does not end a failure");
    assertEquals("4\u00a0s", part(10, Robots.DOWN).since());
    assertEquals("retry 4 s", part(10, Robots.DOWN).word());
    assertEquals("now", part(11, Robots.UP).since());
    assertEquals("2\u00a0min", part(131, Robots.UP).since());
  }

  @Test
  void aRobotThatFailedSaysWhy() {
    RuicSnapshot failed = new RuicSnapshot("Keira", RuicState.FAILED, "the type 'ros' is not installed", Robots.UP,
        List.of(), List.of(), List.of());
    ConnectionLine line = look(failed).lines(Filter.of(true, "", ""), Set.of()).getFirst();
    assertEquals(Health.BAD, line.health());
    assertEquals("the type 'ros' is not installed", line.text());
  }

  @Test
  void aFailedViewIsAProblemOfItsOwn() {
    RuicSnapshot robot = new RuicSnapshot("Keira", RuicState.SELECTED, "", Robots.UP, List.of(new ComponentStatus(
        "front", "camera", ComponentStatus.Kind.UIC, RuicState.FAILED, "fenced: did not return within 2 s",
        Optional.empty())), List.of(), List.of());
    assertEquals(List.of("0 Keira", "1 front \u00b7 camera"),
        names(look(robot).lines(Filter.of(true, "", ""), Set.of())));
  }

  @Test
  void theTranscriptHasALineEachWithMarksForProblems() {
    ConnectionsLook look = look(Robots.plain("Keira", Robots.UP), Robots.plain("Natalie", Robots.DOWN));
    assertEquals("""
        2 links: 1 connected, 1 failed
          connected    Keira
            connected    base \u00b7 ros: localhost:11311
              10.0\u00a0Hz      /scan: newest 20\u00a0ms old
            view         map: 1 of 1 ports connected
              connected    scan \u00b7 Image: base./scan
          retry 4 s    Natalie: 1 problem
          ! retry 4 s    base \u00b7 ros: 10.0.0.7:11311 refuses the connection
              10.0\u00a0Hz      /scan: newest 20\u00a0ms old
            view         map: 1 of 1 ports connected
              connected    scan \u00b7 Image: base./scan
        """, Transcript.of(look.summary(), look.lines(Filter.ALL, Set.of())));
  }

  @Test
  void fiftyRobotsWithFiftyPortsEachAreMadeAndFilteredWithinATick() {
    List<RuicSnapshot> many = IntStream.range(0, 50).mapToObj(i -> Robots.large("robot" + i, 50)).toList();
    long best = Long.MAX_VALUE;
    for (int i = 0; i < 10; i++) {
      long start = System.nanoTime();
      ConnectionsLook look = survey.look(many, List.of(), i * SECOND);
      assertEquals(50 * (1 + 1 + 50 + 10 + 50), look.lines(Filter.ALL, Set.of()).size());
      assertEquals(50 * (1 + 1 + 1 + 1 + 1), look.lines(Filter.of(false, "", "topic_17"), Set.of()).size());
      assertFalse(look.lines(Filter.ALL, Set.of()).isEmpty());
      best = Math.min(best, System.nanoTime() - start);
    }
    assertTrue(best < SECOND / 5, "took " + best / 1_000_000 + " ms");
  }

  private ConnectionLine part(long seconds, LinkState link) {
    return survey.look(List.of(Robots.plain("Keira", link)), List.of(), seconds * SECOND).branches().getFirst().parts()
        .getFirst();
  }

  private ConnectionsLook look(RuicSnapshot... robots) {
    return survey.look(List.of(robots), List.of(), 0);
  }

  private static void assertLine(ConnectionsLook look, String name, Health health, String word, String text) {
    ConnectionLine line = line(look, name);
    assertEquals(health, line.health(), name);
    assertEquals(word, line.word(), name);
    assertEquals(text, line.text(), name);
  }

  private static ConnectionLine line(ConnectionsLook look, String name) {
    return look.lines(Filter.ALL, Set.of()).stream().filter(line -> line.name().equals(name)).findFirst().orElseThrow();
  }

  private static List<String> names(List<ConnectionLine> lines) {
    return lines.stream().map(line -> line.level() + " " + line.name()).toList();
  }
}
